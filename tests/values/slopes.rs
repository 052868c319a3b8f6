//! What is read from the expression of f′: parity, growth at the ends, a leading power, shorter polynomials, narrow features.
#![allow(clippy::unwrap_used)]

use sneddon::eval::constant_value;
use sneddon::expr::{Bindings, Expr, Symbol};
use sneddon::num::Region;
use sneddon::transform::Segment;
use sneddon::transform::inner::{Growth, LeadingPower, Limit, Parity, centred, growth, parity};

#[test]
fn slopes_of_profiles() {
    let r = Expr::symbol("r");
    let radius = Symbol::new("r");
    let of = |expr: &Expr| parity(expr, &radius);
    assert_eq!(of(&(&r / (Expr::integer(4) - r.power(2)).sqrt())), Some(Parity::Odd));
    assert_eq!(of(&Expr::call("tanh", [r.clone()])), Some(Parity::Odd));
    assert_eq!(of(&(Expr::call("cos", [r.clone()]) * &r + r.power(3))), Some(Parity::Odd));
    assert_eq!(of(&Expr::integer(3)), Some(Parity::Even));
    assert_eq!(of(&(&r + Expr::one())), None);
    assert_eq!(of(&r.pow(&Expr::ratio(17, 10))), None);
    assert_eq!(of(&Expr::call("exp", [r.clone()])), None);
    assert_eq!(of(&(Expr::call("exp", [-r.power(2)]) * &r)), Some(Parity::Odd));
    assert_eq!(of(&r.pow(&Expr::symbol("n"))), None);
    let bessel = |order: &Expr| Expr::call("besselj", [order.clone(), r.clone()]);
    assert_eq!(of(&bessel(&Expr::one())), Some(Parity::Odd));
    assert_eq!(of(&bessel(&Expr::integer(2))), Some(Parity::Even));
    assert_eq!(of(&bessel(&Expr::ratio(1, 2))), None);
}

#[test]
fn powers_of_the_distance_are_told_apart() {
    let (r, b, c) = (Expr::symbol("r"), Expr::symbol("b"), Expr::symbol("c"));
    let segment = Segment { lower: b.clone(), upper: Some(c.clone()) };
    let of = |slope: &Expr| growth(slope, &segment);
    let distance = r.power(2) - b.power(2);
    assert_eq!(of(&(&r * distance.sqrt())), Growth::Bounded);
    assert_eq!(of(&(&r * distance.pow(&Expr::ratio(-1, 3)))), Growth::Gentle);
    assert_eq!(of(&(&r / distance.sqrt())), Growth::Steep);
    // The upper end counts as well, and a symbolic exponent proves nothing.
    assert_eq!(of(&(&r / (c.power(2) - r.power(2)).sqrt())), Growth::Steep);
    assert_eq!(of(&(&r - &b).pow(&(Expr::symbol("n") - Expr::one()))), Growth::Unproven);
    assert_eq!(of(&Expr::call("ln", [Expr::one() - &r / &c])), Growth::Gentle);
    // At the axis nothing is cut.
    assert_eq!(growth(&r.pow(&Expr::ratio(-1, 2)), &Segment::whole()), Growth::Bounded);
}

#[test]
fn logarithms_take_a_quarter() {
    let (delta, r) = (Symbol::new("δ"), Expr::symbol("δ"));
    let slope = &r * Expr::call("ln", [Expr::integer(3) * &r]) + r.power(2);
    let own = LeadingPower::of(&slope, &delta).unwrap();
    assert_eq!(own.exponent, 0.75);
    for most in [1e-12, 1e-3, 0.5, 4.0] {
        let bound = own.rest_over(Region::interval(0.0, most), &mut Vec::new());
        let largest = (1..=400).map(|i| most * f64::from(i) / 400.0).map(|d| (d * (3.0 * d).ln() + d * d).abs() / d.powf(0.75));
        let largest = largest.fold(0.0, f64::max);
        assert!(largest <= bound && bound < 40.0, "{largest} {bound} {most}");
    }
    assert!(LeadingPower::of(&Expr::call("ln", [&r + Expr::one()]).pow(&Expr::ratio(-1, 2)), &delta).is_none_or(|own| own.exponent > -1.0));
}

#[test]
fn only_what_becomes_shorter_is_rewritten() {
    let r = || Expr::symbol("r");
    let one = Expr::integer(1);
    let square = Expr::integer(-4) * r().power(2) + Expr::integer(8) * r() - Expr::integer(4);
    let ridge = Expr::call("exp", [square.clone()]);
    let expected = Expr::call("exp", [Expr::integer(-4) * (r() - &one).power(2)]);
    assert_eq!(centred(&ridge), expected);
    // Outside a function nothing cancels beyond recovery, and 2r − r² is as short as 1 − (r − 1)².
    let flat = Expr::integer(2) * r() - r().power(2);
    for unchanged in [square, Expr::call("exp", [flat]), Expr::call("tanh", [r().power(2) + &one])] {
        assert_eq!(centred(&unchanged), unchanged);
    }
    let cubic = r().power(3) + Expr::integer(3) * r().power(2) + Expr::integer(3) * r() + Expr::integer(8);
    assert_eq!(centred(&Expr::call("tanh", [cubic])), Expr::call("tanh", [(r() + &one).power(3) + Expr::integer(7)]));
}

fn is_featureless(slope: &Expr, end: i64) -> bool {
    let below = Bindings::one("r", Expr::integer(end) - Expr::symbol("δ")).apply(slope);
    let value = constant_value(&Expr::integer(end), &Bindings::default()).unwrap();
    Limit::new(value, below).unwrap().is_featureless(0.0)
}

#[test]
fn what_is_narrow_before_an_end_is_seen() {
    let r = Expr::symbol("r");
    let root = (Expr::integer(4) - r.power(2)).sqrt();
    let half = &r / Expr::integer(2);
    for plain in [
        &r / &root,
        &r * Expr::call("asin", [half.clone()]) / &root,
        &r * (Expr::one() - half.power(2)).pow(&Expr::ratio(-7, 10)),
        &r * Expr::call("exp", [r.clone()]) / &root,
    ] {
        assert!(is_featureless(&plain, 2), "{plain:?}");
        // Place, width and height: each is much narrower than its distance to the end.
        for (place, widths) in [
            ((3, 10), [100, 1_000_000, 10_000_000_000]),
            ((11, 10), [400, 10_000_000, 1_000_000_000_000]),
            ((199, 100), [40_000, 100_000_000, 10_000_000_000_000]),
        ] {
            for inverse in widths {
                let u = Expr::integer(inverse) * (&r - Expr::ratio(place.0, place.1));
                let peak = Expr::call("tanh", [u.clone()]) / Expr::call("cosh", [u]) * Expr::ratio(inverse, 1_000_000);
                assert!(!is_featureless(&(&plain + peak), 2), "{plain:?} {place:?} {inverse}");
            }
        }
    }
}
