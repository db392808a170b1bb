//! Which bytes make a picture file?
//!
//! [`encode`] gives the bytes of a PNG or OpenEXR file, [`decode`] reads them back; the caller writes and reads files. The same
//! image gives the same bytes always.
//!
//! | format | holds | light below 0 and above 1 | NaN |
//! |---|---|---|---|
//! | PNG, 8 bit | sRGB in 256 steps | clamped (E8) | black |
//! | PNG, 16 bit | sRGB in 65,536 steps | clamped (E8) | black |
//! | OpenEXR | linear `f32`, each bit of it | kept | kept |
//!
//! The PNG files carry no sRGB chunk, because the library does not write one; programs take a PNG without one for sRGB. When reading, gamma
//! and colour profile chunks are ignored in the same spirit: PNG is sRGB, OpenEXR is linear with sRGB primaries.
//!
//! ```
//! use canvas::{Format, Image, Rgb, codec};
//! let image = Image::from_fn(3, 2, |i, j| Rgb::new(0.1 * i as f32, 1.96, 0.3 * j as f32));
//! let bytes = codec::encode(&image, Format::Exr)?;
//! assert_eq!(codec::decode(&bytes)?, image);
//! # Ok::<(), canvas::CodecError>(())
//! ```
//!
//! Read [`mod@crate::srgb`] first; [`mod@crate::compare`] is next.

use std::io::Cursor;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use ::image::codecs::openexr::OpenExrEncoder;
use ::image::codecs::png::{CompressionType, FilterType, PngEncoder};
use ::image::{
    DynamicImage, ExtendedColorType, ImageDecoder, ImageEncoder, ImageFormat, ImageReader, Limits,
};
use thiserror::Error;

use crate::exr_header::{self, Claims};
use crate::{Image, Rgb, srgb};

/// The most pixels that [`decode`] accepts, 8192 × 8192: about 800 MB as an [`Image`]. A file of a few bytes can claim any
/// size, so there has to be an end.
pub const MOST_PIXELS: u64 = 8192 * 8192;

/// What the decoder may allocate for itself: [`MOST_PIXELS`] in the widest kind of pixel, RGBA in `f32`.
const MOST_DECODER_BYTES: u64 = MOST_PIXELS * 16;

/// A kind of picture file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// PNG, 8 bits a channel, sRGB: `picture.png`.
    Png8,
    /// PNG, 16 bits a channel, sRGB: `picture.16.png`.
    Png16,
    /// OpenEXR, `f32` a channel, linear, lossless: `picture.exr`.
    Exr,
}

impl Format {
    /// The format that a file name asks for: `.png` 8 bits, `.16.png` 16 bits, `.exr` OpenEXR; upper case will do.
    ///
    /// ```
    /// use canvas::Format;
    /// assert_eq!(Format::from_path("out/teapot.16.png".as_ref())?, Format::Png16);
    /// # Ok::<(), canvas::CodecError>(())
    /// ```
    ///
    /// # Errors
    /// [`CodecError::UnknownExtension`] for any other extension and for none.
    pub fn from_path(path: &Path) -> Result<Self, CodecError> {
        let extension = lower_case_extension(path);
        match extension.as_deref() {
            Some("exr") => Ok(Self::Exr),
            Some("png")
                if path
                    .file_stem()
                    .and_then(|stem| lower_case_extension(stem.as_ref()))
                    .as_deref()
                    == Some("16") =>
            {
                Ok(Self::Png16)
            }
            Some("png") => Ok(Self::Png8),
            _ => Err(CodecError::UnknownExtension { found: extension }),
        }
    }
}

