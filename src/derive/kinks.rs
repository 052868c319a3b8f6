//! The kinks of abs, min and max: located exactly where the equation solves, numerically where it has no parameters.

mod inversion;

use crate::derive::angles;
use crate::derive::angles::Positive;
use crate::derive::chain::Chain;
use crate::derive::domain::decided::decided_for_all;
use crate::derive::domain::demands;
use crate::derive::domain::located::approximate;
use crate::derive::domain::numeric_sign::numeric_sign;
use crate::eval::{BoundedAlgebra, PreciseAlgebra, Tape, WideAlgebra, constant_value};
use crate::expr::{Bindings, Condition, Expr, Function, Node, Sign, Symbol, normal, rewritten, shown_to_30_digits};
use crate::integrate::error::TransformError;
use crate::num::{Bounded, Precise, Wide};
use inversion::Crossing;
use std::cell::RefCell;

/// The largest number of kinks that are resolved in one chain.
const MOST_KINKS: usize = 200;

/// An abs, min or max with its arguments.
type Kink = (Function, Vec<Expr>);

/// A chain without abs, min and max.
pub(crate) struct Resolved {
    pub(crate) chain: Chain,
    /// The breakpoints at kinks, at which the pieces meet.
    pub(crate) kinks: Vec<Expr>,
    /// For each piece, the arguments of min and max that it does not use: f is defined only where they are, too.
    pub(crate) unused: Vec<Vec<Expr>>,
}

/// Replaces every abs, min and max that depends on r by pieces.
///
/// Of kinks without end, such as those of |sin r|, the first ones are located; a condition says how far they reach.
///
/// # Errors
/// [`TransformError::Kinks`] if a kink cannot be located.
pub(crate) fn resolve(mut chain: Chain, conditions: &mut Vec<Condition>) -> Result<Resolved, TransformError> {
    let mut kinks = Vec::new();
    let mut unused = vec![Vec::new(); chain.pieces.len()];
    for _ in 0..MOST_KINKS {
        let found = chain.pieces.iter().enumerate().find_map(|(i, piece)| Some((i, find(piece)?)));
        let Some((index, (function, arguments))) = found else { return Ok(Resolved { chain, kinks, unused }) };
        kinks.extend(split(&mut chain, &mut unused, index, function, &arguments, conditions)?);
    }
    Err(TransformError::TooManyPieces { limit: MOST_KINKS })
}

/// The summands of an expression, those without kinks together and those with the same kinks together.
pub(crate) fn groups(expr: &Expr) -> Vec<Expr> {
    let mut groups: Vec<(Option<Kink>, Vec<Expr>)> = vec![(None, Vec::new())];
    for term in expr.terms() {
        let kink = find(&term);
        match groups.iter_mut().find(|(own, _)| *own == kink) {
            Some((_, list)) => list.push(term),
            None => groups.push((kink, vec![term])),
        }
    }
    let plain_only = groups.len() == 1;
    groups.into_iter().filter(|(_, list)| plain_only || !list.is_empty()).map(|(_, list)| Expr::sum(list)).collect()
}

/// The innermost abs, min or max that depends on r.
fn find(expr: &Expr) -> Option<Kink> {
    if let Some(inner) = expr.children().into_iter().find_map(find) {
        return Some(inner);
    }
    match expr.node() {
        Node::Function(function, arguments)
            if matches!(function.name(), "abs" | "min" | "max") && arguments.iter().any(|a| a.contains(&Symbol::new("r"))) =>
        {
            Some((*function, arguments.clone()))
        }
        _ => None,
    }
}

