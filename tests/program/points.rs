//! Lists and ranges of points on the command line.
#![cfg(feature = "cli")]

use sneddon::cli::inner::{CallUnits, read};
use sneddon::contact::Dimension;

fn bare(list: &str) -> Result<Vec<f64>, impl std::fmt::Debug> {
    read(list, &CallUnits::of(&[], &[], None), Dimension::LENGTH)
}

#[test]
fn lists_and_ranges() {
    assert_eq!(bare("0.1, 3/2,1e-6").unwrap(), [0.1, 1.5, 1e-6]);
    assert_eq!(bare("0:1:5").unwrap(), [0.0, 0.25, 0.5, 0.75, 1.0]);
    assert_eq!(bare("2:1:1").unwrap(), [2.0]);
    // Every point is the double nearest to its decimal.
    assert_eq!(bare("0.1:0.5:5").unwrap(), [0.1, 0.2, 0.3, 0.4, 0.5]);
    let log = bare("log:0.01:100:5").unwrap();
    assert_eq!((log[0], log[4], log.len()), (0.01, 100.0, 5));
    assert!((log[2] - 1.0).abs() < 1e-15);
}

#[test]
fn what_is_no_list() {
    for text in [
        "",
        " ",
        ",",
        "1,",
        "-1",
        "nan",
        "inf",
        "1e999",
        "1:2",
        "1:2:0",
        "1:2:-3",
        "1:2:1e9",
        "log:0:1:5",
        "1:2:3:4",
        "0:1:10000001",
        "2,0:-1:3",
    ] {
        assert!(bare(text).is_err(), "{text}");
    }
}
