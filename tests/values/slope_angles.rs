//! Tips whose flanks are given by slope angles: kinks and joins are found for symbolic angles, and numbers agree with mpmath.
#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used, clippy::excessive_precision)]

use sneddon::contact::{Edge, relations};
use sneddon::expr::{Bindings, Expr};
use sneddon::transform::{Evaluator, Method, Profile, check, derive};
use sneddon::{parse, print};

/// Profile, x, g(x) and F(x)/E* at theta = 0.3, R = 2, h = 0.2, b = 0.5: the defining integrals with 40 digits, split at the kink.
const VALUES: &[(&str, f64, f64, f64)] = &[
    ("min(r^2/(2*R), r*tan(theta))", 0.4, 0.08, 0.04266666666666666666666667),
    ("min(r^2/(2*R), r*tan(theta))", 1.5, 0.7678191409809263498369789, 1.28807397567211702065236),
    ("min(r^2/(2*R), r*tan(theta))", 3.0, 1.463764608261153698485774, 4.443196215436028358474417),
    ("min(R-sqrt(R^2-r^2), r*tan(theta))", 1.0, 0.5493061443340548456976226, 0.7465307216702742284881131),
    ("min(R-sqrt(R^2-r^2), r*tan(theta))", 1.5, 0.7574853778264305552898522, 1.241828133850282466658764),
    ("max(R-sqrt(R^2-r^2), r*tan(theta))", 1.5, 1.430803600912012595113886, 2.932425632368008869157549),
    ("max(sqrt(R^2+r^2)-R, r*tan(theta))", 2.5, 2.228483522024853160141898, 6.90689027536908569218882),
    ("min(sqrt(R^2+r^2)-R, r*tan(theta))", 2.5, 1.22641555098177034958631, 3.146135868862097257432497),
    ("min(r*tan(theta), h)", 0.4, 0.194361697852522179086593, 0.07774467914100887163463722),
    ("min(r*tan(theta), h)", 1.5, 0.2067763157831103637667143, 0.03946325462013864937917776),
    ("min(r*tan(theta), h)", 3.0, 0.2015815103635033430681798, 0.0188442409407210134334672),
    ("max(0, r*sin(2*theta) - h)", 0.4, 0.1091324406522356048355088, 0.08082167186987035304576072),
    ("max(0, r*sin(2*theta) - h)", 1.5, 1.12850053688354851687012, 1.984266691570434158331413),
    ("max(0, r*sin(2*theta) - h)", 3.0, 2.460347355287148332676829, 7.976845315209140919140127),
    ("abs(r*cos(theta) - b)", 0.4, -0.6002556191886538534447557, -0.2401022476754615413779023),
    ("abs(r*cos(theta) - b)", 1.5, 1.229468541804796322290458, 3.249933146437445613336654),
    ("abs(r*cos(theta) - b)", 3.0, 3.496773749365893394267059, 13.44431477740158900298525),
    (
        "piecewise(R-sqrt(R^2-r^2), r<R*sin(theta), r*tan(theta)-R*(1/cos(theta)-1))",
        0.4,
        0.08109302162163287639560262,
        0.04336742486498191451426728,
    ),
    (
        "piecewise(R-sqrt(R^2-r^2), r<R*sin(theta), r*tan(theta)-R*(1/cos(theta)-1))",
        1.5,
        0.6340530341770106837059829,
        1.085611106993243956740828,
    ),
    (
        "piecewise(R-sqrt(R^2-r^2), r<R*sin(theta), r*tan(theta)-R*(1/cos(theta)-1))",
        3.0,
        1.363896475842419096623078,
        4.369396427256857302660237,
    ),
    ("piecewise(r^2*tan(theta)/(2*b), r<b, (r-b/2)*tan(theta))", 0.4, 0.09898759987507943457129718, 0.05279338660004236510469183),
    ("piecewise(r^2*tan(theta)/(2*b), r<b, (r-b/2)*tan(theta))", 1.5, 0.6507811190213933156102112, 1.088888214111664641060688),
    ("piecewise(r^2*tan(theta)/(2*b), r<b, (r-b/2)*tan(theta))", 3.0, 1.380198146890627673502562, 4.370977963867001411179854),
    (
        "piecewise(R-sqrt(R^2-r^2), r<R*cos(pi/2-theta), (r-R*sin(theta))*tan(theta)+R*(1-cos(theta)))",
        0.4,
        0.08109302162163287639560262,
        0.04336742486498191451426728,
    ),
    (
        "piecewise(R-sqrt(R^2-r^2), r<R*cos(pi/2-theta), (r-R*sin(theta))*tan(theta)+R*(1-cos(theta)))",
        1.5,
        0.6340530341770106837059829,
        1.085611106993243956740828,
    ),
    (
        "piecewise(R-sqrt(R^2-r^2), r<R*cos(pi/2-theta), (r-R*sin(theta))*tan(theta)+R*(1-cos(theta)))",
        3.0,
        1.363896475842419096623078,
        4.369396427256857302660237,
    ),
];

