//! OBJ files and their material libraries from raw bytes: two bytes say how long the library is,
//! then come both.
#![no_main]

mod model;

use libfuzzer_sys::fuzz_target;
use microraster::host::Model;
use std::path::PathBuf;
use std::sync::OnceLock;

/// A folder of this process' own.
fn folder() -> &'static PathBuf {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    FOLDER.get_or_init(|| {
        let name = format!("microraster-fuzz-{}", std::process::id());
        let folder = std::env::temp_dir().join(name);
        std::fs::create_dir_all(&folder).expect("there is a place for temporary files");
        folder
    })
}

fuzz_target!(|data: &[u8]| {
    let Some((length, rest)) = data.split_first_chunk::<2>() else { return };
    let length = usize::from(u16::from_le_bytes(*length)).min(rest.len());
    let (library, text) = rest.split_at(length);
    if !library.is_empty() {
        std::fs::write(folder().join("m.mtl"), library).expect("a file can be written");
    }
    if let Ok(model) = Model::read_obj(text, folder().join("m.obj")) {
        model::check(&model);
    }
});
