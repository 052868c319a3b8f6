//! Line colours that are suitable for colour-blind readers, and the font of pictures.

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

/// The name of the font in pictures.
pub(super) const LETTERS: &str = "sans-serif";

/// Returns the colour of an index, in cyclic order.
pub(super) fn colour(index: usize) -> RGBColor {
    COLOURS.get(index % COLOURS.len()).copied().unwrap_or(RGBColor(0, 0, 0))
}

/// Registers the embedded font, so that no system font is required.
pub(super) fn prepare_letters() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        for style in [FontStyle::Normal, FontStyle::Bold] {
            // The font is embedded; if it could not be read, drawing would return an error.
            let _ = register_font(LETTERS, style, dejavu::sans::regular()).is_ok();
        }
    });
}