fn set() -> Bindings {
    [("theta", (3, 10)), ("R", (2, 1)), ("h", (1, 5)), ("b", (1, 2))].into_iter().map(|(name, (p, q))| (name, Expr::ratio(p, q))).collect()
}

#[test]
fn kinks_are_found_while_the_angle_is_a_symbol() {
    for (text, x, g, force) in VALUES {
        let profile = Profile::new(&parse::profile(text).unwrap()).unwrap_or_else(|error| panic!("{text}: {error}"));
        let solution = derive(&profile).unwrap();
        assert!(solution.is_closed(), "{text}");
        let evaluator = Evaluator::new(&solution, &set(), Method::Exact, 1e-13).unwrap();
        for (what, found, expected) in [("g", evaluator.equivalent(*x), *g), ("F", evaluator.force(*x), force / 2.0)] {
            let found = found.unwrap_or_else(|error| panic!("{what} of {text} at {x}: {error}")).estimate;
            let error = (found.value - expected).abs();
            assert!(error <= found.error + 1e-15 * expected.abs(), "{what} of {text} at {x}: {} for {expected}", found.value);
        }
    }
}

#[test]
fn the_condition_on_the_angle_is_stated_and_the_check_draws_acute_angles() {
    let text = "piecewise(R-sqrt(R^2-r^2), r<R*sin(theta), r*tan(theta)-R*(1/cos(theta)-1))";
    let solution = derive(&Profile::new(&parse::profile(text).unwrap()).unwrap()).unwrap();
    let conditions: Vec<String> = solution.conditions.iter().map(sneddon::print::text_condition).collect();
    assert!(conditions.iter().any(|condition| condition == "theta < pi/2"), "{conditions:?}");
    let outcome = check(&solution).unwrap();
    assert!(outcome.points >= 64, "{outcome:?}");
}

/// Class "kinks with sin(2θ)": a sphere and a cone from one apex meet at R sin 2θ while that is an acute angle; a hyperboloid at R tan 2θ.
#[test]
fn spheres_and_cones_meet_at_twice_the_angle() {
    for (text, kink, condition) in [
        ("min(R-sqrt(R^2-r^2), r*tan(theta))", "R*sin(2*theta)", "theta < pi/4"),
        ("max(0, R-sqrt(R^2-r^2)-r*tan(theta/2))", "R*sin(theta)", "theta < pi/2"),
        ("abs(sqrt(R^2+r^2)-R-r*tan(theta))", "R*tan(2*theta)", "theta < pi/4"),
        ("max(R-sqrt(R^2-r^2), r/tan(pi*alpha/180))", "2*R/(1 + tan(pi/180*alpha)^2)*tan(pi/180*alpha)", "45 < alpha"),
        ("max(b-b*sqrt(1-r^2/c^2), h*r/w)", "2*b*c^2*h*w/(b^2*w^2 + c^2*h^2)", "c*h < b*w"),
    ] {
        let solution = derive(&Profile::new(&parse::profile(text).unwrap()).unwrap()).unwrap();
        let g = print::text(&solution.equivalent_profile().formula);
        assert!(g.contains(&format!(", x < {kink}, ")), "{text}: {g}");
        let conditions: Vec<String> = solution.conditions.iter().map(print::text_condition).collect();
        assert!(conditions.iter().any(|own| own == condition), "{text}: {conditions:?}");
        assert!(check(&solution).unwrap().points >= 60, "{text}");
    }
    // Steeper cones do not meet the sphere again, and the formula with a kink does not apply to them.
    let general = derive(&Profile::new(&parse::profile("min(R-sqrt(R^2-r^2), r*tan(theta))").unwrap()).unwrap()).unwrap();
    let of = |angle: i64| [("theta", Expr::ratio(angle, 10)), ("R", Expr::integer(2))].into_iter().collect::<Bindings>();
    assert!(
        Evaluator::new(&general, &of(7), Method::Auto, 1e-13).is_ok() && Evaluator::new(&general, &of(10), Method::Auto, 1e-13).is_err()
    );
    let steep = Profile::new(&parse::profile("min(R-sqrt(R^2-r^2), r*tan(1))").unwrap()).unwrap();
    assert_eq!(print::text(&derive(&steep).unwrap().equivalent_profile().formula), "x*atanh(x/R)");
}

