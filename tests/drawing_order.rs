//! Rows from their last pixel, several pixels at a time, and few pixels one by one, are those of spans
//! drawn from their first.
#![cfg(feature = "std")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::expect_used,
    reason = "random numbers are cut to what is wanted"
)]

mod support;

use fixed::types::I8F8;
use microraster::raster::{BoundingBox, ScreenVertex};
use microraster::texture::{Mirror, Repeat, Replace, Sampler, Texture};
use microraster::{
    Adaptive, AnyMask, AtFragments, Color, ConstantDepth, Corner, Damage, DepthRange, DrawContext,
    Equal, Every, Exact, Flat, Fog, Fogged, Format, Frame, Gouraud, Greater, Invert, Keep, Less,
    LessEqual, PerspectiveCorner, PolygonOffset, ReadOnly, Rect, Rgb, Rgb565, Rgba8888, Row,
    ScreenPass, Shader, Size, SmoothColor, State, Stats, Stencil, Stenciled, Textured, VertexInput,
};
use support::Random;

/// All channels, which only the program knows: pixels are drawn from the first of a row then.
const ALL: AnyMask = AnyMask { red: true, green: true, blue: true };

/// A frame's place in a picture, and its buffers' rows.
#[derive(Clone, Copy, Debug)]
struct Place {
    size: Size,
    first_row: u16,
    picture_height: u16,
    stride: u32,
    depth_stride: u32,
    scissor: Option<Rect>,
}

impl Place {
    fn random(random: &mut Random, wide: bool) -> Self {
        let width = if wide { 8192 } else { random.range(1, 40) as u16 };
        let height = if wide { 2 } else { random.range(1, 20) as u16 };
        let first_row =
            [0, random.range(0, 30), 8192 - i32::from(height)][random.range(0, 2) as usize];
        let first_row = first_row as u16;
        let picture_height = (first_row + height + random.range(0, 3) as u16).min(8192);
        let stride = u32::from(width) + random.range(0, 1) as u32 * 5;
        let depth_stride = if random.range(0, 2) == 0 { u32::from(width) } else { stride };
        let top = i32::from(first_row);
        let scissor = (random.range(0, 2) == 0).then(|| {
            let (x, y) = (random.range(0, i32::from(width)), random.range(0, i32::from(height)));
            Rect::new(x / 3, top + y / 3, x + 1, top + y + 1)
        });
        let size = Size::new(width, height);
        Self { size, first_row, picture_height, stride, depth_stride, scissor }
    }

    /// A corner: small triangles, edges through centres, and now and then far away.
    fn corner(&self, random: &mut Random, about: (i32, i32), reach: i32) -> ScreenVertex {
        let mask = if random.range(0, 1) == 0 { !7 } else { !0 };
        let (x, y) = (random.range(-reach, reach), random.range(-reach, reach));
        let z = [30_000, random.range(0, 65_535), random.range(29_990, 30_010)];
        let z = z[random.range(0, 2) as usize];
        ScreenVertex::from_bits((about.0 + x) & mask, (about.1 + y) & mask, z as u16)
    }

    fn triangles<C: Copy>(
        &self,
        random: &mut Random,
        mut corner: impl FnMut(&mut Random) -> C,
    ) -> Vec<Corners<C>> {
        (0..3)
            .map(|_| {
                let right = i32::from(self.size.width) * 16;
                let (top, height) =
                    (i32::from(self.first_row) * 16, i32::from(self.size.height) * 16);
                let about =
                    (random.range(-16, right + 16), random.range(top - 16, top + height + 16));
                let reach = [20, 40, 200, 8000, 60_000][random.range(0, 4) as usize];
                [(); 3].map(|()| (self.corner(random, about, reach), corner(random)))
            })
            .collect()
    }
}

/// A triangle's places and attributes.
type Corners<C> = [(ScreenVertex, C); 3];

/// Colours, depth, stencil values, counts and damage.
type Drawn<P> = (Vec<P>, Vec<u16>, Vec<u8>, Stats, Rect);