/// Why an image could not become a file, or a file an image.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum CodecError {
    /// The file name does not say which format is meant.
    #[error("{}: use .png (8 bit), .16.png (16 bit) or .exr (OpenEXR)", name_of_extension(found.as_deref()))]
    UnknownExtension {
        /// The extension in lower case, without its dot; `None` if there is none.
        found: Option<String>,
    },
    /// The image has no pixels; neither PNG nor OpenEXR can say so.
    #[error("a picture of {width} × {height} pixels cannot be a file: width and height must be at least 1")]
    Empty {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
    },
    /// The bytes begin like no format that is read here.
    #[error("neither a PNG nor an OpenEXR file, going by its first bytes")]
    UnknownContent,
    /// The file claims more than [`MOST_PIXELS`].
    #[error("the file claims {width} × {height} pixels; at most {MOST_PIXELS} in all are read")]
    TooLarge {
        /// Claimed width in pixels.
        width: u32,
        /// Claimed height in pixels.
        height: u32,
    },
    /// The bytes are damaged, cut off, or use a feature that is not read.
    #[error("damaged or unsupported picture file: {reason}")]
    Unreadable {
        /// What the reader of the format met.
        reason: String,
    },
    /// The format cannot hold the image, because it is too large for it.
    #[error("the picture does not fit the format: {reason}")]
    Unwritable {
        /// What the writer of the format met.
        reason: String,
    },
}

/// The bytes of a file that shows this image. The table above says what each format keeps.
///
/// # Errors
/// [`CodecError::Empty`] if width or height is 0; [`CodecError::Unwritable`] if the image is too large for the format.
pub fn encode(image: &Image, format: Format) -> Result<Vec<u8>, CodecError> {
    let (width, height) = (image.width(), image.height());
    if width == 0 || height == 0 {
        return Err(CodecError::Empty { width, height });
    }
    let channels = image.pixels().iter().flat_map(Rgb::as_ref);
    let mut file = Cursor::new(Vec::new());
    match format {
        Format::Png8 => {
            let steps: Vec<u8> = channels.map(|light| srgb::to_u8(*light)).collect();
            png_encoder(&mut file).write_image(&steps, width, height, ExtendedColorType::Rgb8)
        }
        Format::Png16 => {
            // The encoder takes the computer's own byte order and writes PNG's.
            let steps: Vec<u8> = channels
                .flat_map(|light| srgb::to_u16(*light).to_ne_bytes())
                .collect();
            png_encoder(&mut file).write_image(&steps, width, height, ExtendedColorType::Rgb16)
        }
        Format::Exr => {
            let light: Vec<u8> = channels.flat_map(|light| light.to_ne_bytes()).collect();
            OpenExrEncoder::new(&mut file).write_image(&light, width, height, ExtendedColorType::Rgb32F)
        }
    }
    .map_err(|error| CodecError::Unwritable {
        reason: error.to_string(),
    })?;
    Ok(file.into_inner())
}

/// The image that a PNG (grey, RGB, palette; 1 to 16 bits; with or without alpha) or OpenEXR file (RGB or RGBA) shows. The
/// format is known by the content, not by a name.
///
/// Transparent pixels show black behind them: PNG stores colour and alpha apart, so the light is multiplied by alpha; OpenEXR
/// stores the product.
///
/// # Errors
/// [`CodecError::UnknownContent`], [`CodecError::TooLarge`], [`CodecError::Unreadable`]; hostile bytes too end in one of them.
pub fn decode(bytes: &[u8]) -> Result<Image, CodecError> {
    let format = match ::image::guess_format(bytes) {
        Ok(format @ (ImageFormat::Png | ImageFormat::OpenExr)) => format,
        _ => return Err(CodecError::UnknownContent),
    };
    if format == ImageFormat::OpenExr {
        check_claims(bytes)?;
    }
    // The OpenEXR reader panics on some damaged files (its B44 decompression overflows, in builds that check for that).
    // It works on nothing of ours but the bytes, so no state is left half changed. The program's panic hook still hears
    // of it, which by default means a message on standard error.
    catch_unwind(AssertUnwindSafe(|| read(bytes, format))).unwrap_or_else(|_| {
        Err(CodecError::Unreadable {
            reason: "the reader of the format failed".to_owned(),
        })
    })
}

