//! Three turning gears, after Brian Paul's well-known demo: flat teeth, a smooth bore.

use microraster::math::{Angle, AngleUnits, Mat4, Vec3};
use microraster::{
    Camera, Cull, DepthBuffer, Frame, Gouraud, Lambert, Less, Light, Mesh, Normal, Pass,
    RestartIndices, Rgb, Rgb565, Stats, TriangleStrip,
};

/// Draws the gears; `turn` is the red one's angle in degrees, 70 of them a second in the demo.
pub(crate) fn draw(frame: &mut Frame<'_, Rgb565, DepthBuffer<'_>>, turn: f32, stats: &mut Stats) {
    frame.clear(Rgb::new(8, 10, 18));
    // The shorter side of the window is the demo's: 2 at distance 5.
    let camera = Camera::perspective(22.62.degrees(), 5.0);
    let view = Mat4::translation(Vec3::new(0.9, 0.0, -40.0))
        * Mat4::rotation_x(20.0.degrees())
        * Mat4::rotation_y(30.0.degrees());
    let mut gear = |mesh: &Mesh<'_, _, _>, color, x, y, angle: f32| {
        let sun = Light::directional(Vec3::new(-5.0, -5.0, -10.0), Rgb::WHITE);
        let model =
            view * Mat4::translation(Vec3::new(x, y, 0.0)) * Mat4::rotation_z(angle.degrees());
        let shader = Gouraud::new(Lambert::new(&[sun]).material(color));
        let mut pass = Pass::new(&camera).cull(Cull::Back).depth(Less).count(stats);
        pass.draw(frame, &model, mesh, &shader);
    };
    gear(&RED.mesh(), Rgb::new(204, 26, 0), -3.0, -2.0, turn);
    gear(&GREEN.mesh(), Rgb::new(0, 204, 51), 3.1, -2.0, -2.0 * turn - 9.0);
    gear(&BLUE.mesh(), Rgb::new(51, 51, 255), -3.1, 4.2, -2.0 * turn - 25.0);
}

pub(crate) static RED: Gear<{ 20 * VERTICES }, { 20 * INDICES }> = Gear::new(1.0, 4.0, 1.0, 0.7);
static GREEN: Gear<{ 10 * VERTICES }, { 10 * INDICES }> = Gear::new(0.5, 2.0, 2.0, 0.7);
static BLUE: Gear<{ 10 * VERTICES }, { 10 * INDICES }> = Gear::new(1.3, 2.0, 0.5, 0.7);

/// Vertices of a tooth: corners with several normals are several vertices.
const VERTICES: usize = 7 + 7 + 4 * 4 + 4;
/// Indices of a tooth: strips, each with a restart behind it.
const INDICES: usize = 8 + 8 + 4 * 5 + 5;

/// A gear that the compiler made, in flash.
pub(crate) struct Gear<const V: usize, const I: usize> {
    positions: [[i16; 3]; V],
    normals: [Normal; V],
    indices: [u16; I],
    /// What one step of a position is.
    step: f32,
}

impl<const V: usize, const I: usize> Gear<V, I> {
    /// The gear as a mesh: 20 triangles a tooth in strips.
    pub(crate) fn mesh(&self) -> Mesh<'_, Normal, TriangleStrip<RestartIndices<'_, u16>>> {
        Mesh::new(&self.positions, &self.normals)
            .with_topology(TriangleStrip::new(RestartIndices::new(&self.indices)))
            .placed(Vec3::splat(self.step), Vec3::ZERO)
    }

    const fn new(inner: f32, outer: f32, width: f32, depth: f32) -> Self {
        let (r1, r2) = (outer - depth / 2.0, outer + depth / 2.0);
        let step = r2 / 32_767.0;
        let mut maker = Maker { gear: Self::empty(step), vertices: 0, indices: 0 };
        let quarter = 360.0 / (V / VERTICES * 4) as f32;
        let mut tooth = 0;
        while tooth < V / VERTICES {
            // The outline of a tooth: radius, and angle in quarters of a tooth.
            let first = (tooth * 4) as f32;
            let p = [
                polar(r2, (first + 1.0) * quarter),
                polar(r2, (first + 2.0) * quarter),
                polar(r1, first * quarter),
                polar(r1, (first + 3.0) * quarter),
                polar(inner, first * quarter),
                polar(r1, (first + 4.0) * quarter),
                polar(inner, (first + 4.0) * quarter),
            ];
            let half = width / 2.0;
            let mut i = 0;
            while i < 7 {
                maker.vertex(p[i], half, [0.0, 0.0, 1.0]);
                i += 1;
            }
            maker.restart();
            while i > 0 {
                i -= 1;
                maker.vertex(p[i], -half, [0.0, 0.0, -1.0]);
            }
            maker.restart();
            let sides = [(0, 2), (1, 0), (3, 1), (5, 3)];
            while i < 4 {
                let (ahead, behind) = (p[sides[i].0], p[sides[i].1]);
                let out = [ahead[1] - behind[1], behind[0] - ahead[0], 0.0];
                maker.quad([behind, ahead], half, [out, out]);
                i += 1;
            }
            let (from, to) = (p[4], p[6]);
            maker.quad([to, from], half, [[-to[0], -to[1], 0.0], [-from[0], -from[1], 0.0]]);
            tooth += 1;
        }
        maker.gear
    }

    const fn empty(step: f32) -> Self {
        Self { positions: [[0; 3]; V], normals: [[0; 3]; V], indices: [0; I], step }
    }
}

/// A gear as it grows.
struct Maker<const V: usize, const I: usize> {
    gear: Gear<V, I>,
    vertices: usize,
    indices: usize,
}

impl<const V: usize, const I: usize> Maker<V, I> {
    #[allow(clippy::cast_possible_truncation, reason = "within the box, and units times 127")]
    const fn vertex(&mut self, [x, y]: [f32; 2], z: f32, [u, v, w]: [f32; 3]) {
        let step = self.gear.step;
        self.gear.positions[self.vertices] =
            [(x / step) as i16, (y / step) as i16, (z / step) as i16];
        let unit = 127.0 / microraster::math::sqrt(u * u + v * v + w * w);
        self.gear.normals[self.vertices] = [(u * unit) as i8, (v * unit) as i8, (w * unit) as i8];
        self.gear.indices[self.indices] = self.vertices as u16;
        self.vertices += 1;
        self.indices += 1;
    }

    /// Ends a strip.
    const fn restart(&mut self) {
        self.gear.indices[self.indices] = u16::MAX;
        self.indices += 1;
    }

    /// A rectangle across the gear's width, seen from where its normals point to.
    const fn quad(&mut self, [behind, ahead]: [[f32; 2]; 2], half: f32, normals: [[f32; 3]; 2]) {
        self.vertex(behind, -half, normals[0]);
        self.vertex(ahead, -half, normals[1]);
        self.vertex(behind, half, normals[0]);
        self.vertex(ahead, half, normals[1]);
        self.restart();
    }
}

/// A point of the plane by radius and angle.
const fn polar(radius: f32, degrees: f32) -> [f32; 2] {
    let (sin, cos) = Angle::from_degrees(degrees).sin_cos();
    [radius * cos, radius * sin]
}
