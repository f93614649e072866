use super::rows::pixel_box;
use super::{Edges, Rows};
use crate::frame::Rect;
use crate::raster::{SpanBatch, Traversal, Triangle};

/// Every pixel of the bounding box, tested by three edge functions that are stepped.
///
/// Source: J. Pineda, *A Parallel Algorithm for Polygon Rasterization*, SIGGRAPH 1988.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BoundingBox;

impl Traversal for BoundingBox {
    type Walk = Rows;

    fn start(&self, walk: &mut Rows, triangle: &Triangle, area: &Rect, batch: &mut SpanBatch) {
        let (edges, pixels) = (Edges::new(triangle), pixel_box(triangle, *area));
        let rows = (pixels.top..pixels.bottom).filter_map(|y| {
            let mut values = edges.at(pixels.left, y);
            let mut found: Option<(i32, i32)> = None;
            for x in pixels.left..pixels.right {
                if values.iter().all(|value| *value >= 0) {
                    found = Some((found.map_or(x, |(first, _)| first), x + 1));
                } else if found.is_some() {
                    break;
                }
                edges.step_right(&mut values);
            }
            found.map(|(first, behind)| (y, first, behind))
        });
        walk.start(rows, *area, batch);
    }
}
