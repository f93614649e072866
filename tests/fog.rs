//! Fog over a floor of two triangles, from behind the eye to far beyond the fog's end.
#![cfg(feature = "std")]
#![allow(clippy::cast_possible_truncation, reason = "rows of a small picture")]

use microraster::host::reference;
use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::{AtFragments, Camera, Flat, Fog, Fogged, Frame, Mesh, Pass, Rgb, Rgba8888, Size};

#[test]
fn a_large_floor_fades_with_the_distance_of_each_pixel() {
    static FLOOR: [[i16; 3]; 6] =
        [[-1, 0, 1], [1, 0, 1], [1, 0, -1], [-1, 0, 1], [1, 0, -1], [-1, 0, -1]];
    let (width, height) = (32_u16, 200_u16);
    let camera = Camera::perspective(60.0.degrees(), 0.1);
    // From 40 behind the eye to 240 before it, 1 below.
    let floor = Mesh::new(&FLOOR, &[(); 6])
        .placed(Vec3::new(100.0, 1.0, 140.0), Vec3::new(0.0, -1.0, -100.0));
    let fog = Fog::linear(Rgb::BLACK, 5.0, 30.0);
    let shader = Fogged::new(Flat::solid(Rgb::WHITE), fog).at(AtFragments);
    let mut pixels = vec![0_u32; usize::from(width) * usize::from(height)];
    let mut frame =
        Frame::<Rgba8888>::new(&mut pixels, Size::new(width, height)).expect("a buffer that fits");
    frame.clear(Rgb::BLUE);
    Pass::new(&camera).draw(&mut frame, &Mat4::identity(), &floor, &shader);
    let seen = |y: f64| {
        // The ray through the row meets the floor at this distance along the view.
        let down = (y - f64::from(height) / 2.0) / (f64::from(height) / 2.0);
        let distance = 1.0 / (down * 30.0_f64.to_radians().tan());
        let fog = reference::Fog::Linear { start: 5.0, end: 30.0 };
        fog.over([255.0; 3], [0.0; 3], distance)[0]
    };
    let mut shades = 0;
    for y in 102..i32::from(height) {
        // Corners may lie a sixteenth of a pixel beside their places.
        let ends = [-1.0, 1.0].map(|beside| seen(f64::from(y) + 0.5 + beside / 16.0));
        let row = y.unsigned_abs() as usize * usize::from(width);
        for pixel in pixels.iter().skip(row).take(width.into()) {
            let [r, ..] = pixel.to_le_bytes();
            let shade = f64::from(r);
            assert!(
                ends[0] - 3.0 <= shade && shade <= ends[1] + 3.0,
                "{shade} in row {y}: {ends:?}"
            );
        }
        shades += u32::from((1.0..254.0).contains(&ends[0]));
    }
    assert!(shades > 20, "{shades} rows lie in the fog");
}
