//! `wasm-pack`, from its library: arguments in, its own output and exit status out. Nothing is asked
//! of the network for a newer version.

use clap::Parser;

fn main() {
    env_logger::init();
    let arguments = wasm_pack::Cli::parse();
    wasm_pack::PBAR.set_log_level(arguments.log_level);
    wasm_pack::PBAR.set_quiet(arguments.quiet);
    if let Err(error) = wasm_pack::command::run_wasm_pack(arguments.cmd) {
        eprintln!("Error: {error:?}");
        std::process::exit(1);
    }
}