/// Class "kinks with angles".
///
/// A kink is found from a sign that is the same for every acute angle. Conditions that no angle meets are not stated, and rounding errors
/// are not taken for a jump.
#[test]
fn signs_of_slope_angles_decide_about_kinks() {
    let conditions = |text: &str| {
        let solution = derive(&Profile::new(&parse::profile(text).unwrap()).unwrap_or_else(|error| panic!("{text}: {error}"))).unwrap();
        assert!(check(&solution).unwrap().points >= 60, "{text}");
        (print::text(&solution.equivalent_profile().formula), solution.conditions.iter().map(print::text_condition).collect::<Vec<_>>())
    };
    for (text, g, limit) in [
        ("min(r*sin(2*theta), r*tan(theta))", "pi/2*x*tan(theta)", "theta < pi/4"),
        ("max(r*sin(theta), r)", "pi/2*x", "theta < pi/2"),
        ("max(sqrt(h^2+r^2*tan(theta)^2)-h, r*tan(2*theta))", "pi/2*x*tan(2*theta)", "theta < pi/4"),
    ] {
        let (formula, stated) = conditions(text);
        assert!(formula == g && stated.iter().any(|own| own == limit) && !stated.concat().contains("abs"), "{text}: {formula} {stated:?}");
    }
    for (text, kink) in [
        ("max(0, r*sin(2*theta)-r*tan(theta)-h)", "h/(sin(2*theta) - tan(theta))"),
        ("max(r*tan(theta), r*sin(theta)+h)", "-h/(sin(theta) - tan(theta))"),
        ("min(h, r*(1-sin(theta)^2))", "h/(1 - sin(theta)^2)"),
    ] {
        let (formula, _) = conditions(text);
        assert!(formula.contains(&format!(", x < {kink}, ")), "{text}: {formula}");
    }
    // The sign changes at pi/4.
    assert!(Profile::new(&parse::profile("max(r/tan(theta), r*tan(theta))").unwrap()).is_err());
    // Values of g(x) computed with mpmath. The last two profiles have no kink, because the cosines of 100 and 160 degrees are negative.
    for (text, x, g) in [
        ("abs(3/10*(1-cos(7*pi/180))-r*tan(7*pi/180))", 0.7, 0.130_535_862_362_664_4),
        ("min(13/10*(1-cos(50*pi/180)), r^2*cos(100*pi/180))", 0.5, -0.086_824_088_833_465_18),
        ("r^2+max(0,r^2*cos(160*pi/180)-3/10*(1-cos(80*pi/180)))", 0.5, 0.5),
    ] {
        let profile = Profile::new(&parse::profile(text).unwrap()).unwrap_or_else(|error| panic!("{text}: {error}"));
        let solution = derive(&profile).unwrap();
        let found = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13).unwrap().equivalent(x).unwrap().estimate;
        assert!((found.value - g).abs() <= found.error + 4e-16 * g.abs(), "{text}: {}", found.value);
    }
}

