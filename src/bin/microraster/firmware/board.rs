//! The boards that QEMU models, bare WebAssembly, and what the linker must know of each.

/// One board.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Board {
    /// The name on the command line.
    pub(crate) name: &'static str,
    /// Rust's name of the target.
    pub(crate) target: &'static str,
    /// QEMU's name of the machine; empty for WebAssembly.
    pub(crate) machine: &'static str,
    /// Symbols that override those of `memory.x` and of the runtime.
    pub(crate) symbols: &'static [&'static str],
    /// Those of the counter of instructions.
    pub(crate) counter: &'static [&'static str],
}

/// What runs a board's firmware.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Emulator {
    /// QEMU: its program, and what it needs before the machine.
    Qemu(&'static str, &'static [&'static str]),
    /// Node, which runs WebAssembly.
    Node,
}

impl Board {
    /// What runs its firmware.
    pub(crate) fn emulator(&self) -> Emulator {
        if self.target.starts_with("wasm32") {
            Emulator::Node
        } else if self.target.starts_with("riscv32") {
            Emulator::Qemu("qemu-system-riscv32", &["-bios", "none"])
        } else {
            Emulator::Qemu("qemu-system-arm", &[])
        }
    }
}

/// Armv8-M boards put code and data into the large memory that they have at the same place, so that
/// one firmware serves both; 512 KB for code is all that an547 has elsewhere. Vectors come first.
const ARMV8M: &[&str] = &[
    "__flash_origin=0x10000000",
    "__flash_length=0x70800000",
    "_stext=0x80000000",
    "__ram_origin=0x80800000",
];

/// All of them, from the smallest core up.
pub(crate) const BOARDS: [Board; 8] = [
    Board {
        name: "m0",
        target: "thumbv6m-none-eabi",
        // QEMU has no M0+ board with RAM enough; the M3's runs the same code.
        machine: "mps2-an385",
        symbols: &[],
        counter: &[],
    },
    Board {
        name: "m3",
        target: "thumbv7m-none-eabi",
        machine: "mps2-an385",
        symbols: &[],
        counter: &[],
    },
    Board {
        name: "m4",
        target: "thumbv7em-none-eabihf",
        machine: "mps2-an386",
        symbols: &[],
        counter: &[],
    },
    Board {
        name: "m7",
        target: "thumbv7em-none-eabihf",
        machine: "mps2-an500",
        symbols: &[],
        counter: &[],
    },
    Board {
        name: "m33",
        target: "thumbv8m.main-none-eabihf",
        machine: "mps2-an505",
        symbols: ARMV8M,
        counter: &["__counter=0x40302018", "__counter_ps=50000"],
    },
    Board {
        name: "m55",
        target: "thumbv8m.main-none-eabihf",
        machine: "mps3-an547",
        symbols: ARMV8M,
        counter: &["__counter=0x49302018", "__counter_ps=50000"],
    },
    Board {
        name: "rv32",
        target: "riscv32imc-unknown-none-elf",
        machine: "virt",
        symbols: &["__flash_origin=0x80000000", "__ram_origin=0x80400000"],
        counter: &[],
    },
    Board {
        name: "wasm32",
        target: "wasm32-unknown-unknown",
        machine: "",
        symbols: &[],
        counter: &[],
    },
];

/// The board of this name.
///
/// # Errors
/// A name that no board has.
pub(crate) fn find(name: &str) -> Result<&'static Board, String> {
    BOARDS.iter().find(|board| board.name == name).ok_or_else(|| {
        let names: Vec<_> = BOARDS.iter().map(|board| board.name).collect();
        format!("there is no board `{name}`; choose from {}", names.join(", "))
    })
}
