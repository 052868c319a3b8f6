//! The file of a measured tip, which is opened once, after the scene itself has been validated.

use super::Failure;
use crate::scene::{LONGEST_TIP, Scene, SceneError, decoded};
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

/// Returns the scene with the points of its tip, if it has one; `scene_file` is the path of the scene file.
///
/// `failed` adds the position in the scene to an error.
pub(super) fn with_points(scene: Scene, scene_file: &Path, failed: impl Fn(SceneError) -> Failure) -> Result<Scene, Failure> {
    let Some(measured) = &scene.measured else { return Ok(scene) };
    let path = beside(scene_file, measured.file());
    let place = measured.place();
    let refused = |message: String, help: &str| Err(failed(SceneError::value(message).help(help).at(place.clone())));
    let mut bytes = Vec::new();
    let limit = LONGEST_TIP as u64;
    // On some systems opening a directory succeeds, and only reading it fails.
    // A pipe or a device could block forever, or be changed by reading.
    if std::fs::metadata(&path).is_ok_and(|own| !own.is_file()) {
        return refused(format!("{} is not a regular file", path.display()), "expected a file of points");
    }
    let done = File::open(&path).and_then(|file| file.take(limit + 1).read_to_end(&mut bytes));
    if let Err(error) = done {
        let message = format!("cannot read {}: {error}", path.display());
        return refused(message, "expected a file of points, with a path relative to the directory of the scene");
    }
    if bytes.len() as u64 > limit {
        return refused(format!("{} has more than {limit} bytes", path.display()), "expected fewer rows");
    }
    let text = decoded(bytes);
    let name = path.display().to_string();
    scene.with_points(&text).map_err(|error| match error.span() {
        Some(_) => Failure::scene(&name, &text.0, &error),
        None => Failure::new(format!("{name}: {error}")).help(error.accepted().unwrap_or("expected a file of points")),
    })
}

/// Resolves a path in a scene relative to the directory of the scene.
fn beside(scene_file: &Path, file: &str) -> PathBuf {
    match scene_file.parent().filter(|_| scene_file.as_os_str() != "-") {
        Some(directory) if Path::new(file).is_relative() => directory.join(file),
        _ => PathBuf::from(file),
    }
}
