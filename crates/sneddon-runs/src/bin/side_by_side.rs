//! Writes `docs/side-by-side.md`: `cargo run --release -p sneddon-runs --bin side_by_side > docs/side-by-side.md`.

use sneddon_checks::chapter::side_by_side::{compared, page};

fn main() {
    print!("{}", page(&compared()));
}
