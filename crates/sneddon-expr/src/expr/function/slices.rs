//! The elementary functions of one number over slices: values without a call through the table per point, and how errors grow.

/// A function of one number over a slice.
#[derive(Clone, Copy, Debug)]
pub struct SliceLaw {
    /// The values, bit for bit those of the row.
    pub values: fn(&[f64], &mut [f64]),
    /// Bounds the change of each value from the arguments, their distances and the values; infinite if no cheap bound exists.
    pub growth: Growth,
}

/// From arguments, distances and values to bounds.
pub type Growth = fn(&[f64], &[f64], &[f64], &mut [f64]);

/// The values of `f` while the argument at `place` runs over a slice: one loop around the function itself.
#[inline(always)]
pub(super) fn sweep(arguments: &mut [f64], place: usize, values: &[f64], out: &mut [f64], f: impl Fn(&[f64]) -> f64) {
    for (out, value) in out.iter_mut().zip(values) {
        if let Some(argument) = arguments.get_mut(place) {
            *argument = *value;
        }
        *out = f(arguments);
    }
}

/// Relative margin for the rounding errors of computing a bound.
const MARGIN: f64 = 1.001;
/// Below this the bounds of functions that grow exponentially are short.
const SMALL: f64 = 0.5;

fn values(z: &[f64], out: &mut [f64], f: impl Fn(f64) -> f64) {
    for (value, z) in out.iter_mut().zip(z) {
        *value = f(*z);
    }
}

/// `bound` has argument, distance and value.
fn growth(z: &[f64], by: &[f64], v: &[f64], out: &mut [f64], bound: impl Fn(f64, f64, f64) -> f64) {
    for (((out, z), by), v) in out.iter_mut().zip(z).zip(by).zip(v) {
        *out = MARGIN * bound(*z, *by, *v);
    }
}

/// The bound where the condition holds.
fn known(condition: bool, bound: f64) -> f64 {
    if condition { bound } else { f64::INFINITY }
}

/// e^z: expm1(δ) ≤ δ + δ² up to 1.
pub(super) const EXP: SliceLaw = SliceLaw {
    values: |z, out| values(z, out, f64::exp),
    growth: |z, by, v, out| growth(z, by, v, out, |_, by, v| known(by <= SMALL, v * by * (1.0 + by))),
};

/// ln z: δ over the remaining distance to the pole.
pub(super) const LN: SliceLaw = SliceLaw {
    values: |z, out| values(z, out, f64::ln),
    growth: |z, by, v, out| growth(z, by, v, out, |z, by, _| known(by <= 0.5 * z, by / (z - by))),
};

/// |cos| ≤ 1, and no sine is further from another than 2.
pub(super) const SIN: SliceLaw =
    SliceLaw { values: |z, out| values(z, out, f64::sin), growth: |z, by, v, out| growth(z, by, v, out, |_, by, _| smaller(2.0, by)) };

/// |sin z| ≤ |z| and 1.
pub(super) const COS: SliceLaw = SliceLaw {
    values: |z, out| values(z, out, f64::cos),
    growth: |z, by, v, out| growth(z, by, v, out, |z, by, _| smaller(2.0, by * smaller(1.0, z.abs() + by))),
};

/// tan(z + δ) − tan z = tan δ (1 + t²)/(1 − t tan δ), and tan δ ≤ δ + δ² up to 1/2.
pub(super) const TAN: SliceLaw = SliceLaw {
    values: |z, out| values(z, out, f64::tan),
    growth: |z, by, v, out| {
        growth(z, by, v, out, |_, by, t| {
            let (by, t) = (by + by * by, t.abs());
            known(by <= SMALL && t * by <= SMALL, by * (1.0 + t * t) / (1.0 - t * by))
        })
    },
};

