//! Contact radii over 24 orders of magnitude: existence, independence of the unit of length, and the round trip d → a → d.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use sneddon::contact::{Contact, ContactError};
use sneddon::expr::Bindings;
use sneddon::num::special::dawson;
use sneddon::num::work::apart;
use sneddon::num::{Bound, Estimate};
use sneddon::parse;
use sneddon::transform::{Evaluator, Method, Profile, Reading, derive};
use sneddon_checks::decimal::Decimal;
use sneddon_checks::random::Stream;
use sneddon_checks::seeds::cases;

/// A profile in which [s] is the unit of length; its solution is kept as long as the tests run.
fn contact(text: &str, unit: f64) -> Contact<'static> {
    let formula = parse::profile(&text.replace("[s]", &format!("({unit:?})"))).unwrap();
    let solution = Box::leak(Box::new(derive(&Profile::new(&formula).unwrap()).unwrap()));
    let evaluator = Evaluator::new(solution, &Bindings::default(), Method::Auto, 1e-13).unwrap();
    Contact::new(evaluator, 1.0, None, 1e-13)
}

/// a(d), and the depth at this radius.
fn radius(text: &str, unit: f64, depth: f64) -> Result<(Reading, f64), ContactError> {
    let contact = contact(text, unit);
    let found = contact.contact_radius(depth)?;
    let back = contact.depth(found.estimate.value).unwrap().estimate;
    Ok((found, back.value))
}

/// Profiles with the largest depth at which they have a contact radius, in units of [s].
const SHAPES: [(&str, f64); 14] = [
    ("[s]*(1-exp(-(r/[s])^2))", 1.28),
    ("[s]*(r/[s])^2/(1+(r/[s])^2)", 0.99),
    ("[s]*(1-1/(1+(r/[s])^2)^2)", 1.0),
    ("(r/[s])^2*[s]", 9.0),
    ("[s]-([s]^2-r^2)^(1/2)", 5.0),
    ("[s]*ln(1+(r/[s])^2)", 30.0),
    ("[s]*(exp(r/[s])-1-r/[s])", 1e6),
    ("max(0, r-[s])^2/(2*[s])", 3.0),
    ("max(0, r-[s])*0.1", 3.0),
    ("r*0.2+[s]*(1-exp(-(r/[s])^2))", 7.0),
    ("(r/[s])^0.5*[s]", 4.0),
    ("piecewise(r/5, r<[s], [s]/5+(r-[s])/2)", 6.0),
    ("[s]*(1-besselj(0,r/[s]))", 0.9),
    ("[s]*atan((r/[s])^2)", 1.3),
];

/// Class "no contact radius where there is one".
#[test]
fn radii_are_found_alike_in_every_unit() {
    let (mut stream, mut worst) = (Stream::new(33), (0.0f64, 0.0f64));
    for round in 0..cases(28, 1000) {
        let (text, largest) = SHAPES[round % SHAPES.len()];
        let (share, unit) = (stream.uniform(0.001, 0.999), 10f64.powf(stream.uniform(-12.0, 12.0)));
        let Ok((one, _)) = radius(text, 1.0, share * largest) else { panic!("{text}: none at {}", share * largest) };
        let depth = share * largest * unit;
        let (own, back) = radius(text, unit, depth).unwrap_or_else(|error| panic!("{text} in units of {unit:e}: {error}"));
        let (other, far) = ((own.estimate.value / unit / one.estimate.value - 1.0).abs(), (back / depth - 1.0).abs());
        worst = (worst.0.max(other), worst.1.max(far));
        // d is rounded twice, and the unit in the formula once more.
        assert!(other < 5e-15, "{text} in units of {unit:e}: {own:?} and {one:?}");
        assert!(far < 1e-13, "{text}: from {depth:e} to {back:e}");
    }
    println!("largest difference between units {:e}, of the round trip {:e}", worst.0, worst.1);
}

