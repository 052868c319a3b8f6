//! Routines that sum the power series of g, F and p next to the axis, where the closed form cancels.
//!
//! f(x τ) = Σ A_n τ^(n+s) in powers of τ, whose coefficients follow from one another at run time, gives g(x) = Σ κ_(n+s) A_n,
//! F/(2E*) = x Σ κ_(n+s) A_n (n+s)/(n+s+1) and, for s = 0 and x = a, π p/E* = Σ n κ_n A_n J_n/a with J_n = ∫ τ^(n−1)/√(τ²−ρ²) dτ from
//! ρ = r/a to 1: (n−1) J_n = √(1−ρ²) + (n−2) ρ² J_(n−2), where nothing cancels, and J_1 = arcosh(1/ρ).

use super::tree::LENGTH;
use crate::contact::Quantity;
use crate::eval::{Series, power_series};
use crate::expr::{Bindings, Expr, FirstPower, Node, Number, Symbol, derivative, leading_term};
use crate::num::kappa::kappa;

/// The text of a routine in the language of the stable forms, and the constants that precede it.
pub(super) struct SeriesText {
    /// Names of constants with their expressions, in the order in which they are needed.
    pub(super) constants: Vec<(String, Expr)>,
    /// The statements; they return NaN where the series is not seen to converge fast.
    pub(super) body: String,
}

/// The largest power of r that multiplies a series, and of a series as a product.
const MOST_FACTORS: i64 = 32;
/// The most arrays: each costs as many operations as half the square of the number of terms.
const MOST_ARRAYS: usize = 24;
/// The coefficients among which gaps are sought.
const SEEN: usize = 80;
/// Terms may be this much larger than their sum, alone and where a quadrature follows.
const CANCELLING: [f64; 2] = [32.0, 2.0];
/// Terms may grow by this factor beyond the first one.
const GROWING: f64 = 1e6;

/// The series of the first pieces of a profile at `coordinate`; `None` if no recurrence is known.
///
/// `is_alone` says that no quadrature follows; `sample` has numbers for the parameters, from which the gaps between powers are read.
pub(super) fn text(profile: &Expr, coordinate: &str, quantity: Quantity, is_alone: bool, sample: &Bindings) -> Option<SeriesText> {
    let [alone, followed] = CANCELLING;
    let cancelling = if is_alone { alone } else { followed };
    let gap = gap(&sample.apply(profile))?;
    let mut writer = Writer::new(coordinate);
    let (shift, total) = writer.total(profile)?;
    // The coefficients that are 0 whatever the parameters are, f(0) among them; rounded ones would not vanish.
    let slope = derivative(profile, &writer.radius).ok()?;
    let lead = (leading_term(&slope)?.exponent.to_f64() + 1.0 - shift).round();
    let (first, second) = if shift == 0.0 { (1.0, kappa(1.0)) } else { (kappa(shift), kappa(shift + 1.0)) };
    let power = if shift == 0.0 { String::new() } else { format!("pow({coordinate}, {shift:?}) * ") };
    let sum = format!("{power}(_sum + _lost)");
    let (mut before, mut integral) = (String::new(), "");
    let (weight, result) = match quantity {
        Quantity::Force => (format!(" * ((_n + {shift:?}) / (_n + {:?}))", shift + 1.0), format!("{coordinate} * {sum}")),
        Quantity::Pressure if shift == 0.0 => {
            // J_1 has no weight or the factor ρ² where it is infinite; under a cone the pressure is infinite at the axis.
            before = format!(
                "let _edge = sqrt(({coordinate} - r) * ({coordinate} + r)); let _square = (r / {coordinate}) * (r / {coordinate});
                let _rim = _edge / {coordinate}; let _j = 0; let _j1 = 0; let _j2 = 0;"
            );
            if lead <= 1.0 {
                before.push_str(" if r == 0 { return nan(); }");
            }
            integral = "_j2 = _j1; _j1 = _j; _j = 0;
                if _n == 1 && r > 0 { _j = asinh(_edge / r); }
                if _n >= 2 { _j = (_rim + (_n - 2) * _square * _j2) / (_n - 1); }";
            (" * _n * _j".to_owned(), format!("{sum} / {coordinate}"))
        }
        Quantity::Pressure => return None,
        _ => (String::new(), sum),
    };
    let body = format!(
        "{} {} let _n = 0; let _sum = 0; let _lost = 0; let _total = 0; let _size = 0; let _first = 0; let _small = 0; let _part = 0;
        let _kappa = {first:?}; let _next = {second:?}; let _after = 0; {before}
        while _n < {LENGTH} && _small <= {gap} {{
          if _n > 0 {{ {} }}
          {integral}
          if _n >= {lead:?} {{
            _part = {total}[_n] * _kappa{weight};
            if _first == 0 {{ _first = abs(_part); }}
            if !(abs(_part) <= {GROWING:?} * _first) {{ return nan(); }}
            _total = _sum + _part;
            _lost = _lost + ((_sum - _total) + _part);
            _sum = _total;
            _size = _size + abs(_part);
            if abs(_part) <= 1e-17 * abs(_sum) {{ _small = _small + 1; }} else {{ _small = 0; }}
          }}
          _after = _kappa * ((_n + {:?}) / (_n + {:?}));
          _kappa = _next;
          _next = _after;
          _n = _n + 1;
        }}
        if _small <= {gap} || _size > {cancelling:?} * abs(_sum) {{ return nan(); }}
        return {result};",
        if writer.step.contains("_k") { "let _s = 0; let _k = 0;" } else { "" },
        writer.begin,
        writer.step,
        shift + 2.0,
        shift + 1.0,
    );
    Some(SeriesText { constants: writer.constants, body })
}

