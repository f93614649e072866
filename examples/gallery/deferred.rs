//! Deferred shading: what is visible first, its colour later, by a pixel format of one's own.
//!
//! The first pass stores a normal and a material for each pixel, whatever lies over each other; the
//! second lights each pixel once. The frame neither knows nor cares that its pixels are no colours.

use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::models::TEAPOT;
use microraster::{
    Camera, Color, Corner, Cull, DrawContext, Format, Frame, FrameError, Less, Normal, Pass, Rgb,
    Rgb565, Shader, Size, SmoothColor, Stats, VertexInput,
};

use super::shapes::BALL;

/// What is known of a pixel: a normal in the world, 128 being zero, and a material's number.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Attributes;

impl Format for Attributes {
    type Raw = [u8; 4];

    fn pack(color: Color) -> [u8; 4] {
        [color.red(), color.green(), color.blue(), color.alpha()]
    }

    fn unpack([x, y, z, material]: [u8; 4]) -> Color {
        Color::new(x, y, z).with_alpha(material)
    }
}

/// Makes attributes: the normal takes the way of a colour, the material that of its alpha.
struct Visible {
    material: u8,
}

impl Shader for Visible {
    type Vertex = Normal;
    type Varying = SmoothColor;
    /// The model's rotation, 256 being 1.
    type Prepared = [[i32; 3]; 3];

    #[allow(clippy::cast_possible_truncation, reason = "a float cast saturates")]
    fn prepare(&self, draw: &DrawContext) -> Self::Prepared {
        let rows = draw.model.transpose();
        [rows.x, rows.y, rows.z]
            .map(|row| (row.truncate().normalize() * 256.0).to_array().map(|number| number as i32))
    }

    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "limited to 8 bits just before"
    )]
    fn vertex(
        &self,
        rows: &Self::Prepared,
        vertex: VertexInput<'_, Normal>,
    ) -> Corner<SmoothColor> {
        let normal = vertex.attributes.map(i32::from);
        let [x, y, z] = rows.map(|row| {
            let turned = row[0] * normal[0] + row[1] * normal[1] + row[2] * normal[2];
            (128 + (turned >> 8)).clamp(0, 255) as u8
        });
        Color::new(x, y, z)
    }

    fn fragment(&self, _: &Self::Prepared, normal: &SmoothColor) -> Option<Color> {
        Some(normal.color().with_alpha(self.material))
    }
}

/// Number 0 is the background.
const MATERIALS: [Rgb; 6] = [
    Rgb::new(20, 22, 34),
    Rgb::new(236, 228, 214),
    Rgb::new(214, 96, 60),
    Rgb::new(70, 150, 160),
    Rgb::new(226, 178, 70),
    Rgb::new(120, 104, 190),
];

/// Draws rows `first_row..` of a picture, as many as `pixels` hold; `turn` in degrees.
///
/// # Errors
/// Buffers that are too small: all three have as many places.
pub(crate) fn draw(
    pixels: &mut [u16],
    attributes: &mut [[u8; 4]],
    depth: &mut [u16],
    (picture, first_row, rows): (Size, u16, u16),
    turn: f32,
    stats: &mut Stats,
) -> Result<(), FrameError> {
    let size = Size::new(picture.width, rows);
    let mut frame = Frame::<Attributes>::new(attributes, size)?
        .with_depth(depth)?
        .band(first_row, picture.height)?;
    frame.clear(Color::new(128, 128, 128).with_alpha(0));
    let camera = Camera::perspective(42.0.degrees(), 0.5).look_at(
        Vec3::new(0.0, 3.4, 8.0),
        Vec3::new(0.0, -0.6, 0.0),
        Vec3::Y,
    );
    let mut pass = Pass::new(&camera).cull(Cull::Back).depth(Less).count(stats);
    // Far to near, the worst order there is: nothing is lit in vain all the same.
    for (number, material) in (0_u8..6).zip([3, 4, 5, 2, 3, 4]) {
        let (sin, cos) = (180.0 + turn + 60.0 * f32::from(number)).degrees().sin_cos();
        let model = Mat4::translation(Vec3::new(3.0 * sin, -0.6, 3.0 * cos))
            * Mat4::scale(Vec3::splat(0.8));
        pass.draw(&mut frame, &model, &BALL, &Visible { material });
    }
    let model = Mat4::rotation_y((20.0 - turn).degrees());
    pass.draw(&mut frame, &model, &TEAPOT, &Visible { material: 1 });

    for (pixel, visible) in pixels.iter_mut().zip(attributes.iter()) {
        *pixel = Rgb565::pack(lit(*visible));
    }
    Ok(())
}

/// A light: where it is from, as long as 127, and its colour.
const LIGHTS: [([i32; 3], [i32; 3]); 3] = [
    ([-62, 88, 67], [190, 176, 150]),
    ([118, 12, 45], [40, 80, 150]),
    ([-84, -6, -94], [230, 80, 120]),
];

/// Halfway between a light and the eye, the same of each.
const HALFWAY: [[i32; 3]; 3] = [[-37, 79, 92], [78, 36, 93], [-88, 39, 82]];

/// The colour of what is visible: ambient, and the diffuse light and highlight of each light.
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "limited to 8 bits just before"
)]
fn lit([x, y, z, material]: [u8; 4]) -> Color {
    let Rgb { r, g, b } = MATERIALS.get(usize::from(material)).copied().unwrap_or(Rgb::BLACK);
    if material == 0 {
        return Color::new(r, g, b);
    }
    let normal = [x, y, z].map(|component| i32::from(component) - 128);
    let cosine = |to: &[i32; 3]| {
        let sum = normal[0] * to[0] + normal[1] * to[1] + normal[2] * to[2];
        (sum >> 6).clamp(0, 255)
    };
    let (mut diffuse, mut shine) = ([40, 42, 56], [0; 3]);
    for ((light, color), halfway) in LIGHTS.iter().zip(&HALFWAY) {
        let facing = cosine(light);
        // The 32nd power of a cosine, by squares.
        let power = (0..5).fold(cosine(halfway), |power, _| (power * power) >> 8);
        for ((diffuse, shine), color) in diffuse.iter_mut().zip(&mut shine).zip(color) {
            *diffuse += (facing * color) >> 8;
            *shine += (power * color) >> 9;
        }
    }
    let channel = |material: u8, diffuse: i32, shine: i32| {
        (((i32::from(material) * diffuse) >> 8) + shine).clamp(0, 255) as u8
    };
    Color::new(
        channel(r, diffuse[0], shine[0]),
        channel(g, diffuse[1], shine[1]),
        channel(b, diffuse[2], shine[2]),
    )
}
