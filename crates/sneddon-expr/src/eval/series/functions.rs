//! Powers and functions of series: coefficients by the differential equation of the function, bounds by its majorant.
//!
//! With u = u₀ + v and δ ≥ Σ |v_n| ρ^n the bound for h(u) is Σ_{k≥1} |h_k| δ^k, h_k being Taylor coefficients of h at u₀.

use super::{Frame, Series, SeriesError, widened};
use crate::expr::{Expr, Function};
use crate::num::Bounded;

/// Whole powers up to this one are products.
const MOST_FACTORS: f64 = 64.0;
/// Relative rounding that quotients near 1 are charged with before they meet a pole.
const EDGE: f64 = 1e-12;

impl Frame {
    /// A function of the table.
    pub(super) fn call(&self, function: Function, arguments: &[Expr]) -> Result<Series, SeriesError> {
        let name = function.name();
        let unknown = || Err(SeriesError::Unknown { function: name });
        match arguments {
            [argument] => {
                let u = self.series(argument)?;
                if name == "ln" {
                    return self.ln(&u);
                }
                let u = self.plain(&u)?;
                match name {
                    "exp" => self.exp(&u),
                    "sin" => Ok(self.circular(&u).0),
                    "cos" => Ok(self.circular(&u).1),
                    "tan" => self.quotient(self.circular(&u)),
                    "sinh" => Ok(self.hyperbolic(&u).0),
                    "cosh" => Ok(self.hyperbolic(&u).1),
                    "tanh" => self.quotient(self.hyperbolic(&u)),
                    "atan" => self.arc(&u, 1.0, -1.0, f64::atan),
                    "atanh" => self.arc(&u, -1.0, -1.0, libm::atanh),
                    "asinh" => self.arc(&u, 1.0, -0.5, libm::asinh),
                    "asin" => self.arc(&u, -1.0, -0.5, f64::asin),
                    "acos" => {
                        let negative = self.scaled(&self.arc(&u, -1.0, -0.5, f64::asin)?, Bounded::exact(-1.0));
                        self.sum(&self.constant(Bounded::rounded(std::f64::consts::FRAC_PI_2)), &negative)
                    }
                    "erf" => self.erf(&u, function),
                    "dawson" if u.first_bound() == 0.0 => self.dawson(&u),
                    _ => unknown(),
                }
            }
            [order, argument] if matches!(name, "besselj" | "besseli" | "struveh" | "struvel") => {
                let Some(n) = order.as_integer().filter(|n| (0..=1000).contains(n)) else { return unknown() };
                let u = self.plain(&self.series(argument)?)?;
                if u.first_bound() != 0.0 {
                    return unknown();
                }
                let sign = if name.ends_with(['j', 'h']) { -1.0 } else { 1.0 };
                if name.starts_with("bessel") { self.bessel(&u, n as f64, sign) } else { self.struve(&u, n as f64, sign) }
            }
            [..] => unknown(),
        }
    }

    fn scaled(&self, u: &Series, factor: Bounded) -> Series {
        self.product(u, &self.constant(factor))
    }

    /// sin/cos and the like.
    fn quotient(&self, (above, below): (Series, Series)) -> Result<Series, SeriesError> {
        Ok(self.product(&above, &self.power(&below, -1.0, true)?))
    }

    /// u^p; `exact` means that p carries no rounding error.
    pub(super) fn power(&self, u: &Series, p: f64, exact: bool) -> Result<Series, SeriesError> {
        if !exact {
            return self.general_power(u, Bounded::rounded(p));
        }
        if p.fract() == 0.0 && (0.0..=MOST_FACTORS).contains(&p) {
            return Ok(self.whole_power(u, p as u32));
        }
        let u = self.normalised(u)?;
        if p > 1.0 && p < MOST_FACTORS {
            // A whole power times a root has the smaller bound.
            let whole = self.whole_power(&u, p.floor() as u32);
            return Ok(self.product(&whole, &self.power(&u, p.fract(), true)?));
        }
        let shift = u.shift * p;
        let analytic = self.binomial(&Series { shift: 0.0, ..u }, Bounded::exact(p))?;
        Ok(Series { shift, ..analytic })
    }

    /// u^p with an inexact exponent, which requires u(0) ≠ 0: no power of r may be factored out.
    pub(super) fn general_power(&self, u: &Series, p: Bounded) -> Result<Series, SeriesError> {
        let u = self.normalised(u)?;
        if u.shift != 0.0 {
            return Err(SeriesError::NotAnalytic { what: "a power of r with an exponent that no 64-bit float holds" });
        }
        self.binomial(&u, p)
    }