/// The largest distance between powers of r with a coefficient, in the profile or in a part of it, and between the leading powers of the
/// terms of a sum: where the terms of one part are negligible, those of another, which come less often or later, may not be.
fn gap(profile: &Expr) -> Option<usize> {
    let groups = power_series(profile, SEEN, &[]).ok()?;
    let widest = |own: &Series| {
        let places: Vec<usize> = own.coefficients.iter().enumerate().filter(|(_, c)| c.value.abs() > c.error).map(|(n, _)| n).collect();
        places.windows(2).map(|pair| pair[1] - pair[0]).max().unwrap_or(1)
    };
    let mut own = groups.iter().map(widest).max()?;
    if let Node::Sum(terms) = profile.node() {
        let leads: Vec<f64> = terms.iter().filter_map(|term| Some(leading_term(term)?.exponent.to_f64())).collect();
        let (first, last) = leads.iter().fold((f64::INFINITY, 0.0_f64), |ends, lead| (ends.0.min(*lead), ends.1.max(*lead)));
        own = own.max((last - first).max(0.0).ceil() as usize);
    }
    Some(profile.children().into_iter().filter_map(gap).fold(own, usize::max))
}

/// A part of the profile: a number, or the name of the array of its coefficients.
enum Part {
    Number(Expr),
    Series(String),
}

/// The statements that compute the coefficients, those of order 0 and those of order n.
struct Writer {
    coordinate: Expr,
    radius: Symbol,
    constants: Vec<(String, Expr)>,
    arrays: usize,
    begin: String,
    step: String,
}

impl Writer {
    fn new(coordinate: &str) -> Self {
        let (begin, step) = (String::new(), String::new());
        Self { coordinate: Expr::symbol(coordinate), radius: Symbol::new("r"), constants: Vec::new(), arrays: 0, begin, step }
    }

    /// The shift s and the array of a sum whose terms have powers of r that differ by whole numbers.
    fn total(&mut self, profile: &Expr) -> Option<(f64, String)> {
        let mut parts: Vec<(Number, Vec<Expr>)> = Vec::new();
        for term in profile.terms() {
            let (mut exponent, mut rest) = (Number::integer(0), Vec::new());
            for factor in term.factors() {
                let (base, power) = factor.split_power();
                match power.as_number() {
                    Some(power) if base.as_symbol() == Some(&self.radius) => exponent = &exponent + power,
                    _ => rest.push(factor),
                }
            }
            parts.push((exponent, rest));
        }
        let least = parts.iter().map(|own| own.0.clone()).min()?;
        let shift = if least.to_i64().is_some_and(|own| own >= 0) { Number::integer(0) } else { least };
        if shift.to_f64() <= -1.0 || !shift.is_exact_f64() {
            return None;
        }
        let mut all = Vec::new();
        for (exponent, rest) in parts {
            let whole = (&exponent - &shift).to_i64()?;
            let part = self.node(&Expr::product(rest))?;
            all.push(self.raised(part, whole)?);
        }
        Some((shift.to_f64(), self.sum(all)?))
    }

