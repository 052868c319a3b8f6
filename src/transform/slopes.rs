//! Slope and bend of a profile in plain sight: what a verdict looks at before it asks for transforms.

use super::integral::NumericSegment;
use super::{ClosureProfile, NumericProfile, TableProfile};
use crate::num::Bounded;

/// f′ and (r f′)′ at any radius, and where f′ jumps.
pub trait Slopes: Send + Sync {
    /// f′(r), beyond a kink where r is one.
    fn first(&self, r: f64) -> Bounded;

    /// (r f′)′ at r; NaN where it is not known.
    fn bend(&self, r: f64) -> Bounded;

    /// The places where f′ jumps beyond doubt, rising, and by how much.
    fn kinks(&self) -> Vec<(f64, f64)>;

    /// True where f is 0 throughout.
    fn is_flat(&self) -> bool;
}

impl Slopes for TableProfile {
    fn first(&self, r: f64) -> Bounded {
        self.at(r, |piece, delta| (piece.slope(delta), piece.slope_size(delta)))
    }

    fn bend(&self, r: f64) -> Bounded {
        self.at(r, |piece, delta| {
            let size = piece.slope_size(delta) + r * piece.second_size(delta);
            (piece.slope(delta) + r * piece.second(delta), size)
        })
    }

    fn kinks(&self) -> Vec<(f64, f64)> {
        self.jumps()
    }

    fn is_flat(&self) -> bool {
        self.pieces().iter().all(|piece| piece.coefficients.iter().skip(1).all(|c| *c == 0.0))
    }
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
            Some((segment, delta)) => (Some(&segment.slope), delta),
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
    /// The segment that has r, the later one where two meet, and how far r lies into it; sources stand in the order of their ends.
    fn segment(&self, r: f64) -> Option<(&NumericSegment, f64)> {
        let index = self.segments.partition_point(|own| own.lower.value <= r).checked_sub(1)?;
        let own = self.segments.get(index)?;
        Some((own, r - own.lower.value))
    }
}