/// Splits one piece at the sign changes of the deciding difference, which it returns. A condition says up to where they are known, if not
/// throughout.
fn split(
    chain: &mut Chain,
    unused: &mut Vec<Vec<Expr>>,
    index: usize,
    function: Function,
    arguments: &[Expr],
    conditions: &mut Vec<Condition>,
) -> Result<Vec<Expr>, TransformError> {
    let name = function.name();
    // abs(u) is u where u > 0; max(u, v) is u where u − v > 0; min(u, v) is v there.
    let (difference, above, below) = match (name, arguments) {
        ("abs", [u]) => (u.clone(), u.clone(), -u),
        ("max", [u, v]) => (u - v, u.clone(), v.clone()),
        ("min", [u, v]) => (u - v, v.clone(), u.clone()),
        _ => return Err(failure(name, "the number of arguments is wrong")),
    };
    let lower = if index == 0 { None } else { chain.breakpoints.get(index - 1).cloned() };
    let upper = chain.breakpoints.get(index).cloned();
    let Some(piece) = chain.pieces.get(index).cloned() else { return Err(failure(name, "the piece is missing")) };
    let constants = Positive::of(&difference);
    let range = [lower.as_ref().map_or(Some(0.0), number), upper.as_ref().map_or(Some(f64::INFINITY), number)];
    let found = match inversion::from_one_apex(&difference, &Symbol::new("r")) {
        Some(found) => Changes::of(found),
        None => {
            let general = sign_changes(&constants.replaced(&difference), range, name).ok();
            // Numbers may break a condition that was stated for positive constants.
            let is_met = |own: &Condition| decided_for_all(&restored(&constants, own)) != Some(false);
            match general.filter(|own| own.conditions.iter().all(is_met)) {
                Some(general) => general,
                None => sign_changes(&difference, range, name)?,
            }
        }
    };
    let Changes { roots, starts: mut positive, end, conditions: needed } = found;
    let roots: Vec<Expr> = roots.iter().map(|root| constants.restored(root)).collect();
    conditions.extend(needed.iter().map(|own| restored(&constants, own)));
    conditions.extend(angles::conditions(std::iter::once(&difference)));
    conditions.extend(end.map(|end| Condition::less(Expr::symbol("r"), end)));
    // Keep the roots inside the piece; those before it flip the sign that holds at its lower end.
    let mut inside = Vec::new();
    for root in roots {
        if let Some(lower) = &lower {
            match order(&root, lower)? {
                Sign::Positive => {}
                _ => {
                    positive = !positive;
                    continue;
                }
            }
        }
        match &upper {
            Some(upper) if order(&root, upper)? != Sign::Negative => {}
            _ => inside.push(root),
        }
    }
    let target = Expr::function(function, arguments.to_vec());
    let others = unused.get(index).cloned().unwrap_or_default();
    let (mut pieces, mut lists) = (Vec::new(), Vec::new());
    for _ in 0..=inside.len() {
        let (own, other) = if positive { (&above, &below) } else { (&below, &above) };
        pieces.push(replace(&piece, &target, own));
        // Both arguments of abs are the same up to their sign.
        let other = (arguments.len() == 2 && demands::are_made(other)).then(|| other.clone());
        lists.push(others.iter().cloned().chain(other).collect());
        positive = !positive;
    }
    chain.pieces.splice(index..=index, pieces);
    unused.splice(index..=index, lists);
    chain.breakpoints.splice(index..index, inside.iter().cloned());
    Ok(inside)
}

/// The condition with the angles that positive constants stand for.
fn restored(constants: &Positive, condition: &Condition) -> Condition {
    Condition { left: constants.restored(&condition.left), right: constants.restored(&condition.right), ..condition.clone() }
}

/// The order of two breakpoints: proven, numeric, or an error.
fn order(root: &Expr, end: &Expr) -> Result<Sign, TransformError> {
    match angles::known_sign(&(root - end)) {
        Sign::Unknown if angles::is_proven_zero(&(root - end), &Symbol::new("r")) => Ok(Sign::Zero),
        Sign::Unknown if angles::is_proven_below(root, end) => Ok(Sign::Negative),
        Sign::Unknown if angles::is_proven_below(end, root) => Ok(Sign::Positive),
        Sign::Unknown => {
            Err(crate::expr::ExprError::UnknownOrder { left: crate::print::text_expr(root), right: crate::print::text_expr(end) }.into())
        }
        known => Ok(known),
    }
}

fn failure(function: &'static str, reason: &str) -> TransformError {
    TransformError::Kinks { function, reason: reason.to_owned() }
}

/// The sign changes of an expression on r > 0.
struct Changes {
    /// Where it changes its sign, rising.
    roots: Vec<Expr>,
    /// Whether it is positive just beyond r = 0.
    starts: bool,
    /// Up to where all of them are known, if not throughout.
    end: Option<Expr>,
    /// What must hold for the parameters so that these are the changes.
    conditions: Vec<Condition>,
}

impl Changes {
    fn all(roots: Vec<Expr>, starts: bool) -> Self {
        Self { roots, starts, end: None, conditions: Vec::new() }
    }

