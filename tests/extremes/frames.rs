//! Frames and meshes of the least and the largest sizes, and of none.

use microraster::math::{Mat4, Vec3};
use microraster::{
    Always, Camera, Consecutive, Flat, Frame, FrameError, Gouraud, LineLoop, LineStrip, Mesh, Pass,
    Points, Rgb, Rgb565, Rgba8888, Size, Stats, Thin, TriangleFan, TriangleStrip, MAX_SIDE,
};

/// A square of two triangles over the whole view, and more.
static SQUARE: [[i16; 3]; 4] = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]];
static COLORS: [Rgb; 4] = [Rgb::RED, Rgb::GREEN, Rgb::BLUE, Rgb::WHITE];
static INDICES: [u16; 6] = [0, 1, 2, 0, 2, 3];

fn camera() -> Camera {
    Camera::custom(Mat4::identity())
}

/// Draws the square into a band.
fn square(frame: &mut Frame<'_, Rgba8888, microraster::DepthBuffer<'_>>) -> Stats {
    let mut stats = Stats::default();
    let mesh = Mesh::new(&SQUARE, &COLORS)
        .indexed(&INDICES)
        .placed(Vec3::splat(1.5), Vec3::new(0.0, 0.0, 0.5));
    let camera = camera();
    let mut pass = Pass::new(&camera).depth(Always).count(&mut stats);
    pass.draw(frame, &Mat4::identity(), &mesh, &Gouraud::colored());
    stats
}

/// The whole picture in bands of some rows.
fn picture(size: Size, rows: u16) -> (Vec<u32>, u32) {
    let (width, height) = (usize::from(size.width), usize::from(size.height));
    let (mut pixels, mut depth) = (vec![0; width * height], vec![0; width * height]);
    let each = width * usize::from(rows);
    let bands = pixels.chunks_mut(each).zip(depth.chunks_mut(each));
    let mut written = 0;
    for (number, (pixels, depth)) in bands.enumerate() {
        let held = Size::new(size.width, (pixels.len() / width) as u16);
        let frame = Frame::new(pixels, held).and_then(|frame| frame.with_depth(depth));
        let frame = frame.and_then(|frame| frame.band(number as u16 * rows, size.height));
        let stats = square(&mut frame.expect("a band of the picture"));
        assert_eq!(stats.skipped, 0, "{size:?}, {rows} rows");
        written += stats.pixels;
    }
    (pixels, written)
}

#[test]
fn frames_without_pixels_and_beyond_8192_are_refused_with_what_was_needed() {
    let make = |width: u16, height: u16, words: usize| {
        let mut pixels = vec![0; words];
        Frame::<Rgb565>::new(&mut pixels, Size::new(width, height)).map(|_| ())
    };
    for (width, height) in [(0, 0), (0, 1), (1, 0), (0, u16::MAX), (u16::MAX, 0)] {
        assert_eq!(make(width, height, 100), Err(FrameError::Empty), "{width}x{height}");
    }
    assert_eq!(make(1, 1, 1), Ok(()), "one pixel");
    assert_eq!(make(1, 1, 0), Err(FrameError::Color { needed: 1, got: 0 }), "no room for it");
    for side in [MAX_SIDE - 1, MAX_SIDE] {
        let words = usize::from(side);
        assert_eq!((make(side, 1, words), make(1, side, words)), (Ok(()), Ok(())), "{side}");
        let short = Err(FrameError::Color { needed: side.into(), got: u32::from(side) - 1 });
        assert_eq!(make(side, 1, words - 1), short, "{side} and one pixel missing");
    }
    for side in [MAX_SIDE + 1, u16::MAX] {
        let too_large = Err(FrameError::TooLarge { got: side.into() });
        assert_eq!(make(side, 1, usize::from(side)), too_large, "{side} wide");
        assert_eq!(make(1, side, usize::from(side)), too_large, "{side} high");
    }
}

#[test]
fn pictures_of_one_pixel_one_column_one_row_and_8192_pixels_are_full() {
    for (width, height) in
        [(1, 1), (1, 2), (2, 1), (1, 77), (77, 1), (8192, 1), (1, 8192), (8191, 2), (3, 8191)]
    {
        let size = Size::new(width, height);
        let (pixels, written) = picture(size, height);
        assert!(pixels.iter().all(|pixel| *pixel != 0), "{size:?} has holes");
        assert_eq!(written as usize, pixels.len(), "{size:?}: each pixel once");
    }
}

#[test]
fn bands_of_one_row_up_to_all_of_them_make_the_same_picture() {
    for (width, height) in [(1, 1), (1, 61), (33, 61), (8192, 3), (2, 400)] {
        let size = Size::new(width, height);
        let (whole, _) = picture(size, height);
        for rows in (1..=height.min(60)).chain([height]) {
            assert!(picture(size, rows).0 == whole, "{size:?} in bands of {rows} rows");
        }
    }
}

#[test]
fn bands_may_end_with_the_picture_and_no_row_later() {
    let band = |first: u16, rows: u16, height: u16| {
        let mut pixels = vec![0; usize::from(rows)];
        let frame = Frame::<Rgb565>::new(&mut pixels, Size::new(1, rows));
        frame.and_then(|frame| frame.band(first, height)).map(|_| ())
    };
    assert_eq!(band(0, 1, 1), Ok(()), "the whole picture");
    assert_eq!(band(8191, 1, 8192), Ok(()), "the last row there may be");
    assert_eq!(band(8190, 1, 8191), Ok(()), "one row before that");
    assert_eq!(band(8192, 1, 8192), Err(FrameError::Band { needed: 8193, got: 8192 }), "beyond");
    assert_eq!(band(u16::MAX, 2, 8192), Err(FrameError::Band { needed: 65_537, got: 8192 }), "far");
    assert_eq!(band(0, 1, 8193), Err(FrameError::TooLarge { got: 8193 }), "too tall a picture");
    assert_eq!(band(0, 2, 1), Err(FrameError::Band { needed: 2, got: 1 }), "more than there is");
}

