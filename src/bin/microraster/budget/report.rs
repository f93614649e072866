//! The report, as it is read.

use super::core::Target;
use super::measure::Code;
use super::mesh::Prepared;
use super::plan::{Cost, Offer, Shading};
use super::settings::{cache_bytes, VIEWS};
use super::Verdict;
use microraster::Size;
use std::fmt;

/// All that it says.
#[derive(Debug)]
pub(crate) struct Report<'a> {
    pub(crate) name: &'a str,
    pub(crate) model: &'a Prepared,
    pub(crate) display: Size,
    pub(crate) target: Target,
    /// Bytes that there are; of flash perhaps any number.
    pub(crate) ram: u64,
    pub(crate) flash: Option<u64>,
    pub(crate) chosen: Cost,
    pub(crate) code: Code,
    pub(crate) offers: Vec<Offer>,
}

impl Report<'_> {
    /// RAM by purpose.
    fn ram_uses(&self) -> [(u64, String); 5] {
        let setting = self.chosen.setting;
        let band = setting.bands(self.display) / 2;
        let rows = counted(setting.rows.into(), "row");
        [
            (band, format!("colour, {rows}")),
            (band, format!("depth, {rows}")),
            (cache_bytes(setting.cache) as u64, "vertex cache".into()),
            (self.chosen.stack, "stack while drawing, measured".into()),
            (self.code.statics, "other statics".into()),
        ]
    }

    /// Flash by purpose.
    fn flash_uses(&self) -> [(u64, String); 7] {
        let weights = self.code.weights;
        let [positions, normals, indices] = self.model.flash();
        [
            ((weights.own + weights.core).into(), "code".into()),
            (weights.rest.into(), "tables and constants".into()),
            ((weights.builtins + weights.panic).into(), "the compiler's own routines".into()),
            (weights.runtime.into(), "vectors and start-up".into()),
            (positions, format!("positions of {} vertices", self.model.vertices)),
            (normals, "normals".into()),
            (indices, format!("indices of {}", counted(self.model.triangles, "triangle"))),
        ]
    }

    /// Bytes of RAM and of flash that are missing.
    fn missing(&self) -> [u64; 2] {
        let flash = self.flash.map_or(0, |flash| sum(&self.flash_uses()).saturating_sub(flash));
        [sum(&self.ram_uses()).saturating_sub(self.ram), flash]
    }

    /// Whether all of it fits.
    pub(crate) fn verdict(&self) -> Verdict {
        if self.missing() == [0, 0] {
            Verdict::Fits
        } else {
            Verdict::DoesNotFit
        }
    }

    /// What to give up: where it does not fit, only what frees some of the memory that is missing.
    fn give_up(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [ram, flash] = self.missing();
        let fits = self.verdict() == Verdict::Fits;
        let helps = |offer: &&Offer| ram > 0 && offer.ram > 0 || flash > 0 && offer.flash > 0;
        let offers: Vec<_> = self.offers.iter().filter(|offer| fits || helps(offer)).collect();
        // More than all of them free together: each is told as if it were the only one.
        let freed: u64 = offers.iter().map(|offer| offer.ram.max(0).unsigned_abs()).sum();
        let title = match (fits, offers.is_empty() || ram > freed) {
            (true, _) => "For more room, give up first",
            (false, false) => "To make it fit, give up first",
            (false, true) if offers.is_empty() => "Nothing of it can be given up",
            (false, true) => "To come nearer, give up first; all of it is not enough",
        };
        writeln!(f, "\n{title}")?;
        offers.into_iter().try_for_each(|one| offer(f, one))
    }

    /// How it is drawn.
    fn settings(&self) -> String {
        let setting = self.chosen.setting;
        let shading = match setting.shading {
            Shading::Gouraud => "Gouraud",
            Shading::Flat => "flat",
        };
        let bands = match self.display.height.div_ceil(setting.rows.max(1)) {
            1 => "the whole picture at once".into(),
            bands => format!("{bands} bands of {}", counted(setting.rows.into(), "row")),
        };
        let cache = match setting.cache {
            0 => "the cache of 32 vertices that a draw has on the stack".into(),
            vertices => format!("a cache of {vertices} vertices"),
        };
        format!("{shading}, 16-bit depth, {bands}, {cache}")
    }
}

fn sum(uses: &[(u64, String)]) -> u64 {
    uses.iter().map(|(bytes, _)| bytes).sum()
}

