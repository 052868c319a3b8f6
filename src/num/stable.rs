//! Elementary pieces that keep every digit: scaling by powers of two, legs of right triangles, inverse hyperbolics.

use super::double_double::{two_prod, two_sum};

/// The binary exponent `e` of `x = m 2^e`, `1 <= |m| < 2`; 0 for zero, infinities and NaN.
pub(crate) fn exponent(x: f64) -> i32 {
    if x == 0.0 || !x.is_finite() { 0 } else { libm::ilogb(x) }
}

/// `x 2^e`; exact unless the result over- or underflows.
pub(crate) fn ldexp(x: f64, e: i64) -> f64 {
    libm::scalbn(x, e.clamp(-6000, 6000) as i32)
}

/// `sqrt((a - b)(a + b))` for `0 <= b <= a`, without overflow or underflow between; at most 1.25 ulp.
pub(crate) fn leg(a: f64, b: f64) -> f64 {
    if (1e-120..1e150).contains(&a) { ((a - b) * (a + b)).sqrt() } else { (a - b).sqrt() * (a + b).sqrt() }
}

/// `asinh(t)`, `t >= 0`; the difference to 1 inside the logarithm is never formed.
pub(crate) fn asinh(t: f64) -> f64 {
    if t > 1e100 {
        return t.ln() + std::f64::consts::LN_2;
    }
    (t + t * t / (1.0 + (1.0 + t * t).sqrt())).ln_1p()
}

/// `artanh(x / r)`, `0 <= x < r`, from the exact difference `r - x`; about 1 ulp. Infinite at `x = r`.
pub(crate) fn artanh_quotient(x: f64, r: f64) -> f64 {
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

/// The same as ln(1 + z)/2, z = 2x/(r − x), or as ln(q)/2, q = (r + x)/(r − x), with what the nearest double leaves of z or q.
#[inline]
fn artanh_near(x: f64, r: f64) -> f64 {
    if 3.0 * x > r {
        // q > 2, where the logarithm moves by less than 1.5 of its own for a relative change of q.
        let (sum, below) = (two_sum(r, x), two_sum(r, -x));
        let q = sum.hi / below.hi;
        let product = two_prod(q, below.hi);
        let rest = (sum.hi - product.hi - product.lo) + (sum.lo - q * below.lo);
        return 0.5 * (q.ln() + rest / sum.hi);
    }
    let (top, below) = (2.0 * x, two_sum(r, -x));
    let z = top / below.hi;
    let product = two_prod(z, below.hi);
    let rest = (top - product.hi - product.lo) - z * below.lo;
    // (r − x)(1 + z) = r + x
    0.5 * (z.ln_1p() + rest / (r + x))
}

/// Sum of many positive numbers with one rounding at the end.
#[derive(Default)]
pub(crate) struct Total {
    sum: f64,
    rest: f64,
}

impl Total {
    /// Adds one term.
    pub(crate) fn add(&mut self, term: f64) {
        let next = two_sum(self.sum, term);
        self.sum = next.hi;
        self.rest += next.lo;
    }

    /// The sum so far.
    pub(crate) fn value(&self) -> f64 {
        self.sum + self.rest
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
