//! embedded-graphics: two dimensions, whole pixels, RGB565; neither depth nor a mesh.

use embedded_graphics::pixelcolor::raw::{RawData, RawU16};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::{PrimitiveStyle, Rectangle, StyledDrawable, Triangle};

use super::Renderer;
use crate::scene::{self, rgb565, Rgb, Scene, Shading, Size as Sides};

/// A plain buffer with fills by rows.
pub(super) struct Buffer {
    pixels: Vec<Rgb565>,
    width: usize,
}

impl Buffer {
    pub(super) fn new(size: Sides) -> Self {
        Self { pixels: vec![Rgb565::BLACK; size.pixels()], width: size.width.into() }
    }

    pub(super) fn clear(&mut self) {
        self.pixels.fill(Rgb565::BLACK);
    }

    pub(super) fn picture(&self) -> Vec<Rgb> {
        let texel = |color: &Rgb565| RawU16::from(*color).into_inner();
        self.pixels.iter().map(|color| scene::rgb(texel(color))).collect()
    }
}

impl OriginDimensions for Buffer {
    fn size(&self) -> Size {
        Size::new(self.width as u32, (self.pixels.len() / self.width) as u32)
    }
}

impl DrawTarget for Buffer {
    type Color = Rgb565;
    type Error = core::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(
        &mut self,
        pixels: I,
    ) -> Result<(), Self::Error> {
        for Pixel(Point { x, y }, color) in pixels {
            if x >= 0 && y >= 0 && (x as usize) < self.width {
                if let Some(pixel) = self.pixels.get_mut(y as usize * self.width + x as usize) {
                    *pixel = color;
                }
            }
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Rgb565) -> Result<(), Self::Error> {
        let area = area.intersection(&self.bounding_box());
        let width = area.size.width as usize;
        for y in area.rows() {
            let start = y as usize * self.width + area.top_left.x as usize;
            if let Some(row) = self.pixels.get_mut(start..start + width) {
                row.fill(color);
            }
        }
        Ok(())
    }
}

struct Ready {
    triangles: Vec<(Triangle, PrimitiveStyle<Rgb565>)>,
    buffer: Buffer,
}

/// Scenes without depth in plain colours, and that of the grid, whose triangles do not overlap.
pub(super) fn make(scene: &Scene, size: Sides) -> Option<Box<dyn Renderer>> {
    let color = |number: usize| match &scene.shading {
        Shading::Solid(color) if !scene.depth => Some(*color),
        Shading::Faces(colors) => Some(colors[number]),
        _ => None,
    };
    let point = |[x, y]: &[f32; 2]| Point::new(x.round() as i32, y.round() as i32);
    let triangles = super::projected(scene, size);
    let triangles = triangles.iter().enumerate().map(|(number, [a, b, c])| {
        let color = Rgb565::from(RawU16::new(rgb565(color(number)?)));
        Some((Triangle::new(point(a), point(b), point(c)), PrimitiveStyle::with_fill(color)))
    });
    let triangles = triangles.collect::<Option<_>>()?;
    Some(Box::new(Ready { triangles, buffer: Buffer::new(size) }))
}

impl Renderer for Ready {
    fn clear(&mut self) {
        self.buffer.clear();
    }

    fn draw(&mut self, _: usize) {
        for (triangle, style) in &self.triangles {
            let Ok(()) = triangle.draw_styled(style, &mut self.buffer);
        }
    }

    fn picture(&mut self) -> Vec<Rgb> {
        self.buffer.picture()
    }
}