    fn array(&mut self) -> Option<String> {
        self.arrays += 1;
        let name = format!("_u{}", self.arrays);
        self.begin.push_str(&format!(" array {name};"));
        (self.arrays <= MOST_ARRAYS).then_some(name)
    }

    /// The name of a constant.
    fn constant(&mut self, expr: &Expr) -> String {
        if let Some((name, _)) = self.constants.iter().find(|own| own.1 == *expr) {
            return name.clone();
        }
        let name = format!("_c{}", self.constants.len() + 1);
        self.constants.push((name.clone(), expr.clone()));
        name
    }

    /// r^m times a part.
    fn raised(&mut self, part: Part, m: i64) -> Option<Part> {
        if m == 0 {
            return Some(part);
        }
        if !(1..=MOST_FACTORS).contains(&m) {
            return None;
        }
        let power = self.constant(&self.coordinate.power(m));
        let name = self.array()?;
        match part {
            Part::Number(number) => {
                let number = self.constant(&number);
                self.begin.push_str(&format!(" {name}[{m}] = {number} * {power};"));
            }
            Part::Series(own) => {
                self.step.push_str(&format!(" if _n >= {m} {{ {name}[_n] = {power} * {own}[_n - {m}]; }}"));
            }
        }
        Some(Part::Series(name))
    }

    fn node(&mut self, expr: &Expr) -> Option<Part> {
        if !expr.contains(&self.radius) {
            return Some(Part::Number(expr.clone()));
        }
        let series = match expr.node() {
            Node::Symbol(_) => return self.raised(Part::Number(Expr::one()), 1),
            Node::Sum(terms) => {
                let parts = terms.iter().map(|own| self.node(own)).collect::<Option<Vec<_>>>()?;
                let sum = self.sum(parts)?;
                // What vanishes at the axis exactly, though its parts are rounded.
                let lead = leading_term(expr)?.exponent.to_f64();
                if lead > 0.0 {
                    self.begin.push_str(&format!(" {sum}[0] = 0;"));
                    self.step.push_str(&format!(" if _n < {lead:?} {{ {sum}[_n] = 0; }}"));
                }
                sum
            }
            Node::Product(_) => {
                let (mut m, mut number, mut series) = (0, Vec::new(), Vec::new());
                for factor in expr.factors() {
                    let (base, power) = factor.split_power();
                    if base.as_symbol() == Some(&self.radius) {
                        m += power.as_integer()?;
                        continue;
                    }
                    match self.node(&factor)? {
                        Part::Number(own) => number.push(own),
                        Part::Series(own) => series.push(own),
                    }
                }
                let mut series = series.into_iter();
                let part = match series.next() {
                    None => Part::Number(Expr::product(number)),
                    Some(first) => {
                        let mut product = first;
                        for own in series {
                            product = self.product(&product, &own)?;
                        }
                        Part::Series(self.scaled(&product, &Expr::product(number))?)
                    }
                };
                return self.raised(part, m);
            }
            Node::Power(base, exponent) => {
                if base.as_symbol() == Some(&self.radius) {
                    return self.raised(Part::Number(Expr::one()), exponent.as_integer()?);
                }
                self.power(base, exponent)?
            }
            Node::Function(function, arguments) => match arguments.as_slice() {
                [argument] => self.call(function.name(), argument)?,
                [order, argument] => self.of_order(function.name(), order, argument)?,
                _ => return None,
            },
            Node::Number(_) | Node::Constant(_) => return None,
        };
        Some(Part::Series(series))
    }

    /// Appends what the elements of a new array are at order 0 and at order n.
    fn defined(&mut self, first: &str, next: impl Fn(&str) -> String) -> Option<String> {
        let name = self.array()?;
        self.begin.push_str(&format!(" {name}[0] = {first};"));
        self.step.push_str(&format!(" {}", next(&name)));
        Some(name)
    }

    fn sum(&mut self, parts: Vec<Part>) -> Option<String> {
        let (mut numbers, mut series) = (Vec::new(), Vec::new());
        for own in parts {
            match own {
                Part::Number(number) => numbers.push(number),
                Part::Series(name) => series.push(name),
            }
        }
        let all = |index: &str| series.iter().map(|own| format!("{own}[{index}]")).collect::<Vec<_>>().join(" + ");
        let (at_zero, at_n) = (all("0"), all("_n"));
        let number = Expr::sum(numbers);
        let first = match (number.is_zero(), series.as_slice()) {
            (true, [only]) => return Some(only.clone()),
            (true, _) => at_zero,
            (false, []) => self.constant(&number),
            (false, _) => format!("{} + {at_zero}", self.constant(&number)),
        };
        self.defined(&first, |name| if at_n.is_empty() { String::new() } else { format!("{name}[_n] = {at_n};") })
    }

