use core::marker::PhantomData;

use super::{
    Adaptive, Corner, DrawContext, Fog, FogDepth, Perspective, PerspectiveMode, Scalar, Shader,
    VertexInput,
};
use crate::color::Color;
use crate::pipeline::Clip;

/// Where a [`Fog`]'s formula is evaluated: [`AtVertices`] or [`AtFragments`].
pub trait FogPlace: Copy {
    /// What is interpolated, of the table's place at a vertex: 0 where the table begins, 65535 where
    /// it ends, and beyond both.
    fn vertex(fog: &Fog, place: i32) -> u16;
    /// How much is seen, of what was interpolated.
    fn seen(fog: &Fog, interpolated: u16) -> u16;
}

/// At vertices: what is seen is interpolated. The cheaper, for triangles that are small beside the
/// way in which the fog grows dense.
///
/// # Measured
/// <!-- tradeoff: floor/fog=vertices -->
/// `vertices` in the scene `floor`: 39.9 (M4F), 64.8 (M0+), 38.2 (RV32) instructions a pixel; PSNR 24.5 dB.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct AtVertices;

/// At fragments: the distance is interpolated. The better where triangles are large.
///
/// # Range
/// Vertices from 4 times the fog's reach before its start (behind the eye) to 12 times beyond it;
/// others count as these.
///
/// # Rounding
/// Distances are resolved to 1/4096 of the fog's reach.
///
/// # Measured
/// <!-- tradeoff: floor/fog=fragments -->
/// `fragments` in the scene `floor`: 62.0 (M4F), 92.9 (M0+), 60.3 (RV32) instructions a pixel; PSNR 43.1 dB.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct AtFragments;

impl FogPlace for AtVertices {
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "limited to 16 bits just before")]
    fn vertex(fog: &Fog, place: i32) -> u16 {
        fog.seen(place.clamp(0, 65_535) as u16)
    }

    #[inline(always)]
    fn seen(_: &Fog, interpolated: u16) -> u16 {
        interpolated
    }
}

/// The word at the fog's start, where distances are interpolated: a sixteenth of the table's places,
/// and four times as many before the start.
const START: i32 = 4 * 4096;

impl FogPlace for AtFragments {
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "limited to 16 bits just before")]
    fn vertex(_: &Fog, place: i32) -> u16 {
        (place >> 4).wrapping_add(START).clamp(0, 65_535) as u16
    }

    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "limited to 12 bits just before")]
    fn seen(fog: &Fog, interpolated: u16) -> u16 {
        // 4096 steps from the start to the end, which is as far as the table goes.
        let place = i32::from(interpolated).wrapping_sub(START).clamp(0, 4095);
        fog.seen((place << 4) as u16)
    }
}

/// A shader seen through [`Fog`].
///
/// Distances come from the mesh's positions; a shader that brings positions of its own is seen as
/// if all lay at the mesh's offset.
#[derive(Clone, Copy, Debug)]
pub struct Fogged<S, A = AtVertices, M = Adaptive> {
    shader: S,
    fog: Fog,
    kind: PhantomData<fn() -> (A, M)>,
}

impl<S> Fogged<S> {
    /// A shader in fog that is evaluated at vertices.
    pub const fn new(shader: S, fog: Fog) -> Self {
        Self { shader, fog, kind: PhantomData }
    }
}

impl<S, A, M> Fogged<S, A, M> {
    /// The fog is evaluated elsewhere.
    #[must_use]
    pub fn at<N: FogPlace>(self, _: N) -> Fogged<S, N, M> {
        Fogged { shader: self.shader, fog: self.fog, kind: PhantomData }
    }

    /// What is interpolated of the fog is corrected in another mode.
    #[must_use]
    pub fn perspective<N: PerspectiveMode>(self, _: N) -> Fogged<S, A, N> {
        Fogged { shader: self.shader, fog: self.fog, kind: PhantomData }
    }
}

impl<S: Shader, A: FogPlace, M: PerspectiveMode> Shader for Fogged<S, A, M> {
    type Vertex = S::Vertex;
    type Varying = (S::Varying, Perspective<Scalar, M>);
    type Prepared = (S::Prepared, FogDepth);

    const OWN_POSITIONS: bool = S::OWN_POSITIONS;

    #[inline(always)]
    fn prepare(&self, draw: &DrawContext) -> Self::Prepared {
        (self.shader.prepare(draw), self.fog.prepare(draw))
    }

    #[inline(always)]
    fn position(&self, (prepared, _): &Self::Prepared, vertex: &S::Vertex) -> Option<Clip> {
        self.shader.position(prepared, vertex)
    }

    #[inline(always)]
    fn vertex(
        &self,
        (prepared, depth): &Self::Prepared,
        vertex: VertexInput<'_, S::Vertex>,
    ) -> Corner<Self::Varying> {
        let fog = A::vertex(&self.fog, depth.of(vertex.position));
        (self.shader.vertex(prepared, vertex), fog.into())
    }

    #[inline(always)]
    fn fragment(
        &self,
        (prepared, _): &Self::Prepared,
        (varying, fog): &Self::Varying,
    ) -> Option<Color> {
        let color = self.shader.fragment(prepared, varying)?;
        Some(self.fog.over(color, A::seen(&self.fog, fog.get())))
    }
}
