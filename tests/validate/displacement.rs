//! Faults of displacements have their names.
#![cfg(feature = "cli")]

use sneddon::validate::inner::Displacements;

fn named(change: impl Fn(f64) -> f64) -> Option<&'static str> {
    let mut own = Displacements::new(false);
    for index in 0..50 {
        let r = f64::from(index) / 20.0;
        let exact = 1.0 / (1.0 + r);
        own.push(r, change(exact) * (1.0 + 1e-4 * (7.0 * r).sin()), exact);
    }
    own.suspicion(1e-3, Some(0.91), &|own| own.to_string()).map(|own| own.id)
}

#[test]
fn every_fault_of_a_displacement_has_its_name() {
    assert_eq!(named(|u| u), None);
    assert_eq!(named(|u| -u), Some("u-sign"));
    assert_eq!(named(|u| u + 0.3), Some("u-constant"));
    assert_eq!(named(|u| u - 0.5), Some("u-constant"));
    assert_eq!(named(|u| 0.2 - u), Some("u-sign"));
    assert_eq!(named(|u| 1.07 * u), Some("u-scale"));
    assert_eq!(named(|u| 1.1 * u), Some("u-scale"));
    assert_eq!(named(|u| 1e3 * u), Some("u-scale"));
    assert_eq!(named(|u| 0.91 * u), Some("modulus"));
    assert_eq!(named(|u| u * u), None);
}
