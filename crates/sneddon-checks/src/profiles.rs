//! Random profiles over the whole grammar, and the comparison of what is derived from them with quadrature.

use crate::formulas::bindings;
use crate::random::Stream;
use sneddon::eval::{BoundedAlgebra, walk};
use sneddon::expr::{Expr, Formula, shown};
use sneddon::num::Bounded;
use sneddon::transform::{Derived, Evaluator, Method, Profile, Reading, Status, TransformError, derive};
use sneddon::{parse, print};

/// A profile as text, with values for its parameters.
#[derive(Clone, Debug)]
pub struct Sample {
    pub text: String,
    pub values: Vec<(&'static str, f64)>,
}

/// The results of all profiles.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    pub profiles: usize,
    /// Refused with a typed error: no profile, a jump, an unproven order of breakpoints.
    pub refused: usize,
    /// Quantities whose formula is closed as a whole, and in part.
    pub exact: usize,
    pub partial: usize,
    pub numeric: usize,
    /// Comparisons of numbers, and those that leave less than 1e-8 undecided.
    pub compared: usize,
    pub sharp: usize,
    /// Printed formulas that were read back and compared with the number.
    pub printed: usize,
    /// Disagreements.
    pub faults: Vec<String>,
}

impl Outcome {
    pub fn add(&mut self, other: Self) {
        self.profiles += other.profiles;
        self.refused += other.refused;
        self.exact += other.exact;
        self.partial += other.partial;
        self.numeric += other.numeric;
        self.compared += other.compared;
        self.sharp += other.sharp;
        self.printed += other.printed;
        self.faults.extend(other.faults);
    }
}

/// A random profile.
pub fn sample(stream: &mut Stream) -> Sample {
    let mut writer = Writer { stream, values: Vec::new() };
    let text = writer.profile();
    Sample { text, values: writer.values }
}

struct Writer<'a> {
    stream: &'a mut Stream,
    values: Vec<(&'static str, f64)>,
}

