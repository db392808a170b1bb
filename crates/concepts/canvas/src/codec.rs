//! Which bytes make a picture file?
//!
//! [`encode`] gives the bytes of a PNG or OpenEXR file, [`decode`] reads them back; the caller writes and reads files.
//! The same image gives the same bytes always.
//!
//! | format | holds | light below 0 and above 1 | NaN |
//! |---|---|---|---|
//! | PNG, 8 bit | sRGB in 256 steps | clamped (E8) | black |
//! | PNG, 16 bit | sRGB in 65,536 steps | clamped (E8) | black |
//! | OpenEXR | linear `f32`, each bit of it | kept | kept |
//!
//! The PNG files carry no sRGB chunk, because the library does not write one; programs take a PNG without one for
//! sRGB. When reading, gamma and colour profile chunks are ignored in the same spirit: PNG is sRGB, OpenEXR is linear
//! with sRGB primaries.
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
use crate::{Image, Rgb, exr_luminance, srgb};

/// The most pixels that [`decode`] accepts, 8192 × 8192: about 800 MB as an [`Image`]. A file of a few bytes can claim
/// any size, so there has to be an end; [`encode`] has none.
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
                if path.file_stem().and_then(|stem| lower_case_extension(stem.as_ref())).as_deref()
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
            let curve = srgb::EightBitSteps::new();
            let steps: Vec<u8> = channels.map(|light| curve.nearest(*light)).collect();
            png_encoder(&mut file).write_image(&steps, width, height, ExtendedColorType::Rgb8)
        }
        Format::Png16 => {
            // The encoder takes the computer's own byte order and writes PNG's.
            let steps: Vec<u8> = channels.flat_map(|light| srgb::to_u16(*light).to_ne_bytes()).collect();
            png_encoder(&mut file).write_image(&steps, width, height, ExtendedColorType::Rgb16)
        }
        Format::Exr => {
            let light: Vec<u8> = channels.flat_map(|light| light.to_ne_bytes()).collect();
            OpenExrEncoder::new(&mut file).write_image(&light, width, height, ExtendedColorType::Rgb32F)
        }
    }
    .map_err(|error| CodecError::Unwritable { reason: error.to_string() })?;
    Ok(file.into_inner())
}

/// The image that a PNG (gray, RGB, palette; 1 to 16 bits; with or without alpha) or OpenEXR file (RGB or luminance, with or
/// without alpha) shows. The format is known by the content, not by a name.
///
/// Transparent pixels show black behind them: PNG stores color and alpha apart, so the light is multiplied by alpha;
/// OpenEXR stores the product.
///
/// # Errors
/// [`CodecError::UnknownContent`], [`CodecError::TooLarge`], [`CodecError::Unreadable`]; hostile bytes too end in one
/// of them.
pub fn decode(bytes: &[u8]) -> Result<Image, CodecError> {
    decode_with_alpha(bytes).map(|decoded| decoded.image)
}

/// What a file holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Decoded {
    /// The picture with black behind transparent pixels.
    pub image: Image,
    /// The opacity of each pixel, 0 to 1, rows from the top down as in [`Image::pixels`]; `None` if the file has none.
    pub alpha: Option<Vec<f32>>,
}

/// The same image as [`decode`] gives, and the opacity of its pixels.
///
/// # Errors
/// As [`decode`].
pub fn decode_with_alpha(bytes: &[u8]) -> Result<Decoded, CodecError> {
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
        Err(CodecError::Unreadable { reason: "the reader of the format failed".to_owned() })
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

fn read(bytes: &[u8], format: ImageFormat) -> Result<Decoded, CodecError> {
    if format == ImageFormat::OpenExr && exr_luminance::is_luminance(bytes) {
        return exr_luminance::read(bytes);
    }
    let unreadable = |error: ::image::ImageError| CodecError::Unreadable { reason: error.to_string() };
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    let mut limits = Limits::no_limits();
    limits.max_alloc = Some(MOST_DECODER_BYTES);
    reader.limits(limits);
    let decoder = reader.into_decoder().map_err(unreadable)?;
    let (width, height) = decoder.dimensions();
    check_size(width, height)?;
    let file = DynamicImage::from_decoder(decoder).map_err(unreadable)?;
    let has_alpha = file.color().has_alpha();
    let (pixels, alpha) = light_of(file);
    let image = Image::from_rows(width, height, pixels).expect("one pixel for each place");
    Ok(Decoded { image, alpha: has_alpha.then_some(alpha) })
}

/// Refuses a picture of more than [`MOST_PIXELS`].
pub(crate) fn check_size(width: u32, height: u32) -> Result<(), CodecError> {
    if u64::from(width) * u64::from(height) > MOST_PIXELS {
        return Err(CodecError::TooLarge { width, height });
    }
    Ok(())
}

/// The light and the opacity of each pixel, rows from the top down.
fn light_of(file: DynamicImage) -> (Vec<Rgb>, Vec<f32>) {
    match file {
        DynamicImage::ImageRgb32F(_) | DynamicImage::ImageRgba32F(_) => {
            let pixels = file.into_rgba32f();
            pixels.pixels().map(|pixel| (Rgb::new(pixel.0[0], pixel.0[1], pixel.0[2]), pixel.0[3])).unzip()
        }
        DynamicImage::ImageLuma16(_)
        | DynamicImage::ImageLumaA16(_)
        | DynamicImage::ImageRgb16(_)
        | DynamicImage::ImageRgba16(_) => {
            let light: Vec<f32> = (0..=u16::MAX).map(srgb::from_u16).collect();
            file.into_rgba16().pixels().map(|pixel| over_black(pixel.0, &light)).unzip()
        }
        _ => {
            let light: Vec<f32> = (0..=u8::MAX).map(srgb::from_u8).collect();
            file.into_rgba8().pixels().map(|pixel| over_black(pixel.0, &light)).unzip()
        }
    }
}

/// The light of a pixel (red, green, blue, alpha) with black behind it, and its opacity; `light` is that of each step.
fn over_black<Step: Into<usize>>([r, g, b, alpha]: [Step; 4], light: &[f32]) -> (Rgb, f32) {
    let last_step = (light.len() - 1) as f32;
    let alpha: usize = alpha.into();
    let alpha = alpha as f32 / last_step;
    (Rgb::from([r, g, b].map(|step| light[step.into()])) * alpha, alpha)
}

/// Fast compression: rendered pictures shrink well enough, and saving does not outlast rendering.
fn png_encoder<W: std::io::Write>(file: W) -> PngEncoder<W> {
    PngEncoder::new_with_quality(file, CompressionType::Fast, FilterType::Adaptive)
}

fn lower_case_extension(path: &Path) -> Option<String> {
    path.extension().map(|extension| extension.to_string_lossy().to_lowercase())
}

fn name_of_extension(found: Option<&str>) -> String {
    found.map_or("the file name has no extension".to_owned(), |extension| {
        format!("unknown extension .{extension}")
    })
}
