//! A wine glass before a wall of colours: blended, and its triangles sorted from far to near.

use microraster::math::{Angle, AngleUnits, Mat4, Vec3};
use microraster::{
    Alpha, Camera, Color, Corner, DepthBuffer, DrawContext, Flat, Frame, Less, Mesh, Normal, Pass,
    ReadOnly, Rgb, Rgb565, Scalar, Shader, Stats, VertexInput,
};

/// Draws the wall, then the glass. `words` is memory to sort in.
pub(crate) fn draw(
    frame: &mut Frame<'_, Rgb565, DepthBuffer<'_>>,
    words: &mut [u32],
    turn: f32,
    stats: &mut Stats,
) {
    frame.clear(Rgb::new(24, 26, 34));
    let camera = Camera::perspective(34.0.degrees(), 0.5).look_at(
        Vec3::new(0.0, 0.75, 5.2),
        Vec3::new(0.0, 0.05, 0.0),
        Vec3::Y,
    );
    let wall = Mesh::new(&WALL, &WALL_COLORS)
        .by_face()
        .placed(Vec3::new(0.75, 0.75, 1.0), Vec3::new(-3.0, -2.25, -1.6));
    Pass::new(&camera).depth(Less).count(stats).draw(
        frame,
        &Mat4::identity(),
        &wall,
        &Flat::colored(),
    );
    let model = Mat4::rotation_z((-6.0).degrees()) * Mat4::rotation_y(turn.degrees());
    let indices = sorted(&(camera.view() * model), words);
    let glass = Mesh::new(&GLASS.positions, &GLASS.normals)
        .indexed(indices)
        .placed(Vec3::splat(GLASS.step), Vec3::ZERO);
    let mut pass = Pass::new(&camera).depth(ReadOnly::new(Less)).blend(Alpha).count(stats);
    pass.draw(frame, &model, &glass, &Glass);
}

/// The glass' indices with the farthest triangle first, in `words`.
fn sorted<'a>(to_eye: &Mat4, words: &'a mut [u32]) -> &'a [u16] {
    let (keys, rest) = words.split_at_mut(TRIANGLES.min(words.len()));
    // What of a position is towards the eye.
    let row = to_eye.transpose().z;
    for (key, (number, corners)) in keys.iter_mut().zip((0..).zip(&GLASS.triangles)) {
        let near: f32 = corners.iter().fold(0.0, |sum, index| {
            let [x, y, z] = GLASS.positions[usize::from(*index)].map(f32::from);
            sum + row.x * x + row.y * y + row.z * z
        });
        // Sums of three positions are within 2^17.
        *key = (near * 0.25 + 32_768.0) as u32 * 0x1_0000 + number;
    }
    keys.sort_unstable();
    let indices: &mut [u16] = bytemuck::cast_slice_mut(rest);
    for (place, key) in indices.chunks_exact_mut(3).zip(&*keys) {
        place.copy_from_slice(&GLASS.triangles[(*key & 0xFFFF) as usize]);
    }
    indices.get(..3 * keys.len()).unwrap_or(&[])
}

/// Clear where one looks straight through, denser and bluer where its wall is seen along.
struct Glass;

impl Shader for Glass {
    type Vertex = Normal;
    /// How much the surface faces the eye.
    type Varying = (Scalar, Scalar);
    /// Towards the eye and towards the light, in the mesh's own space, 2^7 long.
    type Prepared = [[i32; 3]; 2];

    fn prepare(&self, draw: &DrawContext) -> [[i32; 3]; 2] {
        let to_model = (draw.view * draw.model).transpose();
        let turned = |direction: Vec3| {
            let Vec3 { x, y, z } = to_model.transform_vector(direction).normalize() * 128.0;
            [x as i32, y as i32, z as i32]
        };
        [turned(Vec3::Z), turned(Vec3::new(-0.5, 0.6, 0.8))]
    }

    fn vertex(
        &self,
        [eye, light]: &[[i32; 3]; 2],
        vertex: VertexInput<'_, Normal>,
    ) -> Corner<Self::Varying> {
        let cosine = |direction: &[i32; 3]| {
            let products = direction.iter().zip(vertex.attributes);
            let sum: i32 = products.map(|(d, n)| d * i32::from(*n)).sum();
            (sum.abs() * 4).clamp(0, 65_535) as u16
        };
        (cosine(eye), cosine(light))
    }

