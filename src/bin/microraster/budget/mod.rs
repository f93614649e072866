//! `microraster budget`: whether a model fits a microcontroller, how it is drawn best there, how
//! fast, and what to give up first.

mod bytes;
mod core;
mod measure;
mod mesh;
mod plan;
mod report;
#[path = "../../../../examples/budget/settings.rs"]
mod settings;

use crate::simulate::options::PictureSize;
use bytes::Bytes;
use core::Target;
use measure::{Bench, Code};
use mesh::Prepared;
use microraster::Size;
use plan::{Cost, Offer, Setting, Shading};
use report::{counted, Report};
use std::io::{self, Write};
use std::path::PathBuf;

/// What stands under the options in `--help`.
const NOTES: &str = "\
The model is drawn in RGB565 with a 16-bit depth buffer, lit by one sun, back faces left out, seen
from four sides. QEMU runs the target's own code and counts its instructions; settings are tried
until the fastest that fits is found. Cycles an instruction takes are an assumption, which the
report states; sending pixels to the display is not in it.

It needs what `cargo firmware` needs: QEMU, a compiler for the target, and a clone of the crate.
On Debian: apt-get install cargo-web rustc-web rust-web-src lld-22 qemu-system-arm qemu-system-misc

The exit code is 0 where the model fits, 2 where it does not, 1 on an error.";

/// Say whether a model fits a microcontroller, and what it costs there.
#[derive(Debug, clap::Args)]
#[command(after_long_help = NOTES, after_help = NOTES)]
pub(crate) struct Arguments {
    /// The model: MODEL.obj, or MODEL.asc, a triangle soup
    model: PathBuf,
    /// Width and height of the display in pixels
    #[arg(long, value_name = "WxH", allow_hyphen_values = true)]
    display: PictureSize,
    /// RAM for bands, depth, caches, stack and statics
    #[arg(long, value_name = "BYTES", allow_hyphen_values = true)]
    ram: Bytes,
    /// Core and clock, like m0+@133MHz; cores are m0+, m3, m4f, m7, m33 and rv32
    #[arg(long, value_name = "CORE@CLOCK")]
    target: Target,
    /// Flash for code and model [default: as much as it takes]
    #[arg(long, value_name = "BYTES", allow_hyphen_values = true)]
    flash: Option<Bytes>,
    /// Put triangles into an order that suits a cache of 32 vertices first
    #[arg(long)]
    ordered: bool,
}

/// What the report says in the end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Verdict {
    Fits,
    DoesNotFit,
}

/// Measures and prints the report.
///
/// # Errors
/// A message for the user: the model cannot be loaded, or what measures it is not installed.
pub(crate) fn run(arguments: &Arguments) -> Result<Verdict, String> {
    let display = Size::new(arguments.display.width, arguments.display.height);
    let model = Prepared::load(&arguments.model, display, arguments.ordered)?;
    let bench = Bench::new(arguments.target.core, &model.words, display)?;
    let (chosen, code) = choose(&bench, display, arguments.ram.0, model.vertices)?;
    let offers = offers(&bench, display, &model, chosen, code)?;
    let name = arguments.model.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let report = Report {
        name: &name,
        model: &model,
        display,
        target: arguments.target,
        ram: arguments.ram.0,
        flash: arguments.flash.map(|bytes| bytes.0),
        chosen,
        code,
        offers,
    };
    match write!(io::stdout(), "{report}") {
        // A reader that has seen enough, like `head`, is no error.
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            return Err(format!("cannot print: {error}"));
        }
        _ => {}
    }
    Ok(report.verdict())
}

/// The best setting that fits into so much RAM; where none does, the smallest there is.
fn choose(bench: &Bench, display: Size, ram: u64, vertices: usize) -> Result<(Cost, Code), String> {
    let least = Setting { shading: Shading::Gouraud, cache: 0, rows: 1 };
    let code = bench.code(least)?;
    // A flag and its alignment for a cache.
    let statics = code.statics + 16;
    let mut stack = 0;
    loop {
        let room = ram.saturating_sub(statics + stack);
        let settings = plan::candidates(display, room, vertices);
        let costs = bench.costs(&settings)?;
        let Some(best) = plan::best(&costs, display) else {
            let costs = bench.costs(&[least])?;
            let cost = costs.first().ok_or("nothing was measured")?;
            return Ok((*cost, code));
        };
        if best.stack <= stack {
            let code = if best.setting.cache == 0 { code } else { bench.code(best.setting)? };
            return Ok((best, code));
        }
        // The stack is known only now; it differs little between settings.
        stack = best.stack.next_multiple_of(64);
    }
}

/// What can be given up, in the order in which one would.
fn offers(
    bench: &Bench,
    display: Size,
    model: &Prepared,
    chosen: Cost,
    code: Code,
) -> Result<Vec<Offer>, String> {
    let setting = chosen.setting;
    let mut offers = Vec::new();
    for cost in bench.costs(&plan::smaller(setting, display))? {
        let other = cost.setting;
        let more = cost.instructions as f64 / chosen.instructions.max(1) as f64 - 1.0;
        let (mut flash, mut seen) = (0, None);
        let what = if other.shading != setting.shading {
            flash = difference(code.flash, bench.code(other)?.flash);
            seen = Some("facets");
            "flat shading".to_owned()
        } else if other.cache != setting.cache {
            match other.cache {
                0 => "the cache of 32 vertices on the stack".to_owned(),
                vertices => format!("a cache of {vertices} vertices"),
            }
        } else {
            format!("bands of {}", counted(other.rows.into(), "row"))
        };
        let ram = difference(setting.buffers(display), other.buffers(display));
        offers.push(Offer { what, ram, flash, slower: Some(100.0 * more), seen });
    }
    offers.push(Offer {
        what: "no depth buffer".into(),
        ram: difference(setting.bands(display) / 2, 0),
        flash: 0,
        slower: None,
        seen: Some("what is drawn last is in front"),
    });
    offers.push(Offer {
        what: "a tenth of the triangles".into(),
        ram: 0,
        flash: difference(model.flash().iter().sum::<u64>() / 10, 0),
        slower: None,
        seen: Some("a coarser shape"),
    });
    plan::order(&mut offers);
    Ok(offers)
}

/// How much smaller the second is; less than zero where it is larger.
fn difference(first: u64, second: u64) -> i64 {
    first.cast_signed().wrapping_sub(second.cast_signed())
}
