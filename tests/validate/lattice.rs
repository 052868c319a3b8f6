//! The pixel of a lattice, from distances and from counted areas.
#![cfg(feature = "cli")]

use sneddon::validate::inner::{Offset, of_areas, of_distances};

#[test]
fn the_pixel_is_found_wherever_the_axis_stands() {
    for (offset, shift) in [(Offset::Centre, (0.0, 0.0)), (Offset::Corner, (0.5, 0.5))] {
        let mut r: Vec<f64> = (0..9)
            .flat_map(|i| (0..9).map(move |j| 0.3 * (f64::from(i) + shift.0).hypot(f64::from(j) + shift.1)))
            .filter(|r| *r < 2.4)
            .collect();
        r.sort_by(f64::total_cmp);
        r.dedup_by(|one, other| (*one - *other).abs() < 1e-9);
        let found = of_distances(&r).unwrap();
        assert!((found.pixel - 0.3).abs() < 1e-12 && found.offset == offset, "{offset:?} {found:?}");
    }
}

#[test]
fn counted_areas_betray_the_pixel() {
    let counts = [341, 683, 998, 1301, 1597, 2011];
    let a = counts.map(|n: i32| (f64::from(n) * 0.05 * 0.05 / std::f64::consts::PI).sqrt());
    let load = |index: usize| 0.1 * (index + 1) as f64;
    let printed: Vec<(f64, f64)> = a.iter().enumerate().map(|(i, a)| (format!("{a:.8}").parse().unwrap(), load(i))).collect();
    assert!((of_areas(&printed).unwrap() - 0.05).abs() < 1e-6);
    let any = [0.511, 0.72312, 0.8853, 1.0212, 1.2345];
    assert_eq!(of_areas(&any.iter().enumerate().map(|(i, a)| (*a, load(i))).collect::<Vec<_>>()), None);
    // a = √(R d) at even steps has areas in whole ratios, but no pixels.
    let computed: Vec<(f64, f64)> = (0..10).map(|i| ((10.0 * load(i)).sqrt(), load(i))).collect();
    assert_eq!(of_areas(&computed), None);
}
