//! The renderers: each draws those scenes that it can.

mod embedded_3dgfx;
mod embedded_graphics;
mod euc;
mod llvmpipe;
mod microraster;
mod retrofire;
mod tiny_skia;

pub(crate) use self::microraster::make_threaded;
use crate::scene::{Rgb, Scene, Size};

/// A scene made ready in a renderer's own form.
pub(crate) trait Renderer {
    /// Clears colour and depth.
    fn clear(&mut self);
    /// Draws a frame; what this takes is measured.
    fn draw(&mut self, frame: usize);
    /// What was drawn, row by row from the top.
    fn picture(&mut self) -> Vec<Rgb>;
}

/// A way of making a scene ready; `None` where the renderer does not offer what it needs.
pub(crate) type Make = fn(&Scene, Size) -> Option<Box<dyn Renderer>>;

/// All renderers, ours first.
pub(crate) const RENDERERS: [(&str, Make); 7] = [
    ("microraster", microraster::make),
    ("llvmpipe", llvmpipe::make),
    ("retrofire", retrofire::make),
    ("embedded-3dgfx", embedded_3dgfx::make),
    ("euc", euc::make),
    ("embedded-graphics", embedded_graphics::make),
    ("tiny-skia", tiny_skia::make),
];

/// The light on a normal: a grey from ambient to full.
pub(crate) fn light(normal: [f32; 3], to_light: [f32; 3]) -> f32 {
    use crate::scene::{AMBIENT, DIFFUSE};
    let cosine: f32 = normal.iter().zip(to_light).map(|(n, l)| n * l).sum();
    AMBIENT + DIFFUSE * cosine.max(0.0)
}

/// The material under a light, in 0..=1.
pub(crate) fn lit(light: f32) -> [f32; 3] {
    crate::scene::MATERIAL.map(|c| f32::from(c) / 255.0 * light)
}

/// Triangles of a scene that does not turn, on the screen, in pixels.
pub(crate) fn projected(scene: &Scene, size: Size) -> Vec<[[f32; 2]; 3]> {
    let matrix = crate::scene::product(&crate::scene::projection(size), &scene.model_view(0));
    let place = |&[x, y, z]: &[f32; 3]| {
        let [x, y, _, w] = matrix.map(|[a, b, c, d]| a * x + b * y + c * z + d);
        let (across, down) = (x / w / 2.0 + 0.5, 0.5 - y / w / 2.0);
        [across * f32::from(size.width), down * f32::from(size.height)]
    };
    scene.triangles.iter().map(|t| t.map(|index| place(&scene.positions[index]))).collect()
}
