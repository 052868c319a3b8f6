//! The waves of a profile, which searches over radii must resolve.

use crate::derive::profile::Profile;
use crate::eval::constant_value;
use crate::evaluate::evaluator::Evaluator;
use crate::expr::{Bindings, Expr, Node, Number, Symbol, derivative};
use std::f64::consts::TAU;

/// Functions that oscillate in their last argument.
const OSCILLATING: &[&str] = &["sin", "cos", "besselj", "struveh", "clsin"];

/// The wave numbers of f: the derivatives with respect to r of the phases of its oscillating functions.
pub(crate) fn wave_numbers(profile: &Profile) -> Vec<Expr> {
    let r = Symbol::new("r");
    let mut numbers: Vec<Expr> = Vec::new();
    for piece in profile.chains.iter().flat_map(|own| &own.pieces) {
        for part in piece.parts() {
            let Node::Function(function, arguments) = part.node() else { continue };
            let phase = arguments.last().filter(|own| OSCILLATING.contains(&function.name()) && own.contains(&r));
            let number = phase.and_then(|own| derivative(own, &r).ok()).filter(|own| !own.is_zero());
            numbers.extend(number.filter(|own| !numbers.contains(own)));
        }
    }
    numbers
}

impl Evaluator<'_> {
    /// The length of the shortest wave of f at a radius; infinite if f has no waves there.
    pub(crate) fn shortest_wave(&self, r: f64) -> f64 {
        let numbers = self.waves.get_or_init(|| wave_numbers(&self.solution.profile));
        if numbers.is_empty() {
            return f64::INFINITY;
        }
        let Some(place) = Number::from_f64(r) else { return f64::INFINITY };
        let radius = Bindings::one("r", Expr::number(place));
        let value = |own: &Expr| constant_value(&radius.apply(own), &self.bindings).map_or(0.0, |own| own.value.abs());
        TAU / numbers.iter().map(value).fold(0.0, f64::max)
    }
}
