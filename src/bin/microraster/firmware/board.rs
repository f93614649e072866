//! The boards that QEMU models and what the linker must know of each.

/// One board.
#[derive(Debug)]
pub(crate) struct Board {
    /// The name on the command line.
    pub(crate) name: &'static str,
    /// Rust's name of the target.
    pub(crate) target: &'static str,
    /// QEMU's name of the machine.
    pub(crate) machine: &'static str,
    /// Symbols that override those of `memory.x`.
    pub(crate) symbols: &'static [&'static str],
}

impl Board {
    /// The emulator's program and what it needs before the machine.
    pub(crate) fn emulator(&self) -> (&'static str, &'static [&'static str]) {
        if self.target.starts_with("riscv32") {
            ("qemu-system-riscv32", &["-bios", "none"])
        } else {
            ("qemu-system-arm", &[])
        }
    }
}

/// All of them, from the smallest core up.
pub(crate) const BOARDS: [Board; 7] = [
    Board {
        name: "m0",
        target: "thumbv6m-none-eabi",
        // QEMU has no M0+ board with RAM enough; the M3's runs the same code.
        machine: "mps2-an385",
        symbols: &[],
    },
    Board { name: "m3", target: "thumbv7m-none-eabi", machine: "mps2-an385", symbols: &[] },
    Board { name: "m4", target: "thumbv7em-none-eabihf", machine: "mps2-an386", symbols: &[] },
    Board { name: "m7", target: "thumbv7em-none-eabihf", machine: "mps2-an500", symbols: &[] },
    Board {
        name: "m33",
        target: "thumbv8m.main-none-eabihf",
        machine: "mps2-an505",
        symbols: &[
            "flash_origin=0x10000000",
            "ram_origin=0x38000000",
            "counter=0x40302018",
            "counter_ps=50000",
        ],
    },
    Board {
        name: "m55",
        target: "thumbv8m.main-none-eabihf",
        machine: "mps3-an547",
        symbols: &[
            "flash_length=512K",
            "ram_origin=0x21000000",
            "counter=0x49302018",
            "counter_ps=50000",
        ],
    },
    Board {
        name: "rv32",
        target: "riscv32imc-unknown-none-elf",
        machine: "virt",
        symbols: &["flash_origin=0x80000000", "ram_origin=0x80400000"],
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