    fn whole_power(&self, u: &Series, n: u32) -> Series {
        (0..n).fold(self.constant(Bounded::exact(1.0)), |total, _| self.product(&total, u))
    }

    /// u^p for u₀ ≠ 0 by Miller's recurrence n u₀ w_n = Σ (p k − n + k) u_k w_{n−k}.
    fn binomial(&self, u: &Series, p: Bounded) -> Result<Series, SeriesError> {
        let first = u.first();
        let whole = p.error == 0.0 && p.value.fract() == 0.0;
        if first.value.abs() <= first.error {
            return Err(SeriesError::Undecided);
        }
        if first.value < 0.0 && !whole {
            return Err(SeriesError::NotAnalytic { what: "a root of a negative number" });
        }
        let start = match p.value {
            _ if p.error > 0.0 => first.powf(p),
            -1.0 => Bounded::exact(1.0) / first,
            0.5 => first.sqrt(),
            -0.5 => Bounded::exact(1.0) / first.sqrt(),
            _ => first.powf(p),
        };
        let mut w = vec![start];
        for n in 1..u.coefficients.len() {
            let count = n as f64;
            let terms = u.coefficients.iter().skip(1).take(n).enumerate().map(|(i, a)| {
                let k = (i + 1) as f64;
                let factor = p * Bounded::exact(k) - Bounded::exact(count - k);
                factor * *a * w.get(n - i - 1).copied().unwrap_or(Bounded::exact(0.0))
            });
            let sum = Bounded::sum(terms);
            w.push(sum / (Bounded::exact(count) * first));
        }
        let (size, least) = (start.value.abs() + start.error, first.value.abs() - first.error);
        let most = p.value.abs() + p.error;
        let rest = u.rest.iter().map(|delta| {
            let t = delta / least * (1.0 + EDGE);
            if t >= 1.0 {
                return f64::INFINITY;
            }
            // Σ |binom(p, k)| t^k is 1 − (1 − t)^p for 0 < p ≤ 1, and at most (1 − t)^(−|p|) − 1 everywhere.
            let grown = if p.error == 0.0 && p.value > 0.0 && p.value <= 1.0 {
                -(p.value * (-t).ln_1p()).exp_m1()
            } else {
                (-most * (-t).ln_1p()).exp_m1()
            };
            widened(size * grown)
        });
        Ok(Series { shift: 0.0, rest: rest.collect(), coefficients: w })
    }

    /// ln u for u₀ > 0: n u₀ w_n = n u_n − Σ k w_k u_{n−k}.
    pub(super) fn ln(&self, u: &Series) -> Result<Series, SeriesError> {
        let u = self.normalised(u)?;
        let first = u.first();
        if u.shift != 0.0 {
            return Err(SeriesError::NotAnalytic { what: "the logarithm of something that vanishes at r = 0" });
        }
        if first.value <= first.error {
            return Err(SeriesError::NotAnalytic { what: "the logarithm of a negative number" });
        }
        let quotient = self.product(&self.slope(&u), &self.power(&u, -1.0, true)?);
        let start = first.apply(f64::ln, 2.0);
        let least = first.value - first.error;
        let rest = u.rest.iter().map(|delta| logarithmic(*delta, least));
        Ok(Series { shift: 0.0, coefficients: integrated(start, &quotient), rest: rest.collect() })
    }

    /// e^u: n w_n = Σ k u_k w_{n−k}.
    pub(super) fn exp(&self, u: &Series) -> Result<Series, SeriesError> {
        let u = self.plain(u)?;
        let start = applied(u.first(), 1.0, f64::exp, 2.0);
        let mut w = vec![start];
        for n in 1..u.coefficients.len() {
            let sum = Bounded::sum(weighted(&u, &w, n));
            w.push(sum / Bounded::exact(n as f64));
        }
        let size = start.value + start.error;
        let rest = u.rest.iter().map(|delta| widened(size * delta.exp_m1()));
        Ok(Series { shift: 0.0, rest: rest.collect(), coefficients: w })
    }

    /// sin u and cos u.
    fn circular(&self, u: &Series) -> (Series, Series) {
        let first = u.first();
        let pair = (applied(first, 0.0, f64::sin, 2.0), applied(first, 1.0, f64::cos, 2.0));
        self.coupled(u, pair, -1.0)
    }

