//! The tests of fragments.

use super::DepthPrecision;
use crate::shade::{AnyCompare, AnyDepth, AnyDepthState, AnyOperation, AnyStencil};

/// Whether a depth code passes; larger is nearer.
#[allow(clippy::float_cmp, reason = "equal is what is asked")]
fn is_near_enough(test: AnyDepth, new: f64, stored: f64) -> bool {
    match test {
        AnyDepth::Off | AnyDepth::Always => true,
        AnyDepth::Less => new > stored,
        AnyDepth::LessEqual => new >= stored,
        AnyDepth::Equal => new == stored,
        AnyDepth::Greater => new < stored,
        AnyDepth::GreaterEqual => new <= stored,
        AnyDepth::NotEqual => new != stored,
    }
}

fn compares(compare: AnyCompare, reference: u8, stored: u8) -> bool {
    match compare {
        AnyCompare::Never => false,
        AnyCompare::Less => reference < stored,
        AnyCompare::LessEqual => reference <= stored,
        AnyCompare::Equal => reference == stored,
        AnyCompare::Greater => reference > stored,
        AnyCompare::GreaterEqual => reference >= stored,
        AnyCompare::NotEqual => reference != stored,
        AnyCompare::Always => true,
    }
}

fn left(operation: AnyOperation, reference: u8, stored: u8) -> u8 {
    match operation {
        AnyOperation::Keep => stored,
        AnyOperation::Replace => reference,
        AnyOperation::Zero => 0,
        AnyOperation::IncrementClamp => stored.saturating_add(1),
        AnyOperation::IncrementWrap => stored.wrapping_add(1),
        AnyOperation::DecrementClamp => stored.saturating_sub(1),
        AnyOperation::DecrementWrap => stored.wrapping_sub(1),
        AnyOperation::Invert => !stored,
    }
}

/// Tests a fragment against what is stored, which becomes what it leaves; whether its colour is
/// drawn.
pub(super) fn test(
    depth: &AnyDepthState,
    stencil: Option<AnyStencil>,
    new: f64,
    stored: &mut f64,
    value: &mut u8,
) -> bool {
    let is_near_enough = is_near_enough(depth.test, new, *stored);
    let mut passes = is_near_enough;
    if let Some(stencil) = stencil {
        let AnyStencil { compare, reference, read_mask, write_mask, .. } = stencil;
        let is_let_through = compares(compare, reference & read_mask, *value & read_mask);
        let operation = match (is_let_through, is_near_enough) {
            (false, _) => stencil.on_fail,
            (true, false) => stencil.on_depth_fail,
            (true, true) => stencil.on_pass,
        };
        let after = left(operation, reference, *value);
        *value = after & write_mask | *value & !write_mask;
        passes &= is_let_through;
    }
    if passes && depth.test != AnyDepth::Off && !depth.read_only {
        *stored = new;
    }
    passes
}

/// The code of a corner where codes have a range.
pub(super) fn in_range(depth: &AnyDepthState, code: f64) -> f64 {
    let (farthest, nearest) = (f64::from(depth.range.0), f64::from(depth.range.1));
    farthest + (nearest - farthest) * code / 65_535.0
}

impl DepthPrecision {
    pub(super) fn round(self, code: f64) -> f64 {
        match self {
            Self::Exact => code,
            Self::Codes => code.round(),
        }
    }

    /// The mean of corners' codes: of whole ones, and down to one, where depths are whole codes.
    pub(super) fn mean(self, codes: &[f64]) -> f64 {
        let sum: f64 = codes.iter().map(|code| self.round(*code)).sum();
        let mean = sum / codes.len() as f64;
        match self {
            Self::Exact => mean,
            Self::Codes => mean.floor(),
        }
    }
}
