use std::vec::Vec;

use super::blocks::{finish, take, BlockRows, SIDE};
use super::rows::pixel_box;
use super::{Edges, Rows};
use crate::frame::Rect;
use crate::raster::{SpanBatch, Traversal, Triangle};

/// Blocks walked from a vertex: row of blocks by row of blocks up and down, and in each to the
/// left and to the right until the triangle is left.
///
/// The plain walk begins each row where the last one had pixels, and loses slivers that slip past
/// that block. Here such a row is searched from its end, which makes the walk exact.
///
/// Source: P. Mileff, K. Nehez, J. Dudra, *Accelerated Half-Space Triangle Rasterization*, Acta
/// Polytechnica Hungarica 12 (2015).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BlockWalk;

/// Walks one row of blocks from `x` both ways; gives its rows and the middle of what was found.
fn walk_row(edges: &Edges, pixels: Rect, x: i32, y: i32) -> (BlockRows, Option<i32>) {
    let mut rows = BlockRows::default();
    let begin = pixels.left & !(SIDE - 1);
    let ends = begin..pixels.right;
    let mut start = x.clamp(begin, (pixels.right - 1).max(begin)) & !(SIDE - 1);
    if !take(edges, &mut rows, start, y) {
        // Not here: search the row from its end.
        let Some(found) =
            ends.clone().step_by(SIDE as usize).find(|&x| take(edges, &mut rows, x, y))
        else {
            return (rows, None);
        };
        start = found;
    }
    let (mut left, mut right) = (start, start);
    while ends.contains(&(left - SIDE)) && take(edges, &mut rows, left - SIDE, y) {
        left -= SIDE;
    }
    while ends.contains(&(right + SIDE)) && take(edges, &mut rows, right + SIDE, y) {
        right += SIDE;
    }
    (rows, Some((left + right) / 2))
}

impl Traversal for BlockWalk {
    type Walk = Rows;

    fn start(&self, walk: &mut Rows, triangle: &Triangle, area: &Rect, batch: &mut SpanBatch) {
        let (edges, pixels) = (Edges::new(triangle), pixel_box(triangle, *area));
        let mut found = Vec::new();
        if !pixels.is_empty() {
            let [vertex, ..] = triangle.vertices();
            let (x, y) = (vertex.x_bits() >> 4, vertex.y_bits() >> 4);
            let begin = y.clamp(pixels.top, pixels.bottom - 1) & !(SIDE - 1);
            for step in [SIDE, -SIDE] {
                let (mut x, mut y) = (x, if step > 0 { begin } else { begin - SIDE });
                while y < pixels.bottom && y + SIDE > pixels.top {
                    let (rows, middle) = walk_row(&edges, pixels, x, y);
                    found.extend(finish(rows, y, pixels));
                    x = middle.unwrap_or(x);
                    y += step;
                }
            }
        }
        walk.start(found, *area, batch);
    }
}