fn check_claims(exr: &[u8]) -> Result<(), CodecError> {
    let reason = match exr_header::claims(exr) {
        None => "its header is damaged or cut off".to_owned(),
        Some(Claims { dwa: true, .. }) => "DWAA and DWAB compression are not read; use ZIP".to_owned(),
        Some(Claims { bytes, .. }) if bytes > MOST_DECODER_BYTES => {
            format!("its header claims {bytes} bytes of pixels, at most {MOST_DECODER_BYTES} are read")
        }
        Some(_) => return Ok(()),
    };
    Err(CodecError::Unreadable { reason })
}

fn read(bytes: &[u8], format: ImageFormat) -> Result<Image, CodecError> {
    let unreadable = |error: ::image::ImageError| CodecError::Unreadable {
        reason: error.to_string(),
    };
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    let mut limits = Limits::no_limits();
    limits.max_alloc = Some(MOST_DECODER_BYTES);
    reader.limits(limits);
    let decoder = reader.into_decoder().map_err(unreadable)?;
    let (width, height) = decoder.dimensions();
    if u64::from(width) * u64::from(height) > MOST_PIXELS {
        return Err(CodecError::TooLarge { width, height });
    }
    let pixels = light_of(DynamicImage::from_decoder(decoder).map_err(unreadable)?);
    Ok(Image::from_rows(width, height, pixels).expect("one pixel for each place"))
}

/// The light of each pixel, rows from the top down.
fn light_of(file: DynamicImage) -> Vec<Rgb> {
    match file {
        DynamicImage::ImageRgb32F(_) | DynamicImage::ImageRgba32F(_) => file
            .into_rgb32f()
            .pixels()
            .map(|pixel| Rgb::from(pixel.0))
            .collect(),
        DynamicImage::ImageLuma16(_)
        | DynamicImage::ImageLumaA16(_)
        | DynamicImage::ImageRgb16(_)
        | DynamicImage::ImageRgba16(_) => {
            let over_black = |[r, g, b, alpha]: [u16; 4]| {
                Rgb::from([r, g, b].map(srgb::from_u16)) * (f32::from(alpha) / f32::from(u16::MAX))
            };
            file.into_rgba16()
                .pixels()
                .map(|pixel| over_black(pixel.0))
                .collect()
        }
        _ => {
            let light: [f32; 256] = std::array::from_fn(|step| srgb::from_u8(step as u8));
            let over_black = |[r, g, b, alpha]: [u8; 4]| {
                Rgb::from([r, g, b].map(|step| light[usize::from(step)]))
                    * (f32::from(alpha) / f32::from(u8::MAX))
            };
            file.into_rgba8()
                .pixels()
                .map(|pixel| over_black(pixel.0))
                .collect()
        }
    }
}

/// Fast compression and one fixed filter: rendered pictures shrink well enough, and saving does not outlast rendering.
fn png_encoder<W: std::io::Write>(file: W) -> PngEncoder<W> {
    PngEncoder::new_with_quality(file, CompressionType::Fast, FilterType::Adaptive)
}

fn lower_case_extension(path: &Path) -> Option<String> {
    path.extension()
        .map(|extension| extension.to_string_lossy().to_lowercase())
}

