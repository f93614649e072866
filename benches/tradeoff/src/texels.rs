//! How far texture coordinates are from where they should be: a shader shows them as colours, all
//! their bits.

use microraster::{
    Adaptive, Affine, Color, Corner, DepthBuffer, DrawContext, Every, Exact, Frame, Less, Pass,
    Perspective, PerspectiveMode, Rgba8888, Shader, Uv, VertexInput,
};

use crate::case::Case;
use crate::errors::Spread;
use crate::scenes::standard::{camera, SIZE};
use crate::scenes::ROOM;
use crate::tradeoff::planes::Plane;
use crate::tradeoff::texture::SIDE;
use crate::truth::planes;

/// Shows the upper 24 bits of u, or of v.
struct Coordinate<M> {
    mode: std::marker::PhantomData<M>,
    is_v: bool,
}

impl<M: PerspectiveMode> Shader for Coordinate<M> {
    type Vertex = [i16; 2];
    type Varying = Perspective<Uv, M>;
    type Prepared = ();

    fn prepare(&self, _: &DrawContext) {}

    fn vertex(&self, (): &(), vertex: VertexInput<'_, [i16; 2]>) -> Corner<Self::Varying> {
        (*vertex.attributes).into()
    }

    fn fragment(&self, (): &(), uv: &Self::Varying) -> Option<Color> {
        let coordinate = if self.is_v { uv.v } else { uv.u };
        let [_, low, middle, high] = coordinate.to_le_bytes();
        Some(Color::new(high, middle, low))
    }
}

type Picture<'a> = Frame<'a, Rgba8888, DepthBuffer<'a>>;

fn draw<M: PerspectiveMode>(plane: &Plane, is_v: bool, picture: &mut Picture<'_>) {
    let (camera, shape) = (camera(), plane.shape());
    let shader = Coordinate::<M> { mode: std::marker::PhantomData, is_v };
    let places = plane.places();
    Pass::new(&camera).depth(Less).draw(picture, &shape.model, &shape.mesh(&places), &shader);
}

/// A coordinate of every pixel in texels; `None` where nothing was drawn.
type Coordinates = Vec<Option<f64>>;

/// Both coordinates, as a mode has them.
fn coordinates(plane: &Plane, mode: &str) -> Option<[Coordinates; 2]> {
    let draw = match mode {
        "affine" => draw::<Affine>,
        "every-8" => draw::<Every<8>>,
        "every-16" => draw::<Every<16>>,
        "every-32" => draw::<Every<32>>,
        "adaptive" => draw::<Adaptive>,
        "exact" => draw::<Exact>,
        _ => return None,
    };
    let texels = f64::from(SIDE) / f64::from(1_u32 << plane.unit_bits);
    let drawn = [false, true].map(|is_v| {
        let (mut words, mut depth) = (vec![0_u32; ROOM], vec![0; ROOM]);
        let mut picture = Frame::new(&mut words, SIZE).ok()?.with_depth(&mut depth).ok()?;
        draw(plane, is_v, &mut picture);
        let coordinate = |(word, code): (&u32, &u16)| {
            let [high, middle, low, _] = word.to_ne_bytes();
            let units = f64::from(i32::from_le_bytes([0, low, middle, high])) / 65_536.0;
            (*code != 0).then_some(units * texels)
        };
        Some(words.iter().zip(&depth).map(coordinate).collect())
    });
    let [u, v] = drawn;
    Some([u?, v?])
}

/// The error of a case's coordinates, the longer of both axes by pixel; `None` for a scene without
/// texture. Where the mesh's coordinates wrap, so does the difference.
pub(crate) fn error(case: &Case) -> Option<Spread> {
    let knob = case.knobs.iter().position(|knob| knob == "perspective")?;
    let (_, plane) = planes::plane_of(&case.scene)?;
    let [u, v] = coordinates(plane, case.settings.get(knob)?)?;
    let exact = planes::texels(&case.scene);
    let whole = f64::from(SIDE) / f64::from(1_u32 << plane.unit_bits) * 65_536.0;
    let off = |drawn: f64, exact: f64| {
        let apart = (drawn - exact).rem_euclid(whole);
        apart.min(whole - apart)
    };
    let both = u.iter().zip(&v).zip(exact);
    Spread::of(both.filter_map(|((u, v), exact)| {
        let [exact_u, exact_v] = exact?;
        Some(off((*u)?, exact_u).max(off((*v)?, exact_v)))
    }))
}
