//! tiny-skia: two dimensions, RGBA; neither depth nor a mesh. Triangles are paths in one colour.

use alloc::boxed::Box;
use alloc::vec::Vec;

use tiny_skia::{Color, FillRule, Paint, PathBuilder, Pixmap, Transform};

use super::Renderer;
use crate::scene::{Rgb, Scene, Shading, Size};

struct Ready {
    triangles: Vec<([[f32; 2]; 3], Rgb)>,
    opacity: u8,
    pixmap: Pixmap,
}

/// Scenes without depth in plain colours, and that of the grid, whose triangles do not overlap.
pub(super) fn make(scene: &Scene, size: Size) -> Option<Box<dyn Renderer>> {
    let color = |number: usize| match &scene.shading {
        Shading::Solid(color) | Shading::Glass(color, _) if !scene.depth => Some(*color),
        Shading::Faces(colors) => Some(colors[number]),
        _ => None,
    };
    let triangles = super::projected(scene, size).into_iter().enumerate();
    let triangles = triangles.map(|(number, triangle)| Some((triangle, color(number)?)));
    let opacity = if let Shading::Glass(_, opacity) = scene.shading { opacity } else { 255 };
    Some(Box::new(Ready {
        opacity,
        triangles: triangles.collect::<Option<_>>()?,
        pixmap: Pixmap::new(size.width.into(), size.height.into())?,
    }))
}

impl Renderer for Ready {
    fn clear(&mut self) {
        self.pixmap.fill(Color::BLACK);
    }

    fn draw(&mut self, _: usize) {
        let mut paint = Paint { anti_alias: false, ..Paint::default() };
        for ([a, b, c], [red, green, blue]) in &self.triangles {
            let mut path = PathBuilder::new();
            path.move_to(a[0], a[1]);
            path.line_to(b[0], b[1]);
            path.line_to(c[0], c[1]);
            path.close();
            paint.set_color_rgba8(*red, *green, *blue, self.opacity);
            if let Some(path) = path.finish() {
                self.pixmap.fill_path(
                    &path,
                    &paint,
                    FillRule::Winding,
                    Transform::identity(),
                    None,
                );
            }
        }
    }

    fn picture(&mut self) -> Vec<Rgb> {
        self.pixmap.pixels().iter().map(|p| [p.red(), p.green(), p.blue()]).collect()
    }
}