fn name_of_extension(found: Option<&str>) -> String {
    found.map_or("the file name has no extension".to_owned(), |extension| {
        format!("unknown extension .{extension}")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 3 × 2 pixels, brighter than paper here and there.
    fn picture() -> Image {
        Image::from_fn(3, 2, |i, j| {
            Rgb::new(0.3 * i as f32, 0.7 * j as f32, 1.96 - 0.5 * i as f32)
        })
    }

    fn png_of(bytes: &[u8], width: u32, height: u32, kind: ExtendedColorType) -> Vec<u8> {
        let mut file = Vec::new();
        png_encoder(&mut file)
            .write_image(bytes, width, height, kind)
            .unwrap();
        file
    }

    #[test]
    fn the_file_name_chooses_the_format() {
        for (name, format) in [
            ("teapot.png", Format::Png8),
            ("out/teapot.16.png", Format::Png16),
            ("TEAPOT.PNG", Format::Png8),
            ("teapot.16.Png", Format::Png16),
            ("teapot16.png", Format::Png8),
            ("16.png", Format::Png8),
            ("pictures.16/teapot.png", Format::Png8),
            ("teapot.png.exr", Format::Exr),
        ] {
            assert_eq!(Format::from_path(name.as_ref()), Ok(format), "{name}");
        }
    }

    #[test]
    fn a_wrong_extension_is_named_with_the_right_ones() {
        let message = |name: &str| Format::from_path(name.as_ref()).unwrap_err().to_string();
        assert_eq!(
            message("teapot.JPG"),
            "unknown extension .jpg: use .png (8 bit), .16.png (16 bit) or .exr (OpenEXR)"
        );
        for name in ["teapot", ".png", "", "pictures.png/teapot"] {
            assert!(
                message(name).starts_with("the file name has no extension"),
                "{name}"
            );
        }
    }

    #[test]
    fn openexr_keeps_every_bit() {
        let mut image = picture();
        image.pixels_mut()[1] = Rgb::new(f32::NAN, f32::INFINITY, -0.0);
        image.pixels_mut()[4] = Rgb::new(f32::from_bits(1), -3.5, f32::MAX);
        let read = decode(&encode(&image, Format::Exr).unwrap()).unwrap();
        let bits = |image: &Image| {
            image
                .pixels()
                .iter()
                .map(|p| p.to_array().map(f32::to_bits))
                .collect::<Vec<_>>()
        };
        assert_eq!(bits(&read), bits(&image));
    }

    #[test]
    fn png_clamps_and_the_first_row_of_the_file_is_the_top() {
        let read = decode(&encode(&picture(), Format::Png8).unwrap()).unwrap();
        for (i, j) in [(0, 0), (2, 0), (1, 1)] {
            let as_stored = picture()
                .get(i, j)
                .to_array()
                .map(|light| srgb::from_u8(srgb::to_u8(light)));
            assert_eq!(read.get(i, j).to_array(), as_stored, "pixel ({i}, {j})");
        }
        assert_eq!(read.get(0, 1).z, 1.0, "1.96 is clamped (E8)");
        // Row 0 of `rows` is the top: j = 1.
        let rows = [0, 0, 0, 255, 255, 255];
        let top_black = decode(&png_of(&rows, 1, 2, ExtendedColorType::Rgb8)).unwrap();
        assert_eq!((top_black.get(0, 1), top_black.get(0, 0)), (Rgb::ZERO, Rgb::ONE));
    }

    #[test]
    fn sixteen_bits_tell_apart_what_eight_bits_do_not() {
        let image = Image::from_fn(2, 1, |i, _| Rgb::splat(srgb::from_u16(30_000 + i as u16)));
        let read_as = |format| decode(&encode(&image, format).unwrap()).unwrap();
        assert_eq!(read_as(Format::Png16), image);
        assert_eq!(read_as(Format::Png8).get(0, 0), read_as(Format::Png8).get(1, 0));
    }

    #[test]
    fn a_png_shows_nan_black_and_infinity_white() {
        let image = Image::new(1, 1, Rgb::new(f32::NAN, f32::INFINITY, f32::NEG_INFINITY));
        for format in [Format::Png8, Format::Png16] {
            assert_eq!(
                decode(&encode(&image, format).unwrap()).unwrap().get(0, 0),
                Rgb::Y
            );
        }
    }

    #[test]
    fn grey_files_are_read() {
        let grey = Image::from_rows(
            2,
            1,
            vec![Rgb::splat(srgb::from_u8(9)), Rgb::splat(srgb::from_u8(200))],
        )
        .unwrap();
        assert_eq!(
            decode(&png_of(&[9, 200], 2, 1, ExtendedColorType::L8)).unwrap(),
            grey
        );
        let wide: Vec<u8> = [9_u16 * 257, 200 * 257]
            .into_iter()
            .flat_map(u16::to_ne_bytes)
            .collect();
        assert_eq!(
            decode(&png_of(&wide, 2, 1, ExtendedColorType::L16)).unwrap(),
            grey
        );
    }

    #[test]
    fn transparent_pixels_show_black_behind_them() {
        let rgba = [10, 200, 30, 51, 10, 200, 30, 255];
        let read = decode(&png_of(&rgba, 2, 1, ExtendedColorType::Rgba8)).unwrap();
        let opaque = Rgb::from([10, 200, 30].map(srgb::from_u8));
        assert_eq!(
            (read.get(0, 0), read.get(1, 0)),
            (opaque * (51.0 / 255.0), opaque)
        );
    }

    /// Colours 0, 1, 2 over 3, 0, 1 from a palette, two bits a pixel; colour 1 has alpha 51.
    const PALETTE_PNG: &[u8] = b"\x89PNG\r\n\x1a\n\
        \x00\x00\x00\x0dIHDR\x00\x00\x00\x03\x00\x00\x00\x02\x02\x03\x00\x00\x00\xe0\x1a\x8e\x89\
        \x00\x00\x00\x0cPLTE\x0a\x14\x1e\xc8d2\x00\xff\x07\x01\x02\x03m\x9a\xc4\xb5\
        \x00\x00\x00\x02tRNS\xff3ZgQ\\\
        \x00\x00\x00\x0fIDATx\x01\x01\x04\x00\xfb\xff\x00\x18\x00\xc4\x01\x10\x00\xdd\x01\x1b\xad\xe4\
        \x00\x00\x00\x00IEND\xaeB`\x82";

    #[test]
    fn files_with_a_palette_are_read() {
        let colors =
            [[10, 20, 30], [200, 100, 50], [0, 255, 7], [1, 2, 3]].map(|c| Rgb::from(c.map(srgb::from_u8)));
        let pale = colors[1] * (51.0 / 255.0);
        let read = decode(PALETTE_PNG).unwrap();
        assert_eq!(
            read.pixels(),
            [colors[0], pale, colors[2], colors[3], colors[0], pale]
        );
    }

    #[test]
    fn an_openexr_file_with_alpha_holds_colours_already_multiplied() {
        let light: Vec<u8> = [0.25_f32, 3.0, 0.5, 0.5]
            .into_iter()
            .flat_map(f32::to_ne_bytes)
            .collect();
        let mut file = Cursor::new(Vec::new());
        OpenExrEncoder::new(&mut file)
            .write_image(&light, 1, 1, ExtendedColorType::Rgba32F)
            .unwrap();
        assert_eq!(
            decode(&file.into_inner()).unwrap().get(0, 0),
            Rgb::new(0.25, 3.0, 0.5)
        );
    }

    #[test]
    fn an_image_without_pixels_is_refused() {
        for (width, height) in [(0, 0), (7, 0), (0, 7)] {
            for format in [Format::Png8, Format::Png16, Format::Exr] {
                let refused = encode(&Image::new(width, height, Rgb::X), format);
                assert_eq!(refused, Err(CodecError::Empty { width, height }));
            }
        }
    }

    #[test]
    fn what_is_neither_png_nor_openexr_is_named() {
        for bytes in [&b""[..], b"P6 1 1 255 abc", b"\xff\xd8\xff\xe0 a JPEG", &[0; 100]] {
            assert_eq!(decode(bytes), Err(CodecError::UnknownContent));
        }
    }

    #[test]
    fn a_png_that_claims_a_huge_size_is_refused_before_memory_is_taken() {
        // An honest file of 1 × 1 pixel with another width and height, and the checksum that belongs to them.
        let claims = |width: u32, height: u32, checksum: u32| {
            let mut file = png_of(&[1, 2, 3], 1, 1, ExtendedColorType::Rgb8);
            file[16..20].copy_from_slice(&width.to_be_bytes());
            file[20..24].copy_from_slice(&height.to_be_bytes());
            file[29..33].copy_from_slice(&checksum.to_be_bytes());
            decode(&file).unwrap_err()
        };
        assert_eq!(
            claims(8192, 8193, 0x3694_8eab),
            CodecError::TooLarge {
                width: 8192,
                height: 8193
            }
        );
        let largest = i32::MAX as u32;
        assert!(matches!(
            claims(largest, largest, 0x9bab_9c31),
            CodecError::Unreadable { .. }
        ));
    }
}
