//! How far a case's picture is from what it should be.

use microraster::host::reference::compare::Difference;
use microraster::Camera;

use crate::case::Case;
use crate::drawing::Drawing;
use crate::scenes::standard::SIZE;
use crate::truth::Truth;

/// A mean and a largest value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Spread {
    pub(crate) mean: f64,
    pub(crate) max: f64,
}

impl Spread {
    /// Of what is given; `None` for nothing.
    pub(crate) fn of(values: impl IntoIterator<Item = f64>) -> Option<Self> {
        let (mut sum, mut max, mut count) = (0.0, 0.0_f64, 0_u32);
        for value in values {
            sum += value;
            max = max.max(value);
            count += 1;
        }
        (count > 0).then(|| Self { mean: sum / f64::from(count), max })
    }
}

/// All of it. What a case has nothing of is `None`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Errors {
    /// Pixels that are drawn and should not be, or the other way round, corners taken where they
    /// are and not on the grid.
    pub(crate) coverage: Option<usize>,
    /// Differences of depth in codes, where the same triangle is seen with corners on the grid and
    /// without.
    pub(crate) codes: Option<Spread>,
    /// The same in units of eye space.
    pub(crate) units: Option<Spread>,
    /// Differences of texture coordinates, in texels.
    pub(crate) texels: Option<Spread>,
    /// Differences of colour, 0 to 255.
    pub(crate) color: Difference,
    /// The peak signal to noise ratio of means over 8x8 pixels: what an eye sees that is too far
    /// away for single pixels.
    pub(crate) from_afar: f64,
    /// The root of the mean square difference from the best that the scene could show, 0 to 255.
    pub(crate) from_ideal: f64,
}

/// Whether a case's depth buffer holds the depths of its whole picture.
fn has_depths(case: &Case) -> bool {
    let is_partial = case.knobs.iter().any(|knob| knob == "samples" || knob == "rows");
    let writes = case.setting() != "off" && case.setting() != "read-only";
    !is_partial && writes && case.scene != "heads-up"
}

/// Compares a picture.
pub(crate) fn compare(
    case: &Case,
    drawing: &Drawing,
    truth: &Truth,
    ideal: &[[f64; 3]],
    texels: Option<Spread>,
    camera: &Camera,
) -> Errors {
    let exact = &truth.exact;
    let depths = has_depths(case) && case.scene != "range";
    let coverage = has_depths(case).then(|| {
        let seen = exact.seen().iter().map(Option::is_some);
        drawing.codes.iter().zip(seen).filter(|(code, seen)| (**code != 0) != *seen).count()
    });
    // Where the grid moves no edge over a pixel.
    let stable = || {
        let pixels = exact.seen().iter().zip(truth.snapped.seen()).enumerate();
        pixels.filter(|(_, (a, b))| a.is_some() && a == b).map(|(i, _)| i)
    };
    let compared = || {
        stable()
            .filter(|i| drawing.codes.get(*i).is_some_and(|code| *code != 0))
            .filter_map(|i| Some((f64::from(*drawing.codes.get(i)?), *exact.depths().get(i)?)))
    };
    let off = |(drawn, exact): (f64, f64)| (drawn - exact).abs();
    let eye = |code: f64| distance(camera, code);
    Errors {
        coverage,
        codes: depths.then(|| Spread::of(compared().map(off))).flatten(),
        units: depths
            .then(|| Spread::of(compared().map(|(a, b)| (eye(a) - eye(b)).abs())))
            .flatten(),
        texels,
        color: Difference::between(&drawing.colors, &truth.colors, drawing.steps),
        from_afar: Difference::between(
            &blocks(&drawing.colors),
            &blocks(&truth.colors),
            drawing.steps,
        )
        .psnr,
        from_ideal: root_mean_square(&drawing.colors, ideal),
    }
}

fn root_mean_square(a: &[[f64; 3]], b: &[[f64; 3]]) -> f64 {
    let squares = a.iter().zip(b).flat_map(|(a, b)| (0..3).map(move |i| (a[i] - b[i]).powi(2)));
    Spread::of(squares).map_or(0.0, |squares| squares.mean.sqrt())
}

/// How far away a depth code is, along the view.
fn distance(camera: &Camera, code: f64) -> f64 {
    let columns = camera.projection(1.0).to_columns();
    // Clip z is a z + b at eye z = -d, and w is d.
    let (a, b) = (f64::from(columns[2][2]), f64::from(columns[3][2]));
    b / ((code - 2.0) / 65_531.0 + a)
}

/// Means over blocks of 8x8 pixels.
fn blocks(colors: &[[f64; 3]]) -> Vec<[f64; 3]> {
    const SIDE: usize = 8;
    let width = usize::from(SIZE.width);
    let across = width / SIDE;
    let mut sums = vec![[0.0; 3]; colors.len() / (SIDE * SIDE)];
    for (i, color) in colors.iter().enumerate() {
        let block = i / width / SIDE * across + i % width / SIDE;
        if let Some(sum) = sums.get_mut(block) {
            *sum = [0, 1, 2].map(|k| sum[k] + color[k] / (SIDE * SIDE) as f64);
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;
    use microraster::math::Angle;

    #[test]
    fn codes_become_distances() {
        let camera = Camera::perspective(Angle::from_degrees(45.0), 0.5);
        for (camera, at, z) in [
            (camera, 0.5, 1.0),
            (camera, 2.0, 0.25),
            (camera.far(100.0), 0.5, 1.0),
            (camera.far(100.0), 100.0, 0.0),
        ] {
            let found = distance(&camera, 2.0 + 65_531.0 * z);
            assert!((found / at - 1.0).abs() < 1e-4, "{found} is not {at}");
        }
    }

    #[test]
    fn blocks_are_means() {
        let pixels = usize::from(SIZE.width) * usize::from(SIZE.height);
        let colors: Vec<[f64; 3]> = (0..pixels)
            .map(|i| if i % 2 == 0 { [10.0, 0.0, 4.0] } else { [20.0, 0.0, 4.0] })
            .collect();
        let blocks = blocks(&colors);
        assert_eq!(blocks.len(), 1200);
        assert!(blocks.iter().all(|block| (block[0] - 15.0).abs() < 1e-9));
    }
}
