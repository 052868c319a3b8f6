//! Indentations: every load against explicit relations, and the verdict against profiles whose validity is known.
#![allow(clippy::unwrap_used, clippy::panic)]

use sneddon::contact::{Boundary, Contact, Indentation, Indented, Load, Setup, State};
use sneddon::expr::Bindings;
use sneddon::num::work::{Budget, Exhausted, within};
use sneddon::num::{Bound, Bounded};
use sneddon::parse;
use sneddon::transform::{
    Evaluator, Interpolation, Method, Profile, Quantities, Reading, Slopes, Solution, TableProfile, TransformError, derive,
};
use sneddon_checks::seeds::cases;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

fn solution(text: &str) -> Solution {
    derive(&Profile::new(&parse::profile(text).unwrap()).unwrap()).unwrap()
}

fn setup(rim: Option<f64>) -> Setup {
    Setup { effective_modulus: 1.0, rim, tolerance: 1e-12, method: Method::Auto }
}

fn solve(text: &str, rim: Option<f64>, load: Load) -> Indented {
    let solution = solution(text);
    Indentation::new(&solution, setup(rim), load).unwrap().solve(load).unwrap()
}

fn state(text: &str, rim: Option<f64>, load: Load) -> State {
    let found = solve(text, rim, load);
    assert!(found.is_valid(), "{text} {load:?}: {found:?}");
    found.state.unwrap()
}

/// The rule of the first error.
fn refused(text: &str, rim: Option<f64>, load: Load) -> (&'static str, Option<f64>) {
    let found = solve(text, rim, load);
    assert!(!found.is_valid(), "{text} {load:?}: {found:?}");
    let first = found.findings.first().unwrap();
    (first.rule, first.at)
}

fn near(value: f64, expected: f64, ulps: f64) {
    assert!((value - expected).abs() <= ulps * f64::EPSILON * expected.abs(), "{value:?} is not {expected:?} to {ulps} ulp");
}

#[test]
fn one_load_gives_the_other_two() {
    for text in [
        "r^2/4",
        "r*tan(1/5)",
        "2-sqrt(4-r^2)",
        "sqrt(1+r^2)-1",
        "piecewise(0, r<1/2, (r-1/2)/3)",
        "r^2/5+r/9",
        "ln(1+r^2/9)",
        "1-exp(-r^2)",
    ] {
        let reference = state(text, None, Load::Radius(0.7));
        for load in [Load::Depth(reference.depth), Load::Force(reference.force)] {
            let found = state(text, None, load);
            near(found.radius, 0.7, 16.0);
            near(found.depth, reference.depth, 16.0);
            near(found.force, reference.force, 16.0);
            assert_eq!(found.boundary, Boundary::Smooth);
        }
    }
}

/// By roots of the other load and by the explicit form: the same numbers.
#[test]
fn roots_agree_with_explicit_forms() {
    for text in ["r^2/4", "r*tan(1/5)", "r^(7/2)", "r^2/5+r/9", "piecewise(0, r<1/2, (r^2-1/4)/3)"] {
        let solution = solution(text);
        let by_form = Indentation::new(&solution, setup(None), Load::Depth(1.0)).unwrap();
        // Without an explicit form for forces, both g and F are inverted by roots.
        let by_root = Indentation::new(&solution, setup(None), Load::Force(1.0)).unwrap();
        for step in 0..40 {
            let depth = 10f64.powf(-12.0 + 0.3 * f64::from(step));
            let (one, two) =
                (by_form.solve(Load::Depth(depth)).unwrap().state.unwrap(), by_root.solve(Load::Depth(depth)).unwrap().state.unwrap());
            near(two.force, one.force, 4.0);
            near(two.radius, one.radius, 4.0);
            let three = by_root.solve(Load::Force(one.force)).unwrap().state.unwrap();
            near(three.depth, depth, 6.0);
        }
    }
}

