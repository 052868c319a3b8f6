//! Known mistakes about the place of the axis.
#![cfg(feature = "cli")]

use sneddon::validate::inner::{Extent, placings};

const N: i32 = 8;

/// Coordinates of a line of 8 pixels of size 1, and the place of each counted from the axis as the data have it.
fn explains(id: &str, coordinate: impl Fn(i32) -> f64, truth: impl Fn(i32) -> f64) -> bool {
    let mut extent = Extent::NONE;
    (0..N).for_each(|own| extent.take(0, coordinate(own)));
    placings(&extent, Some(1.0), None).iter().any(|placing| {
        placing.id == id && (0..N).all(|own| (placing.at(coordinate(own), f64::NAN).0.abs() - truth(own).abs()).abs() < 1e-12)
    })
}

#[test]
fn known_mistakes_are_put_right() {
    let wrapped = |own: i32| f64::from(if own < N / 2 { own } else { own - N });
    let centred = |own: i32| f64::from(own - N / 2);
    // Coordinates from 0, the axis on pixel 4 or between pixels 3 and 4.
    assert!(explains("origin-corner", f64::from, centred));
    assert!(explains("origin-corner", f64::from, |own| centred(own) + 0.5));
    assert!(explains("origin-corner", |own| f64::from(own) + 0.5, |own| centred(own) + 0.5));
    // The first pixel is the axis, whatever the coordinates say.
    assert!(explains("fftshift", f64::from, wrapped));
    assert!(explains("fftshift", centred, wrapped));
    assert!(explains("fftshift", |own| centred(own) + 0.5, wrapped));
}
