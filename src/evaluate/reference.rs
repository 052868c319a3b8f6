//! Reference values: every quantity by the double-exponential rule with 30 digits, independent of closed forms and of the fast
//! rules.

use crate::derive::profile::Profile;
use crate::derive::superposed::Superposed;
use crate::eval::{PreciseAlgebra, Tape, precise_value};
use crate::expr::{Bindings, Expr, Symbol, derivative};
use crate::integrate::error::TransformError;
use crate::integrate::integral::compile_shifted;
use crate::num::precise::DoubleExponential;
use crate::num::special::rf_precise;
use crate::num::{DoubleDouble, Precise};

/// A profile whose parameters have numbers, ready for slow integrals with about 30 digits.
///
/// ```
/// use sneddon::{parse, transform::{PreciseProfile, Profile, Superposed}};
/// let profile = Profile::new(&parse::profile("r^2.5").unwrap()).unwrap();
/// let precise = PreciseProfile::new(&profile).unwrap();
/// // F/(2E*) of r^n is n/(n+1) times g(a) a
/// let (g, force) = (precise.value(Superposed::Equivalent, &[1.0]).unwrap(), precise.value(Superposed::Force, &[1.0]).unwrap());
/// assert!((force.value.hi / g.value.hi - 2.5 / 3.5).abs() < 1e-15 && g.error < 1e-25);
/// ```
pub struct PreciseProfile {
    segments: Vec<PreciseSegment>,
    rule: DoubleExponential,
}

/// f′ and (r f′)′ over the distance to the lower end.
struct PreciseSegment {
    lower: Precise,
    upper: Option<Precise>,
    f_prime: Tape,
    bend: Option<Tape>,
}

impl PreciseProfile {
    /// Compiles f′ on every interval of the profile.
    ///
    /// # Errors
    /// [`TransformError::Evaluation`] if a parameter has no value.
    pub fn new(profile: &Profile) -> Result<Self, TransformError> {
        let radius = Symbol::new("r");
        let none = Bindings::default();
        let mut segments = Vec::new();
        for chain in &profile.chains {
            for ((lower, upper, _), f_prime) in chain.intervals().zip(chain.f_primes()?) {
                if f_prime.is_zero() {
                    continue;
                }
                let bend = derivative(&(Expr::symbol("r") * &f_prime), &radius).ok();
                segments.push(PreciseSegment {
                    lower: precise_value(&lower, &none)?,
                    upper: upper.map(|upper| precise_value(upper, &none)).transpose()?,
                    f_prime: compile_shifted(&f_prime, &lower)?,
                    bend: bend.map(|bend| compile_shifted(&bend, &lower)).transpose()?,
                });
            }
        }
        Ok(Self { segments, rule: DoubleExponential::new() })
    }

    /// g(x) at `[x]`, F/(2E*) at `[a]`, p π/E* at `[r, a]`; `None` for other quantities and where nothing is known.
    ///
    /// The bound holds rounding rigorously, and what the rule leaves out by the difference of its last two levels.
    pub fn value(&self, quantity: Superposed, inputs: &[f64]) -> Option<Precise> {
        let found = match (quantity, inputs) {
            (Superposed::Equivalent, [x]) => self.over_radius(*x, |_| Precise::exact(*x)),
            (Superposed::Force, [a]) => self.over_radius(*a, |r| r.mul(r)),
            (Superposed::Pressure, [r, a]) if r < a => self.pressure(*r, *a)?,
            _ => return None,
        };
        found.is_finite().then_some(found)
    }

    /// ∫₀^x f′(r) weight(r)/√(x² − r²) dr.
    fn over_radius(&self, x: f64, weight: impl Fn(Precise) -> Precise) -> Precise {
        let edge = Precise::exact(x);
        let mut total = Precise::exact(0.0);
        for segment in self.segments.iter().filter(|segment| segment.lower.value.hi < x) {
            let end = segment.end(x);
            let (length, beyond) = (end.sub(segment.lower), edge.sub(end));
            let mut slots = Vec::new();
            let value = self.rule.integrate(|q, rest| {
                let delta = length.mul(q);
                let r = segment.lower.add(delta);
                let Some(f_prime) = segment.f_prime.run(&mut PreciseAlgebra, &[delta], &mut slots) else { return Precise::nan() };
                let root = beyond.add(length.mul(rest)).mul(edge.add(r)).sqrt();
                f_prime.mul(weight(r)).div(root)
            });
            total = total.add(value.mul(length));
        }
        total
    }

