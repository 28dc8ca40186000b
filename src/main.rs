//! The `stabline` command.

fn main() -> std::process::ExitCode {
    stabline::cli::run(std::env::args_os())
}
