//! Random scenes against the laws of contact; the long run is `cargo run --release -p sneddon-runs --bin random_scenes`.
#![allow(clippy::unwrap_used, clippy::panic)]

use sneddon_checks::laws::{LAWS, Tally, examine};

#[test]
fn random_scenes_keep_the_laws() {
    let mut total = Tally::default();
    for seed in 0..60 {
        total.add(examine(seed));
    }
    assert!(total.faults.is_empty(), "{} faults:\n{}", total.faults.len(), total.faults.join("\n"));
    assert!(total.refused <= 12 && total.invalid <= 12, "{} refused, {} invalid", total.refused, total.invalid);
    for ((law, _), (count, _)) in LAWS.iter().zip(total.laws) {
        assert!(count >= 40, "{law} was tested {count} times");
    }
}