    /// ∫₀^a (r f′)′ K(r, s) dr + Σ b δ K(b, s), δ the jump of f′ at b.
    fn pressure(&self, s: f64, a: f64) -> Option<Precise> {
        let (place, edge) = (Precise::exact(s), Precise::exact(a));
        let mut total = Precise::exact(0.0);
        for segment in self.segments.iter().filter(|segment| segment.lower.value.hi < a) {
            let bend = segment.bend.as_ref()?;
            let end = segment.end(a);
            if segment.lower.value.hi > 0.0 {
                total = total.add(segment.jump(segment.lower, s, a)?);
            }
            if end.value.hi < a {
                total = total.sub(segment.jump(end, s, a)?);
            }
            let mut places = vec![segment.lower];
            if s > segment.lower.value.hi && s < end.value.hi {
                places.push(place);
            }
            places.push(end);
            for pair in places.windows(2) {
                let [from, to] = pair else { continue };
                let length = to.sub(*from);
                let (offset, beyond) = (from.sub(segment.lower), edge.sub(*to));
                let mut slots = Vec::new();
                let value = self.rule.integrate(|q, rest| {
                    let (up, down) = (length.mul(q), length.mul(rest));
                    let Some(bend) = bend.run(&mut PreciseAlgebra, &[offset.add(up)], &mut slots) else { return Precise::nan() };
                    // Every distance is a sum of parts of one sign.
                    let gap = if s <= from.value.hi { from.sub(place).add(up) } else { place.sub(*to).add(down) };
                    bend.mul(kernel(from.add(up), s <= from.value.hi, gap, beyond.add(down), place, edge))
                });
                total = total.add(value.mul(length));
            }
        }
        Some(total)
    }
}

impl PreciseSegment {
    fn end(&self, x: f64) -> Precise {
        self.upper.filter(|upper| upper.value.hi < x).unwrap_or(Precise::exact(x))
    }

    /// b f′(b) K(b, s) at an end b of the segment.
    fn jump(&self, at: Precise, s: f64, a: f64) -> Option<Precise> {
        let delta = at.sub(self.lower);
        let f_prime = self.f_prime.run(&mut PreciseAlgebra, &[delta], &mut Vec::new())?;
        let (place, edge) = (Precise::exact(s), Precise::exact(a));
        let beyond = at.value.hi > s;
        let gap = if beyond { at.sub(place) } else { place.sub(at) };
        Some(at.mul(f_prime).mul(kernel(at, beyond, gap, edge.sub(at), place, edge)))
    }
}

/// K(r, s) = ∫_M^a dx/√((x²−r²)(x²−s²)), M = max(r, s), m = min(r, s), from |r − s| and a − r;
/// √((a−M)(a+M)) R_F(M²D, a²D, M²(a−m)(a+m)), D = M² − m².
fn kernel(r: Precise, beyond: bool, gap: Precise, below_edge: Precise, s: Precise, a: Precise) -> Precise {
    let other = a.sub(s);
    let (big, small, edge, rest) = if beyond { (r, s, below_edge, other) } else { (s, r, other, below_edge) };
    let squares = gap.mul(big.add(small));
    let first = big.mul(big).mul(squares);
    let second = a.mul(a).mul(squares);
    let third = big.mul(big).mul(rest).mul(a.add(small));
    edge.mul(a.add(big)).sqrt().mul(carlson([first, second, third]))
}

/// R_F at arguments with errors: it is homogeneous of degree −1/2 and falls in each of them.
fn carlson(arguments: [Precise; 3]) -> Precise {
    let value = rf_precise(arguments.map(|own| own.value));
    let doubt = arguments.iter().filter(|own| own.error > 0.0).map(|own| own.error / own.value.hi.abs()).fold(0.0, f64::max);
    Precise::checked(DoubleDouble { ..value.value }, value.error + value.value.hi.abs() * doubt)
}
