//! The few vector operations that loading needs, in `f64`: products of three `f32` neither
//! overflow nor vanish in it, so huge and tiny models need no special case.

pub(super) type Vector = [f64; 3];

pub(super) fn wide(a: [f32; 3]) -> Vector {
    a.map(f64::from)
}

pub(super) fn sub([a, b, c]: Vector, [d, e, f]: Vector) -> Vector {
    [a - d, b - e, c - f]
}

pub(super) fn add([a, b, c]: Vector, [d, e, f]: Vector) -> Vector {
    [a + d, b + e, c + f]
}

pub(super) fn cross([a, b, c]: Vector, [d, e, f]: Vector) -> Vector {
    [b * f - c * e, c * d - a * f, a * e - b * d]
}

/// The vector of length 1 in the direction of `a`; `None` if that has no direction.
pub(super) fn unit([a, b, c]: Vector) -> Option<[f32; 3]> {
    let length = (a * a + b * b + c * c).sqrt();
    if !length.is_finite() || length <= 0.0 {
        return None;
    }
    #[allow(
        clippy::cast_possible_truncation,
        reason = "components of a unit vector lie within -1..=1"
    )]
    Some([a, b, c].map(|component| (component / length) as f32))
}
