//! Seconds per step for twenty-eight kinds of work, or for those whose names contain the argument.

use rustix::time::{ClockId, clock_gettime};
use sneddon::code::{Language, program};
use sneddon::contact::{Contact, Indentation, Load, Quantity, Setup, relations};
use sneddon::expr::Bindings;
use sneddon::num::work::{Budget, Exhausted, left, within};
use sneddon::transform::{Evaluator, Method, Profile, Solution, check, derive, invert};
use sneddon::{parse, print};

/// A name, and a function that does the work once; its argument lies in (0, 1) and differs between calls.
type Kind = (&'static str, Box<dyn FnMut(f64)>);

/// Each kind of work is repeated for this many seconds of processor time in each round.
const LONG: f64 = 0.1;

/// The fastest of this many rounds counts, because other programs slow down some of them.
const ROUNDS: usize = 7;

fn profile(text: &str) -> Profile {
    let formula = parse::profile(text).unwrap_or_else(|error| panic!("{text}: {error}"));
    Profile::new(&formula).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn solution(text: &str) -> Solution {
    derive(&profile(text)).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn derivation(text: &'static str) -> Box<dyn FnMut(f64)> {
    Box::new(move |_| drop(solution(text)))
}

/// Evaluates one quantity of a profile with one evaluator.
fn number(text: &str, method: Method, ask: fn(&Evaluator<'_>, f64) -> bool) -> Box<dyn FnMut(f64)> {
    let solution = Box::leak(Box::new(solution(text)));
    let evaluator = Evaluator::new(solution, &Bindings::default(), method, 1e-13).unwrap_or_else(|error| panic!("{text}: {error}"));
    let name = text.to_owned();
    Box::new(move |share| assert!(ask(&evaluator, share), "{name} at {share}"))
}

/// Generates a function, whose accuracy is measured with it.
fn code(text: &'static str, quantity: Quantity) -> Box<dyn FnMut(f64)> {
    let solution = solution(text);
    Box::new(move |_| drop(program(&solution, &[quantity], Language::C, text)))
}

fn kinds() -> Vec<Kind> {
    let slope = |evaluator: &Evaluator<'_>, share: f64| evaluator.equivalent(share).is_ok();
    let pressure = |evaluator: &Evaluator<'_>, share: f64| evaluator.pressure(0.9 * share, 1.0).is_ok();
    let many: String = (1..60).map(|i| format!("+max(0,r-{i})")).collect();
    let latex = solution("max(0,r-b)^40");
    let typed = profile("r^2/(2*R)+h*(1-cos(k*r))");
    let with_values = solution("r^2*ln(1+r)");
    let depth: &Solution = Box::leak(Box::new(solution("1-exp(-r^2)")));
    let wavy: &Solution = Box::leak(Box::new(solution("r^2/2+0.01*(1-cos(9*r))")));
    vec![
        ("derive powers", derivation("r^2+2*r^3+3*r^4+r^5/7+r^6/5+r^7+r^8/3+r^9")),
        ("derive logarithms", derivation("ln(1+r)+ln(1+r/2)+ln(1+r/3)+ln(1+r/4)+ln(1+r/5)")),
        ("derive kinks", {
            let text: &'static str = Box::leak(format!("r{many}").into_boxed_str());
            derivation(text)
        }),
        ("derive (1+r)^80", derivation("(1+r)^80")),
        ("derive max(0,r-b)^60", derivation("max(0,r-b)^60")),
        ("derive nested roots", derivation("sqrt(1+sqrt(1+sqrt(1+sqrt(1+sqrt(1+r^2)))))")),
        ("derive a wavy tip", Box::new(move |_| drop(derive(&typed)))),
        ("relations", {
            let own = solution("max(0,r-b)^3+r^2/(2*R)");
            Box::new(move |_| drop(relations(&own, &sneddon::contact::Edge::Smooth)))
        }),
        ("invert", {
            let own = parse::equivalent("x^2/R+h*x*atan(x/w)").unwrap_or_else(|error| panic!("{error}"));
            Box::new(move |_| drop(invert(&own, |text| parse::formula(text).ok())))
        }),
        ("print LaTeX", Box::new(move |_| drop(print::latex(&latex.equivalent_profile().formula)))),
        ("closed, doubles", number("sqrt(1+r^2)-1", Method::Auto, slope)),
        ("closed, 30 digits", number("r^2*struveh(0,r)", Method::Auto, slope)),
        ("closed, Bessel", number("1-besselj(0,r)", Method::Auto, slope)),
        ("closed, hypergeometric", number("atan(r^7)", Method::Exact, slope)),
        ("quadrature of g", number("r*tanh(r)^2", Method::Quadrature, slope)),
        ("quadrature next to a pole", number("r^2/(1.01-r)", Method::Quadrature, slope)),
        ("quadrature of a Bessel f'", number("besselj(0,r)*exp(-r)", Method::Quadrature, slope)),
        ("a modified Bessel f'", number("besseli(0,60*r)-1", Method::Quadrature, slope)),
        ("pressure, series", number("1-exp(-r^2)", Method::Quadrature, pressure)),
        ("pressure, slopes", number("r*tanh(r)", Method::Quadrature, pressure)),
        ("pressure, pieces", number("asinh(r^4)+cos(r)*r", Method::Quadrature, pressure)),
        ("pressure, kink", number("max(0,r-0.3)^2*exp(r)", Method::Quadrature, pressure)),
        ("pressure, sixty kinks", {
            let kinks: String = (1..60).map(|i| format!("+abs(r-{i}/61)")).collect();
            number(&format!("r{kinks}"), Method::Quadrature, pressure)
        }),
        ("contact radius", {
            Box::new(move |share| {
                let evaluator = Evaluator::new(depth, &Bindings::default(), Method::Auto, 1e-13).unwrap_or_else(|error| panic!("{error}"));
                let contact = Contact::new(evaluator, 1.0, None, 1e-13);
                assert!(contact.contact_radius(share).is_ok());
            })
        }),
        ("verdict of a load", {
            Box::new(move |share| {
                let setup = Setup { effective_modulus: 1.0, rim: None, tolerance: 1e-12, method: Method::Auto };
                let solved = Indentation::new(wavy, setup, Load::Depth(share)).and_then(|own| own.solve(Load::Depth(share)));
                assert!(solved.is_ok());
            })
        }),
        ("code, g", code("R-sqrt(R^2-r^2)", Quantity::Equivalent)),
        ("code, sums for F", code("h*r/(w+r)", Quantity::Force)),
        ("check of 64 points", Box::new(move |_| drop(check(&with_values)))),
    ]
}

/// The processor time of this process in seconds.
fn seconds() -> f64 {
    let now = clock_gettime(ClockId::ProcessCPUTime);
    now.tv_sec as f64 + 1e-9 * now.tv_nsec as f64
}

/// Repeats one kind of work for [`LONG`]; returns the steps of one repetition and the nanoseconds of one step.
fn measure(work: &mut dyn FnMut(f64)) -> (u64, f64) {
    let most = Budget::steps(1 << 50);
    let (start, mut times, mut steps) = (seconds(), 0_u32, 0);
    while seconds() - start < LONG {
        // The arguments differ, so that no cache answers.
        let share = 0.05 + 0.9 * (f64::from(times) * 0.618_033_988_749_895).fract();
        let counted = within(most, || {
            work(share);
            Ok::<_, Exhausted>(most.count() - left())
        });
        steps += counted.unwrap_or(0);
        times += 1;
    }
    (steps / u64::from(times), 1e9 * (seconds() - start) / steps.max(1) as f64)
}

fn main() {
    // Cargo adds `--bench` to the arguments.
    let wanted = std::env::args().skip(1).find(|argument| !argument.starts_with('-')).unwrap_or_default();
    let mut kinds: Vec<Kind> = kinds().into_iter().filter(|(name, _)| name.contains(&wanted)).collect();
    kinds.iter_mut().for_each(|(_, work)| work(0.5));
    let rounds: Vec<Vec<(u64, f64)>> = (0..ROUNDS).map(|_| kinds.iter_mut().map(|(_, work)| measure(work)).collect()).collect();
    println!("{:28} {:>12} {:>10}", "kind of work", "steps", "ns a step");
    let mut all = Vec::new();
    for (index, (name, _)) in kinds.iter().enumerate() {
        let fastest = rounds.iter().filter_map(|round| round.get(index)).min_by(|one, other| one.1.total_cmp(&other.1));
        let Some((steps, each)) = fastest else { continue };
        println!("{name:28} {steps:12} {each:10.2}");
        all.push(*each);
    }
    all.sort_by(f64::total_cmp);
    if let [first, .., last] = all.as_slice() {
        println!("from {first:.1} to {last:.1} ns, a ratio of {:.1}; the budget counts 10 ns a step", last / first);
    }
}
