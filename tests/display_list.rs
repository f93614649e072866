//! Recorded triangles: the same bits as drawing the mesh, in bands of any height and order, and
//! errors instead of wrong pictures.
#![cfg(feature = "std")]
#![allow(clippy::expect_used, reason = "a picture that cannot be drawn is a failure")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "random numbers are cut to what is wanted"
)]
#![allow(dead_code, reason = "the scenes serve other tests too")]

#[path = "support/choices.rs"]
mod choices;
#[path = "support/scene_parts.rs"]
mod scene_parts;
mod support;

use choices::Choices as _;
use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::models::TEAPOT;
use microraster::{
    AnyDepthState, AnyStencil, AtFragments, Bands, BlinnPhong, Camera, Color, Consecutive, Corner,
    Cull, DisplayList, DrawContext, Every, Exact, Flat, FlatColor, Fog, Fogged, Frame, Gouraud,
    Less, Light, ListError, ListTriangle, ListVertex, Mesh, Pass, Perspective, Phong, Rect, Rgb,
    Rgb565, Scalar, Shader, Size, SmoothColor, Stats, Stenciled, Textured, Topology, TriangleStrip,
    VertexCache, VertexInput,
};
use scene_parts::{float, matrix, output, vector, Kit, Tests};
use support::Random;

type State = Stenciled<AnyDepthState, AnyStencil>;

/// A random draw of a mesh, and the picture it is in.
#[derive(Clone, Copy, Debug)]
struct Draw {
    random: Random,
    tame: bool,
    size: Size,
    rows: u16,
}

/// Room of a list: for everything, or for less.
#[derive(Clone, Copy, Debug)]
struct Room {
    vertices: usize,
    triangles: usize,
    bands: usize,
}

const ENOUGH: Room = Room { vertices: 800, triangles: 300, bands: 64 };

/// What bands and the whole frame show, and what recording said.
struct Seen {
    whole: Vec<u16>,
    banded: Vec<u16>,
    stats: Stats,
    recorded: Result<(u32, u32), ListError>,
}

impl Draw {
    fn new(random: &mut Random) -> Self {
        let height = random.range(1, 50) as u16;
        let size = Size::new(random.range(2, 70) as u16, height);
        let rows = random.one_of(&[1, 2, 3, 5, 7, 16, 17, height]).min(height);
        Self { random: Random(random.next()), tame: random.range(0, 3) > 0, size, rows }
    }

