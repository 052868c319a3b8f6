//! Elementary pieces that keep every digit: scaling by powers of two, legs of right triangles, inverse hyperbolics.

use super::double_double::two_sum;

/// The binary exponent `e` of `x = m 2^e`, `1 <= |m| < 2`; 0 for zero, infinities and NaN.
#[inline]
pub fn exponent(x: f64) -> i32 {
    match biased(x) {
        0 if x != 0.0 => libm::ilogb(x),
        0 | INFINITE => 0,
        own => own as i32 - 1023,
    }
}

/// `x 2^e`; exact unless the result over- or underflows.
#[inline]
pub fn ldexp(x: f64, e: i64) -> f64 {
    let own = biased(x);
    // Between normal numbers, only the exponent bits change.
    if own != 0 && own != INFINITE && (1..INFINITE).contains(&own.saturating_add(e)) {
        return f64::from_bits(x.to_bits().wrapping_add_signed(e << 52));
    }
    libm::scalbn(x, e.clamp(-6000, 6000) as i32)
}

/// The exponent bits of infinities and NaN.
const INFINITE: i64 = 0x7ff;

/// The exponent bits.
#[inline]
fn biased(x: f64) -> i64 {
    (x.to_bits() >> 52) as i64 & INFINITE
}

/// `sqrt((a - b)(a + b))` for `0 <= b <= a`, without overflow or underflow between; at most 1.25 ulp.
pub fn leg(a: f64, b: f64) -> f64 {
    if (1e-120..1e150).contains(&a) { ((a - b) * (a + b)).sqrt() } else { (a - b).sqrt() * (a + b).sqrt() }
}

/// `asinh(t)`, `t >= 0`; the difference to 1 inside the logarithm is never formed.
pub fn asinh(t: f64) -> f64 {
    if t > 1e100 {
        return t.ln() + std::f64::consts::LN_2;
    }
    (t + t * t / (1.0 + (1.0 + t * t).sqrt())).ln_1p()
}

/// `artanh(x / r)`, `0 <= x < r`, from the exact difference `r - x`; about 1 ulp. Infinite at `x = r`.
pub fn artanh_quotient(x: f64, r: f64) -> f64 {
    if x >= r {
        return if x == r { f64::INFINITY } else { f64::NAN };
    }
    if x < 1e-9 * r {
        return x / r; // the cubic term is below 2^-54
    }
    if (1e-100..1e100).contains(&r) {
        return artanh_near(x, r);
    }
    // One power of two brings both into a range where the parts of a product are exact.
    let e = -i64::from(exponent(r));
    artanh_near(ldexp(x, e), ldexp(r, e))
}

/// The same as ln(1 + z)/2, z = 2x/(r − x), or as ln(q)/2, q = (r + x)/(r − x), with what a quotient of half as many digits leaves.
///
/// With s = (r + x − q (r − x))/(r + x), exact for such a q, the logarithm is ln q − ln(1 − s) = ln q + s + s²/2; with z for q the same.
#[inline]
fn artanh_near(x: f64, r: f64) -> f64 {
    let sum = r + x;
    // r is the larger one.
    let (over, below) = (x - (sum - r), r - x);
    let under = (r - below) - x;
    let (high, low) = halves(below);
    let left = |top: f64, rest: f64, q: f64| ((top - q * high) - q * low) + (rest - q * under);
    let (log, share) = if 3.0 * x > r {
        let q = halves(sum / below).0;
        (q.ln(), left(sum, over, q) / sum)
    } else {
        let top = 2.0 * x;
        let z = halves(top / below).0;
        (z.ln_1p(), left(top, 0.0, z) / sum)
    };
    0.5 * (log + share * (1.0 + 0.5 * share))
}

/// The first 26 binary digits, and the others: products of the first ones are exact.
#[inline(always)]
pub fn halves(value: f64) -> (f64, f64) {
    let high = f64::from_bits(value.to_bits() & !0x07ff_ffff);
    (high, value - high)
}

/// Sum of many positive numbers with one rounding at the end.
#[derive(Default)]
pub struct Total {
    sum: f64,
    rest: f64,
}

impl Total {
    /// Adds one term.
    pub fn add(&mut self, term: f64) {
        let next = two_sum(self.sum, term);
        self.sum = next.hi;
        self.rest += next.lo;
    }

    /// The sum so far.
    pub fn value(&self) -> f64 {
        self.sum + self.rest
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Scaling by the bits of the exponent is what the library does, at both ends of the range of doubles as well.
    #[test]
    fn powers_of_two_scale_as_the_library_does() {
        let mut numbers = vec![0.0, -0.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN, f64::MAX, f64::MIN_POSITIVE, f64::from_bits(1)];
        numbers.extend((-1070..1023).step_by(7).flat_map(|power| [1.37, -1.0].map(|own| libm::scalbn(own, power))));
        for x in numbers {
            assert_eq!(exponent(x), if x == 0.0 || !x.is_finite() { 0 } else { libm::ilogb(x) }, "{x:e}");
            for e in [-5000, -2100, -1075, -1022, -400, -1, 0, 1, 31, 1023, 1024, 2046, 2100, 5000] {
                assert_eq!(ldexp(x, e).to_bits(), libm::scalbn(x, e as i32).to_bits(), "{x:e} {e}");
            }
        }
    }

    /// ln((r + x)/(r − x))/2 with 30 digits, of x from next to nothing to next to r.
    #[test]
    fn the_inverse_hyperbolic_tangent_of_a_quotient_has_its_digits() {
        use crate::double_double::{DoubleDouble, two_sum};
        let mut worst = 0.0f64;
        for i in 0..40_000 {
            let r = 1.37 * 1.21f64.powi(i % 97 - 48);
            let share = 10f64.powf(-10.0 * f64::from(i % 1013) / 1013.0);
            for x in [r * share, r * (1.0 - share * (1.0 - f64::EPSILON))] {
                if x <= 0.0 || x >= r {
                    continue;
                }
                let found = artanh_quotient(x, r);
                let quotient = DoubleDouble::from(2.0 * x).div(two_sum(r, -x));
                let truth = crate::precise::ln1p(quotient).scale(0.5);
                let unit = exponent(truth.value());
                let off = truth.sub(found.into()).value().abs() / ldexp(f64::EPSILON, unit.into());
                worst = worst.max(off);
            }
        }
        // 1.12, of which 1 is the library's ln(1 + z).
        assert!(worst < 1.15, "{worst} ulp");
    }

    #[test]
    fn scaling_is_exact_and_total() {
        assert_eq!(exponent(1.0), 0);
        assert_eq!(exponent(0.75), -1);
        assert_eq!(exponent(5e-324), -1074);
        assert_eq!(exponent(f64::NAN), 0);
        assert_eq!(ldexp(1.5, 3), 12.0);
        assert_eq!(ldexp(1.0, i64::MAX), f64::INFINITY);
        assert_eq!(leg(5.0, 3.0), 4.0);
        assert!((leg(5e200, 3e200) / 4e200 - 1.0).abs() < 4e-16);
    }
}
