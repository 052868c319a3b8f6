//! NumPy's files as they are written: aligned heads.
#![cfg(feature = "cli")]

use sneddon::report::inner::header;

#[test]
fn headers_are_aligned() {
    for shape in [&[][..], &[3], &[2, 5, 7]] {
        let bytes = header("<f8", shape);
        assert_eq!(bytes.len() % 64, 0);
        assert_eq!(bytes.last(), Some(&b'\n'));
    }
}