impl Writer<'_> {
    fn chance(&mut self, probability: f64) -> bool {
        self.stream.unit() < probability
    }

    fn pick(&mut self, list: &[&'static str]) -> &'static str {
        self.stream.pick::<&str>(list)
    }

    /// A positive number in some spelling, or a parameter that has such a value.
    fn number(&mut self, lowest: f64, highest: f64) -> String {
        let value = if self.chance(0.1) { self.stream.log_uniform(lowest / 30.0, lowest) } else { self.stream.short(lowest, highest) };
        let value = format!("{value:.4}").parse().unwrap();
        let value: f64 = if value == 0.0 { lowest } else { value };
        let free = ["b", "c", "h", "k", "w", "A", "B", "C", "P", "Q"];
        match self.stream.whole(0, 9) {
            0..=3 if self.values.len() < free.len() => {
                let name = free[self.values.len()];
                self.values.push((name, value));
                name.to_owned()
            }
            4 => format!("{}", self.stream.whole(1, 4)),
            5 => format!("({}/{})", self.stream.whole(1, 9), self.stream.whole(2, 7)),
            6 => "pi".to_owned(),
            7 => format!("{value:e}"),
            _ => format!("{value}"),
        }
    }

    /// A length beyond which the profile need not reach.
    fn limit(&mut self) -> String {
        format!("{}", self.stream.short(3.2, 9.0))
    }

    fn length(&mut self) -> String {
        self.number(0.3, 3.0)
    }

    fn power(&mut self) -> String {
        match self.stream.whole(0, 9) {
            0..=5 => format!("r^{}", self.stream.whole(1, 6)),
            6 => "r^(1/2)".to_owned(),
            7 => "r^1.5".to_owned(),
            8 => format!("r^{}", self.stream.short(0.3, 5.0)),
            _ => format!("r^{}", self.stream.whole(7, 21)),
        }
    }

    fn ratio(&mut self) -> String {
        format!("r/{}", self.length())
    }

    /// A kernel of a family that has rules.
    fn kernel(&mut self) -> String {
        let (r, limit) = (self.ratio(), self.limit());
        let p = self.pick(&["1/2", "-1/2", "3/2", "-3/2", "-1", "-2", "0.3", "-1.7", "1/3"]);
        let k = self.number(0.3, 2.5);
        match self.stream.whole(0, 29) {
            0 => format!("ln(1+{r})"),
            1 => format!("ln(1+({r})^2)"),
            2 => format!("ln(1-r^2/{limit}^2)"),
            3 => format!("ln({r})"),
            4 => format!("atan({r})"),
            5 => format!("asinh({r})"),
            6 => format!("asin(r/{limit})"),
            7 => format!("atanh(r/{limit})"),
            8 => format!("(1+({r})^2)^({p})"),
            9 => format!("(1-r^2/{limit}^2)^({p})"),
            10 => format!("(1+{r})^({})", self.stream.whole(-3, 2)),
            11 => format!("sqrt(1+{r})"),
            12 => format!("({limit}^4-r^4)^({p})"),
            13 => format!("sin({k}*r)"),
            14 => format!("cos({k}*r)"),
            15 => format!("sinh({r})"),
            16 => format!("cosh({r})"),
            17 => format!("exp(-{k}*r)"),
            18 => format!("exp({r})"),
            19 => format!("exp(-({r})^2)"),
            20 => format!("exp(r^2/{limit})"),
            21 => format!("erf({r})"),
            22 => format!("sin(r^2/{})", self.length()),
            23 => format!("cos(r^2/{})", self.length()),
            24 => format!("besselj({},{k}*r)", self.stream.whole(0, 3)),
            25 => format!("besseli({},{r})", self.stream.whole(0, 2)),
            26 => format!("1/({}+r)", self.length()),
            27 => format!("1/({}^2+r^2)", self.length()),
            28 => format!("sqrt({limit}^2-r^2)"),
            _ => format!("exp(-(r/{limit})^4)"),
        }
    }

    /// A kernel that no rule need know.
    fn odd_kernel(&mut self) -> String {
        let r = self.ratio();
        match self.stream.whole(0, 11) {
            0 => format!("ln(cosh({r}))"),
            1 => format!("tanh({r})"),
            2 => format!("exp(sin({r}))"),
            3 => format!("sqrt(1+sin({r})^2)"),
            4 => format!("sin(ln(1+{r}))"),
            5 => format!("exp(-{r})*cos({r})"),
            6 => format!("1/(1+{r}+({r})^3)"),
            7 => format!("sqrt(1+sqrt(1+{r}))"),
            8 => format!("atan(r^2/{})", self.length()),
            9 => format!("abs(r-{})", self.length()),
            10 => format!("max({r},{})", self.length()),
            _ => format!("r^(1/3)*exp(-{r})"),
        }
    }

    fn factor(&mut self) -> String {
        match self.stream.whole(0, 9) {
            0..=3 => self.power(),
            4..=8 => self.kernel(),
            _ => self.odd_kernel(),
        }
    }

    fn term(&mut self) -> String {
        let coefficient = self.number(0.1, 3.0);
        let one = self.factor();
        match self.stream.whole(0, 9) {
            0..=3 => format!("{coefficient}*{one}"),
            4..=7 => format!("{coefficient}*r^{}*{one}", self.stream.whole(1, 5)),
            8 => format!("{coefficient}*({one})*({})", self.kernel()),
            _ => format!("{coefficient}*({one})^2"),
        }
    }

    fn smooth(&mut self) -> String {
        let mut text = self.term();
        while self.chance(0.4) {
            let (sign, term) = (self.pick(&["+", "-"]), self.term());
            text = format!("{text} {sign} {term}");
        }
        text
    }

    fn profile(&mut self) -> String {
        if self.chance(0.7) {
            return self.smooth();
        }
        let inner = self.smooth();
        let b = format!("{}", self.stream.short(0.3, 1.2));
        let at = |text: &str, place: &str| substituted(text, place);
        match self.stream.whole(0, 3) {
            0 => format!("piecewise(0, r<{b}, {inner} - ({}))", at(&inner, &b)),
            1 => format!("piecewise({inner}, r<{b}, {})", at(&inner, &b)),
            2 => {
                let c = format!("{}", self.stream.short(1.3, 2.2));
                format!("piecewise(0, r<{b}, {inner} - ({}), r<{c}, {} - ({}))", at(&inner, &b), at(&inner, &c), at(&inner, &b))
            }
            _ => {
                let outer = self.smooth();
                format!("piecewise({inner}, r<{b}, {outer} + ({}) - ({}))", at(&inner, &b), at(&outer, &b))
            }
        }
    }
}

/// The text with the radius replaced; other names that contain an r are left alone.
fn substituted(text: &str, place: &str) -> String {
    let letters: Vec<char> = text.chars().collect();
    let mut result = String::new();
    for (index, letter) in letters.iter().enumerate() {
        let word = |at: Option<usize>| at.and_then(|at| letters.get(at)).is_some_and(|c| c.is_alphanumeric() || *c == '_');
        if *letter == 'r' && !word(index.checked_sub(1)) && !word(Some(index + 1)) {
            result.push_str(&format!("({place})"));
        } else {
            result.push(*letter);
        }
    }
    result
}

/// Derives the profile and holds every formula with a closed part against quadrature.
pub fn compare(sample: &Sample, stream: &mut Stream) -> Outcome {
    let mut outcome = Outcome { profiles: 1, ..Outcome::default() };
    let formula = match parse::profile(&sample.text) {
        Ok(formula) => formula,
        Err(error) => {
            outcome.faults.push(format!("{}: {error}", sample.text));
            return outcome;
        }
    };
    let set = if stream.unit() < 0.5 { formula.substitute(&bindings(&sample.values)) } else { formula };
    let solution = match Profile::new(&set).and_then(|profile| derive(&profile)) {
        Ok(solution) => solution,
        Err(_) => {
            outcome.refused += 1;
            return outcome;
        }
    };
    let names: Vec<String> = solution.profile.parameters().iter().map(|s| s.name().to_owned()).collect();
    let values: Vec<(&str, f64)> = sample.values.iter().copied().filter(|(name, _)| names.iter().any(|own| own == name)).collect();
    let build = |method| Evaluator::new(&solution, &bindings(&values), method, 1e-13);
    let (Ok(auto), Ok(exact), Ok(plain)) = (build(Method::Auto), build(Method::Exact), build(Method::Quadrature)) else {
        outcome.refused += 1;
        return outcome;
    };
    let end = plain.limit().min(3.5);
    for (name, derived) in [("g", Some(solution.equivalent_profile())), ("F", Some(solution.force())), ("p", solution.pressure())] {
        let Some(derived) = derived else { continue };
        let own = match derived.status {
            Status::Exact => {
                outcome.exact += 1;
                &exact
            }
            Status::Partial => {
                outcome.partial += 1;
                &auto
            }
            Status::Numeric => {
                outcome.numeric += 1;
                continue;
            }
        };
        for _ in 0..3 {
            let a = stream.short(0.02, 0.98 * end);
            let r = stream.short(0.03 * a, 0.97 * a);
            if a <= 0.0 || r <= 0.0 || r >= a {
                continue;
            }
            let Some((one, two)) = pair(name, own, &plain, r, a) else { continue };
            // A step of erf(r/w) with a tiny w beside r⁵ can weigh less than the reference's samples show: the estimate of a
            // quadrature is then too small, by some 1e-13 of the value. A wrong closed form is off by far more.
            let unseen = 1e-12 * two.estimate.value.abs();
            let (difference, allowed) = ((one.estimate.value - two.estimate.value).abs(), one.estimate.error + two.estimate.error + unseen);
            let place = format!("{:?}: {name} at a = {a}, r = {r}", sample);
            outcome.compared += 1;
            if difference.is_nan() || allowed.is_nan() || difference > allowed {
                outcome.faults.push(format!("{place}: {:?} against {:?}", one.estimate, two.estimate));
                continue;
            }
            if allowed <= 1e-8 * two.estimate.value.abs() {
                outcome.sharp += 1;
                read_back(&derived, &values, name, (r, a), &two, &place, &mut outcome);
            }
        }
    }
    outcome
}

/// The same quantity twice, where both have a value.
fn pair(name: &str, own: &Evaluator<'_>, plain: &Evaluator<'_>, r: f64, a: f64) -> Option<(Reading, Reading)> {
    let read = |one: &Evaluator<'_>| -> Result<Option<Reading>, TransformError> {
        match name {
            "g" => one.equivalent(a).map(Some),
            "F" => one.force(a).map(Some),
            _ => one.pressure(r, a),
        }
    };
    let (one, two) = (read(own).ok()??, read(plain).ok()??);
    // With the whole integrated there is nothing to compare.
    (one.method != "quadrature" && two.estimate.value.is_finite() && one.estimate.error.is_finite()).then_some((one, two))
}

