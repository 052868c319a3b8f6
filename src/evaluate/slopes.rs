//! The slope f′ and the bend (r f′)′ of a profile, which a verdict examines before computing transforms.

use crate::evaluate::closure::ClosureProfile;
use crate::evaluate::table::TableProfile;
use crate::integrate::integral::NumericProfile;
use crate::integrate::integral::NumericSegment;
use crate::num::Bounded;

/// f′ and (r f′)′ at any radius, and the jumps of f′.
pub trait Slopes: Send + Sync {
    /// f′(r); the right-hand limit at a kink.
    fn first(&self, r: f64) -> Bounded;

    /// (r f′)′ at r; NaN if unknown.
    fn bend(&self, r: f64) -> Bounded;

    /// The radii of certain jumps of f′, in increasing order, and their heights.
    fn kinks(&self) -> Vec<(f64, f64)>;

    /// True if f is identically 0.
    fn is_flat(&self) -> bool;

    /// Bounds on f′ and on (r f′)′ between two radii without a kink between them; `None` if unknown.
    fn over(&self, lower: f64, upper: f64) -> Option<Over> {
        let _ = (lower, upper);
        None
    }
}

/// Enclosures of the values between two radii.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Over {
    /// Of f′.
    pub f_prime: (f64, f64),
    /// Of (r f′)′.
    pub bend: (f64, f64),
}

impl Slopes for TableProfile {
    fn first(&self, r: f64) -> Bounded {
        self.at(r, |piece, delta| (piece.f_prime(delta), piece.f_prime_size(delta)))
    }

    fn bend(&self, r: f64) -> Bounded {
        self.at(r, |piece, delta| {
            let size = piece.f_prime_size(delta) + r * piece.second_size(delta);
            (piece.f_prime(delta) + r * piece.second(delta), size)
        })
    }

    fn kinks(&self) -> Vec<(f64, f64)> {
        self.jumps()
    }

    fn is_flat(&self) -> bool {
        self.pieces().iter().all(|piece| piece.coefficients.iter().skip(1).all(|c| *c == 0.0))
    }

    /// Both are quadratic on a piece, so their extrema are at its ends and at one interior point.
    fn over(&self, lower: f64, upper: f64) -> Option<Over> {
        let first = self.pieces().partition_point(|piece| piece.upper <= lower);
        let own = self.pieces().get(first..)?.iter().take_while(|piece| piece.lower < upper);
        own.map(|piece| {
            let [_, linear, quadratic, cubic] = piece.coefficients;
            let (from, to) = (lower.max(piece.lower) - piece.lower, upper.min(piece.upper) - piece.lower);
            let f_prime = quadratic_over([linear, 2.0 * quadratic, 3.0 * cubic], from, to);
            let start = linear + 2.0 * quadratic * piece.lower;
            let bend = quadratic_over([start, 4.0 * quadratic + 6.0 * cubic * piece.lower, 9.0 * cubic], from, to);
            Over { f_prime, bend }
        })
        .reduce(|one, other| Over { f_prime: hull(one.f_prime, other.f_prime), bend: hull(one.bend, other.bend) })
    }
}

/// The range of a + b δ + c δ² between two δ ≥ 0, rounding included.
fn quadratic_over([a, b, c]: [f64; 3], from: f64, to: f64) -> (f64, f64) {
    let value = |delta: f64| a + delta * (b + delta * c);
    let vertex = -0.5 * b / c;
    let within = if vertex > from && vertex < to { value(vertex) } else { value(from) };
    let size = a.abs() + to * (b.abs() + to * c.abs());
    let rounding = 16.0 * f64::EPSILON * size;
    let all = [value(from), value(to), within];
    (all.into_iter().fold(f64::INFINITY, f64::min) - rounding, all.into_iter().fold(f64::NEG_INFINITY, f64::max) + rounding)
}

fn hull(one: (f64, f64), other: (f64, f64)) -> (f64, f64) {
    (one.0.min(other.0), one.1.max(other.1))
}

impl Slopes for ClosureProfile {
    fn first(&self, r: f64) -> Bounded {
        Slopes::first(self.numeric(), r)
    }

    fn bend(&self, r: f64) -> Bounded {
        Slopes::bend(self.numeric(), r)
    }

    fn kinks(&self) -> Vec<(f64, f64)> {
        Slopes::kinks(self.numeric())
    }

    fn is_flat(&self) -> bool {
        Slopes::is_flat(self.numeric())
    }
}

impl Slopes for NumericProfile {
    fn first(&self, r: f64) -> Bounded {
        let (numbers, delta) = match self.segment(r) {
            Some((segment, delta)) => (Some(&segment.f_prime), delta),
            None => (None, 0.0),
        };
        numbers.map_or(Bounded::exact(0.0), |own| own.at(Bounded::exact(delta), &mut Vec::new()))
    }

    fn bend(&self, r: f64) -> Bounded {
        let Some((segment, delta)) = self.segment(r) else { return Bounded::exact(0.0) };
        match segment.bend() {
            Ok(own) => own.at(Bounded::exact(delta), &mut Vec::new()),
            Err(_) => Bounded { value: f64::NAN, error: f64::NAN },
        }
    }

    fn kinks(&self) -> Vec<(f64, f64)> {
        let mut found = Vec::new();
        for segment in self.segments.iter().skip(1) {
            let at = segment.lower.value;
            let (before, beyond) = (Slopes::first(self, at.next_down()), Slopes::first(self, at));
            let jump = beyond - before;
            if jump.value.abs() > jump.error + 16.0 * f64::EPSILON * (before.value.abs() + beyond.value.abs()) {
                found.push((at, jump.value));
            }
        }
        found
    }

    fn is_flat(&self) -> bool {
        self.is_empty()
    }
}

impl NumericProfile {
    /// The segment that contains r, the outer one where two meet, and the distance of r from its lower end.
    fn segment(&self, r: f64) -> Option<(&NumericSegment, f64)> {
        let index = self.segments.partition_point(|own| own.lower.value <= r).checked_sub(1)?;
        let own = self.segments.get(index)?;
        Some((own, r - own.lower.value))
    }
}
