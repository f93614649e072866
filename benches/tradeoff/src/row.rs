//! Everything that was found of a case, and which cases are worth their cost.

use crate::case::Case;
use crate::costs::{Cost, BOARDS};
use crate::errors::Errors;

/// A case with its errors and its costs.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    pub(crate) case: Case,
    pub(crate) errors: Errors,
    pub(crate) cost: Cost,
    /// Bytes of buffers that the case draws with.
    pub(crate) memory: usize,
    /// Bytes of flash more than flat triangles, where that is weighed.
    pub(crate) flash: Option<i64>,
    pub(crate) pixels: u64,
    pub(crate) triangles: u32,
}

impl Row {
    /// The scene and the knob: rows of one table.
    pub(crate) fn group(&self) -> (String, String) {
        (self.case.scene.clone(), self.case.knob())
    }

    /// The error by which settings of one knob are compared: the root of the mean square of
    /// differences of colour.
    pub(crate) fn error(&self) -> f64 {
        255.0 / 10_f64.powf(self.errors.color.psnr / 20.0)
    }
}

/// The error that makes no difference: that of rounding to eight bits.
const SAME: f64 = 1e-3;

/// Whether `a` is no worse than `b` in anything, and better in something: instructions, error,
/// memory.
fn beats(a: &Row, b: &Row, error: impl Fn(&Row) -> f64, boards: &[usize]) -> bool {
    let mut costs =
        boards.iter().map(|board| (a.cost.instructions[*board], b.cost.instructions[*board]));
    let (errors, memory) = ((error(a), error(b)), (a.memory, b.memory));
    let no_worse =
        costs.clone().all(|(a, b)| a <= b) && errors.0 <= errors.1 + SAME && memory.0 <= memory.1;
    let better = costs.any(|(a, b)| a < b) || errors.0 + SAME < errors.1 || memory.0 < memory.1;
    no_worse && better
}

/// Whether no row of `rows` beats this one: it lies on the Pareto front of instructions on every
/// board, error and memory.
pub(crate) fn is_on_front(row: &Row, rows: &[&Row], error: impl Fn(&Row) -> f64 + Copy) -> bool {
    let boards: Vec<usize> = (0..BOARDS.len()).collect();
    !rows.iter().any(|other| beats(other, row, error, &boards))
}

/// The same for one board.
pub(crate) fn is_on_front_of(
    board: usize,
    row: &Row,
    rows: &[&Row],
    error: impl Fn(&Row) -> f64 + Copy,
) -> bool {
    !rows.iter().any(|other| {
        let (a, b) = (other.cost.instructions[board], row.cost.instructions[board]);
        let (e, f) = (error(other), error(row));
        a <= b && e <= f + SAME && (a < b || e + SAME < f)
    })
}
