//! Families over one quadratic Q = ρ² ± r²: its powers, and its logarithm, arctangent and arcsine, times powers of r.

pub(super) mod arcs;
pub(super) mod binomial;
mod laurent;
pub(super) mod logarithm;
mod moments;
mod pieces;
pub(super) mod pole;
mod pressure;
pub(super) mod roots;

use crate::derive::rule::{Answer, Branches, Pair, Parameter, Rule};
use crate::derive::rules::reading;
use crate::derive::term::Term;
use crate::expr::normal::{self, NormalTerm};
use crate::expr::{Condition, Expr, Sign, sign};
use crate::integrate::segment::Segment;
use laurent::Values;
use moments::{Family, Kernel, Moment, Piece};
use pieces::{Field, MomentRange};

const H: Parameter = Parameter { name: "h", lowest: 0.1, highest: 4.0 };
const W: Parameter = Parameter { name: "w", lowest: 0.5, highest: 4.0 };
const R: Parameter = Parameter { name: "R", lowest: 3.2, highest: 6.0 };
const B: Parameter = Parameter { name: "b", lowest: 0.2, highest: 2.0 };
const C: Parameter = Parameter { name: "c", lowest: 0.2, highest: 2.0 };

const RECURRENCE: &str = "recurrence in the exponent";

/// An empty rule, used as the base for rules with common fields.
const BLANK: Rule = Rule {
    id: "",
    title: "",
    pattern: "",
    equivalent: "",
    force: "",
    pressure: None,
    parameters: &[H],
    guard: "",
    reference: &[],
    specializes: None,
    apply: |_| None,
};

/// c·r^m·(kernel over Q), as a rule reads it from a term.
struct Reading {
    /// c, including the factor from the size of the quadratic.
    coefficient: Expr,
    /// m.
    exponent: i64,
    field: Field,
    conditions: Vec<Condition>,
}

/// The two kinds of segment that a rule may be for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Extent {
    /// The whole axis.
    Whole,
    /// Anything else.
    Segment,
}

impl Extent {
    fn fits(self, segment: &Segment) -> bool {
        segment.is_whole() == (self == Self::Whole)
    }
}

/// σ, ρ² and |β| of α + β r² with α > 0: Q = |β|(ρ² + σr²).
fn field(base: &Expr) -> Option<(Field, Expr, Vec<Condition>)> {
    let (alpha, beta) = reading::quadratic(base)?;
    let (sigma, magnitude) = match sign(&beta) {
        Sign::Positive => (1, beta),
        Sign::Negative => (-1, -beta),
        Sign::Zero | Sign::Unknown => return None,
    };
    let conditions = reading::positive(&alpha)?;
    Some((Field { sigma, square_length: alpha / &magnitude }, magnitude, conditions))
}

/// Reads c r^m (α + βr²)^p with whole m, and the exponent p.
fn power(part: &NormalTerm) -> Option<(Reading, Expr)> {
    let (base, exponent) = reading::power(&part.kernel);
    let (field, magnitude, conditions) = field(&base)?;
    let coefficient = &part.coefficient * magnitude.pow(&exponent);
    Some((Reading { coefficient, exponent: part.exponent.as_integer()?, field, conditions }, exponent))
}

/// How ∫_r^a g′/√(x²−r²) dx closes, for a coefficient of 1.
type Pressure = fn(&Moment, &Field) -> Option<Branches>;

/// One family at work: which moment is which combination, and of which pieces.
struct Work<'a> {
    reading: Reading,
    segment: &'a Segment,
    /// The family of the power itself, or of the kernel's derivative.
    family: Family,
    kernel: Option<Kernel>,
}

