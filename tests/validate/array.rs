//! NumPy's arrays: every kind of number, shapes, fields and texts.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, clippy::indexing_slicing)]

use sneddon::validate::inner::array;

fn file(kind: &str, order: &str, shape: &str, data: &[u8]) -> Vec<u8> {
    let text = format!("{{'descr': {kind}, 'fortran_order': {order}, 'shape': {shape}, }}\n");
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((text.len() as u16).to_le_bytes());
    bytes.extend(text.as_bytes());
    bytes.extend(data);
    bytes
}

#[test]
fn every_kind_of_number_is_read() {
    let one = |kind: &str, data: &[u8]| array("a", &file(kind, "False", "(1,)", data)).unwrap()[0].values[0];
    assert_eq!(one("'<f8'", &(-2.5_f64).to_le_bytes()), -2.5);
    assert_eq!(one("'>f8'", &(-2.5_f64).to_be_bytes()), -2.5);
    assert_eq!(one("'<f4'", &1.5_f32.to_le_bytes()), 1.5);
    assert_eq!(one("'<i2'", &(-3_i16).to_le_bytes()), -3.0);
    assert_eq!(one("'>i4'", &(-70_000_i32).to_be_bytes()), -70_000.0);
    assert_eq!(one("'<i8'", &(-5_i64).to_le_bytes()), -5.0);
    assert_eq!(one("'|u1'", &[200]), 200.0);
    assert_eq!(one("'|b1'", &[1]), 1.0);
    for bad in ["'<c16'", "'|O'", "'<M8[ns]'"] {
        assert!(array("a", &file(bad, "False", "(1,)", &[0; 16])).is_err(), "{bad}");
    }
}

#[test]
fn shapes_fields_and_texts_are_read() {
    let bytes: Vec<u8> = (0..6).flat_map(|i| f64::from(i).to_le_bytes()).collect();
    let rows = array("p", &file("'<f8'", "False", "(2, 3)", &bytes)).unwrap();
    assert_eq!((rows[0].shape.as_slice(), rows[0].values[3]), (&[2, 3][..], 3.0));
    // Column by column: element (1, 0) is the second number of the file.
    let columns = array("p", &file("'<f8'", "True", "(2, 3)", &bytes)).unwrap();
    assert_eq!(columns[0].values, [0.0, 2.0, 4.0, 1.0, 3.0, 5.0]);
    let fields = array("x", &file("[('d', '<f8'), ('F', '<f8')]", "False", "(3,)", &bytes)).unwrap();
    assert_eq!((fields[1].name.as_str(), fields[1].values.as_slice()), ("F", &[1.0, 3.0, 5.0][..]));
    let text: Vec<u8> = "um".chars().flat_map(|c| u32::from(c).to_le_bytes()).collect();
    assert_eq!(array("d_unit", &file("'<U2'", "False", "()", &text)).unwrap()[0].text.as_deref(), Some("um"));
    assert!(array("p", &file("'<f8'", "False", "(7,)", &bytes)).unwrap_err().contains("truncated"));
    assert!(array("p", b"\x93NUMPY\x01").is_err());
}
