//! Which of an example's variants this is: the build's environment names it.

/// Whether this is the variant of that name; known when compiling. Without a name it is `flat`.
pub(crate) const fn is(name: &str) -> bool {
    let wanted = match option_env!("MICRORASTER_FEATURE") {
        Some(wanted) => wanted.as_bytes(),
        None => b"flat",
    };
    let name = name.as_bytes();
    let mut at = 0;
    while at < name.len() && at < wanted.len() && name[at] == wanted[at] {
        at += 1;
    }
    at == name.len() && at == wanted.len()
}
