//! Names for the parts of formulas that are too wide for their line.

use super::Notation;
use crate::expr::{Bindings, Expr, Formula, Node, Number, Symbol, rewritten, shown_as_mathematics};
use std::collections::{BTreeSet, HashMap};

/// Maximum number of names for one formula.
const MOST_NAMES: usize = 48;
/// Parts that are not wider than this many letters get no name.
const NARROW: usize = 8;
/// Expressions with more nodes than this are left as they are.
const SIZE: usize = 10_000;
/// Letters for names, in the order in which they are taken.
const LETTERS: [&str; 10] = ["q", "s", "t", "v", "w", "y", "z", "h", "c", "n"];

/// Names for parts of formulas that are too wide for a line, each defined once.
///
/// ```
/// use sneddon_expr::{parse, print::{Names, Notation}};
/// let wide = parse::formula("sqrt(a^2 - r^2)*(b + sqrt(a^2 - r^2))/(c + sqrt(a^2 - r^2))").unwrap();
/// let (short, parts) = Names::avoiding(["p"]).shortened(&wide, Notation::Text, 20);
/// assert_eq!(Notation::Text.formula(&short), "q/(c + q)*(b + q)");
/// assert_eq!(parts.len(), 1);
/// assert_eq!((parts[0].0.as_str(), Notation::Text.formula(&parts[0].1)), ("q", "sqrt(a^2 - r^2)".to_owned()));
/// ```
#[derive(Clone, Debug, Default)]
pub struct Names {
    taken: BTreeSet<String>,
    known: Vec<(Expr, Symbol)>,
}

impl Names {
    /// No names yet; these are taken.
    pub fn avoiding<'n>(taken: impl IntoIterator<Item = &'n str>) -> Self {
        Self { taken: taken.into_iter().map(str::to_owned).collect(), known: Vec::new() }
    }

    /// Excludes a name.
    pub fn avoid(&mut self, name: &str) {
        self.taken.insert(name.to_owned());
    }

    /// Excludes the symbols of a formula, and m where it contains elliptic integrals, because m is their parameter.
    pub fn avoid_symbols(&mut self, formula: &Formula) {
        for expr in formula.expressions() {
            self.taken.extend(expr.symbols().iter().map(|own| own.name().to_owned()));
            let has_parameter = expr.size_up_to(SIZE) < SIZE && has_elliptic(expr);
            self.taken.extend(has_parameter.then(|| "m".to_owned()));
        }
    }

    /// The formula with names for parts if one of its lines is wider than `width` letters, and the definitions of the names that are new.
    ///
    /// A part of an integrand that contains the variable of integration is named as a function of it, as q(x). Replacing the names by
    /// their definitions restores the formula.
    pub fn shortened(&mut self, right: &Formula, notation: Notation, width: usize) -> (Formula, Vec<(String, Formula)>) {
        let fits = |own: &Formula| notation.widest(own, width) <= width;
        let small = |own: &Formula| own.expressions().into_iter().map(|expr| expr.size_up_to(SIZE)).sum::<usize>() < SIZE;
        if fits(right) || !small(right) {
            return (right.clone(), Vec::new());
        }
        let mut shown = right.map(&shown_as_mathematics);
        for (part, name) in &self.known {
            shown = with_name(&shown, part, name);
        }
        let variables = variables(right);
        let mut new: Vec<(Symbol, Formula)> = Vec::new();
        let mut refused = Vec::new();
        while new.len() < MOST_NAMES {
            let all = || std::iter::once(&shown).chain(new.iter().map(|(_, own)| own));
            let formulas: Vec<&Formula> = all().collect();
            // A formula without a part to be named may stay wide; the others are shortened all the same.
            let mut wide = all().filter(|own| !fits(own));
            let Some(part) = wide.find_map(|own| best_part(own, &formulas, &refused, notation, width)) else { break };
            let letter = self.letter_for(&part);
            // Also through other names, as in M(s)² − r².
            let inner = with_definitions(&part, &self.known);
            let arguments: Vec<&str> = variables.iter().filter(|own| inner.contains(own)).map(Symbol::name).collect();
            let name =
                if arguments.is_empty() { Symbol::new(&letter) } else { Symbol::new(&format!("{letter}({})", arguments.join(", "))) };
            let restored = Bindings::one(name.name(), part.clone());
            let changed: Vec<Formula> = all().map(|own| with_name(own, &part, &name)).collect();
            // A root of a square of the name is not the name if the part may be negative.
            if all().zip(&changed).any(|(before, after)| after.substitute(&restored) != *before) {
                self.taken.remove(&letter);
                refused.push(part);
                continue;
            }
            let mut changed = changed.into_iter();
            shown = changed.next().unwrap_or(shown);
            new = new.into_iter().zip(changed).map(|((own, _), definition)| (own, definition)).collect();
            self.known.push((part.clone(), name.clone()));
            new.push((name, part.into()));
        }
        (shown, new.into_iter().map(|(name, definition)| (name.name().to_owned(), definition)).collect())
    }

    /// The letter for a part: M for a maximum, m or n for a minimum, φ for an angle, else the next free letter.
    fn letter_for(&mut self, part: &Expr) -> String {
        let usual: &[&str] = match part.node() {
            Node::Function(function, _) => match function.name() {
                "max" => &["M"],
                "min" => &["m", "n"],
                "asin" | "acos" | "atan" => &["phi", "psi", "chi"],
                _ => &[],
            },
            _ => &[],
        };
        let letters = usual.iter().chain(&LETTERS).map(|own| (*own).to_owned());
        let numbered = (1..).map(|index| format!("q_{index}"));
        let name = letters.chain(numbered).find(|own| !self.taken.contains(own)).unwrap_or_default();
        self.taken.insert(name.clone());
        name
    }
}

