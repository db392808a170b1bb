//! How does an OpenEXR file of luminance alone become a picture? Its one channel Y is a gray.
//!
//! The library that reads the other files takes RGB only.

use std::io::Cursor;

use exr::meta::MetaData;
use exr::meta::header::Header;
use exr::prelude::{ReadChannels, ReadLayers, ReadSpecificChannel, Text, Vec2};

use crate::codec::{CodecError, Decoded, check_size};
use crate::{Image, Rgb};

/// Whether the file has luminance and no colors. With chroma (RY, BY) it has colors, in a form that is not read.
pub(crate) fn is_luminance(bytes: &[u8]) -> bool {
    let Ok(about) = MetaData::read_from_buffered(Cursor::new(bytes), false) else {
        return false;
    };
    let has =
        |header: &Header, name: &str| header.channels.find_index_of_channel(&Text::from(name)).is_some();
    let is_gray = |header: &Header| !header.deep && has(header, "Y") && !has(header, "RY");
    let is_colored = |header: &Header| !header.deep && ["R", "G", "B"].iter().all(|name| has(header, name));
    about.headers.iter().any(is_gray) && !about.headers.iter().any(is_colored)
}

/// The gray picture, and its opacity if it has an alpha channel.
///
/// # Errors
/// [`CodecError`] if it is too large or damaged.
pub(crate) fn read(bytes: &[u8]) -> Result<Decoded, CodecError> {
    let unreadable = |error: exr::error::Error| CodecError::Unreadable { reason: error.to_string() };
    let about = MetaData::read_from_buffered(Cursor::new(bytes), false).map_err(unreadable)?;
    let first = about.headers.first();
    let window = first.map(|header| header.shared_attributes.display_window).unwrap_or_default();
    let too_large = |_| CodecError::TooLarge { width: u32::MAX, height: u32::MAX };
    let [width, height] = [window.size.width(), window.size.height()].map(u32::try_from);
    let (width, height) = (width.map_err(too_large)?, height.map_err(too_large)?);
    check_size(width, height)?;
    let file = exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .specific_channels()
        .required("Y")
        .optional("A", f32::NAN)
        .collect_pixels(
            |size, _| (size, vec![(0.0_f32, 0.0_f32); size.area()]),
            |(size, pixels): &mut (Vec2<usize>, Vec<(f32, f32)>), at, pixel: (f32, f32)| {
                pixels[at.flat_index_for_size(*size)] = pixel;
            },
        )
        .first_valid_layer()
        .all_attributes()
        .from_buffered(Cursor::new(bytes))
        .map_err(unreadable)?;
    let (size, samples) = file.layer_data.channel_data.pixels;
    let offset = file.layer_data.attributes.layer_position - window.position;

    let mut pixels = vec![Rgb::ZERO; width as usize * height as usize];
    let has_alpha = file.layer_data.channel_data.channels.1.is_some();
    let mut alpha = vec![0.0; if has_alpha { pixels.len() } else { 0 }];
    // What lies outside the display window is not shown; where the window has no data, it is empty.
    for (at, (luminance, opacity)) in samples.into_iter().enumerate() {
        let x = i64::from(offset.x()) + (at % size.width()) as i64;
        let y = i64::from(offset.y()) + (at / size.width()) as i64;
        if (0..i64::from(width)).contains(&x) && (0..i64::from(height)).contains(&y) {
            let place = y as usize * width as usize + x as usize;
            pixels[place] = Rgb::splat(luminance);
            if has_alpha {
                alpha[place] = opacity;
            }
        }
    }
    let image = Image::from_rows(width, height, pixels).expect("one pixel for each place");
    Ok(Decoded { image, alpha: has_alpha.then_some(alpha) })
}
