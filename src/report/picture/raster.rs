//! Panels as PNG.

use super::{Panel, vector};
use plotters::prelude::*;

/// Returns the bytes of a PNG file.
pub(super) fn png(panels: &[Panel]) -> Result<Vec<u8>, String> {
    let (width, height) = vector::size(panels);
    let mut pixels = vec![255; 3 * width as usize * height as usize];
    {
        let area = BitMapBackend::with_buffer(&mut pixels, (width, height)).into_drawing_area();
        vector::draw(panels, &area).map_err(|error| format!("cannot draw the picture: {error}"))?;
    }
    let mut bytes = Vec::new();
    let failed = |error: png::EncodingError| format!("cannot write the picture: {error}");
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header().map_err(failed)?;
    writer.write_image_data(&pixels).map_err(failed)?;
    writer.finish().map_err(failed)?;
    Ok(bytes)
}
