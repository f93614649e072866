//! Cycles by a model: instructions by class, each class with what a core takes for it.
//!
//! QEMU counts instructions and no cycles. The model says what an instruction takes beyond the
//! first cycle; memory answers at once.

use super::profile::{Place, Profile};
use std::fmt;

/// How often each class was executed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Classes {
    pub(crate) instructions: u64,
    pub(crate) loads: u64,
    pub(crate) stores: u64,
    /// Words of loads of several beyond the first.
    pub(crate) more_loaded: u64,
    /// The same of stores.
    pub(crate) more_stored: u64,
    /// Branches, calls and returns that were taken.
    pub(crate) taken: u64,
    pub(crate) multiplies: u64,
    pub(crate) divides: u64,
    /// Divisions and roots of the floating-point unit.
    pub(crate) float_divides: u64,
}

/// What an instruction does, as far as cycles go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Class {
    /// So many words.
    Load(u64),
    Store(u64),
    Multiply,
    Divide,
    FloatDivide,
    Other,
}

/// RISC-V's names, of which many would be the beginning of others.
const LOADS: [&str; 8] = ["lb", "lbu", "lh", "lhu", "lw", "lr.w", "c.lw", "c.lwsp"];
const STORES: [&str; 6] = ["sb", "sh", "sw", "sc.w", "c.sw", "c.swsp"];
/// Arm's, with what widths, conditions and sizes follow.
const ARM_LOADS: [&str; 6] = ["ldr", "ldm", "pop", "vldr", "vldm", "vpop"];
const ARM_STORES: [&str; 6] = ["str", "stm", "push", "vstr", "vstm", "vpush"];
const MULTIPLIES: [&str; 9] =
    ["mul", "mla", "mls", "umul", "umla", "umaal", "smul", "smla", "smmul"];
const DIVIDES: [&str; 4] = ["div", "rem", "udiv", "sdiv"];
const FLOAT_DIVIDES: [&str; 2] = ["vdiv", "vsqrt"];

impl Class {
    /// The class of a disassembled instruction of either architecture.
    fn of(text: &str) -> Self {
        let (name, operands) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
        let starts = |names: &[&str]| names.iter().any(|start| name.starts_with(start));
        if LOADS.contains(&name) || starts(&ARM_LOADS) {
            Self::Load(words(name, operands))
        } else if STORES.contains(&name) || starts(&ARM_STORES) {
            Self::Store(words(name, operands))
        } else if starts(&FLOAT_DIVIDES) {
            Self::FloatDivide
        } else if starts(&DIVIDES) {
            Self::Divide
        } else if starts(&MULTIPLIES) {
            Self::Multiply
        } else {
            Self::Other
        }
    }
}

/// Words that a load or a store moves: registers of the list in braces, two of a double.
fn words(name: &str, operands: &str) -> u64 {
    let list = operands.split_once('{').and_then(|(_, rest)| rest.split_once('}'));
    let Some((list, _)) = list else {
        return if name.starts_with("ldrd") || name.starts_with("strd") { 2 } else { 1 };
    };
    let number = |register: &str| {
        let named = [("sb", 9), ("sl", 10), ("fp", 11), ("ip", 12)];
        let alias = named.iter().find(|(name, _)| *name == register).map(|(_, number)| *number);
        alias.or_else(|| register.trim_start_matches(|c: char| !c.is_ascii_digit()).parse().ok())
    };
    list.split(',')
        .map(|part| match part.trim().split_once('-') {
            Some((first, last)) => match (number(first.trim()), number(last.trim())) {
                (Some(first), Some(last)) => u64::saturating_sub(last, first) + 1,
                _ => 1,
            },
            None => 1,
        })
        .sum()
}

impl Classes {
    /// Counts a profile's instructions.
    pub(crate) fn of(profile: &Profile) -> Self {
        let mut classes =
            Self { instructions: profile.instructions, taken: profile.taken, ..Self::default() };
        for Place { count, text, .. } in &profile.places {
            match Class::of(text) {
                Class::Load(words) => {
                    classes.loads += count;
                    classes.more_loaded += count * (words - 1);
                }
                Class::Store(words) => {
                    classes.stores += count;
                    classes.more_stored += count * (words - 1);
                }
                Class::Multiply => classes.multiplies += count,
                Class::Divide => classes.divides += count,
                Class::FloatDivide => classes.float_divides += count,
                Class::Other => {}
            }
        }
        classes
    }
}

/// Cycles of a core: of every instruction, and what a class takes beyond that.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Model {
    /// The board whose code the core runs.
    pub(crate) board: &'static str,
    instruction: f64,
    load: f64,
    store: f64,
    /// Each word of a load or a store of several beyond the first.
    more: f64,
    taken: f64,
    multiply: f64,
    divide: f64,
    float_divide: f64,
    /// Where it comes from.
    source: &'static str,
}