    /// Draws a mesh into a whole frame and, recorded, into bands.
    fn through<H: Shader, T: Topology<Primitive = [u32; 3]>>(
        &self,
        mesh: &Mesh<'_, H::Vertex, T>,
        shader: &H,
        room: Room,
    ) -> Seen {
        let (random, tame) = (&mut self.random.clone(), self.tame);
        let camera = match random.range(0, 2) {
            0 => Camera::custom(matrix(random, tame)),
            1 => Camera::perspective(60.0.degrees(), 0.5).far(float(random, tame)),
            _ => Camera::perspective(60.0.degrees(), 0.1 + random.unit() as f32),
        };
        let camera = camera.look_at(vector(random, tame), Vec3::new(0.0, 0.0, -3.0), Vec3::Y);
        let model = matrix(random, tame);
        let (blend, dither, mask) = output(random);
        let (mut drawn, mut recorded) = (Stats::default(), Stats::default());
        let pass = Pass::new(&camera)
            .cull(scene_parts::cull(random))
            .front_face(scene_parts::front(random))
            .depth(State::choose(random))
            .blend(blend)
            .dither(dither)
            .color_mask(mask);
        let pass = if random.is_one_in(5) {
            let mut corner = || random.range(-90, 90);
            pass.viewport(Rect::new(corner(), corner(), corner(), corner()))
        } else {
            pass
        };
        let (background, code) = (Rgb::new(90, 60, 30), 20_000);
        let whole = self.in_bands(self.size.height, |frame| {
            frame.clear(background);
            frame.clear_depth(code);
            pass.count(&mut drawn).draw(frame, &model, mesh, shader);
        });
        let mut vertices = vec![ListVertex::default(); room.vertices];
        let mut triangles = vec![ListTriangle::default(); room.triangles];
        let mut numbers = vec![0; room.bands];
        let list = DisplayList::new(&mut vertices, &mut triangles, &mut numbers);
        let mut cache = VertexCache::<u16, 8>::new();
        let mut recording =
            pass.count(&mut recorded).record(list, self.size, &model, mesh, shader, &mut cache);
        let said = recording.check().map(|()| (recording.vertices(), recording.triangles()));
        let banded = self.in_bands(self.rows, |frame| {
            frame.clear(background);
            frame.clear_depth(code);
            let mut pass = pass;
            pass.replay_or_draw(frame, &mut recording, &model, mesh, shader);
        });
        let shared = self.in_bands(self.rows, |frame| {
            frame.clear(background);
            frame.clear_depth(code);
            let mut pass = pass;
            assert_eq!(pass.replay_shared(frame, &recording), recording.check(), "{self:?}");
        });
        let nothing = || {
            self.in_bands(self.rows, |frame| {
                frame.clear(background);
                frame.clear_depth(code);
            })
        };
        let expected = if said.is_ok() { whole.clone() } else { nothing() };
        assert!(shared == expected, "shared: {self:?}");
        assert_eq!(recorded.triangles, drawn.triangles, "each once: {self:?}");
        assert_eq!(recorded.culled, drawn.culled, "{self:?}");
        assert_eq!(recorded.clipped, drawn.clipped, "{self:?}");
        // A box may hold a pixel that its triangle does not cover.
        let seen = |stats: &Stats| stats.outside + stats.skipped + stats.drawn;
        assert_eq!(seen(&recorded), seen(&drawn), "{self:?}");
        assert!(recorded.outside <= drawn.outside, "all that is drawn is recorded: {self:?}");
        Seen { whole, banded, stats: drawn, recorded: said }
    }
}

/// A number of each corner, in perspective: w is what tells a triangle's corners apart where they
/// have one attribute.
struct Numbered;

impl Shader for Numbered {
    type Vertex = Rgb;
    type Varying = Perspective<Scalar, Exact>;
    type Prepared = ();

    fn prepare(&self, _: &DrawContext) {}

    fn vertex(&self, (): &(), input: VertexInput<'_, Rgb>) -> Corner<Self::Varying> {
        u16::from_le_bytes([input.attributes.r, input.attributes.g]).into()
    }

    fn fragment(&self, (): &(), number: &Self::Varying) -> Option<Color> {
        let [low, high] = number.get().to_le_bytes();
        Some(Color::new(low << 3, high, low))
    }
}

/// Half of the colour of the corner that provokes, half of what lies between all three.
struct Mixed;

impl Shader for Mixed {
    type Vertex = Rgb;
    type Varying = (FlatColor, SmoothColor);
    type Prepared = ();

    fn prepare(&self, _: &DrawContext) {}

    fn vertex(&self, (): &(), input: VertexInput<'_, Rgb>) -> (Color, Color) {
        let color = Color::from(*input.attributes);
        (color, color)
    }

    fn fragment(&self, (): &(), (flat, smooth): &Self::Varying) -> Option<Color> {
        let (flat, smooth) = (flat.color(), smooth.color());
        let half = |a: u8, b: u8| (a >> 1) + (b >> 1);
        Some(Color::new(
            half(flat.red(), smooth.red()),
            half(flat.green(), smooth.green()),
            half(flat.blue(), smooth.blue()),
        ))
    }
}

type Full<'a> = Frame<'a, Rgb565, microraster::StencilBuffer<'a, microraster::DepthBuffer<'a>>>;

