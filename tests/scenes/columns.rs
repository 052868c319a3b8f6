//! Columns of a file of points: headers with units, delimiters, quotes, comments, and the places of what is no number.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used)]

use sneddon::scene::inner::{parts, sheet};

#[test]
fn ways_to_write_a_unit() {
    for text in ["r_um", "r [um]", "r (um)", "r/um", "r / um", "r um", "R[um]"] {
        let (name, unit) = parts(text);
        assert_eq!((name.to_lowercase().as_str(), unit), ("r", Some("um")), "{text}");
    }
    assert_eq!(parts("r"), ("r", None));
}

fn rows(text: &str) -> Vec<(f64, f64)> {
    sheet(text, false).unwrap().rows.iter().map(|row| (row.r, row.z)).collect()
}

#[test]
fn delimiters_quotes_and_comments() {
    let expected = vec![(0.0, 0.5), (1.0, 1.5)];
    for text in [
        "r_um,z_nm\n0,0.5\n1,1.5\n",
        "\u{feff}# from a microscope\r\nr [um];z [nm]\r\n0;0,5\r\n\r\n1;1,5\r\n",
        "r (um)\tz (nm)\n0\t0.5\n1\t1.5",
        "r [um]  z [nm]\n  0   0.5\n  1   1.5\n",
        "# r_um z_nm\n0 0.5\n# half way\n1 1.5\n",
        "# tip 7\n# r_um, z_nm\n0 0.5\n1 1.5\n",
        "\"r_um\",\"z_nm\"\n\"0\",\"0.5\"\n1,1.5,\n",
        "name,z_nm,r_um\nfirst,0.5,0\n\"second, last\",1.5,1\n",
        "r_um,z_nm\r0,0.5\r1,1.5\r",
    ] {
        assert_eq!(rows(text), expected, "{text:?}");
    }
}

#[test]
fn places_are_those_of_the_fields() {
    for (text, marked) in
        [("r_um,z_nm\n0,1\n1, x7 \n", "x7"), ("r;z\n0;\"nan\"\n", "nan"), ("# a\nr z\n1 2 3\n", "1 2 3"), ("r,z\n1,2e999\n", "2e999")]
    {
        let span = sheet(text, false).unwrap_err().span().unwrap();
        assert_eq!(&text[span], marked, "{text:?}");
    }
}
