//! A mesh with planes of its triangles is the same picture, in every way to draw it.
#![cfg(feature = "std")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::expect_used,
    reason = "random numbers are cut to what is wanted"
)]

mod support;

use microraster::math::{Angle, Mat4, Vec3, Vec4};
use microraster::models::{TEAPOT, TEAPOT_INDICES, TEAPOT_PLANES};
use microraster::{
    Bands, Camera, Cull, DisplayList, FacePlane, FacePlanes, Flat, Frame, IndexedList, Indices,
    Lambert, LastProvoking, Less, Light, ListTriangle, ListVertex, Mesh, Normal, Pass, PlaneScale,
    Rect, Rgb, Rgb565, Size, Stats, Topology, TriangleStrip, VertexCache, Winding, WithPlanes,
};
use support::Random;

const SIZE: Size = Size::new(96, 72);
const PIXELS: usize = 96 * 72;

/// How a mesh is seen.
#[derive(Clone, Copy, Debug)]
struct View {
    camera: Camera,
    model: Mat4,
    cull: Cull,
    front: Winding,
    viewport: Option<Rect>,
}

fn any_view(random: &mut Random) -> View {
    let mut unit = || random.range(-1000, 1000) as f32 / 1000.0;
    let turn = |v: f32| Angle::from_degrees(v * 180.0);
    let at = Vec3::new(unit(), unit(), unit());
    let (x, y, z) = (turn(unit()), turn(unit()), turn(unit()));
    let [near, far, side, wide] = [unit(), unit(), unit(), unit()].map(f32::abs);
    let (left, low) = (unit(), unit());
    // From within the mesh to far away.
    let distance = [0.0, 1.5, 4.0, 8.0, 40.0][random.range(0, 4) as usize];
    let camera = match random.range(0, 4) {
        2 => Camera::custom(
            // Off the axis, and askew.
            Mat4::frustum(left - 1.5, left + 1.0, low - 1.0, low + 1.2, 0.9, Some(60.0))
                * Mat4::from_rows(
                    Vec4::new(1.0, 0.3 * left, 0.2, 0.0),
                    Vec4::new(0.2 * low, 1.0, 0.0, 0.1),
                    Vec4::new(0.0, 0.1, 1.0, 0.0),
                    Vec4::new(0.0, 0.0, 0.0, 1.0),
                ),
        ),
        0 => Camera::orthographic(2.0 + side * 4.0, 0.1, 20.0 + 30.0 * far),
        1 => Camera::perspective(Angle::from_degrees(20.0 + 80.0 * wide), 0.05 + near)
            .far(6.0 + 40.0 * far),
        _ => Camera::perspective(Angle::from_degrees(20.0 + 80.0 * wide), 0.05 + near),
    };
    let mirrored = if random.range(0, 3) == 0 { -1.0 } else { 1.0 };
    let lengths = Vec3::new(mirrored, 0.1 + side, 0.1 + wide);
    let model = Mat4::translation(at + Vec3::new(0.0, 0.0, -distance))
        * Mat4::rotation_x(x)
        * Mat4::rotation_y(y)
        * Mat4::rotation_z(z)
        * Mat4::scale(lengths);
    View {
        camera,
        model,
        cull: [Cull::Back, Cull::Front, Cull::None][random.range(0, 2) as usize],
        front: [Winding::CounterClockwise, Winding::Clockwise][random.range(0, 1) as usize],
        viewport: (random.range(0, 3) == 0).then(|| Rect::new(-20, 10, 60, 90)),
    }
}

impl View {
    fn pass(&self) -> Pass<'_> {
        let pass = Pass::new(&self.camera).cull(self.cull).front_face(self.front);
        match self.viewport {
            Some(viewport) => pass.viewport(viewport),
            None => pass,
        }
    }

    /// The picture, its depth, and what became of the triangles.
    fn draw<T: Topology<Primitive = [u32; 3]>>(
        &self,
        mesh: &Mesh<'_, Normal, T>,
    ) -> (Vec<u16>, Vec<u16>, Stats) {
        let (mut pixels, mut depth) = (vec![0; PIXELS], vec![0; PIXELS]);
        let mut stats = Stats::default();
        let mut frame = Frame::<Rgb565>::new(&mut pixels, SIZE)
            .and_then(|frame| frame.with_depth(&mut depth))
            .expect("buffers are as large as the picture");
        frame.clear(Rgb::BLACK);
        let mut pass = self.pass().depth(Less).count(&mut stats);
        pass.draw(&mut frame, &self.model, mesh, &shader());
        (pixels, depth, stats)
    }

    /// That a mesh is drawn as it is without planes; the triangles that were culled.
    fn compare<T, N>(&self, mesh: &Mesh<'_, Normal, T>, with_planes: &Mesh<'_, Normal, N>) -> u32
    where
        T: Topology<Primitive = [u32; 3]>,
        N: Topology<Primitive = [u32; 3]>,
    {
        let (pixels, depth, plain) = self.draw(mesh);
        let (planes_pixels, planes_depth, planes) = self.draw(with_planes);
        assert!(pixels == planes_pixels && depth == planes_depth, "another picture: {self:?}");
        let seen = |stats: &Stats| {
            let Stats { triangles, drawn, pixels, skipped, clipped, .. } = *stats;
            (
                triangles,
                drawn,
                pixels,
                skipped,
                clipped,
                stats.culled + stats.outside + stats.degenerate,
            )
        };
        assert_eq!(seen(&plain), seen(&planes), "{self:?}");
        assert!(planes.culled >= plain.culled, "planes leave out as culled: {self:?}");
        plain.culled
    }
}