/// The models, in the order of the table's columns.
pub(crate) const MODELS: [Model; 5] = [
    Model {
        board: "m4",
        instruction: 1.0,
        load: 1.0,
        store: 0.0,
        more: 1.0,
        taken: 2.0,
        multiply: 0.0,
        divide: 6.0,
        float_divide: 13.0,
        source: "table 3-1 of the core's reference manual (Arm 100166), middles of its ranges; loads in a row, which take \
                 less, are not told apart",
    },
    Model {
        board: "m0",
        instruction: 1.0,
        load: 1.0,
        store: 1.0,
        more: 1.0,
        taken: 1.0,
        multiply: 0.0,
        divide: 0.0,
        float_divide: 0.0,
        source: "table 3-1 of the core's reference manual (Arm DDI 0484C); the multiplier of one cycle; calls count as \
                 branches, though they take one more",
    },
    Model {
        board: "m7",
        instruction: 0.75,
        load: 0.0,
        store: 0.0,
        more: 0.0,
        taken: 0.25,
        multiply: 0.0,
        divide: 6.0,
        float_divide: 13.0,
        source: "an assumption: half of all instructions in pairs, branches predicted",
    },
    Model {
        board: "m33",
        instruction: 1.0,
        load: 0.5,
        store: 0.0,
        more: 1.0,
        taken: 1.5,
        multiply: 0.0,
        divide: 6.0,
        float_divide: 13.0,
        source: "an assumption: every second load waits, branches take 2 to 3 cycles",
    },
    Model {
        board: "rv32",
        instruction: 1.0,
        load: 0.5,
        store: 0.0,
        more: 0.0,
        taken: 1.5,
        multiply: 0.0,
        divide: 17.0,
        float_divide: 0.0,
        source: "an assumption: a short pipeline in order, such as Hazard3; cores differ",
    },
];

impl Model {
    /// Cycles of what was counted.
    pub(crate) fn cycles(&self, classes: &Classes) -> f64 {
        let Classes { loads, stores, more_loaded, more_stored, .. } = *classes;
        [
            (self.instruction, classes.instructions),
            (self.load, loads),
            (self.store, stores),
            (self.more, more_loaded + more_stored),
            (self.taken, classes.taken),
            (self.multiply, classes.multiplies),
            (self.divide, classes.divides),
            (self.float_divide, classes.float_divides),
        ]
        .into_iter()
        .map(|(cycles, count)| cycles * count as f64)
        .sum()
    }

    /// Its figures, as a table's cells: what they are of, and the figure.
    pub(crate) fn cells(&self) -> [(&'static str, String); 9] {
        let more = |cycles: f64| format!("{cycles:+}");
        [
            ("each instruction", self.instruction.to_string()),
            ("load", more(self.load)),
            ("store", more(self.store)),
            ("each further word", more(self.more)),
            ("branch, taken", more(self.taken)),
            ("multiply", more(self.multiply)),
            ("divide", more(self.divide)),
            ("divide or root of floats", more(self.float_divide)),
            ("from", self.source.to_owned()),
        ]
    }
}

impl fmt::Display for Classes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { instructions, loads, stores, more_loaded, more_stored, .. } = self;
        write!(
            f,
            "instructions={instructions} loads={loads} stores={stores} \
             more_words={} taken={} multiplies={} divides={} float_divides={}",
            more_loaded + more_stored,
            self.taken,
            self.multiplies,
            self.divides,
            self.float_divides
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn instructions_have_their_class() {
        for (text, class) in [
            ("ldr.w r0, [r1, #4]", Class::Load(1)),
            ("ldrh r0, [r1]", Class::Load(1)),
            ("ldrd r0, r1, [sp, #8]", Class::Load(2)),
            ("pop {r4, r5, pc}", Class::Load(3)),
            ("ldm.w sp!, {r4, r5, r6, r7, r8, sb, sl, fp, pc}", Class::Load(9)),
            ("stm r0!, {r1-r4, r7}", Class::Store(5)),
            ("push.w {r4-fp, lr}", Class::Store(9)),
            ("vpush {d8}", Class::Store(1)),
            ("strb r0, [r1]", Class::Store(1)),
            ("muls r0, r1, r0", Class::Multiply),
            ("smlal r0, r1, r2, r3", Class::Multiply),
            ("umull r0, r1, r2, r3", Class::Multiply),
            ("udiv r0, r1, r2", Class::Divide),
            ("vdiv.f32 s0, s1, s2", Class::FloatDivide),
            ("lw a0,4(a1)", Class::Load(1)),
            ("sb a0,4(a1)", Class::Store(1)),
            ("mulhu a0,a1,a2", Class::Multiply),
            ("remu a0,a1,a2", Class::Divide),
            ("li a0,1", Class::Other),
            ("lui a0,16", Class::Other),
            ("subs r0, r1, r2", Class::Other),
            ("slli a0,a0,2", Class::Other),
            ("bne #0x100", Class::Other),
            ("nop", Class::Other),
        ] {
            assert_eq!(Class::of(text), class, "{text}");
        }
    }

    #[test]
    fn cycles_are_instructions_and_what_classes_take_more() {
        let place = |count, text: &str| Place {
            count,
            address: 0,
            text: text.to_owned(),
            function: String::new(),
        };
        let places = vec![
            place(10, "ldr r0, [r1]"),
            place(10, "adds r0, #1"),
            place(10, "bne #0x10"),
            place(1, "pop {r4, r5, pc}"),
        ];
        let classes = Classes::of(&Profile { instructions: 31, taken: 10, places });
        let expected = Classes {
            instructions: 31,
            loads: 11,
            more_loaded: 2,
            taken: 10,
            ..Classes::default()
        };
        assert_eq!(classes, expected, "by class");
        let m0 = MODELS.iter().find(|model| model.board == "m0").expect("it has a model");
        let cycles = m0.cycles(&classes);
        assert!((cycles - (31.0 + 11.0 + 2.0 + 10.0)).abs() < 1e-9, "{cycles}");
    }

    #[test]
    fn every_model_has_its_board() {
        for model in &MODELS {
            assert!(super::super::board::find(model.board).is_ok(), "{}", model.board);
        }
    }
}
