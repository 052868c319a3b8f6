//! The budget of work: it ends every computation with a typed error or a partial answer, and counts the same on every machine.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, clippy::panic)]

use sneddon::contact::{Absence, Contact, ContactError, Indentation, Load, Setup, each_point};
use sneddon::eval::{EvalError, Tape};
use sneddon::expr::{Bindings, Expr, Number, Sign, Symbol, normal, sign};
use sneddon::num::special::besseli;
use sneddon::num::work::{Budget, Exhausted, apart, left, spend, with_deadline, within};
use sneddon::scene::{Control, Loads, Row, Run, Scene};
use sneddon::transform::{Evaluator, Method, Profile, TransformError, derive};
use sneddon::{parse, print, transform};
use sneddon_checks::seeds::cases;
use std::sync::atomic::{AtomicBool, Ordering};

/// Steps that a computation takes, and its result.
fn counted<T>(work: impl FnOnce() -> T) -> (T, u64) {
    let most = Budget::steps(1 << 50);
    within(most, || {
        let result = work();
        Ok::<_, Exhausted>((result, most.count() - left()))
    })
    .unwrap()
}

/// Reading, derivation and formulas of a profile.
fn formulas(text: &str) -> Result<usize, TransformError> {
    let profile = Profile::new(&parse::profile(text).unwrap())?;
    let solution = derive(&profile)?;
    let shown = [Some(solution.equivalent_profile()), Some(solution.force()), solution.pressure()];
    Ok(shown.iter().flatten().map(|own| print::text(&own.formula).len()).sum())
}

/// Profiles that once took minutes or gigabytes: giant exponents, towers of powers, recurrences without end, many pieces.
fn monsters() -> Vec<String> {
    let tower = vec!["(2*r)"; 16].join("^");
    let roots = (0..30).fold("1+r^2".to_owned(), |inner, _| format!("1+sqrt({inner})"));
    let pieces: String = (1..60).map(|i| format!(", r<{i}, {}*(r-{i})+{}", 2 * i, i * (i - 1))).collect();
    let mut all: Vec<String> =
        ["abs(r-b)^121.5", "abs(r-b)^129.5", "max(0,r-b)^300", "r^2*w^99999", "(1+r+b)^40*(2+r*b)^40", "((r+b)^30+1)^30"]
            .map(str::to_owned)
            .to_vec();
    all.extend([tower, roots, format!("piecewise(0{pieces})")]);
    all
}

#[test]
fn a_small_budget_is_a_typed_error_and_never_a_formula() {
    for text in monsters().into_iter().step_by(cases(2, 1)) {
        let mut ends = Vec::new();
        for steps in [1, 1000, 30_000, 3_000_000] {
            let found = within(Budget::steps(steps), || formulas(&text));
            ends.push(matches!(found, Err(TransformError::Exhausted(Exhausted { steps: own })) if own == steps));
        }
        assert!(ends[0] && ends[1], "{text}: {ends:?}");
    }
}

/// Class "an expression that was cut is 0": constructors beyond the work limit return an expression that stays what it is in every other,
/// and that nothing takes for a formula.
#[test]
fn an_expression_that_was_cut_is_refused() {
    let x = Expr::symbol("x");
    let constructors: [&dyn Fn(&Expr) -> Expr; 5] =
        [&|own| own + Expr::one(), &|own| own * Expr::integer(3), &|own| own.power(2), &|own| Expr::call("sin", [own.clone()]), &|own| {
            Expr::integer(2).pow(own)
        }];
    for build in constructors {
        let (cut, ..) = apart(1, || {
            spend(2);
            build(&x)
        });
        assert!(cut.is_cut() && !cut.is_zero() && sign(&cut) == Sign::Unknown);
        assert!(constructors.iter().all(|build| build(&cut).is_cut()));
        assert!((&cut - &cut).is_cut() && (Expr::zero() * &cut).is_cut() && cut.power(0).is_cut() && Expr::one().pow(&cut).is_cut());
        assert_eq!(Tape::compile(std::slice::from_ref(&cut), &[]).err(), Some(EvalError::Cut));
        assert!(!normal::is_proven_zero(&cut, &Symbol::new("x")));
        for text in [print::text_expr(&cut), print::unicode(&cut.clone().into()), print::latex(&cut.clone().into())] {
            assert!(parse::formula(&text).is_err(), "{text}");
        }
    }
}

