//! Seeded random numbers: the same draws on every machine and in every run.

/// SplitMix64.
pub struct Stream(u64);

impl Stream {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// In [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * (-53f64).exp2()
    }

    /// In [lowest, highest).
    pub fn uniform(&mut self, lowest: f64, highest: f64) -> f64 {
        lowest + (highest - lowest) * self.unit()
    }

    /// In [lowest, highest), evenly over the orders of magnitude.
    pub fn log_uniform(&mut self, lowest: f64, highest: f64) -> f64 {
        self.uniform(lowest.ln(), highest.ln()).exp()
    }

    /// A whole number in [lowest, highest].
    pub fn whole(&mut self, lowest: i64, highest: i64) -> i64 {
        lowest + (self.bits() % (highest - lowest + 1) as u64) as i64
    }

    /// One of the given.
    pub fn pick<'a, T>(&mut self, list: &'a [T]) -> &'a T {
        &list[self.whole(0, list.len() as i64 - 1) as usize]
    }

    /// A number with few bits, which `f64` and its decimal print hold exactly.
    pub fn short(&mut self, lowest: f64, highest: f64) -> f64 {
        (self.uniform(lowest, highest) * 1024.0).round() / 1024.0
    }
}
