//! The quadrature that computes g and F where the power series converges slowly and the closed form cancels.
//!
//! With r = x sin θ, g(x) = x ∫ f′(r) dθ and F/(2E*) = a² ∫ f′(r) sin²θ dθ over 0 < θ < π/2, piece by piece: the terms of the sum have
//! one sign where the profile rises. One rule has its points densely at both ends of a piece: roots and poles of f′ may lie there, and
//! the other rule misses what is short beside the contact radius.

/// The sums of the Kronrod rule and of its Gauss rule differ by at most this part of the sum of magnitudes: the Kronrod sum has about
/// the square root of the third power of the other's error.
const ALIKE: f64 = 1e-14;

/// Where a piece lies: the names of the variables for its ends, if it does not begin at the axis and does not reach to infinity.
pub(super) struct Extent {
    pub(super) lower: Option<String>,
    pub(super) upper: Option<String>,
}

/// The variables that the statements assign.
pub(super) const VARIABLES: [&str; 13] =
    ["_integral", "_start", "_width", "_k", "_sine", "_r", "_slope", "_part", "_gauss", "_size", "_total", "_sum", "_lost"];
/// The placeholder for the value of f′ at `_r`.
pub(super) const PLACEHOLDER: &str = "placeholder";

/// The statements that add the integral over a piece by a rule to `_integral`, with [`PLACEHOLDER`] for f′ at `_r`.
pub(super) fn piece(coordinate: &str, is_force: bool, rule: &str, extent: &Extent) -> String {
    let weight = if is_force { " * _sine * _sine" } else { "" };
    let (start, mut width) = match &extent.lower {
        None => ("0".to_owned(), "_width = 1.5707963267948966;".to_owned()),
        Some(b) => {
            (format!("asin({b} / {coordinate})"), format!("_width = atan2(sqrt(({coordinate} - {b}) * ({coordinate} + {b})), {b});"))
        }
    };
    if let Some(b) = &extent.upper {
        width.push_str(&format!(" if {coordinate} > {b} {{ _width = asin({b} / {coordinate}) - _start; }}"));
    }
    let inner = format!(
        "_start = {start}; {width}
        _k = 0; _sum = 0; _lost = 0; _size = 0; _gauss = 0;
        while _k <= 60 {{
          _sine = sin(_start + _width * {rule}_place(_k));
          _r = {coordinate} * _sine;
          _slope = {PLACEHOLDER};
          _part = _slope{weight};
          if floor(0.5 * _k) < 0.5 * _k {{ _gauss = _gauss + {rule}_gauss(0.5 * (_k - 1)) * _part; }}
          _part = {rule}_weight(_k) * _part;
          _size = _size + abs(_part);
          _total = _sum + _part;
          _lost = _lost + ((_sum - _total) + _part);
          _sum = _total;
          _k = _k + 1;
        }}
        if !(abs(_gauss - _sum) <= {ALIKE:?} * _size) {{ return nan(); }}
        _integral = _integral + _width * (_sum + _lost);"
    );
    match &extent.lower {
        None => inner,
        Some(b) => format!("if {coordinate} > {b} {{ {inner} }}"),
    }
}
