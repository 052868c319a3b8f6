//! Writes docs/speed-and-accuracy.md and its plots: what accuracy costs, for eight profiles.
//!
//! `cargo run --release -p sneddon-runs --bin speed_and_accuracy`, from the checkout; half a minute on a machine that does nothing else.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::print_stderr)]

use sneddon::expr::Bindings;
use sneddon::parse;
use sneddon::report::Tradeoff;
use sneddon::report::tradeoff::{markdown, plot};
use sneddon::tradeoff::{Options, Problem, Quantity, Study, run};
use sneddon::transform::{Evaluator, Method, Profile, Solution, derive};
use std::fs;
use std::io::Write;
use std::path::Path;

/// Name of the plot, title, profile.
const PROFILES: [(&str, &str, &str); 8] = [
    ("sphere", "Sphere", "2 - sqrt(4 - r^2)"),
    ("power", "Power 2.7", "r^2.7"),
    ("root", "Square root", "0.7*sqrt(r)"),
    ("worn", "Worn paraboloid", "piecewise(0, r<0.6, (r^2-0.36)/4)"),
    ("cosine", "Wave", "0.4*(1-cos(2.2*r))"),
    ("ln-cosh", "ln cosh, which has no closed form", "ln(cosh(r))"),
    ("gaussian", "Gaussian", "0.4*(1-exp(-r^2/1.69))"),
    ("kinked", "Kinked cone", "0.3*max(0, r-0.6)"),
];

fn main() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let figures = root.join("docs/figures");
    fs::create_dir_all(&figures).unwrap();
    let mut text: Vec<u8> = Vec::new();
    opening(&mut text);
    let mut leaders = Vec::new();
    for (name, title, profile) in PROFILES {
        eprintln!("{title}");
        let formula = parse::profile(profile).unwrap();
        let solution = derive(&Profile::new(&formula).unwrap()).unwrap();
        writeln!(text, "\n## {title}\n\n$f(r)$ = `{profile}`").unwrap();
        for quantity in [Quantity::Force, Quantity::Equivalent, Quantity::Pressure] {
            let study = studied(&solution, quantity);
            let record = Tradeoff { profile: &formula, parameters: Vec::new(), study: &study };
            let symbol = quantity.key();
            let closed = study.rows.iter().any(|row| row.method == "closed form");
            leaders.push((title, symbol, leader(&study), closed));
            if quantity == Quantity::Force {
                let file = format!("{name}.svg");
                fs::write(figures.join(&file), plot::svg(&record).unwrap()).unwrap();
                writeln!(text, "\n![{symbol} of the profile: error against time](figures/{file})").unwrap();
            }
            place(&study, &mut text);
            markdown::tradeoff(&record, &mut text).unwrap();
        }
    }
    summary(&leaders, &mut text);
    peers(&root, &mut text);
    fs::write(root.join("docs/speed-and-accuracy.md"), text).unwrap();
}

fn opening(text: &mut Vec<u8>) {
    let system = (std::env::consts::ARCH, std::env::consts::OS);
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    writeln!(
        text,
        "# Speed and accuracy

What accuracy costs, method by method, for eight profiles; `sneddon tradeoff` does the same for any profile.
The figures were measured by `cargo run --release -p sneddon-runs --bin speed_and_accuracy`, which writes this file and its plots.
The machine: {} {}, {cores} cores shared with other work, a release build without flags for its processor; compare ratios, never times.

How to read the tables:

- The true error is the largest relative error over 32 seeded points; the reference is the closed form with 30 digits, else a double-exponential rule with 30 digits, each with its own bound.
  An error that is not a thousand times larger than the bound of its reference is given as a bound (≤).
- The stated error is the largest bound that the method itself gave; a dash is a method that states none.
- Times are processor time for one point: the median over 15 rounds of batches, the order of the methods shuffled with a fixed seed in every round, and the middle half of the rounds.
- The set-up is everything from the profile to the first value, and is paid once; for a slice, also what its first pass makes for those after it.
- A slice has 131 072 points, those of the profile again and again; a closed form is expanded in short polynomials where so many lie close together (`src/evaluate/local_polynomials.rs`).
- ★ marks the Pareto front: nothing else is both as accurate and faster.",
        system.0, system.1
    )
    .unwrap();
}

/// The comparison with other libraries, which another command measures.
fn peers(root: &Path, text: &mut Vec<u8>) {
    let Ok(table) = fs::read_to_string(root.join("benches/peers/table.txt")) else { return };
    writeln!(
        text,
        "
## Against other libraries

`benches/peers/run` builds GSL, Boost.Math, the crates gkquad and bilby, hand-written C and, where Python has it, openAbel, runs them and this crate in turn at the same places with the tolerance 1e-12, and prints this table; a peer counts where its true error is below 1e-12.
`closure` is f′ as a Rust function; for smooth f′ the mean of 1000 values by one `AbelTransform` over the last tenth below x, with the time that it takes to be made and to expand f′.
`alone` is one such value by `abel`, which knows nothing beforehand, `told` the same with a bound on |f′| off the real axis, which spares what is else spent on finding out, `typed` an expression as a user types it; a kink is told to the peers and read from the formula by us.
The last run, kept in `benches/peers/table.txt` by `benches/peers/run | tee benches/peers/table.txt`:

```text
{}
```",
        table.trim_end()
    )
    .unwrap();
}

fn studied(solution: &Solution, quantity: Quantity) -> Study<'_> {
    let evaluator = Evaluator::new(solution, &Bindings::default(), Method::Auto, 1e-13).unwrap();
    let problem = Problem::new(solution, &evaluator, quantity, None, None).unwrap();
    run(problem, &Options::default()).unwrap()
}

fn place(study: &Study<'_>, text: &mut Vec<u8>) {
    let problem = &study.problem;
    let (low, high) = problem.points.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), x| (low.min(*x), high.max(*x)));
    let radius = problem.radius.map_or(String::new(), |a| format!(", a = {a:.3}"));
    let coordinate = problem.quantity.coordinate();
    writeln!(
        text,
        "\n### {}({coordinate})\n\n{} points, {coordinate} from {low:.3} to {high:.3}{radius}.\n",
        problem.quantity.key(),
        problem.points.len()
    )
    .unwrap();
}

/// The most accurate row of the front, and the fastest one that has at least six digits.
fn leader(study: &Study<'_>) -> (String, String) {
    let front = || study.rows.iter().filter(|row| row.front);
    let name = |row: Option<&sneddon::tradeoff::Row>| row.map_or("–".to_owned(), |row| format!("{} ({})", row.method, row.setting));
    let best = front().min_by(|one, other| one.error.total_cmp(&other.error));
    let fast = front().filter(|row| row.error < 1e-6).min_by(|one, other| one.time.median.total_cmp(&other.time.median));
    (name(best), name(fast))
}

fn summary(leaders: &[(&str, &str, (String, String), bool)], text: &mut Vec<u8>) {
    writeln!(
        text,
        "\n## Who leads\n\nWhere there is a closed form it leads: over a slice it is right to a unit or two in the last place for some nanoseconds a point, whatever functions it \
         holds; few points are faster by quadrature, which has less to set up.\nWhere there is none the polynomials of the whole curve lead.\n"
    )
    .unwrap();
    writeln!(text, "| profile | | closed form | most accurate | fastest below 1e-6 |\n|---|---|---|---|---|").unwrap();
    for (title, symbol, (best, fast), closed) in leaders {
        writeln!(text, "| {title} | {symbol} | {} | {best} | {fast} |", if *closed { "yes" } else { "no" }).unwrap();
    }
}
