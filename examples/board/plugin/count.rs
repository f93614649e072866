//! A QEMU plugin: counts executed instructions by function and by address, and taken branches.
//!
//! Only the measured parts count: what runs between a first and a second reading of the board's
//! clock (`meter::clock::now`). `cargo firmware --profile SCENE` builds and uses it; by hand:
//!
//! ```text
//! rustc -O --crate-type cdylib examples/board/plugin/count.rs -o target/libcount.so
//! qemu-system-arm ... -plugin target/libcount.so,out=profile.txt,top=40
//! ```

use std::collections::HashMap;
use std::ffi::{c_char, c_int, c_uint, c_void, CStr, CString};
use std::fmt::Write as _;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering::Relaxed};
use std::sync::{Mutex, MutexGuard, PoisonError};

extern "C" {
    fn qemu_plugin_register_vcpu_tb_trans_cb(id: u64, callback: extern "C" fn(u64, *mut c_void));
    fn qemu_plugin_register_atexit_cb(
        id: u64,
        callback: extern "C" fn(u64, *mut c_void),
        data: *mut c_void,
    );
    fn qemu_plugin_register_vcpu_insn_exec_inline(
        insn: *mut c_void,
        operation: c_int,
        counter: *mut u64,
        add: u64,
    );
    fn qemu_plugin_register_vcpu_insn_exec_cb(
        insn: *mut c_void,
        callback: extern "C" fn(c_uint, *mut c_void),
        flags: c_int,
        data: *mut c_void,
    );
    fn qemu_plugin_register_vcpu_tb_exec_cb(
        block: *mut c_void,
        callback: extern "C" fn(c_uint, *mut c_void),
        flags: c_int,
        data: *mut c_void,
    );
    fn qemu_plugin_tb_n_insns(block: *const c_void) -> usize;
    fn qemu_plugin_tb_get_insn(block: *const c_void, index: usize) -> *mut c_void;
    fn qemu_plugin_insn_vaddr(insn: *const c_void) -> u64;
    fn qemu_plugin_insn_size(insn: *const c_void) -> usize;
    fn qemu_plugin_insn_symbol(insn: *const c_void) -> *const c_char;
    fn qemu_plugin_insn_disas(insn: *const c_void) -> *mut c_char;
    fn qemu_plugin_outs(text: *const c_char);
    fn free(memory: *mut c_void);
}

/// The version of the plugin interface.
#[no_mangle]
pub static qemu_plugin_version: c_int = 1;

/// How the clock's function is written in both of the compiler's manglings.
const CLOCK: &str = "5meter5clock3now";

/// Whether a measured part runs, for [`block_runs`], which is called far too often for a lock.
static MEASURING: AtomicBool = AtomicBool::new(false);
/// Where the block that ran last ends.
static END: AtomicU64 = AtomicU64::new(0);
/// Branches, calls and returns that were taken in measured parts: a block that ran after one that
/// does not end where it begins.
static TAKEN: AtomicU64 = AtomicU64::new(0);

/// Where a translated block lies.
struct Block {
    start: u64,
    end: u64,
}

/// One instruction of the firmware.
struct Place {
    /// Raised by the emulated code itself; boxed, so that it stays in place.
    running: Box<u64>,
    /// What `running` was when the measured part began.
    before: u64,
    /// Executions in measured parts.
    count: u64,
    function: String,
    text: String,
}

#[derive(Default)]
struct State {
    places: HashMap<u64, Place>,
    /// Where the function of the clock begins.
    clock: Option<u64>,
    /// Whether a measured part runs.
    measuring: bool,
    out: Option<String>,
    top: usize,
}

static STATE: Mutex<Option<State>> = Mutex::new(None);

fn state() -> MutexGuard<'static, Option<State>> {
    STATE.lock().unwrap_or_else(PoisonError::into_inner)
}

fn text(pointer: *const c_char) -> String {
    if pointer.is_null() {
        return "?".into();
    }
    // SAFETY: QEMU hands out zero-terminated text.
    unsafe { CStr::from_ptr(pointer) }
        .to_string_lossy()
        .into_owned()
}

/// The instruction without its code: QEMU's own disassembler for RISC-V begins a line with four
/// or eight hexadecimal digits and a gap.
fn assembly(line: &str) -> &str {
    match line.split_once("    ") {
        Some((code, rest)) if code.bytes().all(|byte| byte.is_ascii_hexdigit()) => {
            rest.trim_start()
        }
        _ => line,
    }
}

/// Each second reading of the clock ends a measured part.
extern "C" fn clock_read(_processor: c_uint, _data: *mut c_void) {
    let mut guard = state();
    let Some(state) = guard.as_mut() else { return };
    state.measuring = !state.measuring;
    MEASURING.store(state.measuring, Relaxed);
    for place in state.places.values_mut() {
        if state.measuring {
            place.before = *place.running;
        } else {
            place.count += *place.running - place.before;
        }
    }
}

