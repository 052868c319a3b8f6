//! The table: for every work the fastest peer that is accurate enough, ours, their ratio and the target.

use std::collections::BTreeMap;
use std::fs;

/// One measurement; of several runs the fastest.
struct Measurement {
    who: String,
    form: String,
    ns: f64,
    error: f64,
    evaluations: u64,
}

/// A peer counts where its relative error is at most this.
const ENOUGH: f64 = 1e-12;

fn main() {
    let mut arguments = std::env::args().skip(1);
    let targets = arguments.next().expect("the file of targets, then files of measurements");
    let mut all: BTreeMap<String, Vec<Measurement>> = BTreeMap::new();
    for file in arguments {
        for row in fs::read_to_string(&file).unwrap_or_default().lines() {
            let cells: Vec<&str> = row.split(',').collect();
            let [work, who, form, ns, error, evaluations] = cells[..] else { continue };
            let (Ok(ns), Ok(error), Ok(evaluations)) = (ns.parse(), error.parse(), evaluations.parse()) else { continue };
            let own = all.entry(work.to_owned()).or_default();
            match own.iter_mut().find(|known| known.who == who && known.form == form) {
                Some(known) => known.ns = known.ns.min(ns),
                None => own.push(Measurement { who: who.to_owned(), form: form.to_owned(), ns, error, evaluations }),
            }
        }
    }
    let header = ["work", "ours as", "fastest peer", "its ns", "its error", "our ns", "our error", "our f'", "ratio", "target", "met"];
    let mut table = vec![header.map(str::to_owned)];
    for row in fs::read_to_string(&targets).expect("the file of targets").lines().skip(1) {
        let cells: Vec<&str> = row.split(',').collect();
        let [work, form, rival, most, sharp] = cells[..] else { continue };
        // What has no target is shown for comparison.
        let target: Option<(f64, f64)> = (!most.is_empty()).then(|| (most.parse().expect("a ratio"), sharp.parse().expect("an error")));
        let list = all.get(work).map_or(&[][..], Vec::as_slice);
        let eligible = |own: &&Measurement| own.who != "ours" && own.error <= ENOUGH && (rival == "any" || own.who == rival);
        let peer = list.iter().filter(eligible).min_by(|one, other| one.ns.total_cmp(&other.ns));
        let ours = list.iter().find(|own| own.who == "ours" && own.form == form);
        let text = |own: Option<&Measurement>, of: &dyn Fn(&Measurement) -> String| own.map_or("-".to_owned(), of);
        let ratio = peer.zip(ours).map(|(peer, ours)| ours.ns / peer.ns);
        let met = |(most, sharp): (f64, f64)| match ratio {
            None => "not measured",
            Some(ratio) if ratio <= most && ours.is_some_and(|own| own.error <= sharp) => "yes",
            Some(_) => "NO",
        };
        table.push([
            work.to_owned(),
            form.to_owned(),
            text(peer, &|own| format!("{} {}", own.who, own.form)),
            text(peer, &|own| short(own.ns)),
            text(peer, &|own| format!("{:.0e}", own.error)),
            text(ours, &|own| short(own.ns)),
            text(ours, &|own| format!("{:.0e}", own.error)),
            text(ours, &|own| own.evaluations.to_string()),
            ratio.map_or("-".to_owned(), |ratio| format!("{ratio:.3}")),
            target.map_or("-".to_owned(), |(most, sharp)| format!("{most}, {sharp:.0e}")),
            target.map_or("", met).to_owned(),
        ]);
    }
    let widths: Vec<usize> =
        (0..header.len()).map(|column| table.iter().map(|row| row[column].chars().count()).max().unwrap_or(0)).collect();
    for row in &table {
        let cells: Vec<String> = row.iter().zip(&widths).map(|(cell, width)| format!("{cell:<width$}")).collect();
        println!("{}", cells.join("  ").trim_end());
    }
}

/// Three digits.
fn short(ns: f64) -> String {
    if ns < 10.0 {
        format!("{ns:.2}")
    } else if ns < 100.0 {
        format!("{ns:.1}")
    } else {
        format!("{ns:.0}")
    }
}