/// Class "a radius next to a maximum".
///
/// For 1 − exp(−r²), g = 2x D(x) has a maximum: just below it there are two radii, of which the first is returned; above it there is none.
#[test]
fn the_top_of_a_hump_is_reached_and_not_passed() {
    // D(x) + x D′(x) = 0 with D′ = 1 − 2x D, by bisection.
    let rise = |x: f64| dawson(x) + x * (1.0 - 2.0 * x * dawson(x));
    let (mut low, mut high) = (1.0, 2.0);
    while high - low > 1e-15 {
        let middle = 0.5 * (low + high);
        if rise(middle) > 0.0 { low = middle } else { high = middle }
    }
    let top = 2.0 * low * dawson(low);
    for unit in [1e-10, 1.0, 1e9] {
        let text = "[s]*(1-exp(-(r/[s])^2))";
        for below in [1e-3, 1e-6, 1e-10] {
            let (found, _) = radius(text, unit, top * (1.0 - below) * unit).unwrap();
            let x = found.estimate.value / unit;
            assert!(x < low && (2.0 * x * dawson(x) / top - (1.0 - below)).abs() < 1e-12, "{x} below {low}");
        }
        assert!(matches!(radius(text, unit, top * (1.0 + 1e-6) * unit), Err(ContactError::NotFound { .. })));
        assert!(matches!(radius(text, unit, top * 1.01 * unit), Err(ContactError::Unreachable { .. })));
    }
}

/// Class "not the first root".
///
/// Waves whose amplitude grows: values of g near the root cost less than those at the end of the decade. The first root is that of
/// a grid of steps of 0.1 with 30 digits.
#[test]
fn the_first_root_of_growing_waves_is_found() {
    for unit in [1e-6, 1.0, 1e7] {
        let (found, _) = radius("(r/[s])*besselj(0,3+(r/[s])/0.7)", unit, 16.98).unwrap();
        assert!((found.estimate.value / unit / 19.606_804_767_141_225 - 1.0).abs() < 1e-14, "{found:?}");
    }
}

/// Class "not the first root".
///
/// The wave is 1/154 of the radius, and the crest before the root that was found is 0.03 % above the depth: x π/2 H₀(2x) = 20 by mpmath with
/// 40 digits, beside a scan of a hundred points per wave.
#[test]
fn the_first_root_of_many_waves_is_found() {
    for unit in [1e-9, 1.0, 1e7] {
        let (found, _) = radius("[s]*sin(r/[s])^2", unit, 20.0 * unit).unwrap();
        assert!((found.estimate.value / unit / 484.962_946_045_529_3 - 1.0).abs() < 1e-15, "{found:?}");
    }
}

/// Class "not the first root". Waves that become shorter outward, for which g is integrated: the references are by mpmath beside a scan of forty
/// points per wave.
#[test]
fn the_first_root_of_shortening_waves_is_found() {
    for (text, depth, root) in [
        ("[s]*((r/[s])^2/20+0.01*sin((r/[s])^3))", 1.5, 3.696_904_731_789_072),
        ("[s]*((r/[s])/5+0.05*sin(5*(r/[s])+20*sin(r/[s])))", 2.522_114_548_612_051, 5.786_322_512_585_65),
    ] {
        let (found, _) = radius(text, 1.0, depth).unwrap();
        assert!((found.estimate.value / root - 1.0).abs() < 1e-15, "{text}: {found:?}");
    }
}

/// Class "not the first root". Rings from a thirtieth to a ten-thousandth of their radius, and cusps of g at kinks, just below whose top the
/// depth lies: the references are by mpmath with 40 digits, and g(x) = x²/R before the kink.
#[test]
fn the_first_root_at_narrow_features_is_found() {
    for unit in [1e-9, 0.37, 1.0, 7e6] {
        for (text, depth, root) in [
            (
                "[s]*((r/[s])^2/(2*9.532150516490486)+0.0016155392432620234*exp(-(r/[s]-0.27054534583845374)^2/0.008103027162236614^2))",
                0.016_425_056_905_278_842,
                0.264_835_207_003_895_25,
            ),
            ("[s]*((r/[s])^2/2+0.001/cosh((r/[s]-1)/0.0001))", 1.05, 0.999_847_439_425_090_6),
            ("[s]*((r/[s])^2/2+0.01*max(0,1-abs(r/[s]-1)/0.001))", 1.1, 0.999_051_961_947_704_1),
            ("[s]*min((r/[s])^2/1.4,0.3)", 0.599_999_999_94, 0.648_074_069_808_382_4),
            ("[s]*(min((r/[s])^2/1.4,0.3)+0.01*r/[s])", 0.610_179_923_622_951_3, 0.648_074_069_808_109_5),
        ] {
            let (found, _) = radius(text, unit, depth * unit).unwrap();
            assert!((found.estimate.value / unit / root - 1.0).abs() < 1e-15, "{text} {unit}: {found:?}");
        }
    }
}

