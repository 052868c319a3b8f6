//! The clock: the processor time of this process, which other programs on the machine do not lengthen.

/// The name of the clock that [`now`] reads.
pub(super) const NAME: &str = if cfg!(unix) { "processor time of the process" } else { "clock on the wall" };

/// Nanoseconds since some moment; every thread of the process counts.
#[cfg(unix)]
pub(super) fn now() -> f64 {
    use rustix::time::{ClockId, clock_gettime};
    let time = clock_gettime(ClockId::ProcessCPUTime);
    time.tv_sec as f64 * 1e9 + time.tv_nsec as f64
}

/// Nanoseconds since some moment.
#[cfg(not(unix))]
pub(super) fn now() -> f64 {
    use std::sync::OnceLock;
    use std::time::Instant;
    static START: OnceLock<Instant> = OnceLock::new();
    START.get_or_init(Instant::now).elapsed().as_secs_f64() * 1e9
}