/// A flat part of radius b = 1 under d = 1e-8: a rounds to b, and F = 2E* b d (1 + …) keeps its digits.
#[test]
fn a_worn_tip_at_a_tiny_depth() {
    // g = x √(x² − 1), F = (2/3)(2a² + 1)√(a² − 1) with a² = (1 + √(1 + 4d²))/2.
    let d = 1e-8f64;
    let expected = |d: f64| {
        let s = (1.0 + 4.0 * d * d).sqrt();
        2.0 * 2f64.sqrt() / 3.0 * d * (2.0 + s) / (1.0 + s).sqrt()
    };
    near(state("piecewise(0, r<1, (r^2-1)/2)", None, Load::Depth(d)).force, expected(d), 4.0);
    let back = state("piecewise(0, r<1, (r^2-1)/2)", None, Load::Force(expected(d)));
    near(back.depth, d, 4.0);
    // A truncated cone has no explicit form: a = 1/cos φ, d = φ/cos φ, F = φ/cos²φ + tan φ.
    for phi in [1e-12f64, 1e-8, 1e-3, 0.1] {
        let (d, force) = (phi / phi.cos(), phi / phi.cos().powi(2) + phi.tan());
        near(state("piecewise(0, r<1, r-1)", None, Load::Depth(d)).force, force, 6.0);
        near(state("piecewise(0, r<1, r-1)", None, Load::Force(force)).depth, d, 6.0);
    }
}

#[test]
fn the_ends_of_loading() {
    let zero = state("r^2/4", None, Load::Depth(0.0));
    assert_eq!((zero.radius, zero.force), (0.0, 0.0));
    let flat = state("piecewise(0, r<1, (r^2-1)/2)", None, Load::Depth(0.0));
    assert_eq!((flat.radius, flat.force), (1.0, 0.0));
    let punch = state("0", Some(3.0), Load::Depth(0.0));
    assert_eq!((punch.radius, punch.force), (3.0, 0.0));
    let apart = state("r^2/4", None, Load::Depth(-1.0));
    assert_eq!((apart.radius, apart.force, apart.boundary), (0.0, 0.0, Boundary::Apart));
    let solution = solution("r^2/4");
    let negative = Indentation::new(&solution, setup(None), Load::Force(1.0)).unwrap().solve(Load::Force(-1.0));
    assert!(negative.unwrap_err().to_string().contains("negative force"));
    assert_eq!(refused("2-sqrt(4-r^2)", None, Load::Depth(1e6)).0, "unreachable");
    assert_eq!(refused("1-exp(-r^2)", None, Load::Depth(1.5)).0, "unreachable");
}

#[test]
fn a_cylinder_with_a_cap() {
    // g(c) = 2 at c = 2: below it the contact is Hertz's, above it the edge is free.
    let smooth = state("r^2/4", Some(2.0), Load::Depth(0.5));
    near(smooth.radius, 1.0, 1.0);
    assert_eq!(smooth.boundary, Boundary::Smooth);
    let rim = state("r^2/4", Some(2.0), Load::Depth(3.0));
    assert_eq!((rim.radius, rim.boundary), (2.0, Boundary::Rim));
    near(rim.force, 2.0 * (3.0 * 2.0 - 8.0 / 6.0), 4.0);
    near(state("r^2/4", Some(2.0), Load::Force(rim.force)).depth, 3.0, 4.0);
    near(state("0", Some(2.0), Load::Force(1.0)).depth, 0.25, 1.0);
    let solution = solution("r^2/4");
    let at_rim = Indentation::new(&solution, setup(Some(2.0)), Load::Radius(2.0)).unwrap().solve(Load::Radius(2.0));
    assert!(at_rim.unwrap_err().to_string().contains("depth or force"));
}