/// Class "work goes on after the budget": numbers of many words are 0 then, which primes divide without end. `compare` of the first profile
/// spun until the clock stopped it.
#[test]
fn work_ends_with_the_budget_wherever_that_is() {
    let set: Bindings =
        [("h", 0.4), ("w", 1.3)].map(|(name, value)| (name, Expr::number(Number::from_f64(value).unwrap()))).into_iter().collect();
    for text in ["h*ln(1+r^2/w^2)", "h*ln(1+r^4/w^4)", "(h*r)^(3/2)+ln(w+r)", "(h*r+w)^12/(h*r+w)^5"] {
        let formula = parse::profile(text).unwrap().substitute(&set);
        let whole = counted(|| Profile::new(&formula).map(|_| ())).1;
        for steps in (1..whole).step_by(cases(7, 1)) {
            let (_, spent, is_whole) = apart(steps, || Profile::new(&formula).map(|_| ()));
            assert!(!is_whole && spent == steps, "{text} within {steps} of {whole}: {spent}");
        }
    }
}

#[test]
fn the_default_budget_ends_what_has_no_end() {
    // Without a budget of the caller.
    let profile = Profile::new(&parse::profile("(1+r+b)^40*(2+r*b)^40*(3+r^2*b)^40").unwrap()).unwrap();
    let outcome = derive(&profile).map(|_| ());
    assert!(matches!(outcome, Ok(()) | Err(TransformError::Exhausted(_))), "{outcome:?}");
}

#[test]
fn work_is_counted_the_same_every_time_and_on_every_thread() {
    for text in ["r^2/(2*R)", "h*ln(1+r/w)", "max(0,r-b)^9", "abs(r-b)^2.5"] {
        let (first, steps) = counted(|| formulas(text).unwrap());
        let (second, again) = counted(|| formulas(text).unwrap());
        assert_eq!((first, steps), (second, again), "{text}");
        let elsewhere = std::thread::spawn(move || counted(|| formulas(text).unwrap()).1).join().unwrap();
        assert_eq!(steps, elsewhere, "{text}");
        assert!(steps > 1000, "{text}: {steps}");
    }
}

#[test]
fn a_budget_that_suffices_changes_no_formula() {
    for text in ["r^2/(2*R)", "h*ln(1+r/w)", "max(0,r-b)^9", "R-sqrt(R^2-r^2)"] {
        let shown = || {
            let solution = derive(&Profile::new(&parse::profile(text).unwrap())?)?;
            Ok::<_, TransformError>(print::text(&solution.equivalent_profile().formula))
        };
        let (free, steps) = counted(|| shown().unwrap());
        assert_eq!(within(Budget::steps(steps + 1), shown).unwrap(), free, "{text}");
        assert!(matches!(within(Budget::steps(steps / 2), shown), Err(TransformError::Exhausted(_))), "{text}");
    }
}

/// What was cut short leaves nothing behind: the same evaluator answers a later call with a larger budget as if nothing had been.
#[test]
fn an_evaluator_forgets_what_a_small_budget_cut_short() {
    for text in ["tanh(r)+0.01*erf(1000*(r-1))", "ln(1+r^3)", "atan(r^3)", "r*J1(r)^2", "sqrt(1+r^2)*sin(3*r)^2"] {
        let profile = Profile::new(&parse::profile(text).unwrap()).unwrap();
        let solution = derive(&profile).unwrap();
        let evaluator = || Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13).unwrap();
        let fresh = evaluator();
        let expected = (fresh.equivalent(1.1).unwrap(), fresh.force(1.1).unwrap(), fresh.pressure(0.5, 1.1).unwrap());
        for steps in [1, 10, 100, 1000, 10_000, 100_000, 1_000_000] {
            let own = evaluator();
            let cut = within(Budget::steps(steps), || {
                let found = (own.equivalent(1.1)?, own.force(1.1)?, own.pressure(0.5, 1.1)?);
                Ok::<_, TransformError>(found)
            });
            match cut {
                Ok(found) => assert_eq!(found, expected, "{text} within {steps}"),
                Err(TransformError::Exhausted(_)) => {}
                Err(other) => panic!("{text} within {steps}: {other}"),
            }
            let later = (own.equivalent(1.1).unwrap(), own.force(1.1).unwrap(), own.pressure(0.5, 1.1).unwrap());
            assert_eq!(later, expected, "{text} after {steps}");
        }
    }
}

