//! The `sneddon` program: arguments, run, exit code.

fn main() -> std::process::ExitCode {
    sneddon::cli::main()
}