/// A branch ends its block, so that one which is taken is seen between two of them.
extern "C" fn block_runs(_processor: c_uint, data: *mut c_void) {
    // SAFETY: what `translated` has leaked for this callback.
    let Block { start, end } = unsafe { &*data.cast::<Block>() };
    if END.swap(*end, Relaxed) != *start && MEASURING.load(Relaxed) {
        TAKEN.fetch_add(1, Relaxed);
    }
}

extern "C" fn translated(_id: u64, block: *mut c_void) {
    let mut guard = state();
    let Some(state) = guard.as_mut() else { return };
    // SAFETY: all calls are on the block that QEMU lends for this callback; the counters are
    // boxed, so that they stay in place, and live as long as the process.
    unsafe {
        let last = qemu_plugin_tb_get_insn(block, qemu_plugin_tb_n_insns(block) - 1);
        let range = Block {
            start: qemu_plugin_insn_vaddr(qemu_plugin_tb_get_insn(block, 0)),
            end: qemu_plugin_insn_vaddr(last) + qemu_plugin_insn_size(last) as u64,
        };
        let range = Box::into_raw(Box::new(range)).cast();
        qemu_plugin_register_vcpu_tb_exec_cb(block, block_runs, 0, range);
        for index in 0..qemu_plugin_tb_n_insns(block) {
            let insn = qemu_plugin_tb_get_insn(block, index);
            let address = qemu_plugin_insn_vaddr(insn);
            let place = state.places.entry(address).or_insert_with(|| {
                let disassembly = qemu_plugin_insn_disas(insn);
                let place = Place {
                    running: Box::new(0),
                    before: 0,
                    count: 0,
                    function: text(qemu_plugin_insn_symbol(insn)),
                    text: text(disassembly),
                };
                free(disassembly.cast());
                place
            });
            // The function's first translated instruction is its entry.
            if place.function.contains(CLOCK) && *state.clock.get_or_insert(address) == address {
                qemu_plugin_register_vcpu_insn_exec_cb(insn, clock_read, 0, std::ptr::null_mut());
            }
            qemu_plugin_register_vcpu_insn_exec_inline(insn, 0, &mut *place.running, 1);
        }
    }
}

extern "C" fn finished(_id: u64, _data: *mut c_void) {
    let guard = state();
    let Some(state) = guard.as_ref() else { return };
    let (mut functions, mut mnemonics) = (HashMap::new(), HashMap::new());
    let mut total = 0;
    for place in state.places.values() {
        total += place.count;
        *functions.entry(&place.function).or_insert(0) += place.count;
        let mnemonic = assembly(&place.text)
            .split_whitespace()
            .next()
            .unwrap_or("?");
        *mnemonics.entry(mnemonic).or_insert(0) += place.count;
    }
    let taken = TAKEN.load(Relaxed);
    let mut report = format!("instructions {total}\ntaken {taken}\n");
    for (title, table) in [
        (
            "function",
            functions
                .into_iter()
                .map(|(n, c)| (c, n.clone()))
                .collect::<Vec<_>>(),
        ),
        (
            "mnemonic",
            mnemonics
                .into_iter()
                .map(|(n, c)| (c, n.to_string()))
                .collect(),
        ),
        (
            "address",
            state
                .places
                .iter()
                .map(|(a, p)| {
                    (
                        p.count,
                        format!("{a:08x} {:40} {}", assembly(&p.text), p.function),
                    )
                })
                .collect(),
        ),
    ] {
        let mut table = table;
        table.retain(|row| row.0 > 0);
        table.sort_by(|a, b| b.0.cmp(&a.0).then_with(|| a.1.cmp(&b.1)));
        for (count, name) in table.iter().take(state.top) {
            let share = *count as f64 * 100.0 / total.max(1) as f64;
            // Writing to a string cannot fail.
            let _ = writeln!(report, "{title} {count:>12} {share:6.2}% {name}");
        }
    }
    let problem = match &state.out {
        Some(path) => std::fs::write(path, report)
            .err()
            .map(|why| format!("{path}: {why}\n")),
        None => Some(report),
    };
    if let Some(text) = problem.and_then(|text| CString::new(text).ok()) {
        // SAFETY: a zero-terminated string.
        unsafe { qemu_plugin_outs(text.as_ptr()) }
    }
}

/// Starts the plugin.
///
/// # Safety
/// QEMU calls it once, with its own argument vector.
#[no_mangle]
pub unsafe extern "C" fn qemu_plugin_install(
    id: u64,
    _info: *const c_void,
    count: c_int,
    arguments: *const *const c_char,
) -> c_int {
    let mut new = State {
        top: 40,
        ..State::default()
    };
    for index in 0..usize::try_from(count).unwrap_or(0) {
        match text(*arguments.add(index)).split_once('=') {
            Some(("out", path)) => new.out = Some(path.to_string()),
            Some(("top", number)) => new.top = number.parse().unwrap_or(new.top),
            _ => return 1,
        }
    }
    *state() = Some(new);
    qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
    qemu_plugin_register_atexit_cb(id, finished, std::ptr::null_mut());
    0
}
