//! Tilted planes by how often w is larger at their far edge than at the near one, and a floor that
//! reaches from behind the eye to near the horizon.

use microraster::math::{Angle, Mat4, Vec3};
use microraster::shade::FogPlace;
use microraster::{
    Adaptive, Affine, AtFragments, AtVertices, Color, Corner, DrawContext, Every, Exact, Flat, Fog,
    Fogged, Gouraud, Less, Pass, Perspective, PerspectiveMode, Rgb, Shader, SmoothColor, Stats,
    Textured, VertexInput,
};

use super::texture::{ByBilinear, ByFineBilinear, ByMipBilinear, ByMipNearest, ByNearest, Reading};
use super::{case, knob, Shape};
use crate::scenes::standard::{camera, facts, frame, measured};
use crate::scenes::{Facts, Probe, Scene, Stage};

/// A rectangle that leans back.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plane {
    /// Half its width.
    half: f32,
    /// Height and depth of its near and of its far edge.
    near: (f32, f32),
    far: (f32, f32),
    /// Repeats of the texture across and along.
    repeats: (i16, i16),
    /// One repeat is so many units: 2 to this.
    pub(crate) unit_bits: u32,
    /// How far it is turned in the picture, in degrees: where w changes along rows, perspective has
    /// to be corrected.
    turn: f32,
}

const fn plane(
    half: f32,
    near: (f32, f32),
    far: (f32, f32),
    repeats: (i16, i16),
    unit_bits: u32,
) -> Plane {
    Plane { half, near, far, repeats, unit_bits, turn: 65.0 }
}

/// By the number in their scenes' names; the last is the floor, which is level.
pub(crate) static PLANES: [Plane; 6] = [
    plane(0.5, (-0.38, -1.0), (0.38, -1.0), (1, 1), 12),
    plane(0.7, (-0.38, -1.0), (0.76, -2.0), (1, 2), 12),
    plane(1.0, (-0.38, -1.0), (1.52, -4.0), (2, 3), 12),
    plane(1.6, (-0.38, -1.0), (3.8, -10.0), (3, 7), 12),
    plane(3.5, (-0.38, -1.0), (19.0, -50.0), (7, 24), 10),
    Plane { turn: 0.0, ..plane(60.0, (-0.6, 2.0), (-0.6, -100.0), (48, 40), 9) },
];

/// Half of what the positions of a plane span.
const REACH: i16 = 1 << 14;

static POSITIONS: [[i16; 3]; 4] = [
    [-REACH, -REACH, REACH],
    [REACH, -REACH, REACH],
    [REACH, REACH, -REACH],
    [-REACH, REACH, -REACH],
];
static INDICES: [u16; 6] = [0, 1, 2, 0, 2, 3];
/// Colours at the corners, where no texture is asked for.
pub(crate) static COLORS: [Rgb; 4] =
    [Rgb::new(255, 40, 40), Rgb::new(40, 255, 40), Rgb::new(40, 40, 255), Rgb::new(255, 255, 120)];

impl Plane {
    pub(crate) fn shape(&self) -> Shape<'static> {
        let ((y, z), (far_y, far_z)) = (self.near, self.far);
        let reach = f32::from(REACH);
        // From the far edge to the near one z grows as positions do.
        let scale = Vec3::new(self.half, (far_y - y) * 0.5, (z - far_z) * 0.5) * (1.0 / reach);
        let offset = Vec3::new(0.0, (y + far_y) * 0.5, (z + far_z) * 0.5);
        let model = Mat4::rotation_z(Angle::from_degrees(self.turn));
        Shape { positions: &POSITIONS, indices: &INDICES, scale, offset, model }
    }

    /// Places in the texture, in units.
    pub(crate) fn places(&self) -> [[i16; 2]; 4] {
        let unit = 1_i16 << self.unit_bits;
        let (right, down) = (self.repeats.0 * unit, self.repeats.1 * unit);
        [[0, down], [right, down], [right, 0], [0, 0]]
    }
}

/// Draws plane number `I` by a shader, with depth.
fn draw<P: Probe, A, S: Shader<Vertex = A>, const I: usize>(
    stage: &mut Stage<'_>,
    probe: &mut P,
    shader: &S,
    attributes: &[A],
) -> Facts {
    let (Some(plane), Ok(mut frame)) = (PLANES.get(I), frame(stage.color, stage.depth)) else {
        return facts(0);
    };
    let (camera, shape) = (camera(), plane.shape());
    let mesh = shape.mesh(attributes);
    measured!(probe, Pass::new(&camera).depth(Less), |pass| pass.draw(
        &mut frame,
        &shape.model,
        &mesh,
        shader
    ));
    facts(2)
}

/// A textured plane.
fn textured<P, M, R, const I: usize>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts
where
    P: Probe,
    M: PerspectiveMode + Default,
    R: Reading,
{
    let Some(plane) = PLANES.get(I) else { return facts(0) };
    match R::sampler(plane.unit_bits) {
        Some(sampler) => {
            let shader = Textured::new(sampler).perspective(M::default());
            draw::<P, _, _, I>(stage, probe, &shader, &plane.places().map(|place| ((), place)))
        }
        None => facts(0),
    }
}