/// −h (r/c)ⁿ with h = c = 1: complete contact from 2h (n = 2), 4h/3 (n = 4), 1.44 h (n = 3), never for n ≤ 1.
#[test]
fn concave_punches() {
    for (text, least, at) in [("-r^2", 2.0, 0.0), ("-r^4", 4.0 / 3.0, 0.5)] {
        assert!(solve(text, Some(1.0), Load::Depth(least * (1.0 + 1e-9))).is_valid());
        let (rule, place) = refused(text, Some(1.0), Load::Depth(least * (1.0 - 1e-6)));
        assert_eq!(rule, "tension_inside");
        assert!((place.unwrap() - at).abs() < 1e-3, "{text} {place:?}");
    }
    assert!(solve("-r^3", Some(1.0), Load::Depth(1.45)).is_valid());
    assert_eq!(refused("-r^3", Some(1.0), Load::Depth(1.43)).0, "tension_inside");
    for text in ["-r", "-r^(1/2)"] {
        assert_eq!(refused(text, Some(1.0), Load::Depth(1e6)), ("tension_inside", Some(0.0)));
    }
    let apart = state("-r^2", Some(1.0), Load::Depth(-1.0001));
    assert_eq!(apart.boundary, Boundary::Apart);
    // At the first touch there is no force yet, and no force is the first touch.
    let touch = state("-r^2", Some(1.0), Load::Depth(-1.0));
    assert_eq!((touch.boundary, touch.force), (Boundary::Apart, 0.0));
    assert_eq!(state("-r^2", Some(1.0), Load::Force(0.0)).depth, -1.0);
    // Between the first touch and complete contact only a ring touches.
    assert_eq!(refused("-r^2", Some(1.0), Load::Depth(-0.5)).0, "tension_inside");
}

/// Class "valid without a single pressure": g is infinite just beyond a kink like (r − b)^s with s < 1/2, and p is −∞ in the limit.
#[test]
fn a_contact_without_any_pressure_is_not_valid() {
    for power in ["1/5", "1/4", "3/10"].into_iter().step_by(cases(3, 1)) {
        let text = format!("r^2+piecewise(0,r<0.5,(r-0.5)^({power}))");
        assert_eq!(refused(&text, None, Load::Radius(0.7)).0, "pressure_unknown", "{text}");
        assert!(solve(&text, None, Load::Radius(0.3)).is_valid(), "{text}");
    }
}

/// A Gaussian: the gap outside closes at a = 0.924 w, where d = h.
#[test]
fn a_gaussian_ends_where_its_depth_is_its_height() {
    let text = "1-exp(-r^2)";
    for d in [0.01, 0.3, 0.9, 0.999] {
        assert!(solve(text, None, Load::Depth(d)).is_valid(), "{d}");
    }
    assert!(solve(text, None, Load::Radius(0.923)).is_valid());
    for load in [Load::Depth(1.001), Load::Radius(0.925), Load::Radius(1.2)] {
        assert_eq!(refused(text, None, load).0, "outside_gap");
    }
    // Beyond the largest g the pressure turns as well.
    assert!(!solve(text, None, Load::Radius(1.6)).is_valid());
}

#[test]
fn waves_end_where_the_next_crest_touches() {
    assert!(solve("1-besselj(0,r)", None, Load::Radius(1.30)).is_valid());
    assert_eq!(refused("1-besselj(0,r)", None, Load::Radius(1.35)).0, "outside_gap");
    for a in [1e-3, 0.1, 1.0, 2.0] {
        let (rule, at) = refused("1-cos(r)", None, Load::Radius(a));
        assert_eq!(rule, "outside_gap");
        assert!(at.unwrap() < 2.0 * std::f64::consts::PI, "{at:?}");
    }
}

/// g falls on the way, and the contact is valid all the same.
#[test]
fn a_falling_g_alone_decides_nothing() {
    let text = "r^2/2+(1-cos(8*r))/20";
    for a in [1.0, 1.5, 2.0] {
        let found = solve(text, None, Load::Radius(a));
        assert!(found.is_valid(), "{a}: {found:?}");
        // From the depth the same contact is found among several roots.
        let back = state(text, None, Load::Depth(found.state.unwrap().depth));
        near(back.radius, a, 64.0);
    }
    // Waves that are too high separate.
    assert!(!solve("r^2/2+(1-cos(8*r))", None, Load::Radius(1.5)).is_valid());
}