impl Work<'_> {
    /// x ∫ f′/√(x²−r²) dr and ∫ r² f′/√(a²−r²) dr from the moments of r^m and r^(m+2), and the pressure where it closes.
    fn answer(self, moment: impl Fn(i64) -> Option<Moment>, pressure: Option<Pressure>) -> Option<Answer> {
        let m = self.reading.exponent;
        let own = moment(m)?;
        let equivalent = self.branches("x", &own.times(laurent::Variable::X, 1));
        let force = self.branches("a", &moment(m + 2)?);
        let Reading { coefficient, field, conditions, .. } = self.reading;
        let pressure = pressure.and_then(|close| close(&own, &field)).map(|found| found.scaled(&coefficient));
        Some(Answer { equivalent, force, pressure, conditions })
    }

    fn branches(&self, name: &str, form: &Moment) -> Branches {
        let pair =
            |upper: Option<&Expr>| Pair { shown: self.value(name, form, upper, false), evaluated: self.value(name, form, upper, true) };
        let within = pair(None);
        match &self.segment.upper {
            Some(upper) => Branches { within, beyond: pair(Some(upper)) },
            None => Branches::endless(within),
        }
    }

    /// The sum over the pieces, their common factor taken out.
    fn value(&self, name: &str, form: &Moment, upper: Option<&Expr>, stable: bool) -> Expr {
        let lower = &self.segment.lower;
        let place = MomentRange { field: &self.reading.field, x: Expr::symbol(name), lower, upper, stable };
        let values = |end: &Expr| Values {
            x: place.x.clone(),
            square_length: self.reading.field.square_length.clone(),
            end: end.clone(),
            sigma: self.reading.field.sigma,
        };
        // The derivative of the logarithm has one more factor r.
        let odd = (self.reading.exponent % 2 != 0) != (matches!(self.kernel, Some(Kernel::Arctangent | Kernel::Arcsine)));
        let mut root = form.at(Piece::Root);
        if self.family.half && !odd && place.needs_algebraic_term() {
            let own = form.at(Piece::Second).times(laurent::Variable::End, 1).times(laurent::Variable::AtEnd, -1);
            root = root.plus(&own.scaled(self.reading.field.sigma, 1));
        }
        let constant = |piece: Piece| form.at(piece).at_axis().to_expr(&values(&Expr::zero()));
        let mut terms = Vec::new();
        let mut add = |coefficient: Expr, piece: &dyn Fn() -> Expr| {
            if !coefficient.is_zero() {
                terms.push(&self.reading.coefficient * coefficient * piece());
            }
        };
        if let (Some(kernel), true) = (self.kernel, self.segment.is_whole()) {
            add(constant(Piece::Kernel), &|| place.whole_kernel(kernel));
        }
        add(constant(Piece::First), &|| place.first(self.family, odd));
        add(constant(Piece::Second), &|| place.second(self.family, odd));
        for (end, direction) in std::iter::once((lower, 1)).chain(upper.map(|end| (end, -1))) {
            let at_end = |own: &laurent::Laurent| {
                let own = if end.is_zero() { own.at_axis() } else { own.clone() };
                own.scaled(direction, 1).to_expr(&values(end))
            };
            let side = if self.family.half { place.root(end) } else { Expr::one() };
            add(at_end(&root), &|| place.leg(end) * &side);
            if let Some(kernel) = self.kernel.filter(|_| !end.is_zero()) {
                add(at_end(&form.at(Piece::KernelRoot)), &|| place.leg(end) * place.kernel(kernel, end));
            }
        }
        let (content, rest) = normal::common_content(&terms);
        content * Expr::sum(rest)
    }
}

/// The kernel rules: r^m K with K over α = 1.
fn kernel(term: &Term, kernel: Kernel, extent: Extent, read: impl Fn(&Expr) -> Option<(Expr, Field)>) -> Option<Answer> {
    let part = term.single()?;
    if !extent.fits(&term.segment) {
        return None;
    }
    let exponent = part.exponent.as_integer()?;
    let (factor, field) = read(&part.kernel)?;
    let odd = exponent % 2 != 0;
    if extent == Extent::Segment && !odd {
        return None;
    }
    let sigma = field.sigma;
    let reading = Reading { coefficient: &part.coefficient * factor, exponent, field, conditions: Vec::new() };
    let work = Work { reading, segment: &term.segment, family: kernel.family(sigma), kernel: Some(kernel) };
    let closes = odd && kernel == Kernel::Arctangent && extent == Extent::Whole;
    work.answer(|m| kernel.moment(sigma, m), closes.then_some(pressure::elliptic))
}
