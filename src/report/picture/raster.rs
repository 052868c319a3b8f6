//! Panels as PNG.

use super::{Panel, vector};
use plotters::prelude::*;

/// The bytes of a PNG file.
pub(super) fn png(panels: &[Panel]) -> Result<Vec<u8>, String> {
    let (width, height) = vector::size(panels);
    let mut pixels = vec![255; 3 * width as usize * height as usize];
    {
        let area = BitMapBackend::with_buffer(&mut pixels, (width, height)).into_drawing_area();
        vector::draw(panels, &area).map_err(|error| format!("the picture cannot be drawn: {error}"))?;
    }
    let mut bytes = Vec::new();
    let failed = |error: png::EncodingError| format!("the picture cannot be written: {error}");
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header().map_err(failed)?;
    writer.write_image_data(&pixels).map_err(failed)?;
    writer.finish().map_err(failed)?;
    Ok(bytes)
}
