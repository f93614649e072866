//! `--ladder`: what a scene of one triangle costs in flash, RAM and instructions, with one feature
//! more on each rung.

use super::board::Board;
use super::build::House;
use super::figures::Figures;
use super::{emulate, lines, sizes};
use std::path::Path;

/// One rung.
#[derive(Debug)]
struct Rung {
    /// As `examples/ladder.rs` names it.
    variant: &'static str,
    /// As the table names it.
    title: &'static str,
    /// Parts of names that no function of a rung below may have.
    parts: &'static [&'static str],
}

/// From the ground up.
const RUNGS: [Rung; 11] = [
    Rung { variant: "nothing", title: "nothing drawn", parts: &[] },
    Rung { variant: "flat", title: "one flat triangle", parts: &["raster::", "pipeline::"] },
    Rung { variant: "depth", title: "+ depth", parts: &["DepthBuffer", "depth_test::Less"] },
    Rung { variant: "gouraud", title: "+ Gouraud", parts: &["gouraud", "smooth_color"] },
    Rung { variant: "texture", title: "+ texture", parts: &["texture", "textured"] },
    Rung {
        variant: "perspective",
        title: "+ perspective",
        parts: &["perspective::subspans", "perspective::planes"],
    },
    Rung { variant: "bilinear", title: "+ bilinear", parts: &["Bilinear", "texture::weights"] },
    Rung { variant: "blend", title: "+ blend", parts: &["blend"] },
    Rung { variant: "fog", title: "+ fog", parts: &["fog"] },
    Rung { variant: "lights", title: "+ lights", parts: &["lighting"] },
    Rung {
        variant: "all",
        title: "all",
        parts: &["stencil", "dither", "color_mask", "mip_", "::line::", "::point"],
    },
];

/// What one rung costs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Cost {
    instructions: u64,
    stack: u64,
    /// Bytes of colour, depth and stencil.
    buffers: [u64; 3],
}

impl Cost {
    /// Reads what the firmware printed.
    ///
    /// # Errors
    /// A figure is missing or no number.
    fn read(printed: &str) -> Result<Self, String> {
        let figure = |name| {
            lines::value(printed, name)
                .and_then(|text| text.parse().ok())
                .ok_or_else(|| format!("the ladder printed no `{name}=…` but `{printed}`"))
        };
        Ok(Self {
            instructions: figure("instructions")?,
            stack: figure("stack")?,
            buffers: [figure("color")?, figure("depth")?, figure("stencil")?],
        })
    }
}

/// Climbs the ladder on a board, prints each rung and puts the table into `file`.
///
/// # Errors
/// A build or a run failed, a rung contains code of one above it, or the file has no marks for
/// the board's table.
pub(crate) fn climb(house: &House, board: &Board, file: Option<&Path>) -> Result<(), String> {
    const COLUMNS: [&str; 7] =
        ["flash", "more", "colour", "depth and stencil", "other RAM", "stack", "instructions"];
    let mut rows = Vec::new();
    let mut before = None;
    for (number, rung) in RUNGS.iter().enumerate() {
        let linked = house.example_of("ladder", rung.variant, board)?;
        let elf = sizes::read(&linked, rung.variant, board)?;
        for above in RUNGS.get(number + 1..).unwrap_or_default() {
            if let Some(what) = sizes::foreign(&elf, above.parts) {
                let (title, name, above) = (rung.title, board.name, above.title);
                return Err(format!("`{title}` on {name} pays for `{above}`: it contains {what}"));
            }
        }
        let cost = Cost::read(&emulate::run(board, &linked, &house.firmware()?, &[], None)?)?;
        let flash = elf.flash();
        let more = i64::from(flash) - i64::from(before.unwrap_or(flash));
        before = Some(flash);
        let [color, depth, stencil] = cost.buffers;
        let other = u64::from(elf.ram()).saturating_sub(color + depth + stencil);
        println!(
            "board={} rung={:?} flash={flash} more={more} colour={color} depth={depth} \
             stencil={stencil} other={other} stack={} instructions={}",
            board.name, rung.title, cost.stack, cost.instructions
        );
        rows.push([
            flash.to_string(),
            more.to_string(),
            color.to_string(),
            (depth + stencil).to_string(),
            other.to_string(),
            cost.stack.to_string(),
            cost.instructions.to_string(),
        ]);
    }
    let mut figures = Figures::default();
    for (column, name) in COLUMNS.iter().enumerate() {
        figures.board(name);
        for (rung, row) in RUNGS.iter().zip(&rows) {
            figures.put(rung.title, row[column].clone());
        }
    }
    file.map_or(Ok(()), |file| figures.write(file, &format!("ladder {}", board.name)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_is_read_back() {
        let printed = " instructions=52000 stack=900 color=16384 depth=16384 stencil=0\n";
        let cost = Cost { instructions: 52_000, stack: 900, buffers: [16_384, 16_384, 0] };
        assert_eq!(Cost::read(printed), Ok(cost));
        let message = Cost::read("instructions=x").expect_err("no number");
        assert!(message.contains("instructions=x"), "the message is: {message}");
    }
}
