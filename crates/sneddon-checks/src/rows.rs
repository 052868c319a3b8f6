//! Rows of reference values: comma-separated text whose fields never contain a comma.

/// The rows of a file below its heading, split into fields; lines that begin with # are comments.
pub fn rows(text: &str) -> Vec<Vec<&str>> {
    text.lines().filter(|line| !line.starts_with('#') && !line.is_empty()).skip(1).map(|line| line.split(',').collect()).collect()
}
