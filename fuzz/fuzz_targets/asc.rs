//! Triangle soups from raw bytes.
#![no_main]

mod model;

use libfuzzer_sys::fuzz_target;
use microraster::host::Model;

fuzz_target!(|data: &[u8]| {
    if let Ok(model) = Model::read_asc(data, "m.asc") {
        model::check(&model);
    }
});