/// Radius and force at 58 depths from 1e-16 on, against 40 digits: within 4 ulp times the condition number of the exponent.
#[test]
fn forces_and_radii_have_their_reference_values() {
    let table = include_str!("../oracle/indentation.csv");
    let (mut worst, mut count) = (0.0f64, 0);
    for line in table.lines().skip(1) {
        let fields: Vec<&str> = line.split(';').collect();
        let [profile, d, a, force] = fields.try_into().unwrap();
        let number = |text: &str| text.parse::<f64>().unwrap();
        let found = state(profile, None, Load::Depth(number(d)));
        // F goes as d^(1 + 1/n), a as d^(1/n).
        let condition = if profile == "r^(0.001)" { 1001.0 } else { 1.0 };
        near(found.force, number(force), 4.0 * condition);
        near(found.radius, number(a), 4.0 * condition);
        worst = worst.max((found.force / number(force) - 1.0).abs() / condition / f64::EPSILON);
        count += 1;
    }
    assert_eq!(count, 58);
    println!("largest error of F: {worst:.2} ulp times the condition number");
}

/// One load that cannot be reached must not change the others, and far out the waves of f are too short to be followed.
#[test]
fn oscillating_profiles_have_no_roots_far_out() {
    // g = 1 − cos x: a(1/2) = π/3, and no more than 2 is reached.
    let bessel = solution("1-besselj(0,r)");
    let many = Indentation::new(&bessel, setup(None), Load::Depth(3.0)).unwrap();
    near(many.solve(Load::Depth(0.5)).unwrap().state.unwrap().radius, std::f64::consts::FRAC_PI_3, 8.0);
    let beyond = many.solve(Load::Depth(3.0)).unwrap();
    assert_eq!((beyond.state, beyond.findings.first().map(|own| own.rule)), (None, Some("unreachable")));
    for load in [Load::Depth(0.5), Load::Depth(1.2), Load::Force(0.01), Load::Force(5.0)] {
        let found = solve("1-cos(r)", None, load);
        assert!(!found.is_valid(), "{load:?}: {found:?}");
    }
    // A bounded g, whose largest value is not reached either.
    let bounded = solution("atan(r)^2");
    let many = Indentation::new(&bounded, setup(None), Load::Depth(3.0)).unwrap();
    let one = Indentation::new(&bounded, setup(None), Load::Depth(0.3)).unwrap();
    let radius = |own: &Indentation<'_>| own.solve(Load::Depth(0.3)).unwrap().state.unwrap().radius;
    near(radius(&many), radius(&one), 8.0);
}

/// A flat end touches as a whole.
#[test]
fn a_flat_end_has_one_contact_radius() {
    assert_eq!(refused("0", Some(1.0), Load::Radius(0.5)).0, "unreachable");
}

/// How often each quantity was computed.
#[derive(Default)]
struct Counts {
    slope: AtomicU64,
    force: AtomicU64,
    integral: AtomicU64,
    pressure: AtomicU64,
    axial: AtomicU64,
    displacement: AtomicU64,
}

impl Counts {
    fn all(&self) -> [u64; 6] {
        [&self.slope, &self.force, &self.integral, &self.pressure, &self.axial, &self.displacement]
            .map(|count| count.load(Ordering::Relaxed))
    }
}

/// A profile that counts what it is asked.
struct Counted {
    profile: TableProfile,
    counts: Arc<Counts>,
}

fn count(counter: &AtomicU64) {
    counter.fetch_add(1, Ordering::Relaxed);
}