/// The digits in groups of three.
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (at, digit) in digits.chars().enumerate() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

/// A number of things.
pub(super) fn counted(number: usize, thing: &str) -> String {
    let plural = if number == 1 { "" } else { "s" };
    format!("{} {thing}{plural}", grouped(number as u64))
}

/// A memory: what there is, what of it is used for what.
fn memory(
    f: &mut fmt::Formatter<'_>,
    name: &str,
    room: Option<u64>,
    uses: &[(u64, String)],
) -> fmt::Result {
    let used = sum(uses);
    match room {
        Some(room) if used > room => {
            let (used, over) = (grouped(used), grouped(used - room));
            writeln!(f, "\n{name}: {used} bytes, {over} more than there are")?;
        }
        Some(room) => {
            let (used, left) = (grouped(used), grouped(room - used));
            writeln!(f, "\n{name}: {used} bytes, {left} left")?;
        }
        None => writeln!(f, "\n{name}: {} bytes", grouped(used))?,
    }
    for (bytes, what) in uses.iter().filter(|(bytes, _)| *bytes > 0) {
        writeln!(f, "{:>11}  {what}", grouped(*bytes))?;
    }
    Ok(())
}

/// What can be given up.
fn offer(f: &mut fmt::Formatter<'_>, offer: &Offer) -> fmt::Result {
    let mut words = Vec::new();
    for (bytes, memory) in [(offer.ram, "RAM"), (offer.flash, "flash")] {
        match bytes {
            0 => {}
            bytes if bytes > 0 => {
                words.push(format!("{} bytes of {memory} less", grouped(bytes.unsigned_abs())));
            }
            bytes => {
                words.push(format!("{} bytes of {memory} more", grouped(bytes.unsigned_abs())))
            }
        }
    }
    match offer.slower {
        Some(slower) if slower >= 0.0 => words.push(format!("{slower:.0} % more instructions")),
        Some(slower) => words.push(format!("{:.0} % fewer instructions", -slower)),
        None => {}
    }
    words.extend(offer.seen.map(str::to_owned));
    writeln!(f, "  {}: {}", offer.what, words.join(", "))
}

