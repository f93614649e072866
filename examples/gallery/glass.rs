//! Balls of glass around a teapot: sorted, blended, each its far side first.

use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::models::TEAPOT;
use microraster::{
    Alpha, BlinnPhong, Camera, Color, Coloring, Corner, Cull, DepthBuffer, Dither4, DrawContext,
    Frame, Gouraud, Less, Light, Normal, Pass, ReadOnly, Rgb, Rgb565, Scalar, Shader, SmoothColor,
    Stats, VertexInput,
};

use super::shapes::BALL;

const COLORS: [Rgb; 6] = [
    Rgb::new(255, 60, 70),
    Rgb::new(255, 170, 40),
    Rgb::new(150, 220, 60),
    Rgb::new(40, 200, 190),
    Rgb::new(70, 120, 255),
    Rgb::new(200, 80, 230),
];

/// Draws the teapot and the balls that circle around it; `turn` in degrees.
pub(crate) fn draw(frame: &mut Frame<'_, Rgb565, DepthBuffer<'_>>, turn: f32, stats: &mut Stats) {
    frame.clear(Rgb::new(236, 238, 242));
    let eye = Vec3::new(0.0, 2.5, 6.0);
    let camera =
        Camera::perspective(48.0.degrees(), 0.5).look_at(eye, Vec3::new(0.0, -0.45, 0.0), Vec3::Y);
    let sun = [Light::directional(Vec3::new(-0.5, -1.0, -0.8), Rgb::new(220, 220, 220))];

    // What is opaque comes first.
    let china = BlinnPhong::new(&sun).material(Rgb::new(80, 88, 108));
    let mut pass = Pass::new(&camera).cull(Cull::Back).depth(Less).dither(Dither4).count(stats);
    let teapot = Mat4::rotation_y((-25.0).degrees()) * Mat4::scale(Vec3::splat(0.8));
    pass.draw(frame, &teapot, &TEAPOT, &Gouraud::new(china));

    // Then the glass from far to near, as blending wants it.
    let mut balls = COLORS.map(|color| (Vec3::ZERO, color));
    for (number, (place, _)) in balls.iter_mut().enumerate() {
        let (sin, cos) = (turn + 60.0 * number as f32).degrees().sin_cos();
        *place = Vec3::new(2.35 * sin, -0.25, 2.35 * cos);
    }
    balls.sort_unstable_by(|(a, _), (b, _)| {
        (*b - eye).length_squared().total_cmp(&(*a - eye).length_squared())
    });
    for (place, color) in balls {
        let model = Mat4::translation(place) * Mat4::scale(Vec3::splat(0.72));
        let light = BlinnPhong::new(&sun).material(color).specular(Rgb::WHITE, 70);
        let glass = Glass { light };
        // A ball is its own far side, and before it its near side. Glass hides nothing: it leaves
        // depth as it is.
        for side in [Cull::Front, Cull::Back] {
            Pass::new(&camera)
                .cull(side)
                .depth(ReadOnly::new(Less))
                .blend(Alpha)
                .count(stats)
                .draw(frame, &model, &BALL, &glass);
        }
    }
}

/// Light of some kind, on a surface that is clear where it faces the eye and dense where it turns
/// away.
struct Glass<L> {
    light: L,
}

/// How dense glass is where it faces the eye, and at its rim.
const CLEAR: i32 = 60 << 8;
const RIM: i32 = 190 << 8;

impl<L: Coloring<Vertex = Normal>> Shader for Glass<L> {
    type Vertex = Normal;
    type Varying = (SmoothColor, Scalar);
    /// What the light prepares, and the direction to the eye in the mesh's own axes, 127 long.
    type Prepared = (L::Prepared, [i32; 3]);

    #[allow(clippy::cast_possible_truncation, reason = "127 at most")]
    fn prepare(&self, draw: &DrawContext) -> Self::Prepared {
        // Far enough away, the eye is in the same direction everywhere: that of the middle.
        let to_eye = draw.view * draw.model;
        let middle = to_eye.transform_point(Vec3::ZERO);
        let toward = to_eye.transpose().transform_vector(-middle).normalize() * 127.0;
        (self.light.prepare(draw), toward.to_array().map(|axis| axis as i32))
    }

    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "limited to 16 bits just before"
    )]
    fn vertex(
        &self,
        (light, toward): &Self::Prepared,
        vertex: VertexInput<'_, Normal>,
    ) -> Corner<Self::Varying> {
        let [x, y, z] = vertex.attributes.map(i32::from);
        let facing = (x * toward[0] + y * toward[1] + z * toward[2]).abs();
        let dense = RIM - (RIM - CLEAR) / 128 * facing / 127;
        let color = self.light.color(light, vertex);
        // Highlights are on the glass, not in it.
        let bright = color.channels().into_iter().min().unwrap_or(0);
        let alpha = dense.max(i32::from(bright)).clamp(0, 0xFFFF);
        (color.into(), alpha as u16)
    }

    fn fragment(&self, _: &Self::Prepared, (color, alpha): &Self::Varying) -> Option<Color> {
        Some(color.color().with_alpha((alpha.get() >> 8) as u8))
    }
}