#[test]
fn numeric_angles_give_exact_pieces() {
    for text in
        ["min(r*tan(0.3), h)", "min(r^2/(2*R), r*tan(0.3))", "piecewise(R-sqrt(R^2-r^2), r<R*sin(0.3), r*tan(0.3)-R*(1/cos(0.3)-1))"]
    {
        let profile = Profile::new(&parse::profile(text).unwrap()).unwrap_or_else(|error| panic!("{text}: {error}"));
        assert!(derive(&profile).unwrap().is_closed(), "{text}");
    }
}

#[test]
fn a_real_jump_is_still_refused() {
    for text in ["piecewise(0, r<b, r*tan(theta))", "piecewise(R-sqrt(R^2-r^2), r<R*sin(theta), r*tan(theta)-R*(1/sin(theta)-1))"] {
        assert!(Profile::new(&parse::profile(text).unwrap()).is_err(), "{text}");
    }
}

/// A join is accepted without a condition only where the identity is proven.
#[test]
fn identities_of_trigonometric_constants_are_proven() {
    let conditions = |jump: &str| {
        let text = format!("piecewise(r, r<b, r + b*({jump}))");
        let profile = Profile::new(&parse::profile(&text).unwrap()).unwrap_or_else(|error| panic!("{text}: {error}"));
        profile.conditions.iter().map(sneddon::print::text_condition).collect::<Vec<_>>()
    };
    for zero in [
        "sin(theta)^2 + cos(theta)^2 - 1",
        "tan(theta) - sin(theta)/cos(theta)",
        "sqrt(1 + tan(theta)^2) - 1/cos(theta)",
        "sin(2*theta) - 2*sin(theta)*cos(theta)",
        "cos(2*theta) - 1 + 2*sin(theta)^2",
        "tan(theta/2)*sin(theta) - (1 - cos(theta))",
        "sin(pi/2 - theta) - cos(theta)",
        "sin(alpha + beta) - sin(alpha)*cos(beta) - cos(alpha)*sin(beta)",
        "sqrt(1 - sin(theta)^2) - cos(theta)",
        "sin(2/5) - 2*sin(1/5)*cos(1/5)",
        "tan(theta*pi/180) - sin(theta*pi/180)/cos(theta*pi/180)",
    ] {
        let found = conditions(zero);
        assert!(!found.iter().any(|condition| condition.contains(" = ")), "{zero}: {found:?}");
    }
    for jump in ["sin(theta)^2 - cos(theta)^2", "tan(theta) - sin(theta)", "sqrt(1 - sin(theta)^2) - sin(theta)"] {
        let text = format!("piecewise(r, r<b, r + b*({jump}))");
        assert!(Profile::new(&parse::profile(&text).unwrap()).is_err(), "{text}");
    }
}

/// Class "a limit that is a multiple of a sine or cosine": √(R² − (R sin θ)²) is printed as R cos θ.
#[test]
fn roots_of_sines_and_cosines_are_cosines_and_sines() {
    let cases = [
        ("piecewise(R-sqrt(R^2-r^2), r<R*sin(theta), (r-R*sin(theta))*tan(theta)+R-R*cos(theta))", "R*cos(theta)", "sqrt(1 - "),
        ("piecewise(0, r<R*cos(theta), R*sin(theta)-sqrt(R^2-r^2))", "R*sin(theta)", "sqrt(1 - "),
        ("piecewise(0, r<b*sin(theta), sqrt(b^2-b^2*sin(theta)^2)-sqrt(b^2-r^2))", "b*cos(theta)", "sqrt(1 - "),
    ];
    for (text, has, lacks) in cases {
        let profile = Profile::new(&parse::profile(text).unwrap()).unwrap();
        let force = relations(&derive(&profile).unwrap(), &Edge::Smooth).unwrap().force;
        let shown = print::text(&force.formula);
        assert!(shown.contains(has) && !shown.contains(lacks), "{text}: {shown}");
    }
}