    fn of((crossing, conditions): (Crossing, Vec<Condition>)) -> Self {
        let own = match crossing {
            Crossing::At { place, is_rising } => Self::all(vec![place], !is_rising),
            Crossing::Never { is_positive } => Self::all(Vec::new(), is_positive),
        };
        Self { conditions, ..own }
    }
}

/// The value of a breakpoint, if it has no parameters.
fn number(place: &Expr) -> Option<f64> {
    constant_value(place, &Bindings::default()).ok().map(|own| own.value)
}

/// The sign changes on r > 0. The range is that in which they are needed, where its ends are numbers.
fn sign_changes(difference: &Expr, range: [Option<f64>; 2], name: &'static str) -> Result<Changes, TransformError> {
    let radius = Symbol::new("r");
    let expanded = normal::expanded(difference, &radius)?;
    match angles::known_sign(&expanded) {
        Sign::Positive | Sign::Zero => return Ok(Changes::all(Vec::new(), true)),
        Sign::Negative => return Ok(Changes::all(Vec::new(), false)),
        Sign::Unknown => {}
    }
    let terms = normal::normal_terms(&expanded, &radius)?;
    if let [one, two] = terms.as_slice()
        && one.kernel.is_one()
        && two.kernel.is_one()
    {
        // A r^p + B r^q = 0 at r = (−A/B)^(1/(q−p)).
        let gap = &two.exponent - &one.exponent;
        let ratio = -&one.coefficient / &two.coefficient;
        match (angles::known_sign(&ratio), angles::known_sign(&gap)) {
            (Sign::Positive, Sign::Positive | Sign::Negative) => {
                let first = if angles::known_sign(&gap) == Sign::Positive { one } else { two };
                let starts = known_sign(&first.coefficient, name)?;
                return Ok(Changes::all(vec![ratio.pow(&gap.recip())], starts == Sign::Positive));
            }
            (Sign::Negative, _) => {
                let starts = known_sign(&one.coefficient, name)?;
                return Ok(Changes::all(Vec::new(), starts == Sign::Positive));
            }
            _ => {}
        }
    }
    if let [only] = terms.as_slice()
        && only.kernel.is_one()
    {
        return Ok(Changes::all(Vec::new(), known_sign(&only.coefficient, name)? == Sign::Positive));
    }
    if let Some((roots, starts)) = quadratic(&expanded, &radius) {
        return Ok(Changes::all(roots, starts));
    }
    if let Some(found) = inversion::crossing(difference, &radius) {
        return Ok(Changes::of(found));
    }
    let others: Vec<Symbol> = expanded.symbols().into_iter().filter(|s| *s != radius).collect();
    if !others.is_empty() {
        return Err(failure(name, &format!("no formula is known for their place, which depends on {}", others[0])));
    }
    isolate(&expanded, range, name)
}

fn known_sign(expr: &Expr, name: &'static str) -> Result<Sign, TransformError> {
    match angles::known_sign(expr) {
        Sign::Unknown => Err(failure(name, &format!("the sign of {} is not known", crate::print::text_expr(expr)))),
        known => Ok(known),
    }
}

/// The positive roots of a quadratic with numbers for coefficients, and whether it is positive near r = 0.
fn quadratic(expanded: &Expr, radius: &Symbol) -> Option<(Vec<Expr>, bool)> {
    let coefficients = normal::polynomial_coefficients(expanded, radius)?;
    let [c, b, a] = coefficients.as_slice() else { return None };
    let starts = numeric_sign(c)? > 0.0;
    let discriminant = b.power(2) - Expr::integer(4) * a * c;
    if numeric_sign(&discriminant)? < 0.0 {
        return Some((Vec::new(), starts));
    }
    let side = |sign: i64| (Expr::integer(sign) * discriminant.sqrt() - b) / (Expr::integer(2) * a);
    let mut roots = [side(-1), side(1)];
    if numeric_sign(a)? < 0.0 {
        roots.reverse();
    }
    let tidy = |root: Expr| normal::expanded(&root, radius).unwrap_or(root);
    let positive = roots.into_iter().map(|root| Some((numeric_sign(&root)? > 0.0, tidy(root)))).collect::<Option<Vec<_>>>()?;
    Some((positive.into_iter().filter(|(positive, _)| *positive).map(|(_, root)| root).collect(), starts))
}