    fn scaled(&mut self, series: &str, factor: &Expr) -> Option<String> {
        if factor.is_one() {
            return Some(series.to_owned());
        }
        let factor = self.constant(factor);
        self.defined(&format!("{factor} * {series}[0]"), |name| format!("{name}[_n] = {factor} * {series}[_n];"))
    }

    /// The sum over k of what is given, from `from` to `to`, divided by the rest.
    fn convolved(name: &str, (from, to): (&str, &str), term: &str, rest: &str) -> String {
        format!("_s = 0; _k = {from}; while _k <= {to} {{ _s = _s + {term}; _k = _k + 1; }} {name}[_n] = {rest};")
    }

    fn product(&mut self, u: &str, v: &str) -> Option<String> {
        self.defined(&format!("{u}[0] * {v}[0]"), |name| Self::convolved(name, ("0", "_n"), &format!("{u}[_k] * {v}[_n - _k]"), "_s"))
    }

    /// u^p by Miller's recurrence; whole powers are products, and others need u₀ ≠ 0.
    fn power(&mut self, base: &Expr, exponent: &Expr) -> Option<String> {
        let Part::Series(u) = self.node(base)? else { return None };
        if exponent.contains(&self.radius) {
            return None;
        }
        if let Some(n) = exponent.as_integer().filter(|n| (1..=MOST_FACTORS).contains(n)) {
            let mut total = u.clone();
            for _ in 1..n {
                total = self.product(&total, &u)?;
            }
            return Some(total);
        }
        self.begins_beyond_zero(base)?;
        self.real_power(&u, exponent)
    }

    fn real_power(&mut self, u: &str, exponent: &Expr) -> Option<String> {
        let first = match exponent.as_number().map(Number::to_f64) {
            Some(-1.0) => format!("1 / {u}[0]"),
            Some(0.5) => format!("sqrt({u}[0])"),
            Some(-0.5) => format!("1 / sqrt({u}[0])"),
            _ => format!("pow({u}[0], {})", self.constant(exponent)),
        };
        let p = self.constant(exponent);
        let next = |name: &str| {
            let term = format!("({p} * _k - (_n - _k)) * {u}[_k] * {name}[_n - _k]");
            Self::convolved(name, ("1", "_n"), &term, &format!("_s / (_n * {u}[0])"))
        };
        self.defined(&first, next)
    }

    /// Succeeds if a series has a constant term that is symbolically nonzero.
    fn begins_beyond_zero(&self, expr: &Expr) -> Option<()> {
        (leading_term(expr)?.exponent == Number::integer(0)).then_some(())
    }

    fn call(&mut self, name: &str, argument: &Expr) -> Option<String> {
        let Part::Series(u) = self.node(argument)? else { return None };
        match name {
            "exp" => self.exponential(&u),
            "ln" => {
                self.begins_beyond_zero(argument)?;
                let next = |name: &str| {
                    let (term, rest) = (format!("_k * {name}[_k] * {u}[_n - _k]"), format!("({u}[_n] - _s / _n) / {u}[0]"));
                    Self::convolved(name, ("1", "_n - 1"), &term, &rest)
                };
                self.defined(&format!("log({u}[0])"), next)
            }
            "sin" | "cos" | "tan" | "sinh" | "cosh" | "tanh" => {
                let is_circular = matches!(name, "sin" | "cos" | "tan");
                let (sine, cosine) = if is_circular { ("sin", "cos") } else { ("sinh", "cosh") };
                let (s, c) = (self.array()?, self.array()?);
                self.begin.push_str(&format!(" {s}[0] = {sine}({u}[0]); {c}[0] = {cosine}({u}[0]);"));
                let term = |other: &str| format!("_k * {u}[_k] * {other}[_n - _k]");
                let sign = if is_circular { "-" } else { "" };
                let next = [
                    Self::convolved(&s, ("1", "_n"), &term(&c), "_s / _n"),
                    Self::convolved(&c, ("1", "_n"), &term(&s), &format!("{sign}_s / _n")),
                ];
                self.step.push_str(&format!(" {}", next.join(" ")));
                match name {
                    "sin" | "sinh" => Some(s),
                    "cos" | "cosh" => Some(c),
                    _ => {
                        let inverse = self.real_power(&c, &Expr::integer(-1))?;
                        self.product(&s, &inverse)
                    }
                }
            }
            "atan" => self.integral_of_power(&u, 1, Expr::integer(-1), "atan"),
            "atanh" => self.integral_of_power(&u, -1, Expr::integer(-1), "atanh"),
            "asinh" => self.integral_of_power(&u, 1, Expr::ratio(-1, 2), "asinh"),
            "asin" => self.integral_of_power(&u, -1, Expr::ratio(-1, 2), "asin"),
            "erf" => {
                let square = self.product(&u, &u)?;
                let negative = self.scaled(&square, &Expr::integer(-1))?;
                let slope = self.exponential(&negative)?;
                let slope = self.scaled(&slope, &(Expr::integer(2) / Expr::pi().sqrt()))?;
                // Exactly 0 at the axis, where erf needs no library.
                self.begins_beyond_zero(argument).is_none().then_some(())?;
                self.integral(&u, &slope, "0")
            }
            "dawson" => self.dawson(argument, &u),
            _ => None,
        }
    }