fn shader() -> Flat<Lambert<1>> {
    Flat::lit(&[Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::WHITE)])
}

#[test]
fn a_teapot_is_the_same_from_everywhere() {
    let mut random = Random(501);
    let with_planes = TEAPOT.with_planes(TEAPOT_PLANES);
    let list = IndexedList::new(&TEAPOT_INDICES);
    let last = TEAPOT.with_topology(LastProvoking(WithPlanes::new(list, TEAPOT_PLANES)));
    let culled: u32 = (0..1500)
        .map(|_| {
            let view = any_view(&mut random);
            view.compare(&TEAPOT.with_topology(LastProvoking(list)), &last);
            view.compare(&TEAPOT, &with_planes)
        })
        .sum();
    assert!(culled > 100_000, "{culled} were culled");
}

#[test]
fn triangles_of_all_sizes_are_the_same() {
    let mut random = Random(502);
    let mut culled = 0;
    for _ in 0..1500 {
        let reach = 1 << random.range(2, 15);
        let about: Vec<[i32; 3]> =
            (0..20).map(|_| [(); 3].map(|()| random.range(-32768, 32767))).collect();
        let positions: Vec<[i16; 3]> = (0..60)
            .map(|vertex| {
                let near = about[vertex / 3];
                near.map(|v| (v + random.range(-reach, reach)).clamp(-32768, 32767) as i16)
            })
            .collect();
        let normals: Vec<Normal> = positions.iter().map(|p| p.map(|v| (v >> 8) as i8)).collect();
        // Some share vertices, some are degenerate, some lack vertices; the planes of some are missing.
        let index = |random: &mut Random, at: u16| match random.range(0, 15) {
            0 => random.range(0, 62) as u16,
            _ => at,
        };
        let indices: Vec<u16> = (0..60).map(|at| index(&mut random, at)).collect();
        let mut scale = PlaneScale::of(&positions, &indices);
        if random.range(0, 3) == 0 {
            scale.radius = random.range(0, 2000) as u16;
        }
        let planes: [FacePlane; 20] = scale.bake(&positions, &indices);
        let some = &planes[..random.range(0, 20) as usize];
        let mesh = Mesh::new(&positions, &normals)
            .placed(Vec3::splat(1.0 / 32768.0), Vec3::ZERO)
            .indexed(&indices);
        let view = any_view(&mut random);
        for planes in [&planes, some] {
            culled += view.compare(&mesh, &mesh.with_planes(FacePlanes::new(planes, scale)));
        }
        // A strip, each second of whose triangles is turned.
        let strip = TriangleStrip::new(Indices::new(&indices));
        let corners = |[a, b, c]: [u32; 3]| {
            Some([
                *positions.get(a as usize)?,
                *positions.get(b as usize)?,
                *positions.get(c as usize)?,
            ])
        };
        let of_strip: Vec<FacePlane> = strip
            .iter()
            .map(|three| corners(three).map_or([128; 4], |corners| scale.plane(corners)))
            .collect();
        let mesh = mesh.with_topology(strip);
        culled += view.compare(&mesh, &mesh.with_planes(FacePlanes::new(&of_strip, scale)));
    }
    assert!(culled > 10_000, "{culled} were culled");
}

#[test]
fn recorded_bands_are_the_same() {
    let mut random = Random(503);
    let with_planes = TEAPOT.with_planes(TEAPOT_PLANES);
    let shader = shader();
    for _ in 0..40 {
        let view = any_view(&mut random);
        let (whole, _, _) = view.draw(&TEAPOT);
        let (mut vertices, mut triangles) =
            (vec![ListVertex::default(); 4000], vec![ListTriangle::BLANK; 2000]);
        let (mut numbers, mut cache) = ([0; 9], VertexCache::<u16, 1024>::new());
        let list = DisplayList::new(&mut vertices, &mut triangles, &mut numbers);
        let mut pass = view.pass().depth(Less);
        let mut recording = pass.record(list, SIZE, &view.model, &with_planes, &shader, &mut cache);
        let (mut pixels, mut depth) = ([0; 96 * 8], [0; 96 * 8]);
        let mut bands = Bands::<Rgb565>::new(&mut pixels, SIZE)
            .and_then(|bands| bands.with_depth(&mut depth))
            .expect("buffers of whole rows");
        let mut picture = Vec::new();
        let sent = bands.draw::<()>(
            |frame| {
                frame.clear(Rgb::BLACK);
                pass.replay(frame, &mut recording).expect("the list is long enough");
            },
            |band| {
                picture.extend_from_slice(band.pixels());
                Ok(())
            },
        );
        assert!(sent.is_ok() && picture == whole, "{view:?}");
    }
}
