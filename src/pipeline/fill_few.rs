use super::fill::{planes, Access, Fill};
use crate::color::Format;
use crate::frame::{DepthAccess, Target};
use crate::raster::{Few, Gradients, Plane, ScreenVertex, Span, Triangle};
use crate::shade::{Corner, DepthTest, Fragments, Row, State, Varying};

/// Corners of a triangle of few pixels in which nothing is interpolated.
pub(super) trait FewCorners {
    /// The triangle's depth, where it has one.
    fn level(&self) -> Option<u16>;

    /// The plane of its depth codes under a test.
    fn depth_plane<V: Varying>(&self, depth: &impl DepthTest) -> Plane;
}

impl FewCorners for Triangle {
    #[inline(always)]
    fn level(&self) -> Option<u16> {
        let [a, b, c] = &self.v;
        (a.z == b.z && a.z == c.z).then_some(a.z)
    }

    #[inline(always)]
    fn depth_plane<V: Varying>(&self, depth: &impl DepthTest) -> Plane {
        Fill::<V>::depth_plane::<true>(self, &Gradients::NONE, depth)
    }
}

/// Corners on the screen, in any order.
impl<C> FewCorners for [(ScreenVertex, C); 3] {
    #[inline(always)]
    fn level(&self) -> Option<u16> {
        let [(a, _), (b, _), (c, _)] = self;
        (a.z == b.z && a.z == c.z).then_some(a.z)
    }

    #[inline(always)]
    fn depth_plane<V: Varying>(&self, depth: &impl DepthTest) -> Plane {
        let [(a, _), (b, _), (c, _)] = self;
        let triangle = oriented([a, b, c]);
        Fill::<V>::depth_plane::<true>(&triangle, &Gradients::NONE, depth)
    }
}

/// A triangle of corners that have an area.
#[inline(never)]
fn oriented([a, b, c]: [&ScreenVertex; 3]) -> Triangle {
    Triangle::oriented([*a, *b, *c]).unwrap_or(Triangle::EMPTY)
}

/// Draws very few pixels of a triangle in which nothing is interpolated, one by one: no span is
/// made and begun. `None` if the frame does not reach so far.
///
/// # Cost
/// On Cortex-M4 some 90 instructions for two pixels, with depth. 110 to 300 bytes of flash a shader
/// and state, more where colours are blended or dithered.
#[inline(never)]
pub(super) fn draw_few<V, H, S, F, D, K>(
    corners: &K,
    provoking: &Corner<V>,
    few: Few,
    target: &mut Target<'_, '_, F, D, Access<S>>,
    state: &mut S,
    shader: &H,
) -> Option<()>
where
    V: Varying,
    H: Fragments<Varying = V>,
    K: FewCorners,
    S: State,
    F: Format,
{
    let Target::Whole(window) = target else { return None };
    let z_plane = if <Access<S>>::HAS_DEPTH {
        let depth = state.parts().0;
        match corners.level() {
            Some(code) if !depth.maps() && depth.offset(0, 0) == 0 => {
                Plane { origin: u32::from(code) << 16 | 0x8000, dx: 0, dy: 0 }
            }
            _ => corners.depth_plane::<V>(depth),
        }
    } else {
        Plane::default()
    };
    let planes = &planes::<V, H, S, F>(&Gradients::NONE, &[*provoking; 3], provoking, false, state);
    let (depth, output, counter) = state.parts();
    let mut window = window.level()?;
    let ((x, mut y), mut covered) = (few.place(), few.covered());
    // Opaque: the compiler would make the sum of products for each column apart.
    let (mut at, mut z) = core::hint::black_box((window.number(x, y), z_plane.at(x, y)));
    loop {
        let mut pixel = |x: i32, at: usize, z: u32| {
            let right = x.wrapping_add(1);
            let span = Span { y, first: x, left: x, right, behind: right };
            let mut runs = V::runs(planes, &span);
            let (varying, step, _) = V::run(planes, &mut runs, &span, x);
            let (pixels, cells) = window.one(at)?;
            shader.span(Row::<S, F, V> {
                x,
                y,
                pixels,
                cells,
                z,
                z_step: z_plane.dx,
                may_be_level: false,
                varying,
                step,
                behind: None,
                depth,
                output,
                counter,
            });
            Some(())
        };
        if covered & 1 != 0 {
            pixel(x, at, z)?;
        }
        if covered & 2 != 0 {
            pixel(x.wrapping_add(1), at.wrapping_add(1), z.wrapping_add(z_plane.dx))?;
        }
        covered >>= 2;
        if covered == 0 {
            return Some(());
        }
        y = y.wrapping_add(1);
        z = z.wrapping_add(z_plane.dy);
        at = at.wrapping_add(window.stride());
        // Not unrolled.
        core::hint::black_box(());
    }
}