impl Quantities for Counted {
    fn equivalent(&self, x: f64) -> Result<Reading, TransformError> {
        count(&self.counts.slope);
        self.profile.equivalent(x)
    }
    fn force(&self, a: f64) -> Result<Reading, TransformError> {
        count(&self.counts.force);
        self.profile.force(a)
    }
    fn integral(&self, a: f64) -> Result<Reading, TransformError> {
        count(&self.counts.integral);
        self.profile.integral(a)
    }
    fn pressure(&self, r: f64, a: f64) -> Result<Option<Reading>, TransformError> {
        count(&self.counts.pressure);
        Quantities::pressure(&self.profile, r, a)
    }
    fn axial(&self, z: f64, a: f64) -> Result<Reading, TransformError> {
        count(&self.counts.axial);
        Quantities::axial(&self.profile, z, a)
    }
    fn displacement(&self, r: f64, a: f64) -> Result<Reading, TransformError> {
        count(&self.counts.displacement);
        self.profile.displacement(r, a)
    }
    fn height(&self, r: f64) -> Result<Reading, TransformError> {
        self.profile.height(r)
    }
    fn limit(&self) -> f64 {
        Quantities::limit(&self.profile)
    }
    fn breakpoints_below(&self, end: f64) -> Vec<f64> {
        self.profile.breakpoints_below(end)
    }
    fn check_domain(&self, symbol: &'static str, at: f64) -> Result<(), TransformError> {
        self.profile.check_domain(symbol, at)
    }
}

impl Slopes for Counted {
    fn first(&self, r: f64) -> Bounded {
        self.profile.first(r)
    }
    fn bend(&self, r: f64) -> Bounded {
        self.profile.bend(r)
    }
    fn kinks(&self) -> Vec<(f64, f64)> {
        self.profile.kinks()
    }
    fn is_flat(&self) -> bool {
        self.profile.is_flat()
    }
}

fn counted_paraboloid() -> (Counted, Arc<Counts>) {
    let r: Vec<f64> = (0..=40).map(|i| 0.05 * f64::from(i)).collect();
    let z: Vec<f64> = r.iter().map(|r| r * r / 4.0).collect();
    let counts = Arc::new(Counts::default());
    (Counted { profile: Profile::from_points(&r, &z, Interpolation::MonotoneCubic).unwrap(), counts: counts.clone() }, counts)
}

/// F(d) needs roots of g and one force per load: no pressure, no stress, no displacement, no energy.
#[test]
fn a_force_computes_no_pressure() {
    let (profile, counts) = counted_paraboloid();
    let indentation = Indentation::of(profile, setup(None), Load::Depth(1.0)).unwrap();
    let [looked, ..] = counts.all();
    let loads = 50;
    for i in 1..=loads {
        let state = indentation.solve(Load::Depth(f64::from(i) / f64::from(loads))).unwrap().state.unwrap();
        assert!(state.force > 0.0);
    }
    let [slope, force, integral, pressure, axial, displacement] = counts.all();
    assert_eq!([pressure, axial, displacement], [0, 0, 0]);
    assert!(force + integral <= 2 * u64::from(loads as u32), "{force} forces and {integral} integrals for {loads} loads");
    assert!(slope - looked <= 12 * u64::from(loads as u32), "{} slopes for {loads} loads", slope - looked);
}

/// Narrow rings and grooves as mpmath judges them: the verdicts agree, those on rings are proven, and the radius is the first one.
#[test]
fn narrow_features_are_judged_as_by_mpmath() {
    let (mut valid, mut rings, mut proven, mut count) = (0, 0, 0, 0);
    let every = cases(30, 1);
    for line in include_str!("../oracle/verdicts.csv").lines().skip(1).step_by(every) {
        let fields: Vec<&str> = line.split(',').collect();
        let [text, radius, verdict, at] = fields[..] else { panic!("{line}") };
        let found = solve(text, None, Load::Radius(radius.parse().unwrap()));
        count += 1;
        if verdict == "valid" {
            assert!(found.is_valid(), "{line}: {found:?}");
            valid += 1;
            // Pressures next to a groove are often too close to 0 for the bounds.
            if !line.contains("exp") {
                rings += 1;
                proven += u32::from(found.radii.is_none());
            }
            continue;
        }
        assert!(!found.is_valid(), "{line}: {found:?}");
        let first = found.findings.first().unwrap();
        assert_eq!(first.rule, verdict, "{line}");
        let at: f64 = at.parse().unwrap();
        // Where u has no digits, a bound on it shows the overlap a little later.
        let late = first.at.unwrap() / at - 1.0;
        assert!(-3e-9 < late && late < 1e-4, "{line}: {:?}", first.at);
    }
    assert!(every * count > 30 && every * valid > 10 && every * (count - valid) > 10);
    // So may be the gap below a very narrow ring.
    assert!(proven + 1 >= rings && every as u32 * rings > 10, "{proven} of {rings} are proven");
}