/// Most kinks that are located numerically.
const MOST_LOCATED: usize = 64;
/// This many kinks are treated as a wave if their shortest distance has at least [`FINE`] steps of the scan.
const WAVE: usize = 4;
/// The fewest steps of the scan in the shortest distance of the kinks of a wave.
const FINE: f64 = 8.0;
/// A wave ends where this many of its lengths contain no kink.
const EXPECTED: f64 = 8.0;

/// The decades of r that are searched for kinks.
const SEARCH: std::ops::Range<i32> = -307..308;
/// The decades that are always scanned in [`STEPS_PER_DECADE`] steps; others are scanned only if [`needs_scan`] returns true.
const USUAL: std::ops::Range<i32> = -30..30;
/// Steps of the scan of a decade.
const STEPS_PER_DECADE: u32 = 300;
/// Maximum number of consecutive decades outside [`USUAL`] to scan; only a wave without end needs more.
const IN_A_ROW: u32 = 20;

/// Maximum error, as a share of the expression at usual radii, that cancellation explains; overflow leaves far larger ones.
const SMALL: f64 = 1e-6;

/// Sign changes of an expression in r alone: a logarithmic scan, then bisection to the last bit.
fn isolate(expr: &Expr, range: [Option<f64>; 2], name: &'static str) -> Result<Changes, TransformError> {
    let radius = [Symbol::new("r")];
    let tape = Tape::compile(std::slice::from_ref(expr), &radius)?;
    let precise = Tape::compile(&[shown_to_30_digits(expr)], &radius)?;
    let unknown = Bounded::exact(f64::NAN);
    let is_known = |own: &Bounded| own.value.abs() > own.error;
    let slots = RefCell::new(Vec::new());
    let in_doubles = |r: f64| tape.run(&mut BoundedAlgebra, &[Bounded::exact(r)], &mut slots.borrow_mut()).unwrap_or(unknown);
    let size = [1e-6, 1e-3, 1.0, 1e3].map(|r| in_doubles(r).value.abs()).into_iter().filter(|size| size.is_finite()).fold(0.0, f64::max);
    let value = |r: f64| {
        let own = in_doubles(r);
        let is_usual = || USUAL.contains(&(r.log10().floor() as i32));
        // Exponents without end do not help against cancellation, as in ln(1 + r) − r near the axis.
        if is_known(&own) || underflows(&own) || (own.is_finite() && (own.error <= SMALL * size || is_usual())) {
            return own;
        }
        // Squares of such radii, or constants, leave the range of doubles.
        let wide = precise.run(&mut WideAlgebra, &[Wide::new(Precise::exact(r))], &mut Vec::new());
        wide.map(|own| own.precise().bounded()).filter(is_known).unwrap_or(own)
    };
    // Where doubles leave the sign open.
    let sharper = |r: f64| {
        let own = precise.run(&mut PreciseAlgebra, &[Precise::exact(r)], &mut Vec::new()).map(|own| own.bounded());
        own.unwrap_or(unknown)
    };
    let mut in_a_row = 0;
    let mut places = SEARCH.flat_map(|decade| {
        let is_usual = USUAL.contains(&decade);
        in_a_row = if is_usual || !needs_scan(&value, decade) { 0 } else { in_a_row + 1 };
        let steps = if is_usual || (1..=IN_A_ROW).contains(&in_a_row) { STEPS_PER_DECADE } else { 1 };
        (0..steps).map(move |step| 10f64.powf(f64::from(decade) + f64::from(step) / f64::from(steps)))
    });
    let mut roots: Vec<f64> = Vec::new();
    let mut end = None;
    let (mut starts, mut before) = (None, None);
    let mut next = places.next();
    let mut r = 0.0;
    while let Some(wide) = next {
        // Kinks that come one after another are those of a wave, which steps as wide as its length would pass over.
        let fine = narrow_step(&roots, r).map_or(f64::INFINITY, |by| r + by);
        if wide <= fine {
            next = places.next();
        }
        r = if wide <= r { continue } else { wide.min(fine) };
        let own = value(r);
        if own.value.is_nan() {
            // The argument's domain ends here, or it overflows on both sides of a difference.
            break;
        }
        // The result is unknown here unless the sign is certain.
        if own.value.abs() <= own.error {
            continue;
        }
        let positive = own.value > 0.0;
        starts.get_or_insert(positive);
        if let Some((left, was, size)) = before
            && was != positive
        {
            let mut sure = |r: f64| Some(value(r)).filter(|own| own.value.abs() > own.error).unwrap_or_else(|| sharper(r));
            let root = bisect(&mut sure, left, r, was);
            let (below, above) = (sure(root * (1.0 - SHARP)), sure(root * (1.0 + SHARP)));
            let is_pole = below.value.abs().min(above.value.abs()) > own.value.abs().max(size);
            if is_pole {
                let [Some(from), Some(to)] = range else {
                    return Err(failure(name, &format!("its argument has a pole near r = {root:?}")));
                };
                if root >= to * (1.0 - SHARP) {
                    break;
                }
                if root > from * (1.0 + SHARP) {
                    // The profile ends at the pole.
                    end = Some(located(root, name)?);
                    break;
                }
                starts = starts.map(|own| !own);
                before = Some((r, positive, own.value.abs()));
                continue;
            }
            let certain = below.value.abs() > below.error && above.value.abs() > above.error;
            if !certain || (below.value > 0.0) == (above.value > 0.0) {
                return Err(failure(name, &format!("the one near r = {root:?} is not sharp enough in double precision")));
            }
            if roots.len() >= MOST_LOCATED {
                end = Some(located(left, name)?);
                break;
            }
            roots.push(root);
        }
        before = Some((r, positive, own.value.abs()));
    }
    match starts {
        Some(starts) => {
            let roots = roots.into_iter().map(|root| located(root, name)).collect::<Result<_, _>>()?;
            Ok(Changes { end, ..Changes::all(roots, starts) })
        }
        None => Err(failure(name, "the sign of its argument is known nowhere")),
    }
}

