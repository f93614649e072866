//! The host program: `simulate` draws a model, `firmware` compares boards with the host.
fn main() {}
