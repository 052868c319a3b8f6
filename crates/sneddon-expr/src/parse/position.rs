//! Byte spans as lines and columns.

use std::ops::Range;

/// Line and column, both counted from 1 and the column in characters, at which `span` begins in `text`.
///
/// ```
/// assert_eq!(sneddon_expr::parse::position("r +\nθ $", 7..8), (2, 3));
/// ```
pub fn position(text: &str, span: Range<usize>) -> (usize, usize) {
    let before = text.char_indices().take_while(|(at, _)| *at < span.start);
    before.fold((1, 1), |(line, column), (_, c)| if c == '\n' { (line + 1, 1) } else { (line, column + 1) })
}
