//! Deferred shading: what is seen is found first, in a format of the example's own, and lit
//! afterwards, each pixel once.

use super::Canvas;
use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::models::TEAPOT;
use microraster::{
    Camera, Color, Corner, Cull, DepthBuffer, DrawContext, Format, Frame, FrameError, Less, Mesh,
    Normal, Pass, Rgb, Rgb565, Scalars, Shader, Size, Stats, VertexInput,
};

/// What is kept of a visible surface: a normal in three bytes, and a material.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Surface;

impl Format for Surface {
    type Raw = u32;

    fn pack(color: Color) -> u32 {
        u32::from_le_bytes([color.red(), color.green(), color.blue(), color.alpha()])
    }

    fn unpack(raw: u32) -> Color {
        let [r, g, b, a] = raw.to_le_bytes();
        Color::new(r, g, b).with_alpha(a)
    }
}

/// Writes normals as the eye sees them, and a material's number.
struct Attributes {
    material: u8,
}

impl Shader for Attributes {
    type Vertex = Normal;
    type Varying = Scalars<3>;
    /// From the mesh to the eye, 2^7 being 1.
    type Prepared = [[i32; 3]; 3];

    fn prepare(&self, draw: &DrawContext) -> [[i32; 3]; 3] {
        let rows = (draw.view * draw.model).transpose();
        [rows.x, rows.y, rows.z].map(|row| {
            let Vec3 { x, y, z } = row.truncate().normalize() * 128.0;
            [x as i32, y as i32, z as i32]
        })
    }

    fn vertex(&self, rows: &[[i32; 3]; 3], vertex: VertexInput<'_, Normal>) -> Corner<Scalars<3>> {
        rows.map(|row| {
            let products = row.iter().zip(vertex.attributes);
            let sum: i32 = products.map(|(factor, n)| factor * i32::from(*n)).sum();
            // 127 x 128 is a unit: 2^15 and some more about the middle.
            (32_768 + sum * 2).clamp(0, 65_535) as u16
        })
    }

    fn fragment(&self, _: &[[i32; 3]; 3], normal: &Scalars<3>) -> Option<Color> {
        let [x, y, z] = normal.get().map(|word| (word >> 8) as u8);
        Some(Color::new(x, y, z).with_alpha(self.material))
    }
}

/// Materials by number: colour, and how much they shine. Nothing is at 0.
const MATERIALS: [(Rgb, i32); 4] = [
    (Rgb::BLACK, 0),
    (Rgb::new(220, 214, 205), 20),
    (Rgb::new(206, 120, 60), 220),
    (Rgb::new(80, 150, 120), 120),
];

/// Draws two teapots on a floor into `surfaces`, then lights them into the frame.
///
/// # Errors
/// Fewer words than pixels.
pub(crate) fn draw(
    canvas: &mut Canvas<'_>,
    turn: f32,
    stats: &mut Stats,
) -> Result<(), FrameError> {
    let Canvas { picture, first_row, rows, pixels, depth, words } = canvas;
    let mut seen: Frame<'_, Surface, DepthBuffer<'_>> =
        Frame::new(words, Size::new(picture.width, *rows))?
            .with_depth(depth)?
            .band(*first_row, picture.height)?;
    seen.clear(Color::new(0, 0, 0).with_alpha(0));
    let camera = Camera::perspective(38.0.degrees(), 0.5).look_at(
        Vec3::new(0.0, 4.0, 9.0),
        Vec3::new(0.0, -0.2, 0.0),
        Vec3::Y,
    );
    let floor =
        Mesh::new(&FLOOR, &[[0, 127, 0]; 6]).placed(Vec3::splat(1.0), Vec3::new(0.0, -1.0, 0.0));
    let mut pass = Pass::new(&camera).depth(Less).cull(Cull::Back).count(stats);
    pass.draw(&mut seen, &Mat4::identity(), &floor, &Attributes { material: 1 });
    for (x, material) in [(-1.75, 2), (1.75, 3)] {
        let model = Mat4::translation(Vec3::new(x, 0.0, 0.0))
            * Mat4::rotation_y((turn + 40.0 * x).degrees());
        pass.draw(&mut seen, &model, &TEAPOT, &Attributes { material });
    }
    // Each visible surface is lit once.
    let seen = usize::from(picture.width) * usize::from(*rows);
    for (pixel, surface) in pixels.iter_mut().zip(words.iter()).take(seen) {
        *pixel = Rgb565::encode(shade(*surface));
    }
    Ok(())
}

static FLOOR: [[i16; 3]; 6] =
    [[-9, 0, 9], [9, 0, 9], [9, 0, -9], [-9, 0, 9], [9, 0, -9], [-9, 0, -9]];

/// Lights in the eye's space: where they come from, 2^7 long, and their colour.
const LIGHTS: [([i32; 3], Rgb); 3] = [
    ([-60, 85, 74], Rgb::new(190, 180, 170)),
    ([110, 30, 58], Rgb::new(30, 60, 130)),
    ([-20, 20, 125], Rgb::new(40, 36, 30)),
];

/// The colour of a surface, dark blue where there is none.
fn shade(surface: u32) -> Color {
    let [x, y, z, material] = surface.to_le_bytes();
    let Some((color, shine)) = MATERIALS.get(usize::from(material)).filter(|_| material != 0)
    else {
        return Color::new(22, 26, 44);
    };
    let normal = [x, y, z].map(|v| i32::from(v) - 128);
    let mut sum = [18, 20, 26];
    for ([u, v, w], light) in &LIGHTS {
        let along = |w: i32| (normal[0] * u + normal[1] * v + normal[2] * w).max(0);
        let cosine = along(*w) >> 6;
        // Halfway to the eye, which is along z; then its eighth power.
        let halfway = (along(w + 128) / 113).min(255);
        let power = (0..3).fold(halfway, |power, _| (power * power) >> 8);
        let channels = [(color.r, light.r), (color.g, light.g), (color.b, light.b)];
        for (sum, (own, light)) in sum.iter_mut().zip(channels) {
            let shown = ((i32::from(own) * cosine) >> 8) + ((power * shine) >> 8);
            *sum += (shown * i32::from(light)) >> 8;
        }
    }
    let [r, g, b] = sum.map(|channel| channel.min(255) as u8);
    Color::new(r, g, b)
}