/// Checks that the printed formula parses and evaluates to the number, within the error bound of the evaluation.
fn read_back(derived: &Derived, values: &[(&str, f64)], name: &str, at: (f64, f64), two: &Reading, place: &str, outcome: &mut Outcome) {
    if derived.status != Status::Exact {
        return;
    }
    let text = print::text(&derived.formula);
    let Ok(again) = parse::formula(&text) else {
        outcome.faults.push(format!("{place}: what is printed, {} characters, does not read back", text.len()));
        return;
    };
    let mut all = values.to_vec();
    all.extend([("x", at.1), ("a", at.1), ("r", at.0), ("E", 1.0)]);
    let Some(found) = bounded(&again, &all) else { return };
    let factor = match name {
        "g" => 1.0,
        "F" => 0.5,
        _ => std::f64::consts::PI,
    };
    let (value, error) = (found.value * factor, found.error * factor);
    if error <= 1e-6 * two.estimate.value.abs() {
        outcome.printed += 1;
        let (difference, allowed) = ((value - two.estimate.value).abs(), error + two.estimate.error + 1e-12 * value.abs());
        if difference.is_nan() || allowed.is_nan() || difference > allowed {
            let begin: String = text.chars().take(300).collect();
            outcome.faults.push(format!("{place}: printed {begin} is {value:e}, quadrature {:?}", two.estimate));
        }
    }
}

/// The value of a formula without integrals, with its running error bound.
fn bounded(formula: &Formula, values: &[(&str, f64)]) -> Option<Bounded> {
    let number = |expr: &Expr| {
        walk(&shown(expr), &mut BoundedAlgebra, &mut |s| values.iter().find(|(n, _)| *n == s.name()).map(|(_, v)| Bounded::exact(*v))).ok()
    };
    match formula {
        Formula::Closed(expr) => number(expr),
        Formula::Sum(parts) => parts.iter().map(|part| bounded(part, values)).try_fold(Bounded::exact(0.0), |sum, own| Some(sum + own?)),
        Formula::Scaled(factor, inner) => Some(number(factor)? * bounded(inner, values)?),
        Formula::Piecewise { variable, pieces, last } => {
            let at = values.iter().find(|(name, _)| *name == variable.name())?.1;
            for (piece, end) in pieces {
                if at < number(end)?.value {
                    return bounded(piece, values);
                }
            }
            bounded(last, values)
        }
        Formula::Integral { .. } => None,
    }
}