impl fmt::Display for Report<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, model, display, target, chosen, .. } = self;
        let verdict = match self.verdict() {
            Verdict::Fits => "fits",
            Verdict::DoesNotFit => "does not fit",
        };
        writeln!(
            f,
            "{name}: {}, {} vertices, {}",
            counted(model.triangles, "triangle"),
            grouped(model.vertices as u64),
            counted(model.parts, "part")
        )?;
        writeln!(
            f,
            "{verdict} {} at {:.0} MHz, {}x{} pixels",
            target.core.name,
            target.hertz / 1e6,
            display.width,
            display.height
        )?;
        writeln!(f, "\nSettings: {}", self.settings())?;
        let [worst, best] = target.frames_per_second(chosen.instructions);
        let [fewest, most] = target.core.cycles;
        writeln!(f, "Speed: {worst:.1} to {best:.1} frames a second")?;
        writeln!(
            f,
            "  {} instructions a frame, counted, the mean of {VIEWS} views, clears included",
            grouped(chosen.instructions)
        )?;
        writeln!(f, "  {fewest} to {most} cycles an instruction, assumed: {}", target.core.reason)?;
        writeln!(f, "  sending pixels to the display is not included")?;
        memory(f, "RAM", Some(self.ram), &self.ram_uses())?;
        memory(f, "Flash", self.flash, &self.flash_uses())?;
        self.give_up(f)?;
        let [made, ordered] = model.made;
        // Less is not worth another order.
        if ordered * 10 < made * 9 {
            let (made, ordered) = (grouped(made as u64), grouped(ordered as u64));
            writeln!(f, "\nFor more speed, put triangles into another order: --ordered")?;
            writeln!(f, "  {ordered} vertices made by a cache of 32 instead of {made}")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::plan::Setting;
    use super::*;
    use crate::firmware::sizes::Weights;

    fn report(model: &Prepared, ram: u64, flash: Option<u64>) -> Report<'_> {
        Report {
            name: "cube.obj",
            model,
            display: Size::new(240, 240),
            target: "m0+@133MHz".parse().expect("the form of the help"),
            ram,
            flash,
            chosen: Cost {
                setting: Setting { shading: Shading::Gouraud, cache: 64, rows: 60 },
                instructions: 1_330_000,
                stack: 1400,
            },
            code: Code {
                weights: Weights { own: 9000, core: 100, rest: 900, ..Weights::default() },
                flash: 10_000,
                statics: 8,
            },
            offers: vec![Offer {
                what: "bands of 30 rows".into(),
                ram: 28_800,
                flash: -4,
                slower: Some(12.4),
                seen: None,
            }],
        }
    }

    #[test]
    fn the_report_says_what_fits_and_what_it_takes() {
        let model =
            Prepared { words: Vec::new(), triangles: 12, vertices: 24, parts: 1, made: [24; 2] };
        let fits = report(&model, 64 << 10, Some(16 << 10));
        assert_eq!(fits.verdict(), Verdict::Fits);
        let text = fits.to_string();
        for part in [
            "cube.obj: 12 triangles, 24 vertices, 1 part\nfits m0+ at 133 MHz, 240x240 pixels\n",
            "Settings: Gouraud, 16-bit depth, 4 bands of 60 rows, a cache of 64 vertices\n",
            // 133 MHz by 1.33 million instructions is 100 a cycle.
            "Speed: 62.5 to 76.9 frames a second\n",
            "1 330 000 instructions a frame",
            "1.3 to 1.6 cycles an instruction, assumed: ",
            "RAM: 60 288 bytes, 5 248 left\n     28 800  colour, 60 rows\n     28 800  depth",
            "Flash: 10 288 bytes, 6 096 left\n      9 100  code\n",
            "For more room, give up first\n  bands of 30 rows: 28 800 bytes of RAM less, \
             4 bytes of flash more, 12 % more instructions\n",
        ] {
            assert!(text.contains(part), "no `{part}` in\n{text}");
        }
    }

    #[test]
    fn only_what_frees_the_memory_that_is_missing_is_told() {
        let model =
            Prepared { words: Vec::new(), triangles: 12, vertices: 24, parts: 1, made: [24; 2] };
        let told = |ram: u64, flash: Option<u64>| report(&model, ram, flash).to_string();
        // The only offer frees 28 800 bytes of RAM.
        let text = told(40_000, None);
        assert!(text.contains("\nTo make it fit, give up first\n  bands of 30 rows: "), "{text}");
        let text = told(1_000, None);
        let title = "\nTo come nearer, give up first; all of it is not enough\n  bands of 30 ";
        assert!(text.contains(title), "{text}");
        let text = told(64 << 10, Some(1_000));
        assert!(text.ends_with("\nNothing of it can be given up\n"), "{text}");
    }

    #[test]
    fn one_triangle_is_no_plural() {
        let model =
            Prepared { words: Vec::new(), triangles: 1, vertices: 3, parts: 1, made: [3; 2] };
        let text = report(&model, 64 << 10, None).to_string();
        assert!(text.contains("cube.obj: 1 triangle, 3 vertices, 1 part\n"), "{text}");
        assert!(text.contains("  indices of 1 triangle\n"), "{text}");
        assert_eq!(counted(3674, "triangle"), "3 674 triangles", "grouped as elsewhere");
    }

    #[test]
    fn what_is_short_is_told_by_memory() {
        let model =
            Prepared { words: Vec::new(), triangles: 12, vertices: 24, parts: 2, made: [24; 2] };
        let small = report(&model, 60_000, None);
        assert_eq!(small.verdict(), Verdict::DoesNotFit);
        let text = small.to_string();
        assert!(text.contains("RAM: 60 288 bytes, 288 more than there are\n"), "{text}");
        assert!(text.contains("does not fit m0+") && text.contains("To make it fit"), "{text}");
        let small = report(&model, 64 << 10, Some(10_000));
        assert_eq!(small.verdict(), Verdict::DoesNotFit);
        let text = small.to_string();
        assert!(text.contains("Flash: 10 288 bytes, 288 more than there are\n"), "{text}");
    }

    #[test]
    fn another_order_is_offered_where_it_gains_a_tenth() {
        let text = |made| {
            let (triangles, vertices, parts) = (2000, 1000, 1);
            let model = Prepared { words: Vec::new(), triangles, vertices, parts, made };
            report(&model, 64 << 10, None).to_string()
        };
        let offered =
            "another order: --ordered\n  1 100 vertices made by a cache of 32 instead of 3 600\n";
        assert!(text([3600, 1100]).ends_with(offered), "{}", text([3600, 1100]));
        assert!(!text([3600, 3300]).contains("--ordered"), "not for a twelfth");
    }
}
