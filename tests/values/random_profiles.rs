//! Random profiles over the whole grammar: no closed form is ever wrong.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)]

use sneddon::parse;
use sneddon::transform::{Evaluator, Method, Profile, Slice, Superposed, derive};
use sneddon_checks::formulas::bindings;
use sneddon_checks::profiles::{Outcome, compare, sample};
use sneddon_checks::random::Stream;
use sneddon_checks::seeds::cases;

/// A sample; the long run is `cargo run --release -p sneddon-runs --bin random_profiles`, and its figures stand in docs/accuracy.md.
const PROFILES: u64 = 300;

#[test]
fn closed_forms_are_never_wrong() {
    let mut total = Outcome::default();
    let profiles = cases(PROFILES / 14, PROFILES) as usize;
    for seed in 0..profiles as u64 {
        let mut stream = Stream::new(1_000_000 + seed);
        let profile = sample(&mut stream);
        total.add(compare(&profile, &mut stream));
    }
    assert!(total.faults.is_empty(), "{}", total.faults.join("\n"));
    println!("{total:?}");
    assert!(total.refused < total.profiles / 4, "{total:?}");
    assert!(total.sharp > profiles && 3 * total.printed > profiles, "{total:?}");
}

/// More than the dearest polynomial is worth, within less than its part.
const DENSE: usize = 4000;

/// Where a slice is dense a value is that of its own slice of one point, or right to 0.8 units in the last place.
#[test]
fn dense_slices_are_never_wrong() {
    let profiles = std::env::var("PROFILES").ok().and_then(|text| text.parse().ok()).unwrap_or(cases(PROFILES / 12, PROFILES / 3));
    let (mut single, mut precise, mut values) = (0, 0, vec![0.0; DENSE]);
    let mut worst = 0.0f64;
    for seed in 0..profiles {
        let mut stream = Stream::new(2_000_000 + seed);
        let profile = sample(&mut stream);
        let Ok(formula) = parse::profile(&profile.text) else { continue };
        let set = formula.substitute(&bindings(&profile.values));
        let Ok(solution) = Profile::new(&set).and_then(|profile| derive(&profile)) else { continue };
        let Ok(evaluator) = Evaluator::new(&solution, &bindings(&[]), Method::Exact, 1e-13) else { continue };
        let end = evaluator.limit().min(4.0);
        let breakpoints = evaluator.breakpoints_below(end);
        let first = match stream.whole(0, 3) {
            0 if !breakpoints.is_empty() => *stream.pick(&breakpoints) * (1.0 - stream.log_uniform(1e-6, 1e-2)),
            1 => end * (1.0 - stream.log_uniform(1e-6, 1e-2)),
            _ => stream.log_uniform(1e-4, 0.98) * end,
        };
        let width = stream.log_uniform(1e-5, 0.05);
        let points: Vec<f64> = (0..DENSE).map(|_| (first * (1.0 + width * stream.unit())).min(end * (1.0 - 1e-9))).collect();
        let a = first + (end - first) * stream.unit();
        for quantity in [Superposed::Equivalent, Superposed::Force, Superposed::Pressure] {
            let fill = |points: &[f64], out: &mut [f64]| match quantity {
                Superposed::Equivalent => evaluator.equivalents(points, Slice::values(out)),
                Superposed::Force => evaluator.forces(points, Slice::values(out)),
                _ => evaluator.pressures(points, a, Slice::values(out)),
            };
            if fill(&points, &mut values).is_err() {
                continue;
            }
            for place in (0..DENSE).step_by(300) {
                let (x, mut alone) = (points[place], [f64::NAN]);
                if fill(&[x], &mut alone).is_ok() && alone[0].to_bits() == values[place].to_bits() {
                    single += 1;
                    continue;
                }
                let inputs = if quantity == Superposed::Pressure { vec![x, a] } else { vec![x] };
                let truth = evaluator.with_30_digits(quantity, &inputs).unwrap().unwrap();
                let size = truth.value.hi.abs();
                let unit = f64::from_bits(size.to_bits() + 1) - size;
                let off = ((values[place] - truth.value.hi) - truth.value.lo).abs();
                worst = worst.max(off / unit);
                assert!(off <= 0.8 * unit + truth.error, "{profile:?}, seed {seed}: {quantity:?} at {inputs:?}: {} units", off / unit);
                precise += 1;
            }
        }
    }
    println!("{precise} values by polynomials, off by {worst} units at most, {single} as alone");
    assert!(precise > 10 * profiles as usize / 3);
}
