//! The mesh of scene S1: a grid of quads, two pixels wide at 320x240.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "counts of a grid that fits 16 bits; colours wrap"
)]

use microraster::Rgb;

/// Quads in a row.
pub(crate) const COLUMNS: usize = 160;
/// Rows of quads.
pub(crate) const ROWS: usize = 120;
/// Two a quad.
pub(crate) const TRIANGLES: usize = 2 * COLUMNS * ROWS;
/// The grid reaches this far to every side.
pub(crate) const REACH: f32 = 32_000.0;

const VERTICES: usize = (COLUMNS + 1) * (ROWS + 1);

/// Row by row from the lower left.
pub(crate) static POSITIONS: [[i16; 3]; VERTICES] = positions();
/// One colour a triangle.
pub(crate) static COLORS: [Rgb; TRIANGLES] = colors();
/// Three a triangle.
pub(crate) static INDICES: [u16; 3 * TRIANGLES] = indices();

const fn positions() -> [[i16; 3]; VERTICES] {
    let mut positions = [[0; 3]; VERTICES];
    let mut i = 0;
    while i < VERTICES {
        let (column, row) = (i % (COLUMNS + 1), i / (COLUMNS + 1));
        let (x, y) = (64_000 * column / COLUMNS, 64_000 * row / ROWS);
        positions[i] = [(x as i32 - 32_000) as i16, (y as i32 - 32_000) as i16, 0];
        i += 1;
    }
    positions
}

const fn colors() -> [Rgb; TRIANGLES] {
    let mut colors = [Rgb::BLACK; TRIANGLES];
    let mut i = 0;
    while i < TRIANGLES {
        let quad = i / 2;
        colors[i] = Rgb::new((quad % COLUMNS) as u8, (quad / COLUMNS) as u8, (i % 2 * 255) as u8);
        i += 1;
    }
    colors
}

const fn indices() -> [u16; 3 * TRIANGLES] {
    let mut indices = [0; 3 * TRIANGLES];
    let mut i = 0;
    while i < TRIANGLES {
        let quad = i / 2;
        let a = quad / COLUMNS * (COLUMNS + 1) + quad % COLUMNS;
        let (b, c, d) = (a + 1, a + COLUMNS + 2, a + COLUMNS + 1);
        let corners = if i % 2 == 0 { [a, b, c] } else { [a, c, d] };
        indices[3 * i] = corners[0] as u16;
        indices[3 * i + 1] = corners[1] as u16;
        indices[3 * i + 2] = corners[2] as u16;
        i += 1;
    }
    indices
}