/// Class "the answer depends on earlier calls".
///
/// Work that the first call prepares for later calls does not count toward the limit of a method. Before, the second or third call
/// returned different last digits for each of these profiles.
#[test]
fn repeated_calls_return_the_same_number() {
    let steps = "0.013*tanh(max(0.0,r-0.264)/0.865)+0.7*tanh(max(0,r-0.47)/1.1e-9)";
    for (text, at, radius) in [
        ("(1-e^(-(2*arctan(r/0.72)^2)^2))*r^0.7", 0.449_475_875_396_871, 1.2),
        ("1 - exp(-(2.1*(cosh(r) - 1.0))^2)", 2.341_700_068_157_262, 2.927_125_085_196_577),
        ("r^(5/2)/(1 + (r^(5/2))^2)*(2.97167*r^2)", 0.202_886_884_839_007, 0.65),
        (&format!("0.2*(r/0.5)^10+{steps}"), 0.1457, 0.47),
        ("0.2*(r/3)^10+0.013*max(0,r-0.485)+1.55*log(1+max(0,r-0.59)/7.59e-4)", 0.451, 0.59),
    ] {
        let solution = derive(&Profile::new(&parse::profile(text).unwrap()).unwrap()).unwrap();
        let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13).unwrap();
        let asked = || (evaluator.equivalent(at), evaluator.force(at), evaluator.pressure(at, radius));
        let first = asked();
        assert!(first.0.is_ok() && (0..3).all(|_| asked() == first), "{text}: {first:?} {:?}", asked());
    }
}

#[test]
fn a_search_for_a_contact_ends_in_the_typed_error() {
    let solution = derive(&Profile::new(&parse::profile("1-cos(r)").unwrap()).unwrap()).unwrap();
    let setup = Setup { effective_modulus: 1.0, rim: None, tolerance: 1e-12, method: Method::Auto };
    let found = within(Budget::steps(2000), || Indentation::new(&solution, setup, Load::Depth(0.3)).map(|_| ()));
    assert!(matches!(found, Err(ContactError::Transform(TransformError::Exhausted(_)))));
}

/// Waves have hundreds of radii with g(a) = d, of which g(x) ≤ d below a leaves one.
#[test]
fn waves_are_solved_without_a_test_of_every_root() {
    let setup = Setup { effective_modulus: 1.0, rim: None, tolerance: 1e-12, method: Method::Auto };
    for text in ["1-cos(r)", "sin(r)^2", "1-besselj(0,r)", "1-cos(r)^3", "r*besselj(1,r)"] {
        let solution = derive(&Profile::new(&parse::profile(text).unwrap()).unwrap()).unwrap();
        let (state, steps) = counted(|| {
            let indentation = Indentation::new(&solution, setup, Load::Depth(0.3)).unwrap();
            indentation.solve(Load::Depth(0.3)).unwrap().state.unwrap()
        });
        assert!(steps < 100_000_000, "{text}: {steps}");
        // The first root: g stays below the depth on the way to it.
        let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-12).unwrap();
        let g = |x: f64| evaluator.equivalent(x).unwrap().estimate.value;
        assert!((g(state.radius) - 0.3).abs() < 1e-12, "{text}");
        assert!((1..50).all(|i| g(state.radius * f64::from(i) / 50.0) < 0.3), "{text}");
    }
}

/// The series of I_0 has about 20 terms at z = 4, 70 at 39 and, as the asymptotic one, 30 at 60; each takes as long as several steps.
#[test]
fn the_terms_of_bessel_functions_count() {
    for (z, least) in [(4.0, 40), (39.0, 150), (60.0, 100)] {
        let (value, steps) = counted(|| besseli(0.0, z));
        assert!(value > 1.0 && steps >= least, "I_0({z}) = {value} in {steps} steps");
    }
}

#[test]
fn the_power_of_a_parameter_is_not_written_out() {
    // (5/4)^99999 has half a million bits.
    let formula = parse::profile("r^2*w^99999").unwrap();
    let set = Bindings::one("w", Expr::ratio(5, 4));
    let (solution, steps) = counted(|| derive(&Profile::new(&formula.substitute(&set)).unwrap()).unwrap());
    assert!(steps < 1_000_000, "{steps}");
    let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13).unwrap();
    assert!(matches!(evaluator.equivalent(0.75), Err(TransformError::Overflow { .. })));
    let solution = derive(&Profile::new(&parse::profile("r^2*(5/4)^999").unwrap()).unwrap()).unwrap();
    let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13).unwrap();
    // mpmath: 2·0.75²·(5/4)^999
    let g = evaluator.equivalent(0.75).unwrap().estimate;
    assert!((g.value - 7.315_693_763_001_962e96).abs() <= g.error + 1e81, "{g:?}");
}