    /// Dawson's integral D of a series without a constant term, from D′ = 1 − 2 u D.
    fn dawson(&mut self, argument: &Expr, u: &str) -> Option<String> {
        self.begins_beyond_zero(argument).is_none().then_some(())?;
        let slope = self.array()?;
        self.begin.push_str(&format!(" {slope}[0] = 1;"));
        let dawson = self.integral(u, &slope, "0")?;
        let next = Self::convolved(&slope, ("1", "_n"), &format!("{u}[_k] * {dawson}[_n - _k]"), "-2 * _s");
        self.step.push_str(&format!(" {next}"));
        Some(dawson)
    }

    /// Bessel and Struve functions of whole orders at z = c r^m, whose powers follow from one another.
    fn of_order(&mut self, name: &str, order: &Expr, argument: &Expr) -> Option<String> {
        let FirstPower { order, exponent, coefficient, sign } = FirstPower::new(name, order)?;
        let (mut m, mut rest) = (0, Vec::new());
        for factor in argument.factors() {
            let (base, power) = factor.split_power();
            match base.as_symbol() == Some(&self.radius) {
                true => m += power.as_integer()?,
                false => rest.push(factor),
            }
        }
        let rest = Expr::product(rest);
        let least = exponent * m;
        if rest.contains(&self.radius) || !(1..=MOST_FACTORS).contains(&m) || least >= i64::try_from(LENGTH).ok()? {
            return None;
        }
        let z = rest * self.coordinate.power(m);
        let first = self.constant(&(coefficient * z.power(exponent)));
        let square = self.constant(&(Expr::integer(sign) * z.power(2)));
        let series = self.array()?;
        self.begin.push_str(&format!(" {series}[{least}] = {first};"));
        // The power j of z is the power j m of r.
        let (two, squared, less, second) = (2 * m, m * m, m * m * order * order, least + 2 * m);
        self.step.push_str(&format!(
            " if _n >= {second} {{ {series}[_n] = {square} * {series}[_n - {two}] * ({squared} / (_n * _n - {less})); }}"
        ));
        Some(series)
    }

    fn exponential(&mut self, u: &str) -> Option<String> {
        let next = |name: &str| Self::convolved(name, ("1", "_n"), &format!("_k * {u}[_k] * {name}[_n - _k]"), "_s / _n");
        self.defined(&format!("exp({u}[0])"), next)
    }

    /// h(u) with h′ = (1 ± u²)^p.
    fn integral_of_power(&mut self, u: &str, sign: i64, p: Expr, function: &str) -> Option<String> {
        let square = self.product(u, u)?;
        let square = self.scaled(&square, &Expr::integer(sign))?;
        let below = self.sum(vec![Part::Number(Expr::one()), Part::Series(square)])?;
        let slope = self.real_power(&below, &p)?;
        self.integral(u, &slope, &format!("{function}({u}[0])"))
    }

    /// h(u) with h′ as a series.
    fn integral(&mut self, u: &str, slope: &str, first: &str) -> Option<String> {
        let next = |name: &str| Self::convolved(name, ("1", "_n"), &format!("_k * {u}[_k] * {slope}[_n - _k]"), "_s / _n");
        self.defined(first, next)
    }
}