/// The colours that the mesh holds, in perspective.
struct Colored<M>(M);

impl<M: PerspectiveMode> Shader for Colored<M> {
    type Vertex = Rgb;
    type Varying = Perspective<SmoothColor, M>;
    type Prepared = ();

    fn prepare(&self, _draw: &DrawContext) {}

    fn vertex(&self, (): &(), vertex: VertexInput<'_, Rgb>) -> Corner<Self::Varying> {
        let color: Color = (*vertex.attributes).into();
        color.into()
    }

    #[inline(always)]
    fn fragment(&self, (): &(), color: &Self::Varying) -> Option<Color> {
        Some((**color).color())
    }
}

fn colored<P, M, const I: usize>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts
where
    P: Probe,
    M: PerspectiveMode + Default,
{
    draw::<P, _, _, I>(stage, probe, &Colored(M::default()), &COLORS)
}

fn linear<P: Probe, const I: usize>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    draw::<P, _, _, I>(stage, probe, &Gouraud::colored(), &COLORS)
}

/// The floor's colour is constant; all that changes is fog.
pub(crate) const GROUND: Rgb = Rgb::new(60, 110, 40);
pub(crate) const HAZE: Rgb = Rgb::new(210, 220, 230);
/// How soon fog hides the floor.
pub(crate) const DENSITY: f32 = 0.05;

fn fogged<P: Probe, A: FogPlace>(stage: &mut Stage<'_>, probe: &mut P, place: A) -> Facts {
    let fog = Fog::exponential_squared(HAZE, DENSITY);
    let shader = Fogged::new(Flat::solid(GROUND), fog).at(place);
    draw::<P, _, _, 5>(stage, probe, &shader, &[(); 4])
}

/// Every way of perspective on one plane.
macro_rules! perspective {
    ($scene:literal, $number:literal) => {
        knob!($scene, "perspective",
            "affine" => textured::<P, Affine, ByNearest, $number>,
            "every-32" => textured::<P, Every<32>, ByNearest, $number>,
            "every-16" => textured::<P, Every<16>, ByNearest, $number>,
            "every-8" => textured::<P, Every<8>, ByNearest, $number>,
            "adaptive" => textured::<P, Adaptive, ByNearest, $number>,
            "exact" => textured::<P, Exact, ByNearest, $number>,
        )
    };
}

/// The ways of perspective that are worth comparing, each with every way of reading the texture.
macro_rules! pairs {
    ($scene:literal, $number:literal, $($reading:literal => $type:ty),+ $(,)?) => {
        [$(
            case(concat!($scene, "/perspective+filter=affine+", $reading),
                textured::<P, Affine, $type, $number>),
            case(concat!($scene, "/perspective+filter=every-16+", $reading),
                textured::<P, Every<16>, $type, $number>),
            case(concat!($scene, "/perspective+filter=adaptive+", $reading),
                textured::<P, Adaptive, $type, $number>),
            case(concat!($scene, "/perspective+filter=exact+", $reading),
                textured::<P, Exact, $type, $number>),
        )+]
    };
}

macro_rules! filters {
    ($scene:literal, $number:literal) => {
        pairs!($scene, $number,
            "nearest" => ByNearest,
            "bilinear" => ByBilinear,
            "fine-bilinear" => ByFineBilinear,
            "mip-nearest" => ByMipNearest,
            "mip-bilinear" => ByMipBilinear,
        )
    };
}

macro_rules! colors {
    ($scene:literal, $number:literal) => {
        knob!($scene, "colour",
            "linear" => linear::<P, $number>,
            "every-16" => colored::<P, Every<16>, $number>,
            "adaptive" => colored::<P, Adaptive, $number>,
            "exact" => colored::<P, Exact, $number>,
        )
    };
}

/// Planes by every way of perspective; two of them by every filter, and two in colours.
pub(crate) fn cases<P: Probe>() -> impl Iterator<Item = Scene<P>> {
    let ways = [
        perspective!("plane-1", 0),
        perspective!("plane-2", 1),
        perspective!("plane-4", 2),
        perspective!("plane-10", 3),
        perspective!("plane-50", 4),
        perspective!("floor", 5),
    ];
    let pairs = [filters!("plane-4", 2), filters!("floor", 5)];
    let colors = [colors!("plane-4", 2), colors!("plane-10", 3)];
    let fogs = knob!("floor", "fog",
        "vertices" => |stage, _, probe| fogged(stage, probe, AtVertices),
        "fragments" => |stage, _, probe| fogged(stage, probe, AtFragments),
    );
    ways.into_iter()
        .flatten()
        .chain(pairs.into_iter().flatten())
        .chain(colors.into_iter().flatten())
        .chain(fogs)
}