/// Draws something of a mesh into a small picture.
fn stats_of(draw: impl FnOnce(&mut Frame<'_, Rgba8888>, &mut Stats)) -> Stats {
    let (mut pixels, mut stats) = ([0; 64], Stats::default());
    draw(&mut Frame::new(&mut pixels, Size::new(8, 8)).expect("it fits"), &mut stats);
    stats
}

#[test]
fn meshes_without_vertices_or_without_indices_draw_nothing() {
    let camera = camera();
    let model = Mat4::identity();
    let empty: Mesh<'_, Rgb> = Mesh::new(&[], &[]);
    let none: [u16; 0] = [];
    let nobody = Consecutive::new(0);
    let shader = Flat::colored();
    let all = [
        stats_of(|frame, stats| {
            Pass::new(&camera).count(stats).draw(frame, &model, &empty, &shader)
        }),
        stats_of(|frame, stats| {
            let mesh = Mesh::new(&SQUARE, &COLORS).indexed(&none);
            Pass::new(&camera).count(stats).draw(frame, &model, &mesh, &shader);
        }),
        stats_of(|frame, stats| {
            let mesh = empty.with_topology(TriangleStrip::new(nobody));
            Pass::new(&camera).count(stats).draw(frame, &model, &mesh, &shader);
        }),
        stats_of(|frame, stats| {
            let mesh = empty.with_topology(TriangleFan::new(nobody));
            Pass::new(&camera).count(stats).draw(frame, &model, &mesh, &shader);
        }),
        stats_of(|frame, stats| {
            let mesh = empty.with_topology(LineStrip::new(nobody));
            Pass::new(&camera).count(stats).draw_lines(frame, &model, &mesh, &shader, Thin);
        }),
        stats_of(|frame, stats| {
            let mesh = empty.with_topology(LineLoop::new(nobody));
            Pass::new(&camera).count(stats).draw_lines(frame, &model, &mesh, &shader, Thin);
        }),
        stats_of(|frame, stats| {
            let mesh = empty.with_topology(Points::new(nobody));
            Pass::new(&camera).count(stats).draw_points(frame, &model, &mesh, &shader, &1_u16);
        }),
    ];
    for (i, stats) in all.into_iter().enumerate() {
        assert_eq!(stats, Stats::default(), "way {i}");
    }
}

#[test]
fn too_few_vertices_for_a_primitive_are_none() {
    let camera = camera();
    for count in 0..3 {
        let stats = stats_of(|frame, stats| {
            let mesh = Mesh::new(&SQUARE, &COLORS)
                .with_topology(TriangleStrip::new(Consecutive::new(count)));
            Pass::new(&camera).count(stats).draw(frame, &Mat4::identity(), &mesh, &Flat::colored());
        });
        assert_eq!(stats, Stats::default(), "{count} vertices");
    }
}

#[test]
fn indices_one_beyond_the_last_vertex_and_at_the_end_of_their_type_are_skipped_and_counted() {
    fn check<I: Copy + Into<u32> + std::fmt::Debug>(inside: [I; 3], beyond: &[I]) {
        let camera = camera();
        let skipped = |indices: &[I]| {
            let stats = stats_of(|frame, stats| {
                let mesh = Mesh::new(&SQUARE, &COLORS).indexed(indices);
                let mut pass = Pass::new(&camera).count(stats);
                pass.draw(frame, &Mat4::identity(), &mesh, &Flat::colored());
            });
            (stats.triangles, stats.skipped)
        };
        assert_eq!(skipped(&inside), (1, 0), "{inside:?}");
        for (place, index) in (0..3).flat_map(|place| beyond.iter().map(move |i| (place, *i))) {
            let mut indices = inside;
            indices[place] = index;
            assert_eq!(skipped(&indices), (1, 1), "{indices:?}");
        }
    }
    check([1_u8, 2, 3], &[4, 254, 255]);
    check([1_u16, 2, 3], &[4, 32_768, u16::MAX]);
    check([1_u32, 2, 3], &[4, 65_536, 1 << 31, u32::MAX]);
}

#[test]
fn attributes_that_are_missing_skip_their_triangles_only() {
    let camera = camera();
    let stats = stats_of(|frame, stats| {
        let mesh = Mesh::new(&SQUARE, &COLORS[..3]).indexed(&INDICES);
        let mut pass = Pass::new(&camera).count(stats);
        pass.draw(frame, &Mat4::identity(), &mesh, &Gouraud::colored());
    });
    assert_eq!((stats.triangles, stats.skipped, stats.drawn), (2, 1, 1), "{stats:?}");
    // Of flat ones the first corner's are enough.
    let stats = stats_of(|frame, stats| {
        let mesh = Mesh::new(&SQUARE, &COLORS[..1]).indexed(&INDICES);
        let mut pass = Pass::new(&camera).count(stats);
        pass.draw(frame, &Mat4::identity(), &mesh, &Flat::colored());
    });
    assert_eq!((stats.triangles, stats.skipped, stats.drawn), (2, 0, 2), "{stats:?}");
}