impl Draw {
    /// What bands of so many rows show of a scene.
    fn in_bands(&self, rows: u16, mut scene: impl FnMut(&mut Full<'_>)) -> Vec<u16> {
        let length = usize::from(self.size.width) * usize::from(rows);
        let (mut pixels, mut codes) = (vec![0; length], vec![0; length]);
        let mut values = vec![0; length];
        let bands = Bands::<Rgb565>::new(&mut pixels, self.size)
            .and_then(|bands| bands.with_depth(&mut codes)?.with_stencil(&mut values));
        let mut sent = Vec::new();
        let all = bands.expect("buffers of so many rows").draw::<()>(
            |frame| scene(frame),
            |band| {
                sent.extend_from_slice(band.pixels());
                Ok(())
            },
        );
        assert_eq!(all, Ok(()), "nothing fails");
        sent
    }

    /// One of many shaders.
    fn any(&self, room: Room) -> Seen {
        let random = &mut Random(self.random.0 ^ 0x5555);
        let kit = Kit::new(random, self.tame);
        let (scale, offset) = kit.place;
        let strip = TriangleStrip::new(Consecutive::new(kit.positions.len()));
        let bare = Mesh::new(&kit.positions, &kit.colors).placed(scale, offset);
        let lit = Mesh::new(&kit.positions, &kit.normals).placed(scale, offset);
        let textured = Mesh::new(&kit.positions, &kit.places).placed(scale, offset);
        let textured = textured.with_topology(strip);
        let sampler = kit.sampler();
        let fog = Fog::linear(Rgb::BLUE, float(random, self.tame), float(random, self.tame));
        let sun = Light::directional(vector(random, self.tame), Rgb::WHITE);
        match random.range(0, 11) {
            0 => self.through(&bare.with_topology(strip), &Gouraud::colored(), room),
            1 => self.through(&bare.indexed(&kit.indices), &Gouraud::colored(), room),
            2 => self.through(&bare.indexed(&kit.indices), &Flat::colored(), room),
            3 => self.through(&bare.with_topology(strip), &Mixed, room),
            4 => self.through(&bare.by_face().with_topology(strip), &Flat::colored(), room),
            5 => self.through(&textured, &Textured::new(sampler), room),
            6 => self.through(&textured, &Textured::new(sampler).perspective(Exact), room),
            7 => self.through(&textured, &Textured::new(sampler).perspective(Every::<8>), room),
            8 => {
                let shader = Fogged::new(Gouraud::colored(), fog).at(AtFragments);
                self.through(&bare.with_topology(strip), &shader, room)
            }
            9 => {
                self.through(&lit.with_topology(strip), &Phong::new(BlinnPhong::new(&[sun])), room)
            }
            10 => self.through(&bare.by_face().with_topology(strip), &Numbered, room),
            // Fewer attributes than vertices: of some triangles a corner has none.
            _ => {
                let short = &kit.colors[..kit.colors.len() - 1];
                let mesh = Mesh::new(&kit.positions, short).placed(scale, offset);
                if random.is_one_in(2) {
                    self.through(&mesh.with_topology(strip), &Flat::colored(), room)
                } else {
                    self.through(&mesh.with_topology(strip), &Mixed, room)
                }
            }
        }
    }
}

#[test]
fn recorded_meshes_are_the_same_in_bands_of_any_height() {
    let mut random = Random(17);
    let (mut pixels, mut clipped, mut triangles) = (0, 0, 0);
    for _ in 0..6000 {
        let draw = Draw::new(&mut random);
        let seen = draw.any(ENOUGH);
        assert!(seen.whole == seen.banded, "{draw:?}: {:?}", seen.recorded);
        let (_, recorded) = seen.recorded.expect("room for everything");
        pixels += seen.stats.pixels;
        clipped += seen.stats.clipped;
        triangles += recorded;
    }
    assert!(
        pixels > 50_000 && clipped > 2000 && triangles > 3000,
        "{pixels} {clipped} {triangles}"
    );
}

#[test]
fn a_list_that_is_too_short_is_an_error_with_what_it_takes_and_never_a_wrong_picture() {
    let mut random = Random(18);
    let mut full = 0;
    for _ in 0..1500 {
        let draw = Draw::new(&mut random);
        let needed = draw.any(ENOUGH).recorded.expect("room for everything");
        let (vertices, triangles) = needed;
        let exact = Room { vertices: vertices as usize, triangles: triangles as usize, bands: 64 };
        let seen = draw.any(exact);
        assert_eq!(seen.recorded, Ok(needed), "as much as it takes: {draw:?}");
        assert!(seen.whole == seen.banded, "{draw:?}");
        if triangles == 0 {
            continue;
        }
        full += 1;
        let error = Err(ListError::Full { vertices, triangles });
        for room in [
            Room { vertices: exact.vertices - 1, ..exact },
            Room { triangles: exact.triangles - 1, ..exact },
            Room { vertices: 0, triangles: 0, bands: 64 },
        ] {
            let seen = draw.any(room);
            assert_eq!(seen.recorded, error, "{room:?}: {draw:?}");
            assert!(seen.whole == seen.banded, "{room:?}: {draw:?}");
        }
        // Recorded, but there are too few numbers for bands.
        let seen = draw.any(Room { bands: 0, ..exact });
        assert!(seen.whole == seen.banded, "no bands: {draw:?}");
    }
    assert!(full > 200, "{full} lists are too few");
}

#[test]
fn what_was_too_short_comes_back_and_serves_a_smaller_mesh() {
    let (mut vertices, mut triangles) = ([ListVertex::default(); 20], [ListTriangle::BLANK; 20]);
    let list = DisplayList::new(&mut vertices, &mut triangles, &mut []);
    let (picture, camera) = (Size::new(64, 48), Camera::perspective(45.0.degrees(), 0.5));
    let away = Mat4::translation(Vec3::new(0.0, 0.0, -5.0));
    let shader = Gouraud::lit(&[Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::WHITE)]);
    let (mut pass, mut cache) = (Pass::new(&camera), VertexCache::<u16, 64>::new());

