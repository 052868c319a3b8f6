//! The note that names the radii at which the pressure is infinite, because f′ jumps there.

use crate::print::Prose;
use crate::transform::Profile;

/// The most radii that are named.
const MOST_NAMED: usize = 4;

/// Returns the note; `None` if f′ is not known to jump.
pub(super) fn note(profile: &Profile) -> Option<Prose> {
    let found = profile.jumps();
    let named = found.iter().take(MOST_NAMED).enumerate().map(|(i, radius)| {
        let before = match i {
            0 => "",
            _ if i + 1 == found.len() => " and ",
            _ => ", ",
        };
        (before, radius, if radius.is_zero() { " (the apex)" } else { "" })
    });
    let start = Prose::read("$f'(r)$ jumps at ");
    let list = named.fold(start, |prose, (before, radius, after)| prose.then(before).then("$r$ = ").formula(radius.clone()).then(after));
    let list = if found.len() > MOST_NAMED { list.then(" and further radii") } else { list };
    (!found.is_empty()).then(|| list.then("; $p$ is infinite there"))
}
