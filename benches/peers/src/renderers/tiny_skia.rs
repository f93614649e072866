//! tiny-skia: two dimensions, RGBA; neither depth nor a mesh. Triangles are paths in one colour.

use tiny_skia::{Color, FillRule, Paint, PathBuilder, Pixmap, Transform};

use super::Renderer;
use crate::scene::{Rgb, Scene, Shading, Size};

struct Ready {
    paths: Vec<(tiny_skia::Path, Paint<'static>)>,
    pixmap: Pixmap,
}

/// Scenes without depth in plain colours, and that of the grid, whose triangles do not overlap.
pub(super) fn make(scene: &Scene, size: Size) -> Option<Box<dyn Renderer>> {
    let color = |number: usize| match &scene.shading {
        Shading::Solid(color) if !scene.depth => Some(*color),
        Shading::Faces(colors) => Some(colors[number]),
        _ => None,
    };
    let triangles = super::projected(scene, size);
    let paths = triangles.iter().enumerate().map(|(number, [a, b, c])| {
        let mut path = PathBuilder::new();
        path.move_to(a[0], a[1]);
        path.line_to(b[0], b[1]);
        path.line_to(c[0], c[1]);
        path.close();
        let [red, green, blue] = color(number)?;
        let mut paint = Paint { anti_alias: false, ..Paint::default() };
        paint.set_color_rgba8(red, green, blue, 255);
        Some((path.finish()?, paint))
    });
    Some(Box::new(Ready {
        paths: paths.collect::<Option<_>>()?,
        pixmap: Pixmap::new(size.width.into(), size.height.into())?,
    }))
}

impl Renderer for Ready {
    fn clear(&mut self) {
        self.pixmap.fill(Color::BLACK);
    }

    fn draw(&mut self, _: usize) {
        for (path, paint) in &self.paths {
            self.pixmap.fill_path(path, paint, FillRule::Winding, Transform::identity(), None);
        }
    }

    fn picture(&mut self) -> Vec<Rgb> {
        self.pixmap.pixels().iter().map(|p| [p.red(), p.green(), p.blue()]).collect()
    }
}
