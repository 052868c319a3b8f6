//! The steps of work that one run of a tape takes.

/// Steps of a run of a tape, whatever its operations …
const RUN: u64 = 1;
/// … of a run over a block of points in doubles, and of one with bounds, whose caller prepares the places …
const BLOCK: u64 = 10;
const BOUNDED_BLOCK: u64 = 30;
/// … and of one point of a block with bounds: the caller finds its place and adds its value to a sum.
const POINT: u64 = 6;

/// A number for each kind of operation: how many of them a tape has, or how many quarters of a step one of them takes.
///
/// The terms of a series are counted one by one, in addition, so that another function may cost less than an elementary one.
/// `cargo bench -p sneddon-runs --bench steps` shows how well the numbers fit.
#[derive(Clone, Copy, Debug, Default)]
pub struct Cost {
    /// Constants, sums, products, quotients and square roots.
    pub(super) arithmetic: u64,
    /// Powers and elementary functions.
    pub(super) elementary: u64,
    /// Other functions.
    pub(super) special: u64,
}

impl Cost {
    /// The costs for one kind of value, in quarters of a step, fitted to the times of `--bench steps`; `--bench operations` measures
    /// single operations.
    pub(super) const fn new(arithmetic: u64, elementary: u64, special: u64) -> Self {
        Self { arithmetic, elementary, special }
    }

    /// The steps of one run of a tape with these counts.
    pub(super) const fn steps(&self, each: &Self) -> u64 {
        RUN + self.product(each) / 4
    }

    /// The steps of a run over a block of points in doubles.
    pub(super) const fn block_steps(&self, points: usize) -> u64 {
        BLOCK + points as u64 * self.product(&PLAIN) / 4
    }

    /// The same with bounds.
    pub(super) const fn bounded_block_steps(&self, points: usize) -> u64 {
        BOUNDED_BLOCK + points as u64 * (POINT + self.product(&BOUNDED) / 4)
    }

    const fn product(&self, each: &Self) -> u64 {
        self.arithmetic * each.arithmetic + self.elementary * each.elementary + self.special * each.special
    }
}

/// The costs at one point of a block, in doubles …
const PLAIN: Cost = Cost::new(1, 3, 60);
/// … and with bounds.
const BOUNDED: Cost = Cost::new(1, 4, 40);
