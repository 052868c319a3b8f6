//! Orders of convergence and the error that no grid cures.
#![cfg(feature = "cli")]

use sneddon::validate::inner::{Level, limit_error, order};

fn level(pixel: f64, errors: Vec<Option<f64>>) -> Level {
    Level { pixel, signed: errors.clone(), errors }
}

fn levels(order: f64, noise: [[f64; 3]; 3]) -> Vec<Level> {
    let errors = |h: f64, row: [f64; 3]| row.iter().enumerate().map(|(i, n)| Some((i + 1) as f64 * h.powf(order) * n.exp())).collect();
    [0.25, 0.125, 0.0625].into_iter().zip(noise).map(|(pixel, row)| level(pixel, errors(pixel, row))).collect()
}

#[test]
fn a_pure_power_has_its_order() {
    let found = order(&levels(1.7, [[0.0; 3]; 3]), 1e-12).unwrap();
    assert!((found.value - 1.7).abs() < 1e-12);
    assert!((found.high.unwrap() - found.low.unwrap()).abs() < 1e-6);
}

#[test]
fn the_interval_is_that_of_textbooks() {
    // Worked by hand: residuals ±0.1 at the middle level of two loads, none at the third; S_xx = 6 ln² 2.
    let found = order(&levels(1.0, [[0.0; 3], [0.1, -0.1, 0.0], [0.0; 3]]), 1e-12).unwrap();
    assert!((found.value - 1.0).abs() < 1e-12);
    // Each of the two loads leaves 0.01·(1 − 1/3); freedom 9 − 3 − 1 = 5, t = 2.570581836.
    let expected = 2.570_581_836 * (2.0 * 0.01 * 2.0 / 3.0 / 5.0 / (6.0 * 2f64.ln().powi(2))).sqrt();
    assert!((found.high.unwrap() - 1.0 - expected).abs() < 1e-8);
}

#[test]
fn a_plateau_is_a_floor_and_a_constant_error_is_none() {
    let level = |pixel, e: f64| level(pixel, vec![Some(e), Some(1.1 * e), Some(0.9 * e)]);
    let found = order(&[level(0.4, 1e-2), level(0.2, 2.5e-3), level(0.1, 1e-3), level(0.05, 1e-3)], 1e-9).unwrap();
    assert!(found.floor.is_some() && found.files == 3);
    let flat = order(&[level(0.4, 1.8e-2), level(0.2, 1.81e-2), level(0.1, 1.79e-2)], 1e-9).unwrap();
    assert!(flat.floor.is_none() && flat.low.unwrap() < 0.0 + 0.05 && flat.value.abs() < 0.01);
    assert!(order(&[level(0.4, 1e-12), level(0.2, 1e-12)], 1e-9).is_none());
}

#[test]
fn one_load_has_ratios() {
    let level = |pixel, e: f64| level(pixel, vec![Some(e)]);
    let found = order(&[level(0.4, 4e-2), level(0.2, 1e-2), level(0.1, 5e-3)], 1e-9).unwrap();
    assert!((found.low.unwrap() - 1.0).abs() < 1e-12 && (found.high.unwrap() - 2.0).abs() < 1e-12 && (found.value - 1.5).abs() < 1e-12);
}

#[test]
fn what_no_grid_cures_is_in_its_interval() {
    let errors = |e0: f64, q: f64| -> Vec<Level> {
        [0.25, 0.125, 0.0625].map(|h: f64| level(h, (1..5).map(|c| Some(e0 + 0.1 * f64::from(c) * h.powf(q))).collect())).into()
    };
    for (e0, q) in [(0.01, 1.0), (-0.01, 2.0), (0.0, 1.0), (-0.02, 0.75)] {
        let (low, high) = limit_error(&errors(e0, q)).unwrap();
        assert!(low <= e0 + 1e-15 && e0 <= high + 1e-15, "{e0} {q}: {low} {high}");
    }
    // A punch whose force is 1 % too small: 1.1 %, 0.46 % and 0.23 % of the grid hide it, its limit does not.
    let hidden = [(0.1, 0.001), (0.05, -0.0054), (0.025, -0.0077)].map(|(h, e)| level(h, vec![Some(e), Some(e), Some(e)]));
    let (_, high) = limit_error(&hidden).unwrap();
    assert!(high < -0.005, "{high}");
}
