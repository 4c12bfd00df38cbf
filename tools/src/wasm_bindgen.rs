//! `wasm-bindgen`, from its library: arguments in, its own output and exit status out.

fn main() {
    env_logger::init();
    let arguments = std::env::args_os();
    if let Err(error) = wasm_bindgen_cli::wasm_bindgen::run_cli_with_args(arguments) {
        eprintln!("Error: {error:?}");
        std::process::exit(1);
    }
}
