//! The quadrature that computes g and F where the power series converges slowly and the closed form cancels.
//!
//! With r = x sin θ, g(x) = x ∫ f′(r) dθ and F/(2E*) = a² ∫ f′(r) sin²θ dθ over 0 < θ < π/2, piece by piece: the terms of the sum have
//! one sign where the profile rises. Features that are short beside the contact radius lie next to the lower end of a piece, so that the
//! rule is applied on intervals that shrink toward it. Next to a root of f′ at the upper end, the closed form is better.

/// The sums of the Kronrod rule and of its Gauss rule differ by at most this part of the sum of magnitudes: the Kronrod sum has about
/// the square root of the third power of the other's error.
const ALIKE: f64 = 1e-14;
/// Those for the upper half of a piece, where roots may lie next to its end, differ by at most this part.
const ALIKE_AT_THE_END: f64 = 2e-15;
/// The rule gives up where the intervals fall below this part of the piece, the fortieth power of 1/8.
const LEAST_SCALE: f64 = 1e-36;
/// An interval with less than this part of the sum over its piece is the last one; a piece beyond a kink may grow toward the kink.
const NEGLIGIBLE: f64 = 1e-18;

/// Where a piece lies: the names of the variables for its ends, if it does not begin at the axis and does not reach to infinity.
pub(super) struct Extent {
    pub(super) lower: Option<String>,
    pub(super) upper: Option<String>,
}

/// The variables that the statements assign.
pub(super) const VARIABLES: [&str; 21] = [
    "_integral",
    "_rest",
    "_doubt",
    "_size",
    "_own",
    "_start",
    "_width",
    "_side",
    "_scale",
    "_from",
    "_length",
    "_k",
    "_angle",
    "_sine",
    "_r",
    "_slope",
    "_part",
    "_gauss",
    "_sum",
    "_lost",
    "_total",
];
/// The placeholder for the value of f′ at `_r`.
pub(super) const PLACEHOLDER: &str = "placeholder";

/// The statements that add the integral over a piece to `_integral` and `_rest`, with [`PLACEHOLDER`] for f′ at `_r`.
pub(super) fn piece(coordinate: &str, is_force: bool, extent: &Extent) -> String {
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
    // Angles are measured from one end of the piece. The intervals of the lower half are 7/8 of what remains; the upper half is one.
    let inner = format!(
        "_start = {start}; {width}
        _side = 0; _own = 0;
        while _side <= 1 {{
          _scale = 0.5 * _width;
          while _scale > {LEAST_SCALE:?} * _width {{
            _from = 0.125 * _scale;
            if _side == 1 {{ _from = 0; }}
            _scale = _scale - _from;
            _k = 0; _sum = 0; _lost = 0; _gauss = 0; _length = 0;
            while _k <= 60 {{
              _angle = _from + _scale * kronrod_place(_k);
              if _side == 1 {{ _angle = _width - _angle; }}
              _sine = sin(_start + _angle);
              _r = {coordinate} * _sine;
              _slope = {PLACEHOLDER};
              _part = _slope{weight};
              if floor(0.5 * _k) < 0.5 * _k {{ _gauss = _gauss + kronrod_gauss(0.5 * (_k - 1)) * _part; }}
              _part = kronrod_weight(_k) * _part;
              _length = _length + abs(_part);
              _total = _sum + _part;
              _lost = _lost + ((_sum - _total) + _part);
              _sum = _total;
              _k = _k + 1;
            }}
            _doubt = _doubt + _scale * abs(_gauss - _sum);
            _length = _scale * _length;
            _size = _size + _length;
            _own = _own + _length;
            if _side == 1 && !(_scale * abs(_gauss - _sum) <= {ALIKE_AT_THE_END:?} * _size) {{ return nan(); }}
            _part = _scale * (_sum + _lost);
            _total = _integral + _part;
            _rest = _rest + ((_integral - _total) + _part);
            _integral = _total;
            _scale = _from;
            if _length < {NEGLIGIBLE:?} * _own {{ _scale = 0; }}
          }}
          if _scale > 0 {{ return nan(); }}
          _side = _side + 1;
        }}"
    );
    match &extent.lower {
        None => inner,
        Some(b) => format!("if {coordinate} > {b} {{ {inner} }}"),
    }
}

/// The statements after those of all pieces.
pub(super) fn result(coordinate: &str, is_force: bool) -> String {
    let whole = format!("{coordinate} * (_integral + _rest)");
    // The square of a large radius overflows.
    let result = if is_force { format!("{coordinate} * ({whole})") } else { whole };
    format!("if !(_doubt <= {ALIKE:?} * _size) {{ return nan(); }} return {result};")
}
