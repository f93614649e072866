//! A wireframe without its hidden lines: depth first, a little farther away, then the edges.

use fixed::types::I8F8;
use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::models::TEAPOT;
use microraster::{
    Camera, Cull, DepthBuffer, Flat, Fog, Fogged, Frame, Less, LessEqual, Pass, PolygonOffset, Rgb,
    Rgb565, Stats, Thin,
};

/// Draws the teapot's edges; `turn` in degrees.
pub(crate) fn draw(frame: &mut Frame<'_, Rgb565, DepthBuffer<'_>>, turn: f32, stats: &mut Stats) {
    let (paper, sheet) = (Rgb::new(18, 44, 92), Rgb::new(28, 64, 126));
    frame.clear(paper);
    let camera = Camera::perspective(45.0.degrees(), 1.0).look_at(
        Vec3::new(0.0, 3.3, 6.9),
        Vec3::new(0.0, -0.1, 0.0),
        Vec3::Y,
    );
    let model = Mat4::rotation_y(turn.degrees());

    // Faces are moved away by their slope and two codes, so that their own edges lie before them.
    let farther = PolygonOffset::new(Less, I8F8::ONE, 2);
    Pass::new(&camera).cull(Cull::Back).depth(farther).count(stats).draw(
        frame,
        &model,
        &TEAPOT,
        &Flat::solid(sheet),
    );

    // Edges of the same faces, paler with distance.
    let ink = Fogged::new(Flat::solid(Rgb::WHITE), Fog::linear(sheet, 5.4, 10.2));
    Pass::new(&camera)
        .cull(Cull::Back)
        .depth(LessEqual)
        .count(stats)
        .draw_wireframe(frame, &model, &TEAPOT, &ink, Thin);
}