/// Class "not the first root". The force falls where g does: under a narrow ring the smaller of several contact radii is found.
#[test]
fn the_first_radius_under_a_force_at_a_narrow_ring_is_found() {
    let ring = contact("r^2/2+0.001/cosh((r-1)/0.0001)", 1.0);
    let before = ring.force(0.9999).unwrap().estimate.value;
    let found = ring.radius_under_force(before).unwrap().estimate;
    assert!((found.value - 0.9999).abs() <= found.error && found.error < 1e-14, "{found:?}");
}

/// Beyond its maximum a falling g overflows; its slopes are too large for products with radii.
#[test]
fn a_falling_g_is_proven_to_stay_below() {
    for text in ["r*(3-r^2)", "r-r^2/4", "r*exp(-r)-r^3"] {
        assert!(matches!(radius(text, 1.0, 30.0), Err(ContactError::Unreachable { .. })), "{text}");
    }
}

/// Class "depths next to a pole". Toward a pole, radii are looked for by their distance from it: 10¹⁰ took the whole budget.
#[test]
fn depths_next_to_a_pole_are_reached() {
    for text in ["r^2/besselj(0,r)", "r^2/(2-besseli(0,r))"] {
        let (found, back) = radius(text, 1.0, 1e10).unwrap();
        assert!((back / 1e10 - 1.0).abs() < 1e-5, "{text}: from {back:e} to {found:?}");
    }
}

/// Class "none without a proof".
///
/// Depths that g reaches nowhere are proven to be unreachable, in every unit, and depths that it reaches are found; the supremum of g is
/// that of a grid with its kinks, with 5 % of room on both sides.
#[test]
fn that_no_radius_reaches_a_depth_is_proven() {
    for text in [
        "[s]*(1-exp(-(r/[s])^2))",
        "[s]*(1-exp(-(r/[s])^4))",
        "[s]*(1-exp(-(r/[s])^(1/2)))",
        "r/(1+r/[s])",
        "[s]*(r/[s])^2/(1+(r/[s])^2)",
        "[s]*(r/[s])^5/(1+(r/[s])^8)",
        "r*exp(-r/[s])",
        "[s]*tanh(r/[s])",
        "[s]*(1-1/cosh(r/[s]))",
        "[s]*erf(r/[s])",
        "[s]*atan((r/[s])^3)",
        "min(r^2/[s], [s])",
        "piecewise(r, r<[s], [s])",
        "[s]*(1-(1-(r/[s])^2)^(3/2))",
    ] {
        let plain = contact(text, 1.0);
        let end = plain.evaluator().limit().min(100.0);
        let places = (1..200).map(|i| end * (f64::from(i) / 200.0).powi(3)).chain(plain.evaluator().breakpoints_below(end));
        let top = places.map(|x| plain.depth(x).unwrap().estimate.value).fold(0.0, f64::max);
        for unit in [1e-9, 1.0, 1e6] {
            assert!(radius(text, unit, 0.95 * top * unit).is_ok(), "{text} in units of {unit:e}");
            for above in [1.05, 2.0, 100.0] {
                let found = radius(text, unit, above * top * unit);
                assert!(matches!(found, Err(ContactError::Unreachable { .. })), "{text} in units of {unit:e}, {above} of {top}: {found:?}");
            }
        }
    }
}

/// Class "a verdict that depends on the unit". The depths lie close above the maximum of g, which is 1.1688761319519….
#[test]
fn proofs_do_not_depend_on_the_unit_of_length() {
    let text = "[s]*(1-1/cosh(r/[s]))";
    for depth in [1.168_876_131_951_948, 1.1689, 1.17, 1.3] {
        let is_proven = |unit: f64| match radius(text, unit, depth * unit) {
            Err(ContactError::Unreachable { .. }) => true,
            Err(ContactError::NotFound { .. }) => false,
            other => panic!("{depth} in units of {unit:e}: {other:?}"),
        };
        let expected = is_proven(1.0);
        assert!([1e-9, 1e-6, 1e-3, 1e3, 2f64.powi(-20)].into_iter().all(|unit| is_proven(unit) == expected), "{depth}: {expected}");
    }
}