    let recording = pass.record(list, picture, &away, &TEAPOT, &shader, &mut cache);
    let needed = (recording.vertices(), recording.triangles());
    assert!(needed.0 > 400 && needed.1 > 400, "{needed:?} is no teapot");
    let error = Err(ListError::Full { vertices: needed.0, triangles: needed.1 });
    assert_eq!(recording.check(), error, "twenty are too few");
    assert_eq!(recording.bounds(), Rect::from_size(picture), "anywhere in the picture");

    let normals = [[0, 0, 127]; 3];
    let mesh = Mesh::new(&[[0, 0, 0], [1, 0, 0], [0, 1, 0]], &normals);
    let list = recording.into_list();
    let recording = pass.record(list, picture, &away, &mesh, &shader, &mut cache);
    assert_eq!((recording.check(), recording.triangles()), (Ok(()), 1), "room for one");
}

/// The teapot, recorded for a picture of 64x48 pixels.
fn teapot<R>(numbers: usize, then: impl FnOnce(&mut dyn FnMut(u16, u16, Size) -> Band) -> R) -> R {
    let (picture, model) = (Size::new(64, 48), Mat4::rotation_y(25.0.degrees()));
    let camera = Camera::perspective(45.0.degrees(), 0.5).look_at(
        Vec3::new(0.0, 2.4, 5.4),
        Vec3::ZERO,
        Vec3::Y,
    );
    let shader = Gouraud::lit(&[Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::WHITE)]);
    let (mut vertices, mut triangles) =
        ([ListVertex::default(); 700], [ListTriangle::default(); 700]);
    let (mut numbers, mut cache) = (vec![0; numbers], VertexCache::<u16, 1024>::new());
    let list = DisplayList::new(&mut vertices, &mut triangles, &mut numbers);
    let mut pass = Pass::new(&camera).cull(Cull::Back).depth(Less);
    let mut recording = pass.record(list, picture, &model, &TEAPOT, &shader, &mut cache);
    let mut draw = |first: u16, rows: u16, picture: Size| {
        let both = [(); 2].map(|()| vec![0; 64 * usize::from(rows)]);
        let [(mut pixels, mut codes), (mut again, mut again_codes)] =
            [(both[0].clone(), both[1].clone()), (both[0].clone(), both[1].clone())];
        let size = Size::new(picture.width, rows);
        let frame = Frame::<Rgb565>::new(&mut pixels, size)
            .and_then(|frame| frame.with_depth(&mut codes)?.band(first, picture.height));
        let replayed = pass.replay(&mut frame.expect("a band"), &mut recording);
        let frame = Frame::<Rgb565>::new(&mut again, size)
            .and_then(|frame| frame.with_depth(&mut again_codes)?.band(first, picture.height));
        pass.draw(&mut frame.expect("a band"), &model, &TEAPOT, &shader);
        let (mut shared_pixels, mut shared_codes) = both.into();
        let frame = Frame::<Rgb565>::new(&mut shared_pixels, size)
            .and_then(|frame| frame.with_depth(&mut shared_codes)?.band(first, picture.height));
        let shared = pass.replay_shared(&mut frame.expect("a band"), &recording);
        assert_eq!(shared.is_ok(), shared_pixels == again, "all of it, or an error");
        let empty = pixels.iter().all(|pixel| *pixel == 0);
        Band { replayed, shared, same: pixels == again, empty }
    };
    then(&mut draw)
}

