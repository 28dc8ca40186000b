//! The `stabline` command.

fn main() {}