/// Class "none without a proof": where g grows without limit toward the end, radii that lie between the last floats are not denied. The
/// radii exist: at π/2 − ε, g tends to (π/2) √(π/ε) for −ln(cos r) and grows faster for tan(r); it is x artanh x for the sphere, and xK(x).
#[test]
fn radii_between_the_last_floats_are_not_denied() {
    for (text, depth) in [("-ln(cos(r))", 1e12), ("tan(r)", 1e30), ("1-sqrt(1-r^2)", 40.0), ("asin(r)", 60.0)] {
        let found = radius(text, 1.0, depth);
        assert!(matches!(found, Err(ContactError::NotFound { .. })), "{text}: {found:?}");
    }
}

/// Class "waves and ends at nanometres". Oscillating profiles, and depths near the end of a profile, at nanometre scale.
#[test]
fn waves_and_ends_are_followed() {
    for (text, depths) in [
        ("1e-9*sin(pi*r/1e-8)^2", &[1e-9, 1.2e-9, 2e-9][..]),
        ("1e-9*(1-1/cosh(r/2e-9))", &[1e-9, 1.02e-9]),
        ("-1e-9*ln(cos(r/2e-9))", &[1e-10, 5e-9]),
        ("2e-9-sqrt(4e-18-r^2)", &[1e-10, 1e-8]),
        ("1e-3*(cosh(r/1e-3)-1)", &[1e-4, 1.0]),
        ("max(0,r-1e-6)^2/4e-7", &[1e-9]),
        ("1e-6-sqrt(1e-12-(r-2e-7)^2)", &[1e-9, 3e-6]),
        ("1e-6*acos(1-r/1e-6)-sqrt(2e-6*r-r^2)", &[1e-9, 3e-6]),
        ("1e-6*(1-(1-(r/1e-6)^3)^(1/3))", &[1e-9, 1.5e-6]),
        ("2e-9*(1-(1-(r/1e-9)^4)^(1/4))", &[1e-12, 3e-9]),
    ] {
        for depth in depths {
            let (_, back) = radius(text, 1.0, *depth).unwrap_or_else(|error| panic!("{text}: {error}"));
            assert!((back / depth - 1.0).abs() < 1e-12, "{text}: from {depth:e} to {back:e}");
        }
    }
}

/// The depth of each with its radius by mpmath. Next to the axis √r and ln r leave f′ without an enclosure, at any distance: a proof
/// by pieces was tried down to underflow, at every radius of the search.
#[test]
fn radii_are_found_without_an_enclosure_at_the_axis() {
    for (text, depth, radius) in [
        ("1-cos(7/10*sqrt(r)+7/10*r^2*ln(r))", 0.5, "0.988318935138760766537309"),
        ("ln(1+(sqrt(r)+r^2*ln(r))^2)", 0.3, "0.4070081533509040723072066"),
    ] {
        let found = contact(text, 1.0).contact_radius(depth).unwrap_or_else(|error| panic!("{text}: {error}")).estimate;
        let off = Decimal::read(radius).distance(found.value);
        assert!(off <= found.error && found.error < 2e-13, "{text}: {found:?} is off by {off:e}");
    }
}

