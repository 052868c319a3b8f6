//! A validation as JSON.

use crate::validate::{Column, FileReport, Order, Suspicion, Validation};
use serde_json::{Map, Value, json};
use std::io::{self, Write};

/// Writes the document.
///
/// # Errors
/// Returns the errors of the writer.
pub fn validation(validation: &Validation, out: &mut dyn Write) -> io::Result<()> {
    let mut document = json!({
        "passed": validation.passed,
        "reason": validation.reason,
        "suspicion": validation.suspicion.as_ref().map(|own| own.text.clone()),
        "suspicion_details": validation.suspicion.as_ref().map(suspicion),
        "columns": columns(&validation.columns),
        "order": validation.orders.as_ref().map(|own| own.iter().map(|(name, order)| ((*name).to_owned(), one_order(order))).collect::<Map<_, _>>()),
        "files": validation.files.iter().map(file).collect::<Vec<_>>(),
        "notes": validation.notes,
    });
    if let (Some(why), Some(map)) = (validation.cut_short, document.as_object_mut()) {
        map.insert("complete".to_owned(), json!(false));
        map.insert("why".to_owned(), json!(why));
    }
    super::super::json::write("validate", &document, out)
}

fn suspicion(own: &Suspicion) -> Value {
    json!({ "id": own.id, "l2_before": own.before, "l2_after": own.after })
}

fn columns(list: &[Column]) -> Value {
    Value::Object(list.iter().map(|own| (own.name.to_owned(), column(own))).collect())
}

fn column(own: &Column) -> Value {
    let mut value = json!({
        "l1": own.l1,
        "l2": own.l2,
        "max": own.max,
        "worst_at": own.worst_at,
        "bias": own.bias,
        "rows": own.rows,
        "at_largest_load": own.at_largest_load,
        "tolerance": own.tolerance,
        "passed": own.passed,
    });
    if let (Some(map), Some(pixels)) = (value.as_object_mut(), own.pixels) {
        map.insert("pixels".to_owned(), json!(pixels));
    }
    if let (Some(map), Some(out)) = (value.as_object_mut(), own.excluded) {
        map.insert("excluded".to_owned(), json!({ "rows": out.rows, "infinite": out.infinite, "l2": out.l2, "max": out.max }));
    }
    if let (Some(map), None) = (value.as_object_mut(), own.tolerance) {
        let why =
            if own.name == "a" { "contact radii are judged only if the pixel is known" } else { "this column is reported, but not judged" };
        map.insert("why".to_owned(), json!(why));
    }
    value
}

fn one_order(own: &Order) -> Value {
    let mut value = json!({ "value": own.value, "low": own.low, "high": own.high, "files": own.files, "floor": own.floor });
    if let (Some(map), None) = (value.as_object_mut(), own.low) {
        map.insert("why".to_owned(), json!("two files with one load are not enough to judge the order"));
    }
    value
}

fn file(own: &FileReport) -> Value {
    json!({
        "name": own.name,
        "grid": own.grid,
        "pixel_over_contact_radius": own.pixel,
        "rows": own.rows,
        "columns": columns(&own.columns),
        "notes": own.notes,
    })
}
