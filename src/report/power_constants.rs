//! The constants κ_n of power-law profiles, as text, CSV and JSON.

use super::text::{error, number, table};
use crate::expr::Expr;
use crate::num::Estimate;
use crate::print;
use serde::Serialize;
use std::io::{self, Write};

/// κ_n for one exponent.
pub struct PowerConstant {
    /// n.
    pub exponent: f64,
    /// κ_n.
    pub value: Estimate,
    /// κ_n as an expression, if n is whole and at most 120: a fraction or a multiple of π.
    pub exact: Option<Expr>,
}

/// Writes a table.
///
/// # Errors
/// Returns the errors of the writer.
pub fn as_text(list: &[PowerConstant], out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "kappa_n = sqrt(pi)*gamma(n/2 + 1)/gamma(n/2 + 1/2): f(r) = C*r^n has g(x) = kappa_n*C*x^n\n")?;
    let rows = || {
        list.iter().map(|own| {
            let exact = own.exact.as_ref().map_or(String::new(), print::text_expr);
            [number(own.exponent), number(own.value.value), error(&own.value), exact]
        })
    };
    table(&["n", "kappa_n", "error", "exact"], rows, out)
}

/// Writes comma-separated values.
///
/// # Errors
/// Returns the errors of the writer.
pub fn as_csv(list: &[PowerConstant], out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "n,kappa_n,error,bound")?;
    let row = |own: &PowerConstant| (own.exponent, own.value.value, own.value.error, own.value.bound.name());
    list.iter().map(row).try_for_each(|(n, value, error, bound)| writeln!(out, "{n:?},{value:?},{error:?},{bound}"))
}

/// Writes JSON.
///
/// # Errors
/// Returns the errors of the writer.
pub fn as_json(list: &[PowerConstant], out: &mut dyn Write) -> io::Result<()> {
    #[derive(Serialize)]
    struct Document {
        points: Vec<Point>,
    }
    #[derive(Serialize)]
    struct Point {
        at: f64,
        value: f64,
        error_estimate: f64,
        bound: &'static str,
        exact: Option<String>,
    }
    let point = |own: &PowerConstant| Point {
        at: own.exponent,
        value: own.value.value,
        error_estimate: own.value.error,
        bound: own.value.bound.name(),
        exact: own.exact.as_ref().map(print::text_expr),
    };
    super::json::write("kappa", &Document { points: list.iter().map(point).collect() }, out)
}
