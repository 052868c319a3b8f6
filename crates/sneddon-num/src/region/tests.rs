//! Every value at a point of a rectangle lies in the rectangle of the values.

use super::Region;
use num_complex::Complex64;
use std::f64::consts::FRAC_PI_2;

type Law = (&'static str, fn(Region) -> Region, fn(Complex64) -> Complex64);

/// Numbers in (0, 1), the same at every run.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

/// Whether z is in the region, or outside by no more than what the double value itself is wrong by.
fn holds(region: Region, z: Complex64, slack: f64) -> bool {
    let inside = |own: super::Interval, v: f64| v >= own.low - slack && v <= own.high + slack;
    inside(region.re, z.re) && inside(region.im, z.im)
}

const LAWS: &[Law] = &[
    ("square", |z| z.powi(2), |z| z * z),
    ("cube", |z| z.powi(3), |z| z * z * z),
    ("inverse cube", |z| z.powi(-3), |z| 1.0 / (z * z * z)),
    ("recip", Region::recip, |z| 1.0 / z),
    ("sqrt", Region::sqrt, Complex64::sqrt),
    ("ln", Region::ln, Complex64::ln),
    ("exp", Region::exp, Complex64::exp),
    ("power", |z| z.power(Region::real(1.7)), |z| z.powf(1.7)),
    ("inverse power", |z| z.power(Region::real(-0.3)), |z| z.powf(-0.3)),
    ("exponential", |z| Region::real(3.0).power(z), |z| (z * 3.0_f64.ln()).exp()),
    ("sin", Region::sin, Complex64::sin),
    ("cos", Region::cos, Complex64::cos),
    ("tan", Region::tan, Complex64::tan),
    ("sinh", Region::sinh, Complex64::sinh),
    ("cosh", Region::cosh, Complex64::cosh),
    ("tanh", Region::tanh, Complex64::tanh),
    ("asin", Region::asin, Complex64::asin),
    ("atan", Region::atan, Complex64::atan),
    ("asinh", Region::asinh, Complex64::asinh),
    ("atanh", Region::atanh, Complex64::atanh),
    ("product", |z| z * (z + Region::real(0.7)), |z| z * (z + 0.7)),
    ("quotient", |z| z / (Region::real(2.0) - z), |z| z / (2.0 - z)),
    ("erf", Region::erf, erf),
    ("ln 1 + z", Region::ln_1p, |z| (1.0 + z).ln()),
    ("acosh", |z| (z + Region::real(3.0)).acosh(), |z| (z + 3.0).acosh()),
    ("abs", |z| (z + Region::real(9.0)).abs(), |z| z + 9.0),
    ("erfi", Region::erfi, |z| -Complex64::i() * erf(Complex64::i() * z)),
    ("dawson", Region::dawson, |z| -0.5 * std::f64::consts::PI.sqrt() * Complex64::i() * erf(Complex64::i() * z) * (-z * z).exp()),
    ("fresnelc", Region::fresnelc, |z| mean(|t| z * (FRAC_PI_2 * t * t * z * z).cos())),
    ("fresnels", Region::fresnels, |z| mean(|t| z * (FRAC_PI_2 * t * t * z * z).sin())),
    ("struveh 0", |z| z.struveh(0.0), |z| struve(z, 0)),
    ("struveh 3", |z| z.struveh(3.0), |z| struve(z, 3)),
    ("struvel 1", |z| z.struvel(1.0), |z| -struve(Complex64::i() * z, 1)),
    ("struvel 0", |z| z.struvel(0.0), |z| Complex64::i().inv() * struve(Complex64::i() * z, 0)),
    ("ellipk", Region::ellipk, |z| mean(|t| FRAC_PI_2 / (1.0 - z * (FRAC_PI_2 * t).sin().powi(2)).sqrt())),
    ("ellipe", Region::ellipe, |z| mean(|t| FRAC_PI_2 * (1.0 - z * (FRAC_PI_2 * t).sin().powi(2)).sqrt())),
    ("elliprc", |z| Region::elliprf(z, Region::real(0.6), Region::real(0.6)), |z| (z / 0.6).sqrt().acos() / (0.6 - z).sqrt()),
    ("gamma", |z| (z + Region::real(4.0)).gamma(), |z| stirling(z + 4.0)),
    ("digamma", |z| (z + Region::real(4.0)).digamma(), |z| psi(z + 4.0, 0)),
    ("polygamma 2", |z| (z + Region::real(4.0)).polygamma(2.0), |z| psi(z + 4.0, 2)),
    ("besselj 0", |z| z.besselj(0.0), |z| bessel(z, 0)),
    ("besselj 3", |z| z.besselj(3.0), |z| bessel(z, 3)),
    ("besseli 1", |z| z.besseli(1.0), |z| bessel(Complex64::i() * z, 1) / Complex64::i()),
];

/// The power series, for arguments of a few units.
fn erf(z: Complex64) -> Complex64 {
    let (mut term, mut total) = (z, z);
    for k in 1..200 {
        term = -term * z * z / f64::from(k);
        total += term / f64::from(2 * k + 1);
    }
    total * std::f64::consts::FRAC_2_SQRT_PI
}

/// The mean over t from 0 to 1, by Simpson's rule.
fn mean(f: impl Fn(f64) -> Complex64) -> Complex64 {
    const INTERVALS: usize = 400;
    let weight = |i: usize| {
        if i == 0 || i == INTERVALS {
            1.0
        } else if i % 2 == 1 {
            4.0
        } else {
            2.0
        }
    };
    (0..=INTERVALS).map(|i| weight(i) * f(i as f64 / INTERVALS as f64)).sum::<Complex64>() / (3.0 * INTERVALS as f64)
}

/// The power series of H_n.
fn struve(z: Complex64, n: i32) -> Complex64 {
    let half = 0.5 * z;
    let first = (1..=n).fold(std::f64::consts::FRAC_2_PI, |product, k| product / (f64::from(k) + 0.5));
    let mut term = first * half.powi(n + 1) * 2.0;
    let mut total = term;
    for k in 1..100 {
        term = -term * half * half / ((f64::from(k) + 0.5) * (f64::from(k + n) + 0.5));
        total += term;
    }
    total
}

/// Γ(z) from Γ(z + 12) and Stirling's series.
fn stirling(z: Complex64) -> Complex64 {
    let (mut w, mut below) = (z, Complex64::new(1.0, 0.0));
    for _ in 0..12 {
        (below, w) = (below * w, w + 1.0);
    }
    let inverse = w.inv();
    let square = inverse * inverse;
    let series = inverse * (1.0 / 12.0 - square * (1.0 / 360.0 - square * (1.0 / 1260.0 - square / 1680.0)));
    ((w - 0.5) * w.ln() - w + 0.5 * std::f64::consts::TAU.ln() + series).exp() / below
}

/// ψ^(m)(z) for m = 0 and 2, from its value at z + 20 and the first terms of the asymptotic series.
fn psi(z: Complex64, m: i32) -> Complex64 {
    let (mut w, mut below) = (z, Complex64::new(0.0, 0.0));
    for _ in 0..20 {
        below += w.powi(-m - 1);
        w += 1.0;
    }
    let square = (w * w).inv();
    if m == 0 {
        w.ln() - 0.5 / w - square * (1.0 / 12.0 - square * (1.0 / 120.0 - square / 252.0)) - below
    } else {
        -square * (1.0 + 1.0 / w + square * (0.5 - square * (1.0 / 6.0 - square / 6.0))) - 2.0 * below
    }
}

fn bessel(z: Complex64, n: i32) -> Complex64 {
    let half = 0.5 * z;
    let mut term = (1..=n).fold(Complex64::new(1.0, 0.0), |product, k| product * half / f64::from(k));
    let mut total = term;
    for k in 1..100 {
        term = -term * half * half / (f64::from(k) * f64::from(k + n));
        total += term;
    }
    total
}

#[test]
fn values_at_points_of_a_rectangle_are_in_the_rectangle_of_values() {
    let mut random = Numbers(7);
    for (name, region, value) in LAWS {
        let mut known = 0;
        for _ in 0..1000 {
            // Rectangles of all sizes, some of them with an end on an axis.
            let width = 10.0_f64.powf(random.between(-3.0, 0.6));
            let mut end = |low: f64, high: f64| if random.next() < 0.2 { 0.0 } else { random.between(low, high) };
            let (a, b) = (end(-3.0, 3.0), end(-2.0, 2.0));
            let (re, im) = ((a, a + width * random.next()), (b, b + width * random.next()));
            let found = region(Region::new(re, im));
            if found.largest().is_infinite() {
                continue;
            }
            known += 1;
            for _ in 0..8 {
                let z = Complex64::new(random.between(re.0, re.1), random.between(im.0, im.1));
                let own = value(z);
                let slack = 1e-13 * (1.0 + found.largest());
                assert!(holds(found, own, slack), "{name} at {z} is {own}, not in {found:?}");
                assert!(own.norm() <= found.largest() + slack, "{name} at {z}");
            }
        }
        assert!(known > 150, "{name}: {known} rectangles had an answer");
    }
}

/// A rectangle of values shrinks with the rectangle of arguments: bounds on the magnitude alone would not give finite quotients.
#[test]
fn special_functions_close_in_on_their_values() {
    let mut random = Numbers(3);
    let special = ["erf", "daw", "fre", "str", "ell", "gam", "dig", "pol", "bes"];
    for (name, region, _) in LAWS.iter().filter(|(name, ..)| special.iter().any(|own| name.starts_with(own)) && *name != "elliprc") {
        for _ in 0..200 {
            let (x, size) = (random.between(0.3, 0.9), 10.0_f64.powf(random.between(-9.0, -3.0)));
            let found = region(Region::new((x, x + size), (0.0, size)));
            let width = (found.re.high - found.re.low).max(found.im.high - found.im.low);
            assert!(width <= 100.0 * size + 1e-12, "{name} at {x}: {width:e} from {size:e}");
        }
    }
}

/// |f(z)| is about |z| for small z; with a bound of 1 for tanh, the bounds of integrals next to the axis were too large.
#[test]
fn functions_that_vanish_at_0_have_small_values_next_to_it() {
    let odd = ["sin", "sinh", "tanh", "tan", "atan", "atanh", "asinh", "asin"];
    for (name, region, value) in LAWS.iter().filter(|(name, ..)| odd.contains(name)) {
        for size in [1e-12, 1e-6, 0.01, 0.1] {
            let found = region(Region::new((-size, size), (-size, size)));
            assert!(found.largest() <= 2.1 * size, "{name}: {:e} for {size:e}", found.largest());
            assert!(holds(found, value(Complex64::new(-size, size)), 1e-15 * size), "{name} at {size:e}");
        }
    }
}

#[test]
fn what_is_not_analytic_is_not_known() {
    let unit = Region::new((-1.0, 1.0), (-1.0, 1.0));
    let left = Region::new((-2.0, -1.0), (-0.1, 0.1));
    let long = Region::new((0.0, 1.0), (0.0, 1.6));
    for (what, found) in [
        ("1/z around 0", unit.recip()),
        ("√z across the cut", left.sqrt()),
        ("ln z across the cut", left.ln()),
        ("z^1.7 across the cut", left.power(Region::real(1.7))),
        ("tanh z around iπ/2", long.tanh()),
        ("tan z around π/2", Region::new((0.0, 1.6), (0.0, 1.0)).tan()),
        ("arctan z around i", long.atan()),
        ("artanh z around 1", unit.atanh()),
        ("arcsin z around 1", Region::new((0.0, 1.1), (-0.1, 0.1)).asin()),
        ("1/(1 + z²) around i", (Region::real(1.0) + long.powi(2)).recip()),
        ("J of order 1/2", unit.besselj(0.5)),
        ("overflow", Region::new((0.0, 800.0), (0.0, 1.0)).exp()),
        ("what is unknown", Region::unknown() * Region::real(0.0)),
    ] {
        assert!(found.largest().is_infinite(), "{what}: {found:?}");
    }
}

/// e^(−z²) sin z and its like far out, where one factor overflows and the other one underflows: ln|z| of the product is known, since
/// |e^w| = e^(Re w) and sinh |y| ≤ |sin z| ≤ cosh y.
#[test]
fn products_of_what_overflows_and_what_underflows_have_their_size() {
    let mut numbers = Numbers(11);
    let mut tight = 0;
    for _ in 0..2000 {
        let (x, y) = (numbers.between(-3000.0, 3000.0), numbers.between(-3000.0, 3000.0));
        let half = numbers.between(0.0, 0.001);
        let z = Region::new((x - half, x + half), (y - half, y + half));
        let gauss = (z.powi(2) * Region::real(-1.0)).exp();
        // ln of the size at the middle, to 1e-9 and the ln 2 of the sine.
        let size = y * y - x * x + y.abs() - std::f64::consts::LN_2;
        let spread = 2.0 * half * (x.abs() + y.abs()) + 0.2;
        for (own, log) in [
            (gauss * z.sin(), size),
            (z.sin() * gauss * z.cos(), size + y.abs() - std::f64::consts::LN_2),
            ((gauss * z.sinh()).recip() * gauss, std::f64::consts::LN_2 - x.abs()),
        ] {
            if y.abs() < 2.0 || x.abs() < 2.0 {
                continue;
            }
            assert!(own.largest() >= (log - 1.0).exp().min(f64::MAX) * 0.4, "{x} {y}: {own:?}");
            if (-700.0..700.0).contains(&log) && spread < 5.0 {
                assert!(own.largest() <= (log + 3.0 * spread + 2.0).exp(), "{x} {y} {half}: {own:?} beside e^{log}");
                tight += 1;
            }
        }
    }
    assert!(tight > 100, "{tight}");
}

/// An enclosure of tanh x on a short interval of the axis is hardly wider than the values, which tanh′ = 1/cosh² gives. Between 1.2
/// and 18 it was as wide as the distance to ±1.
#[test]
fn tanh_on_the_axis_is_enclosed_without_loss() {
    let mut numbers = Numbers(12);
    for _ in 0..2000 {
        let (low, width) = (numbers.between(-12.0, 12.0), numbers.between(0.0, 0.01));
        let (least, most) = Region::interval(low, low + width).tanh().real_range().unwrap();
        assert!(least <= low.tanh() && most >= (low + width).tanh());
        let steepest = if low < 0.0 && low + width > 0.0 { 1.0 } else { low.abs().min((low + width).abs()).cosh().powi(-2) };
        assert!(most - least <= width * steepest + 1e-14, "{low} {width}: [{least}, {most}]");
    }
}

/// A real product that overflows is known by its sign, so that e^(−c x⁴) has a value far out.
#[test]
fn products_that_overflow_keep_their_sign() {
    let mut numbers = Numbers(13);
    for _ in 0..2000 {
        let (exponent, decades) = (numbers.between(60.0, 150.0), numbers.between(0.0, 1.0));
        let x = Region::interval(10_f64.powf(exponent), 10_f64.powf(exponent + decades));
        let factor = Region::real(-(10_f64.powf(numbers.between(-30.0, 3.0))));
        let (least, most) = (factor * x.powi(4)).exp().real_range().unwrap();
        assert!(least <= 0.0 && (0.0..1e-300).contains(&most), "1e{exponent}: [{least}, {most}]");
        let wave = x.powi(3) * (factor * x.powi(4)).exp();
        assert!(wave.largest() < 1e-300, "1e{exponent}: {wave:?}");
    }
}
