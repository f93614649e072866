//! The cores that a budget is made for, and what is assumed of each.

use std::str::FromStr;

/// One core.
#[derive(Debug, PartialEq)]
pub(crate) struct Core {
    /// The name on the command line.
    pub(crate) name: &'static str,
    /// QEMU's board that runs its code, as `cargo firmware --boards` names it.
    pub(crate) board: &'static str,
    /// Cycles an instruction of the pixel loops takes, at best and at worst. An assumption: QEMU
    /// counts instructions and no cycles.
    pub(crate) cycles: [f64; 2],
    /// Where the assumption comes from.
    pub(crate) reason: &'static str,
}

/// All of them. Memory is assumed to answer at once; what waits for flash is slower.
pub(crate) const CORES: [Core; 6] = [
    Core {
        name: "m0+",
        board: "m0",
        cycles: [1.3, 1.6],
        reason: "loads, stores and taken branches take 2 cycles, all else 1",
    },
    Core {
        name: "m3",
        board: "m3",
        cycles: [1.3, 1.7],
        reason: "loads 2 or less in a row, taken branches 2 to 4, long products 3 to 5",
    },
    Core {
        name: "m4f",
        board: "m4",
        cycles: [1.2, 1.5],
        reason: "loads 2 or less in a row, taken branches 2 to 4, products 1",
    },
    Core {
        name: "m7",
        board: "m7",
        cycles: [0.6, 1.0],
        reason:
            "up to two instructions a cycle, branches predicted; memory tightly coupled or cached",
    },
    Core {
        name: "m33",
        board: "m33",
        cycles: [1.1, 1.4],
        reason: "loads 1 or 2, taken branches 2 to 3, some pairs at once",
    },
    Core {
        name: "rv32",
        board: "rv32",
        cycles: [1.2, 1.7],
        reason: "a short pipeline in order, as of Hazard3 or an ESP32-C3; cores differ",
    },
];

/// A core and its clock.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Target {
    pub(crate) core: &'static Core,
    /// Cycles a second.
    pub(crate) hertz: f64,
}

impl Target {
    /// Frames a second of so many instructions, at worst and at best.
    pub(crate) fn frames_per_second(&self, instructions: u64) -> [f64; 2] {
        let [best, worst] = self.core.cycles;
        [worst, best].map(|cycles| self.hertz / (instructions.max(1) as f64 * cycles))
    }
}

impl FromStr for Target {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let names = || CORES.map(|core| core.name).join(", ");
        let form = "write it like m0+@133MHz";
        let (name, clock) = text.split_once('@').ok_or_else(|| format!("{form}: core @ clock"))?;
        let core = CORES
            .iter()
            .find(|core| core.name.eq_ignore_ascii_case(name))
            .ok_or_else(|| format!("there is no core `{name}`; choose from {}", names()))?;
        let clock = clock.to_ascii_lowercase();
        let units = [("ghz", 1e9), ("mhz", 1e6), ("khz", 1e3)];
        let hertz = units
            .into_iter()
            .find_map(|(unit, factor)| {
                Some(clock.strip_suffix(unit)?.trim().parse::<f64>().ok()? * factor)
            })
            .filter(|hertz| (1e3..=1e10).contains(hertz))
            .ok_or_else(|| format!("{form}: a clock ends in MHz, GHz or kHz, 1 kHz to 10 GHz"))?;
        Ok(Self { core, hertz })
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::firmware::board;
    use super::*;

    #[test]
    fn a_target_is_a_core_and_a_clock() {
        let target: Target = "m0+@133MHz".parse().expect("the form of the help");
        assert_eq!((target.core.name, target.core.board), ("m0+", "m0"));
        assert!((target.hertz - 133e6).abs() < 1.0, "{}", target.hertz);
        for (text, hertz) in [("M4F@168mhz", 168e6), ("m7@1.2GHz", 1.2e9), ("rv32@500 kHz", 5e5)] {
            let target: Target = text.parse().expect(text);
            assert!((target.hertz - hertz).abs() < 1.0, "{text}: {}", target.hertz);
        }
    }

    #[test]
    fn another_word_is_an_error_that_says_what_is_known() {
        for (text, part) in [
            ("m0+", "m0+@133MHz"),
            ("m5@100MHz", "choose from m0+, m3, m4f, m7, m33, rv32"),
            ("m4f@fast", "MHz"),
            ("m4f@-1MHz", "MHz"),
            ("m4f@NaNMHz", "MHz"),
            ("m4f@168", "MHz"),
            ("m4f@0MHz", "1 kHz to 10 GHz"),
            ("m4f@infMHz", "1 kHz to 10 GHz"),
            ("@133MHz", "choose from m0+"),
        ] {
            let message = text.parse::<Target>().expect_err(text);
            assert!(message.contains(part), "{text}: {message}");
        }
    }

    #[test]
    fn every_core_has_its_board_and_a_sensible_range() {
        for core in &CORES {
            assert!(board::find(core.board).is_ok(), "{}", core.name);
            let [best, worst] = core.cycles;
            assert!(0.5 <= best && best < worst && worst <= 2.0, "{}", core.name);
        }
    }

    #[test]
    fn frames_are_cycles_by_cycles() {
        let target: Target = "m0+@160MHz".parse().expect("the form of the help");
        let [worst, best] = target.frames_per_second(10_000_000);
        assert!(
            (worst - 10.0).abs() < 1e-9 && (best - 160.0 / 13.0).abs() < 1e-9,
            "{worst} {best}"
        );
    }
}
