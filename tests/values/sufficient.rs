//! Rules that are known to suffice: what is kept of their rounding covers every place.

use sneddon::expr::{Bindings, Expr};
use sneddon::transform::inner::{Weight, segments};
use sneddon::transform::{NumericProfile, Segment};

/// What is kept for a sixteenth against the bounds at places within it.
#[test]
fn what_is_kept_of_rounding_covers_every_place() {
    let r = || Expr::symbol("r");
    let slopes = [
        r().power(41),
        Expr::call("exp", [r().power(2)]) * r(),
        Expr::call("sin", [r() * Expr::integer(7)]),
        Expr::call("sin", [r() * Expr::integer(7)]) + Expr::call("cos", [r() * Expr::integer(5)]) * r().power(3),
        (Expr::integer(1) - r().power(2)) * (Expr::integer(4) - r().power(2)) * r(),
        r() * (Expr::integer(1000) - Expr::call("cosh", [r()])),
        Expr::call("tanh", [r()]) - r(),
        r() * Expr::call("exp", [-r().power(2)]),
        // Here all rounding is that of one sum, which may be nothing by chance.
        Expr::call("sin", [r() + Expr::integer(100_272_824)]),
        Expr::call("sin", [r() + Expr::integer(13_352)]),
    ];
    let mut kept = 0;
    for slope in &slopes {
        for lower in [Expr::integer(0), Expr::ratio(1, 3)] {
            let segment = Segment { lower: lower.clone(), upper: None };
            let own = NumericProfile::new(&[(segment, slope.clone())], &Bindings::default()).unwrap();
            let [segment] = segments(&own) else { panic!("{slope:?}") };
            for i in 0..400 {
                let x = 0.01 * 1.02f64.powi(i);
                for weight in [Weight::Equivalent, Weight::Force, Weight::Integral] {
                    let Some(known) = (x > segment.lower.value).then(|| segment.sufficient(x, weight)).flatten() else { continue };
                    if known.noise < f64::INFINITY {
                        let (found, _) = segment.noise_at(known.known, x, weight).unwrap();
                        assert!(found <= known.noise, "{slope:?} at {x}, {weight:?}: {found} {}", known.noise);
                        kept += 1;
                    }
                }
            }
        }
    }
    assert!(kept > 8000, "{kept}");
}
