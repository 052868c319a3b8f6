//! NumPy's files as they are written: checksums and aligned heads.
#![cfg(feature = "cli")]

use sneddon::report::inner::{checksum, header};

/// The check value that the catalogue of parametrised CRC algorithms states for CRC-32/ISO-HDLC.
#[test]
fn the_checksum_is_that_of_zip() {
    assert_eq!(checksum(b"123456789"), 0xCBF4_3926);
    assert_eq!(checksum(b""), 0);
}

#[test]
fn headers_are_aligned() {
    for shape in [&[][..], &[3], &[2, 5, 7]] {
        let bytes = header("<f8", shape);
        assert_eq!(bytes.len() % 64, 0);
        assert_eq!(bytes.last(), Some(&b'\n'));
    }
}