    /// sinh u and cosh u.
    fn hyperbolic(&self, u: &Series) -> (Series, Series) {
        let first = u.first();
        let pair = (applied(first, 0.0, f64::sinh, 2.0), applied(first, 1.0, f64::cosh, 2.0));
        self.coupled(u, pair, 1.0)
    }

    /// s′ = u′ c, c′ = ± u′ s.
    fn coupled(&self, u: &Series, (s0, c0): (Bounded, Bounded), sign: f64) -> (Series, Series) {
        let (mut s, mut c) = (vec![s0], vec![c0]);
        for n in 1..u.coefficients.len() {
            let count = Bounded::exact(n as f64);
            let (next_s, next_c) = (Bounded::sum(weighted(u, &c, n)) / count, Bounded::sum(weighted(u, &s, n)) / count);
            s.push(next_s);
            c.push(next_c * Bounded::exact(sign));
        }
        let bound = |one: Bounded, other: Bounded| {
            let (one, other) = (one.value.abs() + one.error, other.value.abs() + other.error);
            let grown = |delta: &f64| {
                let even = 2.0 * (0.5 * delta).sinh().powi(2);
                widened(if one == 0.0 { 0.0 } else { one * even } + if other == 0.0 { 0.0 } else { other * delta.sinh() })
            };
            u.rest.iter().map(grown).collect::<Vec<f64>>()
        };
        let (rest_s, rest_c) = (bound(s0, c0), bound(c0, s0));
        (Series { shift: 0.0, coefficients: s, rest: rest_s }, Series { shift: 0.0, coefficients: c, rest: rest_c })
    }

    /// h(u) with h′ = (1 ± u²)^p: the arc and area functions.
    fn arc(&self, u: &Series, sign: f64, p: f64, h: fn(f64) -> f64) -> Result<Series, SeriesError> {
        let square = self.scaled(&self.product(u, u), Bounded::exact(sign));
        let slope = self.power(&self.sum(&self.constant(Bounded::exact(1.0)), &square)?, p, true)?;
        let first = u.first();
        // The distance from u₀ to the nearest pole, ±i or ±1.
        let distance = if sign > 0.0 {
            let least = (first.value.abs() - first.error).max(0.0);
            (1.0 + least * least).sqrt() * (1.0 - EDGE)
        } else {
            1.0 - u.first_bound()
        };
        if distance <= 0.0 {
            return Err(SeriesError::NotAnalytic { what: "an inverse function at the end of its domain" });
        }
        // |h′| is at most 1/(D − s) at the distance s; with u₀ = 0 the function of the other sign is the majorant itself.
        let centred = u.first_bound() == 0.0;
        let rest = u.rest.iter().map(|delta| {
            let delta = delta * (1.0 + EDGE);
            match (centred, p == -1.0) {
                (true, _) if delta >= 1.0 => f64::INFINITY,
                (true, true) => widened(libm::atanh(delta)),
                (true, false) => widened(delta.asin()),
                (false, _) => logarithmic(delta, distance),
            }
        });
        let quotient = self.product(&self.slope(u), &slope);
        Ok(Series { shift: 0.0, coefficients: integrated(applied(first, 0.0, h, 4.0), &quotient), rest: rest.collect() })
    }

    /// erf u: h′ = (2/√π) e^(−u²).
    fn erf(&self, u: &Series, function: Function) -> Result<Series, SeriesError> {
        let square = self.scaled(&self.product(u, u), Bounded::exact(-1.0));
        let scale = Bounded::rounded(std::f64::consts::FRAC_2_SQRT_PI);
        let slope = self.scaled(&self.exp(&square)?, scale);
        let first = u.first();
        let value = applied(first, 0.0, |z| (function.row().value)(&[z]), function.row().ulps());
        let rest = u.rest.iter().map(|delta| {
            let most = u.first_bound() + delta;
            widened(if *delta == 0.0 { 0.0 } else { std::f64::consts::FRAC_2_SQRT_PI * delta * (most * most).exp() })
        });
        let quotient = self.product(&self.slope(u), &slope);
        Ok(Series { shift: 0.0, coefficients: integrated(value, &quotient), rest: rest.collect() })
    }