/// δ/√(1 − ζ²) at the end nearer to the edge.
const fn arc(values: fn(&[f64], &mut [f64])) -> SliceLaw {
    SliceLaw {
        values,
        growth: |z, by, v, out| {
            growth(z, by, v, out, |z, by, _| {
                let room = 1.0 - z.abs();
                known(by <= 0.5 * room, by / ((room - by) * (1.0 + z.abs())).sqrt())
            })
        },
    }
}

/// See [`arc`].
pub(super) const ASIN: SliceLaw = arc(|z, out| values(z, out, f64::asin));
/// See [`arc`].
pub(super) const ACOS: SliceLaw = arc(|z, out| values(z, out, f64::acos));

/// δ/(1 + ζ²) at the end nearer to 0.
pub(super) const ATAN: SliceLaw = SliceLaw {
    values: |z, out| values(z, out, f64::atan),
    growth: |z, by, v, out| {
        growth(z, by, v, out, |z, by, _| {
            let near = larger(z.abs() - by, 0.0);
            by / (1.0 + near * near)
        })
    },
};

/// cosh(|z| + δ) ≤ cosh z·e^δ, and e^δ ≤ 1 + 2δ up to 1.
pub(super) const SINH: SliceLaw = SliceLaw {
    values: |z, out| values(z, out, f64::sinh),
    growth: |z, by, v, out| growth(z, by, v, out, |_, by, v| known(by <= SMALL, by * (1.0 + v * v).sqrt() * (1.0 + 2.0 * by))),
};

/// sinh y ≤ cosh y and y cosh y, at y = |z| + δ.
pub(super) const COSH: SliceLaw = SliceLaw {
    values: |z, out| values(z, out, f64::cosh),
    growth: |z, by, v, out| growth(z, by, v, out, |z, by, v| known(by <= SMALL, by * smaller(1.0, z.abs() + by) * v * (1.0 + 2.0 * by))),
};

/// 1/cosh² at |z| − δ ≤ (1 − tanh² z) e^(2δ); the difference may have lost 4 ulp of 1.
pub(super) const TANH: SliceLaw = SliceLaw {
    values: |z, out| values(z, out, f64::tanh),
    growth: |z, by, v, out| {
        growth(z, by, v, out, |_, by, v| known(by <= SMALL, by * (larger(1.0 - v * v, 0.0) + 16.0 * f64::EPSILON) * (1.0 + 4.0 * by)))
    },
};

/// δ/√(1 + ζ²) ≤ δ/max(1, ζ) at the end nearer to 0; squares would overflow.
pub(super) const ASINH: SliceLaw = SliceLaw {
    values: |z, out| values(z, out, libm::asinh),
    growth: |z, by, v, out| growth(z, by, v, out, |z, by, _| by / larger(z.abs() - by, 1.0)),
};

/// δ/√(ζ² − 1) at the end nearer to the edge.
pub(super) const ACOSH: SliceLaw = SliceLaw {
    values: |z, out| values(z, out, libm::acosh),
    growth: |z, by, v, out| {
        growth(z, by, v, out, |z, by, _| {
            let room = z - 1.0;
            // Two roots, because the product overflows.
            known(by <= 0.5 * room, by / ((room - by).sqrt() * (1.0 + z - by).sqrt()))
        })
    },
};

/// δ/(1 − ζ²) at the end nearer to the pole.
pub(super) const ATANH: SliceLaw = SliceLaw {
    values: |z, out| values(z, out, libm::atanh),
    growth: |z, by, v, out| {
        growth(z, by, v, out, |z, by, _| {
            let room = 1.0 - z.abs();
            known(by <= 0.5 * room, by / ((room - by) * (1.0 + z.abs())))
        })
    },
};

/// The value moves by no more than the argument.
pub(super) const ABS: SliceLaw =
    SliceLaw { values: |z, out| values(z, out, f64::abs), growth: |z, by, v, out| growth(z, by, v, out, |_, by, _| by) };

/// One instruction, unlike `f64::min`; NaN if `b` is.
fn smaller(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// One instruction, unlike `f64::max`; NaN if `b` is.
fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}