/// What two passes draw, count and announce.
macro_rules! compare {
    ($format:ty, $place:expr, $triangles:expr, $shader:expr, $pass:expr) => {{
        let place: Place = $place;
        let draw = |plain: bool| -> Drawn<<$format as Format>::Raw> {
            let rows = usize::from(place.size.height);
            let mut pixels = vec![7; place.stride as usize * rows];
            let mut codes = vec![20_000; place.depth_stride as usize * rows];
            let mut values = vec![3; place.depth_stride as usize * rows];
            let picture = Size::new(place.size.width, place.picture_height);
            let (mut stats, mut damage) = (Stats::default(), Damage::new(picture));
            // Of the first picture, all is damage.
            damage.next_picture();
            let mut frame = Frame::<$format>::with_stride(&mut pixels, place.size, place.stride)
                .and_then(|frame| frame.with_depth_stride(&mut codes, place.depth_stride))
                .and_then(|frame| frame.with_stencil_stride(&mut values, place.depth_stride))
                .and_then(|frame| frame.band(place.first_row, place.picture_height))
                .expect("buffers are large enough");
            if let Some(scissor) = place.scissor {
                frame.set_scissor(scissor);
            }
            let pass = $pass;
            let shader = $shader;
            if plain {
                let mut pass = pass.count(&mut stats).track_damage(&mut damage);
                pass.triangles(&mut frame, shader, $triangles);
            } else {
                let pass = pass.color_mask(ALL).traversal(BoundingBox);
                let mut pass = pass.count(&mut stats).track_damage(&mut damage);
                pass.triangles(&mut frame, shader, $triangles);
            }
            (pixels, codes, values, stats, damage.area())
        };
        let (one, other) = (draw(true), draw(false));
        assert!(
            one == other,
            "{place:?} {:?}: {} {:?} {:?} against {:?} {:?}",
            $triangles,
            stringify!($pass),
            one.3,
            one.4,
            other.3,
            other.4
        );
        one.3.pixels
    }};
}

fn states<H: Shader>(
    random: &mut Random,
    place: Place,
    triangles: &[Corners<Corner<H::Varying>>],
    shader: &H,
) -> u64
where
    Corner<H::Varying>: core::fmt::Debug,
{
    let pass = ScreenPass::new;
    let stencil = || Stencil::new(Equal, 3).on_pass(Invert).on_fail(Keep);
    u64::from(match random.range(0, 11) {
        0 => compare!(Rgb565, place, triangles, shader, pass()),
        1 => compare!(Rgba8888, place, triangles, shader, pass().depth(Less)),
        2 => compare!(Rgb565, place, triangles, shader, pass().depth(ReadOnly::new(Greater))),
        3 => compare!(Rgb565, place, triangles, shader, pass().depth(ConstantDepth::new(Greater))),
        4 => compare!(
            Rgb565,
            place,
            triangles,
            shader,
            pass().depth(DepthRange::new(Greater, 5000, 40_000))
        ),
        5 => compare!(
            Rgb565,
            place,
            triangles,
            shader,
            pass().depth(PolygonOffset::new(Less, I8F8::ONE, 2))
        ),
        6 => compare!(
            Rgb565,
            place,
            triangles,
            shader,
            pass().depth(Stenciled::new(Greater, stencil()))
        ),
        7 => compare!(
            Rgb565,
            place,
            triangles,
            shader,
            pass().depth(LessEqual).cull(microraster::Cull::Back)
        ),
        8 => compare!(Rgba8888, place, triangles, shader, pass()),
        9 => compare!(
            Rgb565,
            place,
            triangles,
            shader,
            pass().depth(PolygonOffset::new(DepthRange::new(Greater, 5000, 40_000), I8F8::ONE, -2))
        ),
        10 => compare!(Rgba8888, place, triangles, shader, pass().depth(Greater)),
        _ => compare!(Rgb565, place, triangles, shader, pass().depth(Greater)),
    })
}

fn any_color(random: &mut Random) -> Color {
    let [red, green, blue, ..] = random.next().to_le_bytes();
    Rgb::new(red, green, blue).into()
}

