//! Cost against error, a picture a scene and a board.

use plotters::prelude::*;
use std::path::Path;

use crate::costs::BOARDS;
use crate::row::{is_on_front_of, Row};

const SIZE: (u32, u32) = (960, 560);
const FONT: &str = "sans-serif";
const INK: RGBColor = RGBColor(40, 44, 52);
const FRONT: RGBColor = RGBColor(0, 90, 181);
const BEATEN: RGBColor = RGBColor(150, 150, 150);
const DEFAULT: RGBColor = RGBColor(220, 50, 32);

/// A label: where its point is on the picture, and what it says.
struct Label {
    x: i32,
    y: i32,
    text: String,
}

/// 1, 2 and 5 of every power of ten between two numbers: what a logarithmic axis names.
fn ticks(from: f64, to: f64) -> Vec<f64> {
    let powers = (-3..12).map(|power| 10_f64.powi(power));
    let all = powers.flat_map(|power| [1.0, 2.0, 5.0].map(|digit| digit * power));
    all.filter(|tick| (from..=to).contains(tick)).collect()
}

/// Moves labels down until none covers another; `height` of each.
fn spread(labels: &mut [Label], height: i32) {
    const WIDTH_OF_A_LETTER: i32 = 6;
    labels.sort_by_key(|label| (label.y, label.x));
    for i in 1..labels.len() {
        let (placed, rest) = labels.split_at_mut(i);
        let Some(label) = rest.first_mut() else { return };
        let width = |text: &str| i32::try_from(text.len()).unwrap_or(0) * WIDTH_OF_A_LETTER + 8;
        // Each pass may push the label onto another; there are only so many.
        for _ in 0..placed.len() {
            let covered = placed.iter().find(|other| {
                let beside = label.x >= other.x + width(&other.text)
                    || other.x >= label.x + width(&label.text);
                !beside && (label.y - other.y).abs() < height
            });
            match covered {
                Some(other) => label.y = other.y + height,
                None => break,
            }
        }
    }
}

/// Draws the rows of a scene as points: instructions a frame to the right, the difference from the
/// ideal picture upwards; the Pareto front as a line.
///
/// # Errors
/// The file cannot be written.
pub(crate) fn draw(title: &str, board: usize, rows: &[&Row], file: &Path) -> Result<(), String> {
    plot(title, board, rows, file).map_err(|why| format!("{}: {why}", file.display()))
}

fn plot(
    title: &str,
    board: usize,
    rows: &[&Row],
    file: &Path,
) -> Result<(), Box<dyn std::error::Error>> {
    let ideal = |row: &Row| row.errors.from_ideal;
    let cost = |row: &Row| row.cost.instructions[board] as f64;
    let costs = || rows.iter().map(|row| cost(row));
    let (low, high) = (costs().fold(f64::MAX, f64::min), costs().fold(0.0, f64::max));
    let errors = || rows.iter().map(|row| ideal(row));
    let (least, most) = (errors().fold(f64::MAX, f64::min), errors().fold(0.0, f64::max));

    let (bottom, top) = (least.max(0.1) * 0.9, most.max(1.0) * 1.15);

    let area = SVGBackend::new(file, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    let name = BOARDS.get(board).map_or("", |(_, name)| name);
    let mut chart = ChartBuilder::on(&area)
        .caption(format!("{title} on {name}"), (FONT, 20).into_font().color(&INK))
        .margin(12)
        .margin_right(130)
        .x_label_area_size(42)
        .y_label_area_size(60)
        .build_cartesian_2d(
            (low * 0.9..high * 1.12).log_scale().with_key_points(ticks(low * 0.9, high * 1.12)),
            (bottom..top).log_scale().with_key_points(ticks(bottom, top)),
        )?;
    chart
        .configure_mesh()
        .light_line_style(WHITE.mix(0.0))
        .x_labels(14)
        .y_labels(10)
        .x_desc("instructions a frame")
        .y_desc("difference from the ideal, root mean square of 255")
        .x_label_formatter(&|count| crate::table::millions(count.round() as u64))
        .y_label_formatter(&|error| crate::table::number(*error))
        .label_style((FONT, 13).into_font().color(&INK))
        .axis_desc_style((FONT, 14).into_font().color(&INK))
        .draw()?;

    let mut front: Vec<&Row> =
        rows.iter().copied().filter(|row| is_on_front_of(board, row, rows, ideal)).collect();
    front.sort_by(|a, b| cost(a).total_cmp(&cost(b)));
    let steps = front.iter().enumerate().flat_map(|(i, row)| {
        // Between two points of the front nothing better is known than the one before.
        let before = i.checked_sub(1).and_then(|before| front.get(before));
        before.map(|before| (cost(row), ideal(before))).into_iter().chain([(cost(row), ideal(row))])
    });
    chart.draw_series(LineSeries::new(steps, FRONT.stroke_width(2)))?;

    let several = rows.iter().any(|row| row.case.knobs != rows[0].case.knobs);
    let mut labels = Vec::new();
    // Settings of several knobs that are one and the same picture share a point, and so do all
    // that are the default.
    let mut points: Vec<(&Row, String)> = Vec::new();
    for row in rows {
        let text = match (row.case.is_default(), row.case.knobs.as_slice()) {
            (true, _) => "default".into(),
            (false, [knob]) if several => format!("{knob} {}", row.case.setting()),
            _ => row.case.setting(),
        };
        let same = points.iter_mut().find(|(other, known)| {
            let is_equal = other.cost == row.cost && (ideal(other) - ideal(row)).abs() < 1e-9;
            is_equal || (text == "default" && known.starts_with("default"))
        });
        match same {
            Some((_, known)) if known.split(", ").any(|part| part == text) => {}
            Some((_, known)) => *known = format!("{known}, {text}"),
            None => points.push((row, text)),
        }
    }
    // The default lies on top.
    points.sort_by_key(|(_, text)| text.starts_with("default"));
    for (row, text) in &points {
        let color = if text.split(", ").any(|part| part == "default") {
            DEFAULT
        } else if is_on_front_of(board, row, rows, ideal) {
            FRONT
        } else {
            BEATEN
        };
        let at = (cost(row), ideal(row));
        chart.draw_series([Circle::new(at, 4, color.filled())])?;
        let (x, y) = chart.backend_coord(&at);
        labels.push(Label { x: x + 7, y: y - 15, text: text.clone() });
    }
    spread(&mut labels, 13);
    for label in labels {
        let style = (FONT, 12).into_font().color(&INK);
        area.draw(&Text::new(label.text, (label.x, label.y), style))?;
    }
    area.present()?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_name_numbers_of_every_power() {
        assert_eq!(ticks(14.0, 95.0), [20.0, 50.0]);
        assert_eq!(ticks(0.9, 2.0), [1.0, 2.0]);
    }

    #[test]
    fn labels_do_not_cover_each_other() {
        let label = |y| Label { x: 0, y, text: "abc".into() };
        let mut labels = [label(5), label(0), label(3), label(40)];
        spread(&mut labels, 10);
        for pair in labels.windows(2) {
            assert!(pair[1].y - pair[0].y >= 10);
        }
        assert_eq!(labels[3].y, 40, "what is free stays");
    }
}
