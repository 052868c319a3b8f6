//! Random scenes against the laws of contact; the long run is `cargo run --release -p sneddon-runs --bin random_scenes`.
#![allow(clippy::unwrap_used, clippy::panic)]

use sneddon_checks::laws::{LAWS, Tally, examine};
use sneddon_checks::seeds::cases;

#[test]
fn random_scenes_keep_the_laws() {
    let mut total = Tally::default();
    let scenes: usize = cases(3, 60);
    for seed in 0..scenes as u64 {
        total.add(examine(seed));
    }
    assert!(total.faults.is_empty(), "{} faults:\n{}", total.faults.len(), total.faults.join("\n"));
    assert!(5 * total.refused <= scenes && 5 * total.invalid <= scenes, "{} refused, {} invalid", total.refused, total.invalid);
    for ((law, _), (count, _)) in LAWS.iter().zip(total.laws) {
        assert!(3 * count >= 2 * scenes, "{law} was tested {count} times");
    }
}
