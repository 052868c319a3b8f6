//! Narrow features of typed profiles against quadrature of 40 digits that is told where they are.

use sneddon::expr::Bindings;
use sneddon::num::Bound;
use sneddon::parse;
use sneddon::transform::{Evaluator, Method, Profile, derive};

/// Spikes, steps and waves of width 1e-1 … 1e-10 on ten backgrounds, half of them next to the rim: `tests/oracle/features.py`.
#[test]
fn no_narrow_feature_is_missed() {
    let rows = include_str!("oracle/features.csv").lines().skip(1);
    let (mut proven, mut refused, mut seen) = (0, 0, 0);
    for row in rows {
        let [profile, quantity, place, value] = row.split(',').collect::<Vec<_>>()[..] else { panic!("{row}") };
        let (place, truth): (f64, f64) = (place.parse().unwrap(), value.parse().unwrap());
        let solution = derive(&Profile::new(&parse::profile(profile).unwrap()).unwrap()).unwrap();
        let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13).unwrap();
        let found = if quantity == "g" { evaluator.slope(place) } else { evaluator.force(place) };
        seen += 1;
        let Ok(found) = found else {
            refused += 1;
            continue;
        };
        let own = if quantity == "g" { found.estimate } else { found.estimate.scaled(2.0) };
        let off = (own.value - truth).abs();
        assert!(off <= own.error + f64::EPSILON * truth.abs(), "{row}: {own:?} is off by {off:e}");
        proven += usize::from(own.bound == Bound::Proven);
    }
    // What is refused are closed backgrounds beside a feature that the recognition form multiplies out; what is estimated lies next to
    // the end of f′ or begins with a fractional power.
    assert!(seen == 80 && refused <= 9 && proven >= 68, "{proven} proven, {refused} refused");
}
