//! Varyings between corners.

use std::vec;
use std::vec::Vec;

use super::corner::Corner;

/// Varyings where a pixel is looked at, and how they change from pixel to pixel.
#[derive(Clone, Debug, Default)]
pub(super) struct Varyings {
    pub(super) here: Vec<f64>,
    pub(super) along: [Vec<f64>; 2],
}

impl Varyings {
    /// Those that do not change.
    pub(super) fn constant(varyings: &[f64]) -> Self {
        let still = || vec![0.0; varyings.len()];
        Self { here: varyings.to_vec(), along: [still(), still()] }
    }

    /// Those of corners with such weights, which change so by pixel.
    ///
    /// In perspective, a varying is the quotient of two that are linear on the screen, a / w and
    /// 1 / w, and its derivative that of a quotient.
    pub(super) fn mixed(
        corners: &[&Corner],
        weights: &[f64],
        slopes: [&[f64]; 2],
        in_perspective: bool,
    ) -> Self {
        let share = |corner: &Corner| if in_perspective { 1.0 / corner.w } else { 1.0 };
        let sum = |weights: &[f64], value: &dyn Fn(&Corner) -> f64| -> f64 {
            corners.iter().zip(weights).map(|(corner, weight)| weight * value(corner)).sum()
        };
        let varying = |corner: &Corner, i: usize| corner.varyings.get(i).copied().unwrap_or(0.0);
        let Some(first) = corners.first() else { return Self::default() };
        // Both linear functions; the upper one of what a corner has more than the first, so that
        // what is the same at all corners is so everywhere.
        let above = |weights: &[f64], i: usize| {
            sum(weights, &|corner| (varying(corner, i) - varying(first, i)) * share(corner))
        };
        let below = |weights: &[f64]| sum(weights, &share);
        let divisor = below(weights);
        let more: Vec<f64> =
            (0..first.varyings.len()).map(|i| above(weights, i) / divisor).collect();
        let along = slopes.map(|slopes| {
            let change = below(slopes);
            let slope = |(i, more): (usize, &f64)| (above(slopes, i) - more * change) / divisor;
            more.iter().enumerate().map(slope).collect()
        });
        let here = more.iter().enumerate().map(|(i, more)| varying(first, i) + more).collect();
        Self { here, along }
    }
}