    /// J_n(u) or I_n(u) for u₀ = 0: (u/2)^n/n! Σ (±u²/4)^k n!/(k! (n+k)!).
    fn bessel(&self, u: &Series, n: f64, sign: f64) -> Result<Series, SeriesError> {
        let mut front = self.constant(Bounded::exact(1.0));
        for k in 1..=n as u32 {
            front = self.product(&front, &self.scaled(u, Bounded::exact(0.5) / Bounded::exact(f64::from(k))));
        }
        let step = |k: f64| Bounded::exact(k) * Bounded::exact(n + k);
        Ok(self.product(&front, &self.by_ratio(u, 0.25 * sign, step, 0.25 / (n + 1.0))?))
    }

    /// H_n(u) or L_n(u) for u₀ = 0: the front (u/2)^(n+1)/(Γ(3/2) Γ(n + 3/2)) times Σ (±u²/4)^k/((3/2)_k (n + 3/2)_k).
    fn struve(&self, u: &Series, n: f64, sign: f64) -> Result<Series, SeriesError> {
        let mut front = self.scaled(u, Bounded::exact(2.0) / Bounded::rounded(std::f64::consts::PI));
        for k in 1..=n as u32 {
            front = self.product(&front, &self.scaled(u, Bounded::exact(1.0) / Bounded::exact(2.0 * f64::from(k) + 1.0)));
        }
        let step = |k: f64| Bounded::exact(k + 0.5) * Bounded::exact(n + k + 0.5);
        Ok(self.product(&front, &self.by_ratio(u, 0.25 * sign, step, 0.25 / (n + 1.5))?))
    }

    /// Dawson's integral for u₀ = 0: u Σ (−u²)^k/(3/2)_k.
    fn dawson(&self, u: &Series) -> Result<Series, SeriesError> {
        Ok(self.product(u, &self.by_ratio(u, -1.0, |k| Bounded::exact(k + 0.5), 1.0)?))
    }

    /// Σ (c u²)^k/(s₁ s₂ … s_k) for u₀ = 0, of which every term is at most (growth u²)^k/k! in magnitude.
    fn by_ratio(&self, u: &Series, c: f64, step: impl Fn(f64) -> Bounded, growth: f64) -> Result<Series, SeriesError> {
        let square = self.scaled(&self.product(u, u), Bounded::exact(c));
        let one = self.constant(Bounded::exact(1.0));
        let mut total = one.clone();
        for k in (1..=self.length / 2 + 1).rev() {
            total = self.sum(&one, &self.scaled(&self.product(&square, &total), Bounded::exact(1.0) / step(k as f64)))?;
        }
        // The loop has bounded a polynomial; this is the majorant of all terms.
        total.rest = u.rest.iter().map(|delta| widened((growth * delta * delta).exp_m1())).collect();
        Ok(total)
    }

    /// u′, as coefficients; its bounds are not used.
    fn slope(&self, u: &Series) -> Series {
        let coefficients = u.coefficients.iter().enumerate().skip(1).map(|(n, a)| *a * Bounded::exact(n as f64)).collect();
        Series { shift: 0.0, coefficients, rest: vec![0.0; self.radii.len()] }
    }
}

/// h(u₀), exact at u₀ = 0, so that what vanishes there is known to vanish.
fn applied(first: Bounded, at_zero: f64, h: impl Fn(f64) -> f64, ulps: f64) -> Bounded {
    if first.value == 0.0 && first.error == 0.0 { Bounded::exact(at_zero) } else { first.apply(h, ulps) }
}

/// Σ k u_k w_{n−k} term by term.
fn weighted<'a>(u: &'a Series, w: &'a [Bounded], n: usize) -> impl Iterator<Item = Bounded> + 'a {
    u.coefficients
        .iter()
        .enumerate()
        .skip(1)
        .take(n)
        .map(move |(k, a)| *a * Bounded::exact(k as f64) * w.get(n - k).copied().unwrap_or(Bounded::exact(0.0)))
}

/// The coefficients of the integral of a series, with its value at r = 0.
fn integrated(start: Bounded, slope: &Series) -> Vec<Bounded> {
    let rest = slope.coefficients.iter().enumerate().map(|(n, a)| *a / Bounded::exact((n + 1) as f64));
    std::iter::once(start).chain(rest).collect()
}

/// −ln(1 − δ/D), the integral of 1/(D − s).
fn logarithmic(delta: f64, distance: f64) -> f64 {
    let t = delta / distance * (1.0 + EDGE);
    if t >= 1.0 { f64::INFINITY } else { widened(-(-t).ln_1p()) }
}
