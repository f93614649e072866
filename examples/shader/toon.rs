//! A shader of one's own: light in a few flat tones, as in a comic.

use microraster::math::Vec3;
use microraster::{Color, DrawContext, Format, Normal, Row, Scalar, Shader, State, VertexInput};

/// Tones from the dark side to the bright one, and where the light comes from.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Toon {
    pub(crate) tones: [Color; 4],
    /// Towards the light, in world space, of any length.
    pub(crate) to_light: Vec3,
}

impl Shader for Toon {
    type Vertex = Normal;
    /// The brightness: one number is all that is interpolated.
    type Varying = Scalar;
    /// Towards the light in the model's own space, so that no normal has to be turned.
    type Prepared = [i32; 3];

    #[allow(clippy::cast_possible_truncation, reason = "a unit vector times 4096")]
    fn prepare(&self, draw: &DrawContext) -> [i32; 3] {
        let Vec3 { x, y, z } = draw.model.transpose().transform_vector(self.to_light).normalize();
        [x, y, z].map(|v| (v * 4096.0) as i32)
    }

    #[allow(clippy::cast_possible_truncation, reason = "limited to 16 bits just before")]
    fn vertex(&self, [x, y, z]: &[i32; 3], vertex: VertexInput<'_, Normal>) -> u16 {
        let [nx, ny, nz] = vertex.attributes.map(i32::from);
        // From -127 x 4096, turned away, to 127 x 4096.
        let cosine = x * nx + y * ny + z * nz;
        ((cosine + 127 * 4096) >> 4).clamp(0, 65_535) as u16
    }

    fn fragment(&self, _: &Self::Prepared, brightness: &Scalar) -> Option<Color> {
        self.tones.get(usize::from(brightness.get() >> 14)).copied()
    }
}

/// The same shader, with its tones packed once a row instead of once a pixel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PackedToon(pub(crate) Toon);

impl Shader for PackedToon {
    type Vertex = Normal;
    type Varying = Scalar;
    type Prepared = [i32; 3];

    fn prepare(&self, draw: &DrawContext) -> [i32; 3] {
        self.0.prepare(draw)
    }

    fn vertex(&self, to_light: &[i32; 3], vertex: VertexInput<'_, Normal>) -> u16 {
        self.0.vertex(to_light, vertex)
    }

    fn fragment(&self, prepared: &Self::Prepared, brightness: &Scalar) -> Option<Color> {
        self.0.fragment(prepared, brightness)
    }

    fn span<S: State, F: Format>(&self, _: &Self::Prepared, row: Row<'_, S, F, Scalar>) {
        let tones = self.0.tones.map(F::pack);
        row.each_packed(|brightness| tones.get(usize::from(brightness.get() >> 14)).copied());
    }
}
