//! The pressure under straight pieces of f: the elliptic kernel and one arc integral for every kink.

use crate::integrate::ask::STRAIGHT;
use crate::integrate::integral::{NumericProfile, NumericSegment, with_ulps};
use crate::integrate::pressure::direct::{Jump, kernel_at};
use crate::integrate::source::endpoint::Endpoint;
use crate::num::spectral::rule;
use crate::num::{Bounded, Estimate, stable, work};

/// Nodes of a panel, and its length in t.
const NODES: usize = 16;
const PANEL: f64 = 1.2;
/// Steps of work of a kink besides its nodes, and of a node.
const KINK: u64 = 20;
const NODE: u64 = 7;
/// The largest error of an arc integral in halves of an ulp, and how it grows with the end of t, whose rounding counts; 4,000 differences
/// from 40 digits are below two thirds of it.
const ROUNDING: (f64, f64) = (24.0, 4.0);
/// The same of arcosh(a/s).
const ULPS: f64 = 8.0;

impl NumericProfile {
    /// ∫_s^a g′/√(x²−s²) dx if f is straight on every segment: Σ δ (b K(b, s) + J(b, s)) over the jumps δ of f′ at b, where
    /// J(b, s) = ∫_M^a arccos(b/x)/√(x²−s²) dx and M = max(b, s).
    ///
    /// `None` if f′ is not constant on a segment, and where the pressure is infinite.
    pub(crate) fn pressure_of_straight_pieces(&self, s: f64, a: f64) -> Option<Estimate> {
        if !(s < a && a.is_normal() && self.segments.iter().all(NumericSegment::is_straight)) {
            return None;
        }
        let mut total = Bounded::exact(0.0);
        let from_axis: Vec<&NumericSegment> = self.segments.iter().filter(|own| own.lower.value == 0.0).collect();
        if !from_axis.is_empty() {
            if s == 0.0 {
                return None;
            }
            // arcosh(a/s) by the distance to the edge.
            let unit = (a - s) / s;
            let arc = stable::asinh(unit.sqrt() * (2.0 + unit).sqrt());
            let slope = from_axis.iter().fold(Bounded::exact(0.0), |sum, own| sum + own.f_prime_at(0.0));
            total = slope * with_ulps(std::f64::consts::FRAC_PI_2 * arc, ULPS);
        }
        for Jump { at, end, height } in self.jumps(a) {
            if height.value == 0.0 && height.error == 0.0 {
                continue;
            }
            if at.value == s {
                return None;
            }
            let kernel = kernel_at(end, s, a);
            let arc = arc_integral(end, s, a);
            // ∂J/∂b = −K(b, s).
            let moved = if end.doubt == 0.0 { 0.0 } else { end.doubt * (kernel.value.abs() + kernel.error) };
            total = total + height * (at * kernel + Bounded { error: arc.error + moved, ..arc });
        }
        total.is_finite().then(|| Estimate::from_bounded(total, 0).by(STRAIGHT))
    }
}

impl NumericSegment {
    /// Returns true if f′ is known to be constant.
    fn is_straight(&self) -> bool {
        self.source.as_ref().is_some_and(|(f_prime, _)| f_prime.symbols().is_empty())
    }
}

/// J(b, s) = ∫_M^a arccos(b/x)/√(x²−s²) dx, M = max(b, s), for s ≠ b.
///
/// With x = M cosh u and cos ε = m/M, m = min(b, s), it is the integral up to arcosh(a/M) of arccos(cos ε/cosh u) if b < s, and of
/// gd(u)/√(1 + sin²ε/sinh²u) if s < b, gd(u) = 2 arctan tanh(u/2).
/// Over t, u = ε sinh t, both are analytic for |Im t| < π/2.
/// On the ellipse of half-height 1.2 around a panel, their largest value is at most 140 times the mean over the panel, so that the
/// error of 16 Gauss nodes is below 3e-18 of the integral.
fn arc_integral(b: Endpoint, s: f64, a: f64) -> Bounded {
    let place = Endpoint::exact(s);
    let is_beyond = place.to(b) > 0.0;
    let (big, small) = if is_beyond { (b.at, s) } else { (s, b.at) };
    let (gap, edge) = (place.to(b).abs(), if is_beyond { b } else { place }.to(Endpoint::exact(a)));
    if edge <= 0.0 {
        return Bounded::exact(0.0);
    }
    let (ratio, unit) = (small / big, edge / big);
    let sine = (gap / big * (1.0 + ratio)).sqrt();
    let epsilon = sine.atan2(ratio);
    let end = stable::asinh(stable::asinh(unit.sqrt() * (2.0 + unit).sqrt()) / epsilon);
    let panels = (end / PANEL).ceil().max(1.0);
    let (length, rule) = (end / panels, rule(NODES, 0.0));
    work::spend(KINK + NODE * NODES as u64 * panels as u64);
    let mut sum = 0.0;
    for panel in 0..panels as u32 {
        for node in rule.nodes() {
            let t = length * (f64::from(panel) + node.unit);
            let (u, stretch) = (epsilon * t.sinh(), t.cosh());
            let height = if is_beyond {
                2.0 * (0.5 * u).tanh().atan() / (1.0 + (sine / u.sinh()).powi(2)).sqrt()
            } else {
                u.sinh().hypot(sine).atan2(ratio)
            };
            sum += node.share * height * stretch;
        }
    }
    let (at_least, for_each) = ROUNDING;
    with_ulps(length * epsilon * sum, at_least + for_each * end)
}
