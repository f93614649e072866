use std::vec::Vec;

use super::rows::pixel_box;
use super::{Edges, Rows};
use crate::frame::Rect;
use crate::raster::{SpanBatch, Traversal, Triangle};

/// Pixels along a block's side.
pub(super) const SIDE: i32 = 4;

/// Blocks of 4x4 pixels: taken or left as a whole where one look at their corners is enough.
///
/// Source: the hierarchical form of Pineda's edge functions, as in M. Abrash, *Rasterization on
/// Larrabee* (2009), with one level.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Blocks;

/// What the rows of one row of blocks cover: first column and the one behind the last.
pub(super) type BlockRows = [Option<(i32, i32)>; SIDE as usize];

/// Adds a block's pixels to the rows; false if the block lies outside.
pub(super) fn take(edges: &Edges, rows: &mut BlockRows, x: i32, y: i32) -> bool {
    let (outside, inside) = edges.block(x, y, SIDE);
    if outside {
        return false;
    }
    for (row, down) in rows.iter_mut().zip(0..) {
        for right in 0..SIDE {
            let x = x + right;
            if inside || edges.covers(x, y + down) {
                let (first, behind) = row.unwrap_or((x, x));
                *row = Some((first.min(x), behind.max(x + 1)));
            }
        }
    }
    true
}

/// The rows of one row of blocks that lie in the box.
pub(super) fn finish(
    rows: BlockRows,
    y: i32,
    pixels: Rect,
) -> impl Iterator<Item = (i32, i32, i32)> {
    rows.into_iter()
        .zip(y..)
        .filter(move |(_, y)| (pixels.top..pixels.bottom).contains(y))
        .filter_map(|(row, y)| row.map(|(first, behind)| (y, first, behind)))
}

impl Traversal for Blocks {
    type Walk = Rows;

    fn start(&self, walk: &mut Rows, triangle: &Triangle, area: &Rect, batch: &mut SpanBatch) {
        let (edges, pixels) = (Edges::new(triangle), pixel_box(triangle, *area));
        let mut found = Vec::new();
        let mut y = pixels.top & !(SIDE - 1);
        while y < pixels.bottom {
            let mut rows = BlockRows::default();
            let mut x = pixels.left & !(SIDE - 1);
            while x < pixels.right {
                take(&edges, &mut rows, x, y);
                x += SIDE;
            }
            found.extend(finish(rows, y, pixels));
            y += SIDE;
        }
        walk.start(found, *area, batch);
    }
}