/// What became of a band.
#[derive(Debug, PartialEq)]
struct Band {
    replayed: Result<(), ListError>,
    /// What replaying from a shared recording said.
    shared: Result<(), ListError>,
    /// Whether it is what drawing the mesh makes.
    same: bool,
    empty: bool,
}

#[test]
fn bands_may_come_in_any_order_and_of_any_height() {
    let picture = Size::new(64, 48);
    teapot(48, |draw| {
        let mut random = Random(19);
        for step in 0..400 {
            let rows = random.range(1, 48) as u16;
            let first = random.range(0, 48 - i32::from(rows)) as u16;
            let band = draw(first, rows, picture);
            assert!(band.replayed.is_ok() && band.same, "{step}: {first}, {rows}: {band:?}");
            // And the one behind it, as a program would go on.
            let next = first + rows;
            if next + rows <= 48 {
                let band = draw(next, rows, picture);
                assert!(band.replayed.is_ok() && band.same, "{step}: {next}, {rows}: {band:?}");
            }
        }
        // The same band again.
        for _ in 0..3 {
            let band = draw(20, 8, picture);
            assert!(band.replayed.is_ok() && band.same && !band.empty, "{band:?}");
        }
    });
}

#[test]
fn what_cannot_be_replayed_is_refused_and_draws_nothing() {
    teapot(5, |draw| {
        let band = draw(0, 8, Size::new(64, 48));
        let error = Err(ListError::Bands { needed: 6, got: 5 });
        assert!(band.replayed == error && band.empty, "{band:?}");
        assert!(band.shared.is_ok(), "needs no numbers of bands: {band:?}");
        let band = draw(8, 8, Size::new(64, 48));
        assert!(band.replayed.is_ok() && band.same, "five are left: {band:?}");
        let other = Size::new(64, 47);
        let error = Err(ListError::Picture { needed: Size::new(64, 48), got: other });
        let band = draw(0, 16, other);
        assert!(band.replayed == error && band.empty, "{band:?}");
        assert_eq!(band.shared, error, "another picture");
    });
}