#[test]
fn an_inverse_of_high_order_costs_no_more_than_its_quadrature() {
    let read = |text: &str| parse::formula(text).ok();
    for (order, most) in [(12, 25_000_000), (22, 300_000_000)].into_iter().take(cases(1, 2)) {
        let (check, steps) = counted(|| {
            let found = transform::invert(&parse::equivalent(&format!("H*ln(1+(L*x)^{order})")).unwrap(), read).unwrap();
            transform::check_inverse(&found).unwrap()
        });
        assert!(check.passed() && check.points == 64, "{order}: {check:?}");
        assert!(steps < most, "{order}: {steps}");
    }
}

#[test]
fn the_stress_at_the_apex_returns() {
    let solution = derive(&Profile::new(&parse::profile("r^2/2").unwrap()).unwrap()).unwrap();
    let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13).unwrap();
    // p(0) = 4 a/(2 π) E*·(1/1): −σ_zz π/E* = ∫₀^a g′/x dx with g = x².
    let found = evaluator.axial(0.0, 1.0).unwrap().estimate;
    assert!((found.value - 2.0).abs() <= found.error + 1e-15, "{found:?}");
    let cone = derive(&Profile::new(&parse::profile("r").unwrap()).unwrap()).unwrap();
    let evaluator = Evaluator::new(&cone, &Bindings::default(), Method::Auto, 1e-13).unwrap();
    assert!(evaluator.axial(0.0, 1.0).is_err());
}

/// What the program prints, what it says beside it, and its exit code.
fn run(arguments: &[&str]) -> (String, String, Option<i32>) {
    let out = std::process::Command::new(env!("CARGO_BIN_EXE_sneddon")).args(arguments).output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (text(&out.stdout), text(&out.stderr), out.status.code())
}

#[test]
fn the_program_says_that_its_budget_is_used_up() {
    let (out, err, code) = run(&["derive", "abs(r-b)^129.5", "--budget", "0.02"]);
    assert!(out.is_empty() && err.contains("budget") && err.contains("--budget SECONDS") && code == Some(1), "{out} {err} {code:?}");
    let (_, err, code) = run(&["derive", "r^2", "--budget", "-1"]);
    assert!(err.contains("not positive") && code == Some(2), "{err} {code:?}");
    for command in ["derive", "eval", "compare", "invert", "solve", "reference", "validate", "tradeoff"] {
        assert!(run(&[command, "--help"]).0.contains("--budget <SECONDS>"), "{command}");
    }
}

#[test]
fn points_that_the_budget_does_not_reach_are_null_with_a_reason() {
    let asked =
        ["eval", "r^2*(1+0.01*sin(200*r)*cos(77*r^2))", "--quantity", "g", "--at", "0.01,0.02,30,0.03", "--budget", "0.1", "--json"];
    let (out, err, code) = run(&asked);
    let answer: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!((&answer["complete"], code), (&serde_json::Value::Bool(false), Some(1)), "{err}");
    assert!(answer["why"].as_str().unwrap().contains("work limit"));
    let points = answer["points"].as_array().unwrap();
    assert!(points[2]["value"].is_null() && points[2]["why"].as_str().unwrap().contains("work limit"));
    // Easy points beside a hard one keep their answers.
    let (whole, _, code) = run(&asked[..6].iter().copied().chain(["--json"]).collect::<Vec<_>>());
    let whole: serde_json::Value = serde_json::from_str(&whole).unwrap();
    assert!(whole["complete"].is_null() && code == Some(0));
    for index in [0, 1, 3] {
        assert_eq!(points[index]["value"], whole["points"][index]["value"]);
    }
}

