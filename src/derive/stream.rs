//! A small deterministic stream of random numbers, the same on every machine.

use crate::expr::Number;

/// Random numbers by splitmix64 from a seed.
#[derive(Clone, Debug)]
pub(crate) struct Stream(u64);

impl Stream {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in (0, 1).
    pub(crate) fn uniform(&mut self) -> f64 {
        ((self.next() >> 11) as f64 + 0.5) / (1u64 << 53) as f64
    }

    /// A multiple of 1/256, evenly spread over the logarithm between 1/4 and 4.
    pub(crate) fn dyadic(&mut self) -> Number {
        let value = (256.0 * 4f64.powf(2.0 * self.uniform() - 1.0)).round();
        Number::ratio(value as i64, 256)
    }
}