#[test]
fn meshes_one_after_the_other_share_the_memory_of_a_list() {
    const PICTURE: Size = Size::new(80, 60);
    let camera = Camera::perspective(45.0.degrees(), 0.5).look_at(
        Vec3::new(0.0, 2.0, 5.0),
        Vec3::ZERO,
        Vec3::Y,
    );
    let sun = Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::WHITE);
    let models = [Mat4::rotation_y(30.0.degrees()), Mat4::rotation_x(80.0.degrees())];
    let (smooth, flat) = (Gouraud::lit(&[sun]), Flat::lit(&[sun]));
    let mut pass = Pass::new(&camera).cull(Cull::Back).depth(Less);
    let mut whole = vec![0; 80 * 60];
    let mut codes = vec![0; 80 * 60];
    let frame = Frame::<Rgb565>::new(&mut whole, PICTURE).expect("the buffer fits");
    let mut frame = frame.with_depth(&mut codes).expect("the buffer fits");
    pass.draw(&mut frame, &models[0], &TEAPOT, &smooth);
    pass.draw(&mut frame, &models[1], &TEAPOT, &flat);

    let mut record = |vertices: usize, triangles: usize| {
        let mut vertices = vec![ListVertex::<Color>::default(); vertices];
        let mut triangles = vec![ListTriangle::BLANK; triangles];
        let (mut ring, mut other_ring) = ([0; 12], [0; 12]);
        let mut cache = VertexCache::<u16, 512>::new();
        let list = DisplayList::new(&mut vertices, &mut triangles, &mut ring);
        let mut first = pass.record(list, PICTURE, &models[0], &TEAPOT, &smooth, &mut cache);
        first.check()?;
        let rest = first.take_rest(&mut other_ring);
        let mut second = pass.record(rest, PICTURE, &models[1], &TEAPOT, &flat, &mut cache);
        second.check()?;
        let used = (first.vertices() + second.vertices(), first.triangles() + second.triangles());
        let (mut pixels, mut depth) = ([0; 80 * 5], [0; 80 * 5]);
        let bands = Bands::<Rgb565>::new(&mut pixels, PICTURE).expect("rows fit");
        let mut bands = bands.with_depth(&mut depth).expect("rows fit");
        let mut banded = Vec::new();
        let drawn = bands.draw::<ListError>(
            |frame| {
                frame.clear(Rgb::BLACK);
                pass.replay(frame, &mut first).expect("made for this picture");
                pass.replay(frame, &mut second).expect("made for this picture");
            },
            |band| {
                banded.extend_from_slice(band.pixels());
                Ok(())
            },
        );
        assert_eq!(drawn, Ok(()), "nothing fails");
        assert!(banded == whole, "both meshes in bands");
        // Nothing is left of what had no more than it needed, and that is no panic.
        let nothing = second.take_rest(&mut []);
        Ok::<_, ListError>((used, nothing.triangles()))
    };
    let ((vertices, triangles), _) = record(1200, 1200).expect("more than enough");
    assert!(triangles > 500, "{triangles} triangles of both");
    let exact = record(vertices as usize, triangles as usize);
    assert_eq!(exact, Ok(((vertices, triangles), 0)), "no more than both need");
    let short = record(vertices as usize, triangles as usize - 1);
    assert!(matches!(short, Err(ListError::Full { .. })), "{short:?}");
}

#[test]
fn a_list_that_is_given_back_serves_the_next_picture() {
    let (mut vertices, mut triangles) =
        ([ListVertex::default(); 700], [ListTriangle::default(); 700]);
    let (mut numbers, mut cache) = ([0; 12], VertexCache::<u16, 1024>::new());
    let mut list = DisplayList::new(&mut vertices, &mut triangles, &mut numbers);
    let shader = Gouraud::lit(&[Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::WHITE)]);
    let camera = Camera::perspective(45.0.degrees(), 0.5).look_at(
        Vec3::new(0.0, 2.4, 5.4),
        Vec3::ZERO,
        Vec3::Y,
    );
    let mut pass = Pass::new(&camera).cull(Cull::Back).depth(Less);
    for (turn, width, height, rows, drawn) in [
        (0.0, 64, 48, 8_u16, 6),
        (25.0, 48, 64, 8, 3),
        (50.0, 64, 48, 4, 12),
        (75.0, 64, 48, 48, 1),
    ] {
        let (picture, model) = (Size::new(width, height), Mat4::rotation_y(turn.degrees()));
        let mut recording = pass.record(list, picture, &model, &TEAPOT, &shader, &mut cache);
        let band = usize::from(picture.width) * usize::from(rows);
        let [mut pixels, mut codes, mut again, mut again_codes] = [(); 4].map(|()| vec![0; band]);
        let bands = Bands::<Rgb565>::new(&mut pixels, picture);
        let mut bands = bands.and_then(|bands| bands.with_depth(&mut codes)).expect("buffers");
        let whole = Bands::<Rgb565>::new(&mut again, picture);
        let mut whole =
            whole.and_then(|bands| bands.with_depth(&mut again_codes)).expect("buffers");
        // Some leave bands unseen, whose rings the next picture must not find.
        for number in 0..drawn {
            let replayed = bands.draw_band(number, |frame| {
                frame.clear(Rgb::BLACK);
                pass.replay(frame, &mut recording).expect("recorded for it");
            });
            let drawn = whole.draw_band(number, |frame| {
                frame.clear(Rgb::BLACK);
                pass.draw(frame, &model, &TEAPOT, &shader);
            });
            let (replayed, drawn) = (replayed.expect("a band"), drawn.expect("a band"));
            assert!(replayed.pixels() == drawn.pixels(), "band {number} at {turn} degrees");
        }
        list = recording.into_list();
    }
    assert!(list.triangles() > 100, "{} triangles", list.triangles());
}
