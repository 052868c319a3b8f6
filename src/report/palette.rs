//! What pictures share: the colours of lines, which the colour-blind can tell apart, and the letters.

use plotters::style::{FontStyle, RGBColor, register_font};
use std::sync::Once;

/// Eight colours (Okabe and Ito, 2008).
const COLOURS: [RGBColor; 8] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(110, 110, 110),
    RGBColor(0, 0, 0),
];

/// The name of the letters in pictures.
pub(super) const LETTERS: &str = "sans-serif";

/// The colour of an index; beyond the last one they begin again.
pub(super) fn colour(index: usize) -> RGBColor {
    COLOURS.get(index % COLOURS.len()).copied().unwrap_or(RGBColor(0, 0, 0))
}

/// Makes the letters known, which need no font of the machine.
pub(super) fn prepare_letters() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        for style in [FontStyle::Normal, FontStyle::Bold] {
            // The font is part of the program; were it not readable, drawing would say so.
            let _ = register_font(LETTERS, style, dejavu::sans::regular()).is_ok();
        }
    });
}