/// Next to the end of these profiles g has no digits or is infinite: loads far below it and close to it are solved all the same,
/// with the contact radius that the search without a verdict finds.
#[test]
fn profiles_that_end_steeply_are_solved_in_every_unit() {
    let shapes = [
        "[s]-([s]^4-r^4)^(1/4)",
        "[s]-([s]^3-r^3)^(1/3)",
        "[s]-([s]^3.5-r^3.5)^(1/3.5)",
        "[s]*acos(1-r/[s])-sqrt(2*[s]*r-r^2)",
        "piecewise(0, r<5*[s], [s]-sqrt([s]^2-(r-5*[s])^2))",
        "-[s]*ln(cos(r/[s]))",
    ];
    for (shape, unit) in shapes.into_iter().flat_map(|shape| [1e-9, 1.0].map(|unit| (shape, unit))) {
        let text = shape.replace("[s]", &format!("({unit:?})"));
        for depth in [0.3 * unit, 1e-3 * unit, 1.4 * unit].into_iter().step_by(cases(3, 1)) {
            let found = state(&text, None, Load::Depth(depth));
            let solution = solution(&text);
            let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-12).unwrap();
            let radius = Contact::new(evaluator, 1.0, None, 1e-12).contact_radius(depth).unwrap().estimate.value;
            assert!((found.radius / radius - 1.0).abs() < 1e-12, "{text} at {depth:?}: {found:?}, {radius:?}");
        }
    }
}

/// The errors of a solved load hold: for a paraboloid, whose numbers are known, and from load to load for profiles that have no formula.
#[test]
fn the_errors_of_a_solved_load_hold() {
    // f = r²: g = 2x², F = (8/3) E a³, U = (32/15) E a⁵, at E = 3.
    let paraboloid = solution("r^2");
    let setup = |rim| Setup { effective_modulus: 3.0, ..setup(rim) };
    let a = 0.75;
    for load in [Load::Radius(a), Load::Depth(2.0 * a * a), Load::Force(8.0 * a * a * a)] {
        let own = Indentation::new(&paraboloid, setup(None), load).unwrap();
        let state = own.solve(load).unwrap().state.unwrap();
        let found = own.estimates(&state, load, 0.0).unwrap();
        let energy = own.energy_estimate(own.energy(&state).unwrap().estimate, &state, &found);
        let truths = [(found.radius, a), (found.depth, 2.0 * a * a), (found.force, 8.0 * a * a * a), (energy, 6.4 * a.powi(5))];
        for (own, truth) in truths {
            // 6.4 a⁵ is rounded three times.
            assert!((own.value - truth).abs() <= own.error + 2.0 * f64::EPSILON * truth, "{load:?}: {own:?} is not {truth}");
            assert!(own.error <= 2e-14 * truth && own.bound == Bound::Proven, "{load:?}: {own:?}");
        }
    }
    for text in ["ln(cosh(r))", "max(0,r-0.5)", "r^1.3", "1-sqrt(1-r^2)", "r^2*exp(-r/4)", "sqrt(r)", "piecewise(r,r<0.8,2*r-0.8)"] {
        let solution = solution(text);
        for depth in [1e-3, 0.3, 0.9] {
            let own = Indentation::new(&solution, setup(None), Load::Depth(depth)).unwrap();
            let first = own.solve(Load::Depth(depth)).unwrap().state.unwrap();
            let known = own.estimates(&first, Load::Depth(depth), 0.0).unwrap();
            let own = Indentation::new(&solution, setup(None), Load::Force(first.force)).unwrap();
            let second = own.solve(Load::Force(first.force)).unwrap().state.unwrap();
            let found = own.estimates(&second, Load::Force(first.force), 0.0).unwrap();
            // dF/dd = 2E a.
            let carried = known.force.error / (2.0 * 3.0 * first.radius);
            assert!((found.depth.value - depth).abs() <= 1.01 * carried + found.depth.error, "{text} at {depth}: {known:?}, {found:?}");
            assert!(
                known.force.error <= 1e-13 * first.force && found.depth.error <= 1e-13 * depth,
                "{text} at {depth}: {known:?}, {found:?}"
            );
        }
    }
}

