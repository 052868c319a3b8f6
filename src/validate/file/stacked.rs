//! Fields under several loads as written by `sneddon reference` in JSON and NPY, converted to columns that include the load.

use crate::scene::{Dimension, Scene};
use crate::validate::ValidationError;
use crate::validate::file::array::Array;
use crate::validate::file::layout::{Averaging, Columns, Layout, columns};
use serde::Deserialize;

/// The fields under one load: the load in the unit of the file, and the arrays.
struct Fields {
    load: Option<f64>,
    arrays: Vec<Array>,
}

#[derive(Deserialize)]
struct Head {
    schema: String,
}

#[derive(Deserialize)]
struct Document {
    units: Option<StackUnits>,
    grid: Grid,
    loads: Vec<Load>,
}

#[derive(Deserialize)]
struct StackUnits {
    length: String,
    pressure: String,
}

#[derive(Deserialize)]
struct Grid {
    #[serde(default)]
    r: Vec<f64>,
    #[serde(default)]
    x: Vec<f64>,
    #[serde(default)]
    y: Vec<f64>,
    cells: bool,
}

#[derive(Deserialize)]
struct Load {
    d: Option<f64>,
    fields: Vec<Field>,
}

#[derive(Deserialize)]
struct Field {
    quantity: String,
    values: Rows,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Rows {
    Line(Vec<Option<f64>>),
    Square(Vec<Vec<Option<f64>>>),
}

const HELP: &str = "expected a JSON document of `sneddon reference`, or CSV, NPY or NPZ";
const SCHEMA: &str = "sneddon/reference/";

/// Reads a document of `sneddon reference`; points without a pressure, where it is infinite or no contact is valid, are skipped.
pub(in crate::validate) fn json(file: &str, bytes: &[u8], layout: &Layout) -> Result<Columns, ValidationError> {
    let fault = |message: String| ValidationError::data(file, None, message, HELP);
    // Check the schema first, since other documents lack required keys.
    if let Ok(Head { schema }) = serde_json::from_slice(bytes)
        && !schema.starts_with(SCHEMA)
    {
        return Err(fault(format!("expected fields, but the document has the schema {schema:?}")));
    }
    let document: Document = serde_json::from_slice(bytes).map_err(|error| fault(format!("invalid JSON data: {error}")))?;
    let units = document.units.as_ref();
    let named = |name: &str, unit: Option<&String>| {
        unit.filter(|own| !own.is_empty()).map_or_else(|| name.to_owned(), |unit| format!("{name}_{unit}"))
    };
    let length = units.map(|own| &own.length);
    let line =
        |name: &str, values: &[f64]| Array { name: named(name, length), shape: vec![values.len()], values: values.to_vec(), text: None };
    let places: Vec<Array> = [("r", &document.grid.r), ("x", &document.grid.x), ("y", &document.grid.y)]
        .into_iter()
        .filter(|own| !own.1.is_empty())
        .map(|(name, values)| line(name, values))
        .collect();
    let mut loads = Vec::new();
    for load in document.loads.into_iter().filter(|own| own.d.is_some()) {
        let mut arrays = places.clone();
        for field in load.fields {
            let unit = if field.quantity == "p" { units.map(|own| &own.pressure) } else { length };
            let (shape, values) = match field.values {
                Rows::Line(own) => (vec![own.len()], own),
                Rows::Square(own) => (vec![own.len(), own.first().map_or(0, Vec::len)], own.into_iter().flatten().collect()),
            };
            if shape.iter().product::<usize>() != values.len() {
                return Err(fault(format!("the rows of {} differ in length", field.quantity)));
            }
            let values = values.into_iter().map(|own| own.unwrap_or(f64::NAN)).collect();
            arrays.push(Array { name: named(&field.quantity, unit), shape, values, text: None });
        }
        loads.push(Fields { load: load.d, arrays });
    }
    let mut all = joined(file, &named("d", length), loads, layout)?;
    all.averaging = Some(match (document.grid.cells, document.grid.r.is_empty()) {
        (false, _) => Averaging::Values,
        (true, true) => Averaging::OverSquares,
        (true, false) => Averaging::OverRings,
    });
    Ok(all)
}

/// Returns `true` for the shape (loads, fields, 2, …places) of values and their errors.
pub(in crate::validate) fn is_reference(shape: &[usize]) -> bool {
    matches!(shape, [_, _, 2, _] | [_, _, 2, _, _])
}

/// Reads an array of `sneddon reference -o FILE.npy`, whose loads, fields and radii are defined by the scene.
pub(in crate::validate) fn npy(file: &str, array: &Array, layout: &Layout, scene: &Scene) -> Result<Columns, ValidationError> {
    let fault = |message: String, help: &str| Err(ValidationError::data(file, None, message, help));
    let (&[count, quantities, _, ..], Some(places)) = (array.shape.as_slice(), array.shape.get(3..)) else {
        return fault("the array has no fields".to_owned(), HELP);
    };
    let (curves, _) = scene.outputs.fields()?;
    if count != scene.loads.len() || quantities != curves.len() {
        let (loads, own) = (scene.loads.len(), curves.len());
        let message = format!("the array has {count} loads and {quantities} fields, but the scene has {loads} and {own}");
        return fault(message, "expected the array of `sneddon reference` for the same scene");
    }
    let mut radii = Vec::new();
    if let [count] = *places {
        let factor = scene.system.out(Dimension::LENGTH);
        radii = scene.outputs.at.iter().map(|own| own * factor).collect();
        if radii.len() != count {
            let message = format!("the array has {count} radii, but `at` in [outputs] of the scene has {}", radii.len());
            return fault(
                message,
                "expected the radii that were used for sneddon reference, such as the grid \"0:2 um:81\", or CSV or JSON, which contain them",
            );
        }
    }
    let each: usize = places.iter().product();
    let mut loads = Vec::new();
    for (index, load) in scene.loads.iter().enumerate() {
        let mut arrays = Vec::new();
        if !radii.is_empty() {
            arrays.push(Array { name: "r".to_owned(), shape: places.to_vec(), values: radii.clone(), text: None });
        }
        for (field, curve) in curves.iter().enumerate() {
            let begin = 2 * (index * quantities + field) * each;
            let values = array.values.get(begin..begin + each).unwrap_or_default();
            // The pressure is infinite at a rim.
            let values = values.iter().map(|own| if own.is_finite() { *own } else { f64::NAN }).collect();
            arrays.push(Array { name: curve.key().to_owned(), shape: places.to_vec(), values, text: None });
        }
        loads.push(Fields { load: Some(load * scene.system.out(scene.control.datum().dimension())), arrays });
    }
    let all = joined(file, scene.control.datum().key(), loads, layout)?;
    let cells = layout.cells.or(scene.data.as_ref().and_then(|own| own.cells));
    let averaging = cells.filter(|own| *own && !radii.is_empty()).map(|_| Averaging::OverRings);
    Ok(Columns { radii: !radii.is_empty(), averaging, ..all })
}

/// Returns `true` for a stack of pressure fields, one for each load of the scene.
pub(in crate::validate) fn is_stack(shape: &[usize], layout: &Layout, scene: &Scene) -> bool {
    let count = scene.loads.len();
    count > 1 && layout.map.is_empty() && matches!(shape, [own, _, _] if *own == count)
}

/// Reads a stack of pressure fields, one for each load of the scene.
pub(in crate::validate) fn stack(file: &str, array: &Array, layout: &Layout, scene: &Scene) -> Result<Columns, ValidationError> {
    let places = array.shape.get(1..).unwrap_or_default();
    let field = |values: &[f64]| Array { name: "p".to_owned(), shape: places.to_vec(), values: values.to_vec(), text: None };
    let shown = |load: f64| load * scene.system.out(scene.control.datum().dimension());
    let fields = array.values.chunks(places.iter().product::<usize>().max(1));
    let loads = scene.loads.iter().zip(fields).map(|(load, values)| Fields { load: Some(shown(load)), arrays: vec![field(values)] });
    let mut all = joined(file, scene.control.datum().key(), loads.collect(), layout)?;
    all.notes.push("the fields of the array are read as p under the loads of the scene, in this order".to_owned());
    Ok(all)
}

/// Returns the columns of all loads one below the other; rows without a number are skipped.
fn joined(file: &str, name: &str, loads: Vec<Fields>, layout: &Layout) -> Result<Columns, ValidationError> {
    let mut all = Columns { names: Vec::new(), values: Vec::new(), notes: Vec::new(), placed: false, averaging: None, radii: false };
    let mut without = 0;
    for Fields { load, arrays } in loads {
        let own = columns(file, arrays, layout)?;
        if all.names.is_empty() {
            all.names = [&[name.to_owned()], own.names.as_slice()].concat();
            all.values = vec![Vec::new(); all.names.len()];
            (all.notes, all.placed) = (own.notes, own.placed);
        }
        let rows = own.values.first().map_or(0, Vec::len);
        for row in 0..rows {
            let numbers: Vec<f64> = load.into_iter().chain(own.values.iter().filter_map(|column| column.get(row).copied())).collect();
            if numbers.iter().any(|own| own.is_nan()) || numbers.len() != all.values.len() {
                without += 1;
                continue;
            }
            all.values.iter_mut().zip(numbers).for_each(|(column, number)| column.push(number));
        }
    }
    if without > 0 {
        all.notes
            .push(format!("{without} rows with an empty field are skipped, as for an infinite pressure or beyond the end of the profile"));
    }
    Ok(all)
}
