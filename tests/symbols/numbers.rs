//! Exact numbers: the nearest doubles, long fractions, and what stays a decimal.

use num_bigint::{BigInt, Sign};
use num_rational::BigRational;
use proptest::prelude::*;
use sneddon::expr::Number;

#[test]
fn nearest_f64_agrees_with_the_standard_parser() {
    for text in [
        "0.1",
        "0.3",
        "1e-6",
        "5e-324",
        "2.5e-324",
        "1.7976931348623157e308",
        "2.2250738585072011e-308",
        "123456789.123456789",
        "9007199254740993",
        "1e400",
        "3e-330",
    ] {
        let number = Number::parse_decimal(text).unwrap();
        assert_eq!(number.to_f64(), text.parse::<f64>().unwrap(), "{text}");
    }
}

#[test]
fn long_numbers_add_and_multiply_as_fractions_do() {
    let powers = [(3_i64, 200_u32), (7, 90), (-10, 77), (12, 60), (1, 0)];
    let all: Vec<BigRational> = powers
        .iter()
        .flat_map(|(base, n)| powers.iter().map(|(other, m)| BigRational::new(BigInt::from(*base).pow(*n), BigInt::from(*other).pow(*m))))
        .collect();
    for one in &all {
        for other in &all {
            let (left, right) = (Number::from(one.clone()), Number::from(other.clone()));
            for (found, expected) in [(&left + &right, one + other), (&left - &right, one - other), (&left * &right, one * other)] {
                assert_eq!((found.value().numer(), found.value().denom()), (expected.numer(), expected.denom()));
            }
        }
    }
}

proptest! {
    /// Factors of many lengths in common, against the fractions of another library.
    #[test]
    fn random_long_numbers_are_reduced(
        parts in prop::collection::vec(prop::collection::vec(any::<u32>(), 1..40), 6),
        alike in any::<bool>(),
    ) {
        let [mut p, q, n, m, one, other]: [BigInt; 6] =
            parts.into_iter().map(|words| BigInt::from_slice(Sign::Plus, &words) + 1).collect::<Vec<_>>().try_into().unwrap();
        if alike {
            // Quotients of Euclid's division that are all 1 or 2, or one that is very long.
            p = (&q << 7) + 1;
        }
        let (a, b) = (BigRational::new(&p * &one, q * &other), BigRational::new(-n * other, m * one));
        let (x, y) = (Number::from(a.clone()), Number::from(b.clone()));
        for (found, expected) in [(&x + &y, &a + &b), (&x - &y, &a - &b), (&x * &y, &a * &b)] {
            prop_assert_eq!((found.value().numer(), found.value().denom()), (expected.numer(), expected.denom()));
        }
    }
}

#[test]
fn a_decimal_stays_one_only_while_it_ends() {
    let a = Number::parse_decimal("0.7").unwrap();
    assert!((&a * &Number::integer(3)).is_decimal());
    assert!(!(&a * &Number::ratio(1, 3)).is_decimal());
    assert!(!(&a * &Number::integer(10)).is_decimal());
}

proptest! {
    /// What is printed for a number computed from decimals is that number, and its parts are decimals that end.
    #[test]
    fn printed_parts_are_the_number(p in 1_i64..1_000_000, q in 1_i64..1_000_000, tens in -40_i32..40) {
        let power = Number::parse_decimal(&format!("1e{tens}")).unwrap();
        let number = &(&Number::ratio(p, q).with_decimals() * &power);
        for number in [number.clone(), number.with_decimals(), number.as_fraction()] {
            let (upper, lower) = number.printed_parts();
            prop_assert_eq!(upper.value() / lower.value(), number.value().clone());
            prop_assert!([upper, lower].iter().all(|own| own.is_integer() || own.is_decimal()));
        }
    }
}
