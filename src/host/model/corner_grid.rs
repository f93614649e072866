//! Points of the plane, found by where they lie.

use std::prelude::rust_2021::*;

/// Some corners of a polygon, sorted into the cells of a grid over their box.
#[derive(Debug, Default)]
pub(super) struct CornerGrid {
    min: [f64; 2],
    /// Cells for each unit of length.
    density: [f64; 2],
    /// Cells on a side.
    side: usize,
    /// Where the corners of each cell begin in `corners`, and at last their number.
    starts: Vec<usize>,
    corners: Vec<usize>,
}

impl CornerGrid {
    /// The most cells on a side.
    const LARGEST_SIDE: usize = 256;

    /// Replaces the contents by those `corners` of the polygon `plane`.
    pub(super) fn fill(&mut self, plane: &[[f64; 2]], corners: &[usize]) {
        let at = |corner: usize| plane.get(corner).copied().unwrap_or_default();
        let mut max = [f64::NEG_INFINITY; 2];
        self.min = [f64::INFINITY; 2];
        for &corner in corners {
            let [x, y] = at(corner);
            self.min = [self.min[0].min(x), self.min[1].min(y)];
            max = [max[0].max(x), max[1].max(y)];
        }
        self.side = corners.len().isqrt().clamp(1, Self::LARGEST_SIDE);
        let density = |size: f64| {
            if size > 0.0 {
                self.side as f64 / size
            } else {
                0.0
            }
        };
        self.density = [density(max[0] - self.min[0]), density(max[1] - self.min[1])];

        // Count, sum up, place: a counting sort.
        let cell = |grid: &Self, corner: usize| {
            let [x, y] = grid.cell(at(corner));
            y * grid.side + x
        };
        self.starts.clear();
        self.starts.resize(self.side * self.side + 1, 0);
        for &corner in corners {
            let cell = cell(self, corner);
            if let Some(count) = self.starts.get_mut(cell + 1) {
                *count += 1;
            }
        }
        let mut sum = 0;
        for start in &mut self.starts {
            sum += *start;
            *start = sum;
        }
        let mut next = self.starts.clone();
        self.corners.clear();
        self.corners.resize(corners.len(), 0);
        for &corner in corners {
            let cell = cell(self, corner);
            if let Some(next) = next.get_mut(cell) {
                if let Some(place) = self.corners.get_mut(*next) {
                    *place = corner;
                }
                *next += 1;
            }
        }
    }

    /// The corners of all cells that the box of a triangle touches, in one slice for each row.
    pub(super) fn around(&self, triangle: [[f64; 2]; 3]) -> impl Iterator<Item = &[usize]> {
        let ends = |axis: usize| {
            let values = triangle.map(|point| point[axis]);
            let min = values.into_iter().fold(f64::INFINITY, f64::min);
            (min, values.into_iter().fold(f64::NEG_INFINITY, f64::max))
        };
        let ((left, right), (low, high)) = (ends(0), ends(1));
        let ([left, low], [right, high]) = (self.cell([left, low]), self.cell([right, high]));
        (low..=high).filter_map(move |row| {
            let first = self.starts.get(row * self.side + left)?;
            let end = self.starts.get(row * self.side + right + 1)?;
            self.corners.get(*first..*end)
        })
    }

    /// The column and row of the cell of a point; of one outside the box the nearest cell.
    fn cell(&self, [x, y]: [f64; 2]) -> [usize; 2] {
        let index = |value: f64, axis: usize| {
            #[allow(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "a float cast saturates: below the box is 0"
            )]
            let cell = ((value - self.min[axis]) * self.density[axis]) as usize;
            cell.min(self.side.saturating_sub(1))
        };
        [index(x, 0), index(y, 1)]
    }
}
