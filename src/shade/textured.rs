use core::marker::PhantomData;

use super::{
    Adaptive, Corner, DrawContext, Perspective, PerspectiveMode, PerspectiveVarying, Row, Shader,
    State, Stepped, Unlit, Uv, UvStep, VertexInput,
};
use crate::color::{Color, ColorLanes, Format};
use crate::pipeline::Clip;
use crate::texture::{Environment, Footprint, Modulate, Replace, Sample, Squares};

/// A texture, alone or on what another shader draws.
///
/// `S` is the sampler, `B` the shader under it, `E` how both meet, `M` how often perspective is
/// corrected. A vertex has the attributes of `B` and its place in the texture, u and v.
///
/// ```
/// use microraster::texture::{Bilinear, Clamp, Modulate, Sampler, Texture, TextureError};
/// use microraster::{Every, Gouraud, Rgb565, Textured};
///
/// # fn main() -> Result<(), TextureError> {
/// static CHECKS: [u16; 4] = [0xFFFF, 0xF800, 0xF800, 0xFFFF];
/// let texture = Texture::<Rgb565>::new(&CHECKS, 2, 2)?;
/// // Vertices hold `((), [u, v])`.
/// let plain = Textured::new(Sampler::nearest(texture)?);
/// // Vertices hold `(Rgb, [u, v])`.
/// let lit = Textured::on(Gouraud::colored(), Sampler::new(texture, Bilinear, Clamp, Clamp)?)
///     .perspective(Every::<16>);
/// # let _ = (plain, lit);
/// # Ok(())
/// # }
/// ```
///
/// # Cost
/// That of the sampler, of `B`'s fragment and of the [`Environment`]. Of a mip-map the picture is
/// chosen once a run of pixels.
#[derive(Clone, Copy, Debug)]
pub struct Textured<S, B = Unlit, E = Replace, M = Adaptive> {
    sampler: S,
    surface: B,
    environment: E,
    mode: PhantomData<M>,
}

impl<S: Sample> Textured<S> {
    /// The texture alone.
    pub const fn new(sampler: S) -> Self {
        Self { sampler, surface: Unlit, environment: Replace, mode: PhantomData }
    }
}

impl<S: Sample, B: Shader> Textured<S, B, Modulate> {
    /// The texture multiplied with what `surface` draws.
    pub const fn on(surface: B, sampler: S) -> Self {
        Self { sampler, surface, environment: Modulate, mode: PhantomData }
    }
}

impl<S: Copy, B: Copy, E: Copy, M: Copy> Textured<S, B, E, M> {
    /// The same with another way for texel and surface to meet.
    #[must_use]
    pub const fn environment<F: Environment>(self, environment: F) -> Textured<S, B, F, M> {
        let Self { sampler, surface, mode, .. } = self;
        Textured { sampler, surface, environment, mode }
    }

    /// The same with perspective corrected as `N` says.
    #[must_use]
    pub const fn perspective<N: PerspectiveMode>(self, _mode: N) -> Textured<S, B, E, N> {
        let Self { sampler, surface, environment, .. } = self;
        Textured { sampler, surface, environment, mode: PhantomData }
    }
}

impl<S, B, E, M> Shader for Textured<S, B, E, M>
where
    S: Sample,
    B: Shader,
    E: Environment,
    M: PerspectiveMode,
{
    type Vertex = (B::Vertex, [i16; 2]);
    type Varying = (B::Varying, Perspective<Uv, M>);
    type Prepared = B::Prepared;

    const OWN_POSITIONS: bool = B::OWN_POSITIONS;

    #[inline(always)]
    fn prepare(&self, draw: &DrawContext) -> B::Prepared {
        self.surface.prepare(draw)
    }

    #[inline(always)]
    fn position(&self, prepared: &B::Prepared, (vertex, _): &Self::Vertex) -> Option<Clip> {
        self.surface.position(prepared, vertex)
    }

    #[inline(always)]
    fn vertex(
        &self,
        prepared: &B::Prepared,
        vertex: VertexInput<'_, Self::Vertex>,
    ) -> Corner<Self::Varying> {
        let (attributes, uv) = vertex.attributes;
        let input = VertexInput { attributes, position: vertex.position };
        (self.surface.vertex(prepared, input), (*uv).into())
    }

    /// From the largest picture, where there are several.
    #[inline(always)]
    fn fragment(&self, prepared: &B::Prepared, (surface, uv): &Self::Varying) -> Option<Color> {
        let color = self.surface.fragment(prepared, surface)?;
        Some(self.environment.combine(self.sampler.fetch(uv.u, uv.v)?, color))
    }

    #[inline(always)]
    fn span<T: State, F: Format>(&self, prepared: &B::Prepared, row: Row<'_, T, F, Self::Varying>) {
        let step = <Perspective<Uv, M>>::inner_step(&row.step().1);
        let sampler = self.sampler.level(|| footprint(step));
        if <Perspective<Uv, M>>::LINEAR {
            let row = row.convert_apart(
                |(surface, uv)| (surface, sampler.begin(*uv)),
                |(surface_step, step)| {
                    let UvStep { right, down } = *<Perspective<Uv, M>>::inner_step(&step);
                    (surface_step, UvStep { right: sampler.begun_way(right), down })
                },
            );
            let fragment = |(surface, uv): &(B::Varying, Uv)| {
                let color = self.surface.fragment(prepared, surface)?;
                self.environment.combine_begun(&sampler, *uv, color)
            };
            let mixes = E::IN_LANES.is_some() && <S::Level as Sample>::IN_ROWS;
            if mixes && sampler.mixes(row.step().1.right) {
                return row.each_in_blocks(
                    fragment,
                    |(_, uv), (_, step), mixed| sampler.mix_row(*uv, step.right.u, mixed),
                    |(surface, _), mixed| {
                        let color = self.surface.fragment(prepared, surface)?;
                        let color = (E::IN_LANES == Some(true)).then_some(color);
                        Some(<S::Level as Sample>::show_mixed::<F>(mixed, color))
                    },
                );
            }
            let Some(multiplies) = E::IN_LANES.filter(|_| <S::Level as Sample>::IN_LANES) else {
                return row.each(fragment);
            };
            return row.each_in_lanes(
                fragment,
                |(surface, uv), (surface_step, step), groups| {
                    let (mut surface, mut are_all) = (*surface, true);
                    for Squares { surface: colors, .. } in &mut *groups {
                        *colors = ColorLanes::of(|_| {
                            let color = self.surface.fragment(prepared, &surface);
                            surface.step(surface_step);
                            are_all &= color.is_some();
                            color.unwrap_or_default()
                        });
                    }
                    are_all.then_some(())?;
                    sampler.gather(*uv, step.right, groups)
                },
                |squares| squares.blended::<F>(multiplies),
            );
        }
        row.each(|(surface, uv)| {
            let color = self.surface.fragment(prepared, surface)?;
            Some(self.environment.combine(sampler.fetch(uv.u, uv.v)?, color))
        });
    }
}

/// What a pixel covers of the texture.
#[inline(always)]
const fn footprint(UvStep { right, down }: &UvStep) -> Footprint {
    Footprint { right: [right.u, right.v], down: [down.u, down.v] }
}