#[test]
fn pixels_are_those_of_rows_from_the_first() {
    let mut random = Random(87);
    let texels: Vec<u16> = (0..64).map(|_| random.next() as u16).collect();
    let mut pixels = [0; 6];
    for round in 0..4000 {
        let random = &mut random;
        let place = Place::random(random, round % 199 == 0);
        let kind = round % 6;
        pixels[kind] += match kind {
            0 => {
                let triangles = place.triangles(random, any_color);
                states(random, place, &triangles, &Flat::colored())
            }
            1 => {
                let triangles = place.triangles(random, any_color);
                states(random, place, &triangles, &Gouraud::colored())
            }
            2 => {
                let fog = Fog::linear(Rgb::new(90, 20, 50), 1.0, 9.0);
                let triangles = place.triangles(random, |random| {
                    (
                        any_color(random),
                        PerspectiveCorner::new(random.next() as u16, random.range(1, 1 << 20)),
                    )
                });
                states(
                    random,
                    place,
                    &triangles,
                    &Fogged::new(Flat::colored(), fog).at(AtFragments),
                )
            }
            kind => {
                let (width, height) =
                    [(1, 64), (64, 1), (8, 8), (16, 2), (1, 1)][random.range(0, 4) as usize];
                let texture =
                    Texture::<Rgb565>::new(&texels, width, height).expect("of a power of two");
                let uv = |random: &mut Random| [random.next() as i16, random.next() as i16];
                let triangles = place.triangles(random, |random| {
                    let w = [1, 1000, random.range(1, 1 << 20)][random.range(0, 2) as usize];
                    (any_color(random), PerspectiveCorner::new(uv(random), w))
                });
                if kind == 3 {
                    let sampler =
                        Sampler::bilinear(texture).expect("of a power of two").unit_bits(8);
                    states(random, place, &triangles, &Textured::on(Gouraud::colored(), sampler))
                } else if kind == 4 {
                    let sampler =
                        Sampler::new(texture, microraster::texture::Bilinear, Mirror, Repeat)
                            .expect("of a power of two")
                            .unit_bits(12);
                    let shader = Textured::on(Flat::colored(), sampler);
                    if round % 4 == 0 {
                        states(random, place, &triangles, &shader.environment(Replace))
                    } else {
                        states(random, place, &triangles, &shader.perspective(Every::<8>))
                    }
                } else {
                    let sampler =
                        Sampler::nearest(texture).expect("of a power of two").unit_bits(10);
                    let shader = Textured::on(Gouraud::colored(), sampler);
                    if round % 4 == 1 {
                        states(random, place, &triangles, &shader.perspective(Exact))
                    } else {
                        states(random, place, &triangles, &shader.perspective(Adaptive))
                    }
                }
            }
        };
    }
    assert!(pixels.iter().all(|count| *count > 4000), "{pixels:?}");
}

/// A smooth colour in a pixel loop that begins with the row's first value.
struct FromFirst;

impl Shader for FromFirst {
    type Vertex = ();
    type Varying = SmoothColor;
    type Prepared = ();

    fn prepare(&self, _: &DrawContext) {}

    fn vertex(&self, (): &(), _: VertexInput<'_, ()>) -> Color {
        Color::default()
    }

    fn fragment(&self, (): &(), varying: &SmoothColor) -> Option<Color> {
        Some(varying.color())
    }

    fn span<S: State, F: Format>(&self, (): &(), row: Row<'_, S, F, SmoothColor>) {
        let first = *row.varying();
        row.convert(|_, step| (first, step)).each(|varying| self.fragment(&(), varying));
    }
}

#[test]
fn rows_begin_with_the_value_at_their_first_pixel() {
    let mut random = Random(88);
    let mut pixels = 0;
    for _ in 0..1500 {
        let place = Place::random(&mut random, false);
        let triangles = place.triangles(&mut random, any_color);
        pixels += states(&mut random, place, &triangles, &FromFirst);
    }
    assert!(pixels > 4000, "{pixels}");
}