/// d(a) = g(a) of a contact with a smooth edge.
fn depth_at(text: &str, a: f64) -> f64 {
    let solution = solution(text);
    Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-12).unwrap().equivalent(a).unwrap().estimate.value
}

/// Class "an unknown bend next to the axis proves that g rises": a bend of the form 0/0 has no enclosure at the axis.
/// The radii at which the bodies touch again were computed with mpmath.
#[test]
fn what_is_unknown_at_the_axis_proves_nothing() {
    for (text, a, touch) in
        [("1-sin(r)/r+r^2/100", 3.0, 5.61695700374609), ("2/7*(1-sin(r)/r)", 3.0, 4.62839052944073), ("1-sin(r)/r", 2.0, 7.06528018521052)]
            .into_iter()
            .take(cases(1, 3))
    {
        let (rule, at) = refused(text, None, Load::Depth(depth_at(text, a)));
        assert!(rule == "outside_gap" && (at.unwrap() / touch - 1.0).abs() < 1e-8, "{text}: {rule} at {at:?}");
    }
}

/// Class "a single load uses up the budget": oscillating profiles, whose values are expensive far from the axis.
#[test]
fn profiles_with_waves_are_solved_within_the_budget() {
    for text in ["r^2/(1+besselj(0,r)^2)", "r^2/(2+besselj(0,r))", "1-sin(r)/r", "r^2*exp(besselj(0,r))", "r^2.5*(r/(1+r))-tanh(r/3)^2/3"]
        .into_iter()
        .step_by(cases(4, 1))
    {
        let (solution, depth) = (solution(text), depth_at(text, 0.9));
        let work = || Ok::<_, Exhausted>(Indentation::new(&solution, setup(None), Load::Depth(depth)).unwrap().solve(Load::Depth(depth)));
        // Half of the budget of one call.
        let found = within(Budget::seconds(1.5), work).unwrap().unwrap();
        assert!(found.is_valid(), "{text}: {found:?}");
        assert!((found.state.unwrap().radius / 0.9 - 1.0).abs() < 1e-13, "{text}: {found:?}");
    }
}

/// Class "a radius at which g has no value ends the search": f overflows far from the axis.
#[test]
fn profiles_that_overflow_far_out_are_solved() {
    for text in ["exp(exp(r)-(1+r))-1-r^2/5", "exp(exp(r))-exp(1)-exp(1)*r", "r^2*exp(r^2)"] {
        near(state(text, None, Load::Depth(depth_at(text, 1.0))).radius, 1.0, 100.0);
    }
}

/// Class "tension on the axis is reported at a tiny radius": the pressure there is −∞ or negative.
#[test]
fn tension_on_the_axis_is_found_there() {
    for text in ["abs(r-1/3)+r^2", "sqrt(1+abs(r-2/9)^2)-1", "r^4-ln(1+r/2)"] {
        assert_eq!(refused(text, None, Load::Depth(0.3)), ("tension_inside", Some(0.0)), "{text}");
    }
    for text in ["r^4-r^2", "r^2*ln(r)", "r^6+cos(r)-1"] {
        assert_eq!(refused(text, None, Load::Depth(0.3)), ("tension_inside", Some(0.0)), "{text}");
    }
}
