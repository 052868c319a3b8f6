//! A study as a table for the terminal.

use super::super::text::{number, short, table};
use super::{Tradeoff, duration};
use crate::print;
use std::io::{self, Write};

/// Writes the problem, the table, missing results, and the recommendations.
///
/// # Errors
/// Returns the errors of the writer.
pub fn tradeoff(record: &Tradeoff<'_>, out: &mut dyn Write) -> io::Result<()> {
    let problem = &record.study.problem;
    let (quantity, coordinate) = (problem.quantity.key(), problem.quantity.coordinate());
    writeln!(out, "{quantity}({coordinate}) of f(r) = {}", print::text(record.profile))?;
    let mut given: Vec<String> = record.parameters.iter().map(|(name, value)| format!("{name} = {}", number(*value))).collect();
    given.extend(problem.radius.map(|a| format!("a = {}", number(a))));
    if !given.is_empty() {
        writeln!(out, "with {}", given.join(", "))?;
    }
    let (low, high) = problem.points.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), x| (low.min(*x), high.max(*x)));
    writeln!(out, "at {} points, {coordinate} from {low:.3} to {high:.3}", problem.points.len())?;
    writeln!(out, "true errors against: {}, relative error at most {}", record.reference(), short(record.reference_error()))?;
    writeln!(out, "times: {}, medians and middle halves of shuffled rounds\n", record.study.clock)?;
    let header = ["", "method", "setting", "true error", "stated", "per point", "middle half", "set-up", "evaluations"];
    let rows = || {
        record.rows().map(|row| {
            let error = if row.at_most { format!("<= {}", short(row.error)) } else { short(row.error) };
            let stated = match (row.claimed, row.honest) {
                (Some(claimed), Some(true)) => short(claimed),
                (Some(claimed), _) => format!("{} TOO LOW", short(claimed)),
                _ => "-".to_owned(),
            };
            [
                if row.front { "*" } else { "" }.to_owned(),
                row.method.to_owned(),
                row.setting.clone(),
                error,
                stated,
                duration(row.time.median),
                format!("{} - {}", duration(row.time.low), duration(row.time.high)),
                duration(row.set_up),
                if row.evaluations == 0.0 { "-".to_owned() } else { format!("{:.0}", row.evaluations) },
            ]
        })
    };
    table(&header, rows, out)?;
    writeln!(out, "\n* no other entry is both as accurate and faster; errors are the largest relative errors over the points")?;
    if !record.study.skipped.is_empty() {
        writeln!(out, "\nWithout result")?;
        for own in &record.study.skipped {
            let setting = own.setting.as_ref().map_or(String::new(), |setting| format!(" ({setting})"));
            writeln!(out, "  {}{setting}: {}", own.method, own.why)?;
        }
    }
    writeln!(out)?;
    record.sentences().iter().try_for_each(|sentence| writeln!(out, "{sentence}"))
}