/// Returns false if six values within the decade of r have one sign and lie on a power law. A feature between them is missed.
fn needs_scan(value: &impl Fn(f64) -> Bounded, decade: i32) -> bool {
    const LOOKS: u32 = 5;
    const STRAIGHT: f64 = 1e-3;
    let found: Vec<Bounded> = (0..=LOOKS).map(|look| value(10f64.powf(f64::from(decade) + f64::from(look) / f64::from(LOOKS)))).collect();
    if found.iter().all(underflows) || [f64::INFINITY, -f64::INFINITY].iter().any(|beyond| found.iter().all(|own| own.value == *beyond)) {
        return false;
    }
    let first = found.first().is_some_and(|own| own.value > 0.0);
    if found.iter().any(|own| !own.is_finite() || own.value.abs() <= own.error || (own.value > 0.0) != first) {
        return true;
    }
    let sizes: Vec<f64> = found.iter().map(|own| own.value.abs().ln()).collect();
    let bends = sizes.windows(3).map(|own| if let [a, b, c] = own { (a - b) - (b - c) } else { 0.0 });
    bends.fold(0.0, |largest: f64, bend| largest.max(bend.abs())) > STRAIGHT
}

/// Returns true if the value is below the smallest normal number.
fn underflows(own: &Bounded) -> bool {
    own.value.abs() + own.error < f64::MIN_POSITIVE
}

/// The step of the scan beyond the last of several kinks, for as long as more of them are to be expected.
fn narrow_step(roots: &[f64], r: f64) -> Option<f64> {
    let last = roots.get(roots.len().checked_sub(WAVE)?..)?;
    let gap = last.windows(2).filter_map(|pair| Some(pair.get(1)? - pair.first()?)).fold(f64::INFINITY, f64::min);
    let beyond = r - last.last()?;
    let whole = last.last()? - last.first()?;
    (beyond <= EXPECTED * whole).then_some(gap / FINE)
}

/// A place that was found numerically.
fn located(place: f64, name: &'static str) -> Result<Expr, TransformError> {
    approximate(place).ok_or_else(|| failure(name, "a kink lies out of range"))
}

/// Half of the relative width within which a located kink must lie: 30 ulps.
const SHARP: f64 = 30.0 * f64::EPSILON;

fn bisect(value: &mut impl FnMut(f64) -> Bounded, mut lower: f64, mut upper: f64, positive_below: bool) -> f64 {
    for _ in 0..120 {
        let middle = lower + 0.5 * (upper - lower);
        if middle <= lower || middle >= upper {
            break;
        }
        if (value(middle).value > 0.0) == positive_below {
            lower = middle;
        } else {
            upper = middle;
        }
    }
    upper
}

/// The expression with every occurrence of `target` replaced.
fn replace(expr: &Expr, target: &Expr, by: &Expr) -> Expr {
    rewritten(expr, &|own, _| (own == target).then(|| by.clone()))
}
