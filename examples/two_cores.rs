//! Two cores draw a picture from one recorded list: here as two threads, on a microcontroller as two
//! programs that share it. No locks and no `unsafe`: while bands are drawn, nobody changes the list.

use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::models::TEAPOT;
use microraster::{
    Band, Bands, Camera, Cull, DisplayList, FrameError, Gouraud, Less, Light, ListTriangle,
    ListVertex, Pass, Recording, Rgb, Rgb565, Size, VertexCache,
};

const PICTURE: Size = Size::new(320, 240);
/// Rows of a band; each core has buffers for one.
const ROWS: usize = 16;
const PIXELS: usize = PICTURE.width as usize * ROWS;

/// Draws every second band, the first of them number `core`, and hands them to `send`.
fn draw_half(
    core: u16,
    camera: &Camera,
    recording: &Recording<'_, Gouraud<microraster::Lambert<1>>>,
    mut send: impl FnMut(Band<'_, Rgb565>),
) -> Result<(), FrameError> {
    let (mut pixels, mut depth) = ([0; PIXELS], [0; PIXELS]);
    let mut bands = Bands::<Rgb565>::new(&mut pixels, PICTURE)?.with_depth(&mut depth)?;
    let mut pass = Pass::new(camera).depth(Less);
    for number in (core..bands.count()).step_by(2) {
        let band = bands.draw_band(number, |frame| {
            frame.clear(Rgb::new(16, 24, 48));
            // It fails for another size of picture than it was recorded for; bands have that one.
            let drawn = pass.replay_shared(frame, recording);
            debug_assert!(drawn.is_ok(), "{drawn:?}");
        });
        if let Some(band) = band {
            send(band);
        }
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let camera = Camera::perspective(45.0.degrees(), 0.5).look_at(
        Vec3::new(0.0, 2.4, 5.4),
        Vec3::ZERO,
        Vec3::Y,
    );
    let sun = Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::new(204, 204, 204));
    let (turned, shader) = (Mat4::rotation_y(25.0.degrees()), Gouraud::lit(&[sun]));

    // One core records: vertices are transformed and lit once.
    let mut vertices = [ListVertex::default(); 600];
    let mut triangles = [ListTriangle::BLANK; 600];
    let mut cache = VertexCache::<u16, 512>::new();
    let list = DisplayList::new(&mut vertices, &mut triangles, &mut []);
    let mut pass = Pass::new(&camera).cull(Cull::Back).depth(Less);
    let recording = pass.record(list, PICTURE, &turned, &TEAPOT, &shader, &mut cache);
    recording.check()?;

    // Both draw; what arrives is put together here, by the row that a band begins with.
    let drawn = std::thread::scope(|scope| {
        let (camera, recording) = (&camera, &recording);
        let cores = [0, 1].map(|core| {
            scope.spawn(move || {
                let mut sent = Vec::new();
                draw_half(core, camera, recording, |band| {
                    sent.push((band.first_row(), band.pixels().to_vec()));
                })?;
                Ok::<_, FrameError>(sent)
            })
        });
        cores.map(|core| core.join().map_err(|_| "a core stopped"))
    });
    let mut display = Vec::new();
    for sent in drawn {
        display.extend(sent??);
    }
    display.sort_by_key(|(first_row, _)| *first_row);
    let display: Vec<u16> = display.into_iter().flat_map(|(_, pixels)| pixels).collect();

    // The same by one core, all at once.
    let (mut whole, mut depth) = (vec![0; display.len()], vec![0; display.len()]);
    let mut bands = Bands::<Rgb565>::new(&mut whole, PICTURE)?.with_depth(&mut depth)?;
    bands.draw(
        |frame| {
            frame.clear(Rgb::new(16, 24, 48));
            pass.draw(frame, &turned, &TEAPOT, &shader);
        },
        |_band| Ok::<(), FrameError>(()),
    )?;
    assert_eq!(whole, display, "two cores make the same picture");
    let (vertices, triangles) = (recording.vertices(), recording.triangles());
    println!("two cores drew {triangles} triangles of {vertices} vertices: the same picture");
    Ok(())
}