/// The clock of the program sets such a flag, at a moment that depends on the machine.
#[test]
fn what_was_finished_before_a_deadline_is_kept() {
    static PASSED: AtomicBool = AtomicBool::new(false);
    let solution = derive(&Profile::new(&parse::profile("2-sqrt(4-r^2)").unwrap()).unwrap()).unwrap();
    let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13).unwrap();
    let contact = Contact::new(evaluator, 1.0, None, 1e-13);
    let radii = [0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9];
    let forces = |last: f64, largest_block: usize| {
        PASSED.store(false, Ordering::Relaxed);
        let read = |block: &[f64]| {
            let found = contact.forces(block);
            PASSED.fetch_or(block.contains(&last), Ordering::Relaxed);
            found
        };
        with_deadline(&PASSED, || within(Budget::DEFAULT, || Ok::<_, ContactError>(each_point(&radii, largest_block, read)))).unwrap()
    };
    // Blocks have 1, 2, 4, … points, or one: the one that is cut short is lost, and no other is begun.
    for (last, largest_block, finished) in [(f64::NAN, usize::MAX, 8), (0.6, usize::MAX, 3), (0.6, 1, 4), (0.2, usize::MAX, 0)] {
        let cut = forces(last, largest_block);
        assert_eq!(cut.len(), radii.len());
        for (index, own) in cut.into_iter().enumerate() {
            match own {
                Ok(found) => {
                    let alone = contact.force(radii[index]).unwrap().estimate;
                    assert!(index < finished && (found.unwrap().estimate.value - alone.value).abs() <= alone.error, "{index}");
                }
                Err(absence) => assert!(index >= finished && absence == Absence::Unfinished, "{index}: {absence:?}"),
            }
        }
    }
}

#[test]
fn rows_that_a_deadline_ends_say_so() {
    static PASSED: AtomicBool = AtomicBool::new(false);
    let profile = Profile::new(&parse::profile("r^2/2").unwrap()).unwrap();
    let scene = Scene { control: Control::Depth, loads: Loads::List(vec![0.1, 0.2, 0.3]), ..Scene::of(profile) };
    let solution = scene.solution().unwrap();
    let run = Run::new(&scene, &solution).unwrap();
    let rows: Vec<_> = with_deadline(&PASSED, || {
        let row = |index| {
            PASSED.store(index == 2, Ordering::Relaxed);
            run.row(index).unwrap()
        };
        (0..3).map(row).collect()
    });
    let is_cut = |own: &Row| own.indented.findings.iter().any(|finding| finding.rule == "unfinished");
    assert_eq!(rows.iter().map(is_cut).collect::<Vec<_>>(), [false, false, true]);
    assert!(rows[1].indented.state.is_some() && rows[2].indented.state.is_none() && run.cut_short().is_some());
}

/// Class "an ordinary profile is refused or slow".
///
/// Closed forms that take seconds far out, where quadrature takes milliseconds, and forms that grow when they are expanded.
#[test]
fn an_ordinary_profile_costs_less_than_a_second() {
    let product = |n: usize| (1..=n).map(|i| format!("(r+{i})")).collect::<Vec<_>>().join("*");
    let profiles = [
        "asinh(r^12)".to_owned(),
        "arsinh(r^2/2*(2.96*r^10))".to_owned(),
        "arsinh(r^2/(2*R)*(2.96*r^10))".to_owned(),
        "atan(r^17)".to_owned(),
        "ln(1+r^14)".to_owned(),
        "sqrt(1+r^15)".to_owned(),
        nested(30, "sqrt(1+U)"),
        nested(24, "1+sqrt(U)"),
        nested(12, "ln(1+U)"),
        product(20),
        product(40),
        "(1+r/2)^90".to_owned(),
    ];
    for text in profiles.into_iter().step_by(cases(2, 1)) {
        let (found, steps) = counted(|| {
            let solution = derive(&Profile::new(&parse::profile(&text).unwrap())?)?;
            let evaluator = Evaluator::new(&solution, &Bindings::one("R", Expr::integer(2)), Method::Auto, 1e-12)?;
            Ok::<_, TransformError>((evaluator.equivalent(0.7)?, evaluator.pressure(0.3, 0.7)?))
        });
        assert!(found.is_ok(), "{text}: {found:?}");
        assert!(steps < Budget::seconds(0.8).count(), "{text}: {steps} steps");
    }
}

