//! The host shim: what needs an operating system.