/// Steps that a search may take, about twice what it takes. In the first profile the form that the rules match cancels towards the end,
/// and one value of g took up to 20 million steps; in the second no piece of f′ next to the axis has an enclosure, and a proof was tried
/// at 1000 places for each value of g.
#[test]
fn a_search_asks_the_cheap_way_to_g_where_the_first_one_is_costly() {
    const MOST: u64 = 1_000_000_000;
    const CANCELLING: &str = "log(r+1)/2.16/(1.876+(5-sqrt(5^2-r^2))^2)";
    const WITHOUT_ENCLOSURE: &str = "4.2206*(1-sqrt(1-(r/4.2206)^2))/((ln(r)*r^2)^2+1.87)";
    for (text, depth, radius, most) in [
        (CANCELLING, 0.1, Some("0.30629211628610263839376189"), 12_000_000),
        (CANCELLING, 0.5, None, 90_000_000),
        (WITHOUT_ENCLOSURE, 0.1, Some("0.87991399601044677200451017"), 12_000_000),
        (WITHOUT_ENCLOSURE, 0.5, None, 140_000_000),
    ] {
        let contact = contact(text, 1.0);
        let (found, steps, _) = apart(MOST, || contact.contact_radius(depth));
        assert!(steps <= most, "{text} at {depth}: {steps} steps");
        match (found, radius) {
            (Ok(found), Some(radius)) => {
                let off = Decimal::read(radius).distance(found.estimate.value);
                assert!(off <= found.estimate.error, "{text}: {found:?} is off by {off:e}");
            }
            (Err(ContactError::Unreachable { .. } | ContactError::NotFound { .. }), None) => {}
            (found, _) => panic!("{text} at {depth}: {found:?}"),
        }
    }
}

/// The round trip a → F → a within the bounds, the force of a paraboloid by its formula, and forces that no radius has.
#[test]
fn radii_under_forces_keep_their_bounds() {
    let mut stream = Stream::new(35);
    for (text, _) in SHAPES {
        for unit in [1e-9, 1.0, 1e6] {
            let contact = contact(text, unit);
            let a = unit * stream.uniform(0.1, 0.7) + if text.contains("r-[s]") { unit } else { 0.0 };
            let force = contact.force(a).unwrap().estimate;
            let found = contact.radius_under_force(force.value).unwrap().estimate;
            // F is rounded, too, and rises at least like a.
            assert!((found.value - a).abs() <= found.error + 2.0 * a * force.error / force.value, "{text} in {unit}: {found:?} for {a}");
            assert!(found.error < 1e-12 * a && found.bound == Bound::Proven, "{text} in {unit}: {found:?}");
        }
    }
    // F = 4E*a³/(3R) with R = 2; (1.5·0.7)^(1/3) at 30 digits, 0.7 being a double.
    let found = contact("r^2/4", 1.0).radius_under_force(0.7).unwrap().estimate;
    assert!(Decimal::read("1.01639635681485340728290132579").distance(found.value) <= found.error && found.error < 1e-15);
    assert_eq!(contact("max(0, r-1)", 1.0).radius_under_force(0.0).unwrap().estimate, Estimate::exact(1.0));
    for (text, force) in [("1-(1-r^2)^(3/2)", 5.0), ("r^2", -1.0), ("r^2", f64::NAN), ("r^2", f64::INFINITY), ("1-exp(-r^2)", 1e70)] {
        let refused = contact(text, 1.0).radius_under_force(force);
        assert!(matches!(refused, Err(ContactError::ForceUnreachable { .. })), "{text} under {force}: {refused:?}");
    }
}

/// Class "a radius where there is none": g falls to minus infinity, where it overflows, or the profile ends first. Values of g that overflow
/// counted as positive, and the radius of a power went on beyond the end.
#[test]
fn no_radius_is_found_beyond_a_maximum_or_an_end() {
    for (text, largest) in [
        ("r/[s]*(3-(r/[s])^2)*[s]", 2.565_099_66),
        ("(r/[s])^2*(3-(r/[s])^2)*[s]", 3.375),
        ("(r/[s])^1.5*(2-r/[s])*[s]", 1.409_833_01),
        ("r*min(1/(1-r/[s]),r/[s])", 2.0),
        ("(1-cosh(r/[s])+2*(r/[s])^2)*[s]", 14.25),
    ] {
        for unit in [1e-9, 1.0, 1e6] {
            for depth in [1.01, 2.0, 1e3] {
                let found = radius(text, unit, depth * largest * unit);
                assert!(found.is_err(), "{text} in units of {unit:e}, {depth}: {found:?}");
            }
        }
        assert!(radius(text, 1.0, 0.5 * largest).is_ok(), "{text}");
    }
    // F of r(3 − r²) is at most 1.58.
    let contact = contact("r*(3-r^2)", 1.0);
    assert!(contact.radius_under_force(100.0).is_err() && contact.force_of_depth(10.0).is_err());
}