/// The part with the definitions of the names in it, the last of which may contain those before.
fn with_definitions(part: &Expr, known: &[(Expr, Symbol)]) -> Expr {
    let all: Bindings = known.iter().map(|(definition, name)| (name.name(), definition.clone())).collect();
    let mut whole = part.clone();
    for _ in known {
        if whole.symbols().iter().all(|own| all.get(own).is_none()) {
            break;
        }
        whole = all.apply(&whole);
    }
    whole
}

/// The variables of integration of a formula.
fn variables(formula: &Formula) -> BTreeSet<Symbol> {
    let (mut found, mut left) = (BTreeSet::new(), formula.integrals());
    while let Some((integrand, variable)) = left.pop() {
        found.insert(variable.clone());
        left.extend(integrand.integrals());
    }
    found
}

fn has_elliptic(expr: &Expr) -> bool {
    expr.parts().any(|own| matches!(own.node(), Node::Function(function, _) if function.name().starts_with("ellip")))
}

/// The part of `wide` to be named next: a maximum or minimum that is repeated, else what saves most of all that is repeated, else the part
/// that divides it most evenly.
fn best_part(wide: &Formula, all: &[&Formula], refused: &[Expr], notation: Notation, width: usize) -> Option<Expr> {
    // In the order in which they occur, so that the same formula has the same names every time.
    let (mut counted, mut places): (Vec<(Expr, usize)>, HashMap<Expr, usize>) = Default::default();
    for formula in all {
        each_part(formula, &mut |part| match places.get(&part).and_then(|place| counted.get_mut(*place)) {
            Some(own) => own.1 += 1,
            None if refused.contains(&part) => {}
            None => {
                places.insert(part.clone(), counted.len());
                counted.push((part, 1));
            }
        });
    }
    let breadth = |part: &Expr| notation.breadth(&part.clone().into());
    let is_extreme = |part: &Expr| matches!(part.node(), Node::Function(function, _) if matches!(function.name(), "max" | "min"));
    if let Some((part, _)) = counted.iter().find(|(part, count)| *count > 1 && is_extreme(part)) {
        return Some(part.clone());
    }
    let repeated = counted.iter().filter(|own| own.1 > 1).map(|(part, count)| (part, (count - 1) * breadth(part).saturating_sub(1)));
    if let Some((part, _)) = repeated.filter(|(part, _)| breadth(part) > NARROW).max_by_key(|own| own.1) {
        return Some(part.clone());
    }
    let whole = notation.widest(wide, width);
    let mut best: Option<(usize, Expr)> = None;
    each_part(wide, &mut |part| {
        let own = breadth(&part);
        let even = own.min(whole.saturating_sub(own));
        let is_new = !refused.contains(&part) && wide.as_closed() != Some(&part);
        if is_new && even > NARROW && best.as_ref().is_none_or(|known| even > known.0) {
            best = Some((even, part));
        }
    });
    best.map(|own| own.1)
}

/// Calls `each` for every part that may have a name: not a bare symbol or number. Parts of integrands may contain the variable.
fn each_part(formula: &Formula, each: &mut impl FnMut(Expr)) {
    formula.expressions().into_iter().for_each(|expr| each_in(expr, each));
}

fn each_in(expr: &Expr, each: &mut impl FnMut(Expr)) {
    if expr.children().is_empty() {
        return;
    }
    if !expr.symbols().is_empty() {
        match expr.node() {
            // The inverse and odd powers of a root are powers of its name.
            Node::Power(base, exponent) => {
                if let Some(root) = exponent.as_number().map(root_of) {
                    root.into_iter().for_each(|root| each(base.pow(&Expr::number(root))));
                } else {
                    each(expr.clone());
                }
            }
            // Products and sums are named as a whole only.
            _ => each(expr.clone()),
        }
    }
    expr.children().into_iter().for_each(|child| each_in(child, each));
}

/// 1/n for an exponent m/n that is not whole.
fn root_of(exponent: &Number) -> Option<Number> {
    let (_, denominator) = exponent.abs().printed_parts();
    if denominator.is_one() { None } else { denominator.reciprocal() }
}

/// The formula with a name in place of a part.
fn with_name(formula: &Formula, part: &Expr, name: &Symbol) -> Formula {
    let name = Expr::from(name.clone());
    formula.map(&|expr| with_name_in(expr, part, &name))
}

fn with_name_in(expr: &Expr, part: &Expr, name: &Expr) -> Expr {
    rewritten(expr, &|own, _| match (own.node(), part.node()) {
        _ if own == part => Some(name.clone()),
        (Node::Power(base, exponent), Node::Power(other, root)) if base == other => (exponent / root).as_integer().map(|n| name.power(n)),
        _ => None,
    })
}
