//! The quadrature that computes g and F where the power series converges slowly and the closed form cancels.
//!
//! With r = x sin θ, g(x) = x ∫ f′(r) dθ and F/(2E*) = a² ∫ f′(r) sin²θ dθ over 0 < θ < π/2, piece by piece: the terms of the sum have
//! one sign where the profile rises. The rule is applied to a whole piece, or on intervals that shrink toward both ends: roots and poles
//! of f′ may lie there, and one interval misses what is short beside the contact radius.

/// The sums of the Kronrod rule and of its Gauss rule differ by at most this part of the sum of magnitudes: the Kronrod sum has about
/// the square root of the third power of the other's error.
const ALIKE: f64 = 1e-14;

/// The intervals end where their scale falls below this, the fortieth power of 1/8.
const LEAST_SCALE: f64 = 1e-36;
/// An interval with less than this part of the sum is the last one.
const NEGLIGIBLE: f64 = 1e-18;

/// The statements after those of all pieces, with `front` for the factor of the integral.
pub(super) fn result(front: &str) -> String {
    format!("if !(_doubt <= {ALIKE:?} * _magnitude) {{ return nan(); }} return {front} * _integral;")
}

/// Where a piece lies: the names of the variables for its ends, if it does not begin at the axis and does not reach to infinity.
pub(super) struct Extent {
    pub(super) lower: Option<String>,
    pub(super) upper: Option<String>,
}

/// The variables that the statements assign.
const VARIABLES: [&str; 17] = [
    "_doubt",
    "_magnitude",
    "_integral",
    "_start",
    "_width",
    "_level",
    "_total",
    "_angle",
    "_k",
    "_sine",
    "_r",
    "_slope",
    "_part",
    "_gauss",
    "_size",
    "_sum",
    "_lost",
];
/// Those of intervals that shrink.
const GRADED: [&str; 3] = ["_side", "_scale", "_whole"];

/// The variables that the statements assign.
pub(super) fn variables(is_graded: bool) -> impl Iterator<Item = &'static str> {
    VARIABLES.into_iter().chain(GRADED.into_iter().filter(move |_| is_graded))
}

/// The placeholder for the value of f′ at `_r`.
pub(super) const PLACEHOLDER: &str = "placeholder";

/// The statements that add the integral over a piece to `_integral`, with [`PLACEHOLDER`] for f′ at `_r`; `is_graded` if the rule is
/// applied on intervals that shrink toward both ends.
pub(super) fn piece(coordinate: &str, is_force: bool, is_graded: bool, extent: &Extent) -> String {
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
    // The sum of the rule over one interval; angles are measured from one end of the piece.
    let sum = |angle: &str, scale: &str| {
        format!(
            "_k = 0;
            while _k <= 60 {{
              {angle}
              _sine = sin(_start + _angle);
              _r = {coordinate} * _sine;
              _slope = {PLACEHOLDER};
              _part = {scale}_slope{weight};
              if floor(0.5 * _k) < 0.5 * _k {{ _gauss = _gauss + kronrod_gauss(0.5 * (_k - 1)) * _part; }}
              _part = kronrod_weight(_k) * _part;
              _level = _level + abs(_part);
              _total = _sum + _part;
              _lost = _lost + ((_sum - _total) + _part);
              _sum = _total;
              _k = _k + 1;
            }}
            _size = _size + _level;"
        )
    };
    let begin = "_sum = 0; _lost = 0; _size = 0; _gauss = 0; _level = 0;";
    let end = |width: &str| {
        format!(
            "_doubt = _doubt + {width} * abs(_gauss - _sum);
            _magnitude = _magnitude + {width} * _size;
            _integral = _integral + {width} * (_sum + _lost);"
        )
    };
    let inner = if is_graded {
        // The intervals are 7/8 of what remains to the end, and their lengths are powers of 1/8 times the first one.
        format!(
            "_whole = 0.5 * _width; _side = 0;
            while _side <= 1 {{
              {begin} _scale = 1;
              while _scale > {LEAST_SCALE:?} {{
                _level = 0;
                {}
                _scale = 0.125 * _scale;
                if _level < {NEGLIGIBLE:?} * _size {{ _scale = 0; }}
              }}
              {}
              _side = _side + 1;
            }}",
            sum(
                "_angle = _whole * _scale * (0.125 + 0.875 * kronrod_place(_k));
                 if _side == 1 { _angle = _width - _angle; }",
                "_scale * "
            ),
            end("0.875 * _whole")
        )
    } else {
        format!("{begin} {} {}", sum("_angle = _width * kronrod_place(_k);", ""), end("_width"))
    };
    let inner = format!("_start = {start}; {width} {inner}");
    match &extent.lower {
        None => inner,
        Some(b) => format!("if {coordinate} > {b} {{ {inner} }}"),
    }
}
