//! The file of a measured tip: opened once, and only after the scene itself was found good.

use super::Failure;
use crate::scene::{LONGEST_TIP, Scene, SceneError, decoded};
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

/// The scene with the points of its tip, if it has one; `scene_file` is where its own text came from.
///
/// `failed` says where an error of the scene stands.
pub(super) fn with_points(scene: Scene, scene_file: &Path, failed: impl Fn(SceneError) -> Failure) -> Result<Scene, Failure> {
    let Some(measured) = &scene.measured else { return Ok(scene) };
    let path = beside(scene_file, measured.file());
    let place = measured.place();
    let refused = |message: String, help: &str| Err(failed(SceneError::value(message).help(help).at(place.clone())));
    let mut bytes = Vec::new();
    let limit = LONGEST_TIP as u64;
    // A directory opens on some systems, and fails only when it is read.
    // A pipe or a device that a scene names could block for ever, or be changed by the reading.
    if std::fs::metadata(&path).is_ok_and(|own| !own.is_file()) {
        return refused(format!("{} is no regular file", path.display()), "a file of points would be accepted");
    }
    let done = File::open(&path).and_then(|file| file.take(limit + 1).read_to_end(&mut bytes));
    if let Err(error) = done {
        let message = format!("{} cannot be read: {error}", path.display());
        return refused(message, "a file of points would be accepted; its name counts from the directory of the scene");
    }
    if bytes.len() as u64 > limit {
        return refused(format!("{} has more than {limit} bytes", path.display()), "fewer rows would be accepted");
    }
    let text = decoded(bytes);
    let name = path.display().to_string();
    scene.with_points(&text).map_err(|error| match error.span() {
        Some(_) => Failure::scene(&name, &text.0, &error),
        None => Failure::new(format!("{name}: {error}")).help(error.accepted().unwrap_or("expected a file of points")),
    })
}

/// A path as it stands in a scene: from the directory of the scene on.
fn beside(scene_file: &Path, file: &str) -> PathBuf {
    match scene_file.parent().filter(|_| scene_file.as_os_str() != "-") {
        Some(directory) if Path::new(file).is_relative() => directory.join(file),
        _ => PathBuf::from(file),
    }
}