/// The profile of n parts, and the power of n that its derivation must not exceed.
type Family = (&'static str, fn(usize) -> String, f64);

fn repeated(n: usize, part: &str, by: &str) -> String {
    (1..=n).map(|i| part.replace('I', &i.to_string())).collect::<Vec<_>>().join(by)
}

fn nested(n: usize, level: &str) -> String {
    (0..n).fold("1+r^2".to_owned(), |inner, _| level.replace('U', &inner))
}

/// Linear pieces, of slope i between i and i + 1.
fn pieces(n: usize) -> String {
    let inner: String = (1..n).map(|i| format!(", {i}*(r-{i})+{}, r<{}", i * (i - 1) / 2, i + 1)).collect();
    format!("piecewise(0, r<1{inner}, {n}*(r-{n})+{})", n * (n - 1) / 2)
}

/// Class "work grows faster than the profile".
#[test]
fn the_work_grows_little_faster_than_the_profile() {
    let families: [Family; 9] = [
        ("powers", |n| repeated(n, "I*r^(I+1)", "+"), 1.3),
        ("logarithms", |n| repeated(n, "ln(1+r/I)", "+"), 1.1),
        ("kinks", |n| repeated(n, "max(0,r-I)", "+"), 1.1),
        ("pieces", pieces, 1.1),
        ("nested roots", |n| nested(n, "1+sqrt(U)"), 1.1),
        ("nested sines", |n| nested(n, "sin(U)"), 1.0),
        // The product has n coefficients of up to n digits.
        ("factors", |n| repeated(n, "(r+I)", "*"), 1.4),
        ("binomials", |n| format!("(1+r)^{n}"), 1.5),
        // The written form has n coefficients of n digits, and its p is compared with an integral for both sizes.
        ("powers of a difference", |n| format!("max(0,r-b)^{n}"), 1.45),
    ];
    for (name, family, power) in families {
        let steps = |n| counted(|| formulas(&family(n))).1 as f64;
        let (few, many) = (steps(40), steps(80));
        assert!((many / few).log2() < power, "{name}: {few} steps, then {many}");
    }
}

/// The factors of its f′ differ in their innermost parts only, which are parts of all that contain them: they take 37 million steps.
/// Compared part by part, they took twice as many as by their levels first, and rewritten in every place where they occur,
/// three times as many.
#[test]
fn the_parts_of_nested_roots_are_compared_by_their_levels_and_rewritten_once() {
    let steps = counted(|| formulas(&nested(64, "1+sqrt(U)"))).1;
    assert!(steps < 39_000_000, "{steps} steps");
}

/// Class "work for a number grows faster than the profile".
///
/// A number needs the formula of one interval, and every root is shown to be analytic at the axis once: 100 pieces and 64 roots took
/// 1.0 and 4.4 million steps, and the work grew with the square of their number.
#[test]
fn the_work_for_a_number_grows_little_faster_than_the_profile() {
    let (roots, sines) = (|n| nested(n, "1+sqrt(U)"), |n| nested(n, "sin(U)"));
    for (few, many, at, power) in [
        (pieces(25), pieces(50), 0.7, 1.0),
        (pieces(25), pieces(50), 24.5, 1.0),
        (roots(20), roots(40), 0.7, 0.8),
        // With twice as many levels, twice as many nodes are needed.
        (sines(40), sines(80), 0.7, 1.7),
    ] {
        let steps = |text: &str| {
            let solution = derive(&Profile::new(&parse::profile(text).unwrap()).unwrap()).unwrap();
            counted(|| Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-12).unwrap().equivalent(at).unwrap()).1 as f64
        };
        let (few, many) = (steps(&few), steps(&many));
        assert!((many / few).log2() < power, "{few} steps, then {many}");
    }
}

/// Quotients whose derivative has a polynomial of degree 8 in its denominators, in some fifty terms: each kernel is
/// read once, although every rule asks for it. Reading them for each rule took nine seconds.
#[test]
fn long_denominators_are_read_once() {
    for profile in [
        "4.96*(1-sqrt(1-(r/4.96)^2))/(r+2.6)/(1+(4.96*(1-sqrt(1-(r/4.96)^2))/(2.6+r))^2)",
        "(3-sqrt(9-r^2))/(r+1.7)/(1+((3-sqrt(9-r^2))/(r+1.7))^2)",
        "(sqrt(1+r^2)-1)/(2+r)/(1.5+((sqrt(1+r^2)-1)/(2+r))^2)",
    ] {
        let steps = counted(|| derive(&Profile::new(&parse::profile(profile).unwrap())?)).1;
        assert!(steps < 11_000_000, "{profile}: {steps} steps");
    }
}