    fn fragment(&self, _: &[[i32; 3]; 2], (facing, lit): &(Scalar, Scalar)) -> Option<Color> {
        let (edge, lit) = (255 - (facing.get() >> 8), u32::from(lit.get() >> 8));
        // A highlight where the light comes from: a high power of the cosine.
        let shine = (lit * lit >> 8).pow(2) >> 8;
        let shine = (shine * shine >> 8).min(255);
        let alpha = (20 + u32::from(edge) * u32::from(edge) / 420 + shine).min(255) as u8;
        let tint = |base: u32| (base + shine).min(255) as u8;
        Some(Color::new(tint(150), tint(195), tint(220)).with_alpha(alpha))
    }
}

/// A chequered wall of 8 x 6 squares, two triangles each.
static WALL: [[i16; 3]; 8 * 6 * 6] = {
    let mut positions = [[0; 3]; 8 * 6 * 6];
    let corners = [[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]];
    let mut i = 0;
    while i < positions.len() {
        let (square, corner) = ((i / 6) as i16, corners[i % 6]);
        positions[i] = [square % 8 + corner[0], square / 8 + corner[1], 0];
        i += 1;
    }
    positions
};

static WALL_COLORS: [Rgb; 8 * 6 * 2] = {
    let wheel = [
        Rgb::new(214, 69, 65),
        Rgb::new(244, 179, 80),
        Rgb::new(88, 177, 159),
        Rgb::new(65, 105, 170),
        Rgb::new(235, 235, 225),
    ];
    let mut colors = [Rgb::BLACK; 8 * 6 * 2];
    let mut i = 0;
    while i < colors.len() {
        let (x, y) = (i / 2 % 8, i / 16);
        colors[i] = wheel[(x * 2 + y * 3) % 5];
        i += 1;
    }
    colors
};

/// The glass' outline: radius and height, from the foot up, and down again inside.
const OUTLINE: [[f32; 2]; 17] = [
    [0.0, -1.2],
    [0.62, -1.2],
    [0.6, -1.15],
    [0.2, -1.08],
    [0.07, -0.95],
    [0.06, -0.4],
    [0.09, -0.25],
    [0.3, -0.1],
    [0.52, 0.15],
    [0.62, 0.5],
    [0.6, 0.85],
    [0.5, 1.2],
    [0.48, 1.2],
    [0.57, 0.85],
    [0.59, 0.5],
    [0.49, 0.17],
    [0.0, -0.05],
];
/// Parts of a turn.
const PARTS: usize = 32;
const VERTICES: usize = OUTLINE.len() * PARTS;
const TRIANGLES: usize = (OUTLINE.len() - 1) * PARTS * 2;

/// A body of revolution, made by the compiler.
struct Lathe {
    positions: [[i16; 3]; VERTICES],
    normals: [Normal; VERTICES],
    triangles: [[u16; 3]; TRIANGLES],
    step: f32,
}

static GLASS: Lathe = Lathe::new();

impl Lathe {
    const fn new() -> Self {
        let step = 1.3 / 32_767.0;
        let mut lathe = Self {
            positions: [[0; 3]; VERTICES],
            normals: [[0; 3]; VERTICES],
            triangles: [[0; 3]; TRIANGLES],
            step,
        };
        let mut vertex = 0;
        while vertex < VERTICES {
            let (ring, part) = (vertex / PARTS, vertex % PARTS);
            let (sin, cos) = Angle::from_turns(part as f32 / PARTS as f32).sin_cos();
            let [radius, height] = OUTLINE[ring];
            let before = OUTLINE[if ring == 0 { 0 } else { ring - 1 }];
            let after = OUTLINE[if ring + 1 < OUTLINE.len() { ring + 1 } else { ring }];
            // Across the outline, outwards as one goes up.
            let (out, up) = (after[1] - before[1], before[0] - after[0]);
            let unit = 127.0 / microraster::math::sqrt(out * out + up * up);
            lathe.positions[vertex] = [
                (radius * cos / step) as i16,
                (height / step) as i16,
                (radius * sin / step) as i16,
            ];
            lathe.normals[vertex] =
                [(out * cos * unit) as i8, (up * unit) as i8, (out * sin * unit) as i8];
            vertex += 1;
        }
        let mut triangle = 0;
        while triangle < TRIANGLES {
            let (ring, part) = (triangle / 2 / PARTS, triangle / 2 % PARTS);
            let (a, b) = (ring * PARTS + part, ring * PARTS + (part + 1) % PARTS);
            let (c, d) = (b + PARTS, a + PARTS);
            let corners = if triangle % 2 == 0 { [a, d, c] } else { [a, c, b] };
            lathe.triangles[triangle] = [corners[0] as u16, corners[1] as u16, corners[2] as u16];
            triangle += 1;
        }
        lathe
    }
}
