//! Quantities by name, for profiles of every kind.

use sneddon::num::Estimate;
use sneddon::transform::Quantities;

/// g, F, G, u or p, by its symbol; contact radius a, place r.
pub fn quantity(own: &impl Quantities, name: &str, r: f64, a: f64) -> Estimate {
    let found = match name {
        "g" => own.equivalent(a),
        "F" => own.force(a),
        "G" => own.integral(a),
        "u" => own.displacement(r, a),
        _ => own.pressure(r, a).map(Option::unwrap),
    };
    found.unwrap_or_else(|error| panic!("{name} at {r:?}, {a:?}: {error}")).estimate
}
