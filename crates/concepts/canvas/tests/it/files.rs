//! Worked numbers: which files are written and read, and what they show.

use std::io::Cursor;

use canvas::{CodecError, Format, Image, Rgb, codec, srgb};
use codec::{decode, encode};
use image::codecs::{openexr::OpenExrEncoder, png::PngEncoder};
use image::{ExtendedColorType, ImageEncoder};

/// 3 × 2 pixels, brighter than paper here and there.
fn picture() -> Image {
    Image::from_fn(3, 2, |i, j| Rgb::new(0.3 * i as f32, 0.7 * j as f32, 1.96 - 0.5 * i as f32))
}

fn png_of(bytes: &[u8], width: u32, height: u32, kind: ExtendedColorType) -> Vec<u8> {
    let mut file = Vec::new();
    PngEncoder::new(&mut file).write_image(bytes, width, height, kind).unwrap();
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
        assert!(message(name).starts_with("the file name has no extension"), "{name}");
    }
}

#[test]
fn openexr_keeps_every_bit() {
    let mut image = picture();
    image.pixels_mut()[1] = Rgb::new(f32::NAN, f32::INFINITY, -0.0);
    image.pixels_mut()[4] = Rgb::new(f32::from_bits(1), -3.5, f32::MAX);
    let read = decode(&encode(&image, Format::Exr).unwrap()).unwrap();
    let bits =
        |image: &Image| image.pixels().iter().map(|p| p.to_array().map(f32::to_bits)).collect::<Vec<_>>();
    assert_eq!(bits(&read), bits(&image));
}

#[test]
fn png_clamps_and_the_first_row_of_the_file_is_the_top() {
    let read = decode(&encode(&picture(), Format::Png8).unwrap()).unwrap();
    for (i, j) in [(0, 0), (2, 0), (1, 1)] {
        let as_stored = picture().get(i, j).to_array().map(|light| srgb::from_u8(srgb::to_u8(light)));
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
        assert_eq!(decode(&encode(&image, format).unwrap()).unwrap().get(0, 0), Rgb::Y);
    }
}

#[test]
fn grey_files_are_read() {
    let grey =
        Image::from_rows(2, 1, vec![Rgb::splat(srgb::from_u8(9)), Rgb::splat(srgb::from_u8(200))]).unwrap();
    assert_eq!(decode(&png_of(&[9, 200], 2, 1, ExtendedColorType::L8)).unwrap(), grey);
    let wide: Vec<u8> = [9_u16 * 257, 200 * 257].into_iter().flat_map(u16::to_ne_bytes).collect();
    assert_eq!(decode(&png_of(&wide, 2, 1, ExtendedColorType::L16)).unwrap(), grey);
}

#[test]
fn transparent_pixels_show_black_behind_them() {
    let rgba = [10, 200, 30, 51, 10, 200, 30, 255];
    let read = decode(&png_of(&rgba, 2, 1, ExtendedColorType::Rgba8)).unwrap();
    let opaque = Rgb::from([10, 200, 30].map(srgb::from_u8));
    assert_eq!((read.get(0, 0), read.get(1, 0)), (opaque * (51.0 / 255.0), opaque));
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
    assert_eq!(read.pixels(), [colors[0], pale, colors[2], colors[3], colors[0], pale]);
}

#[test]
fn an_openexr_file_with_alpha_holds_colours_already_multiplied() {
    let light: Vec<u8> = [0.25_f32, 3.0, 0.5, 0.5].into_iter().flat_map(f32::to_ne_bytes).collect();
    let mut file = Cursor::new(Vec::new());
    OpenExrEncoder::new(&mut file).write_image(&light, 1, 1, ExtendedColorType::Rgba32F).unwrap();
    assert_eq!(decode(&file.into_inner()).unwrap().get(0, 0), Rgb::new(0.25, 3.0, 0.5));
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
    assert_eq!(claims(8192, 8193, 0x3694_8eab), CodecError::TooLarge { width: 8192, height: 8193 });
    let largest = i32::MAX as u32;
    assert!(matches!(claims(largest, largest, 0x9bab_9c31), CodecError::Unreadable { .. }));
}

/// An OpenEXR file of 3 × 2 pixels, rows from the top down, with these channels.
fn exr_of(names: &[&str], value: impl Fn(usize, usize, usize) -> f32) -> Vec<u8> {
    use exr::prelude::{AnyChannel, AnyChannels, FlatSamples, WritableImage};
    let channel = |(which, name): (usize, &&str)| {
        let samples = (0..6).map(|k| value(which, k % 3, k / 3)).collect();
        AnyChannel::new(*name, FlatSamples::F32(samples))
    };
    let channels = AnyChannels::sort(names.iter().enumerate().map(channel).collect());
    let mut file = Cursor::new(Vec::new());
    exr::prelude::Image::from_channels((3, 2), channels).write().to_buffered(&mut file).unwrap();
    file.into_inner()
}

#[test]
fn openexr_files_of_luminance_alone_are_gray() {
    let luminance = |_: usize, x: usize, row: usize| 0.5 * x as f32 + 3.0 * row as f32;
    let read = decode(&exr_of(&["Y"], luminance)).unwrap();
    assert_eq!((read.width(), read.height()), (3, 2));
    // Row 0 of the file is the top, j = 1.
    assert_eq!((read.get(2, 1), read.get(1, 0)), (Rgb::splat(1.0), Rgb::splat(3.5)));
    let with_alpha =
        codec::decode_with_alpha(&exr_of(
            &["Y", "A"],
            |which, x, row| {
                if which == 0 { luminance(0, x, row) } else { 0.25 }
            },
        ));
    let with_alpha = with_alpha.unwrap();
    assert_eq!((with_alpha.image, with_alpha.alpha), (read, Some(vec![0.25; 6])));
}

#[test]
fn openexr_files_that_are_neither_rgb_nor_luminance_are_refused() {
    for names in [&["Z"][..], &["R", "G"], &["BY", "RY", "Y"]] {
        assert!(
            matches!(decode(&exr_of(names, |_, _, _| 0.5)), Err(CodecError::Unreadable { .. })),
            "{names:?}"
        );
    }
}

#[test]
fn opacity_comes_with_the_picture_where_a_file_has_it() {
    let rgba = [0, 0, 0, 0, 0, 0, 0, 255];
    let read = codec::decode_with_alpha(&png_of(&rgba, 2, 1, ExtendedColorType::Rgba8)).unwrap();
    assert_eq!(read.alpha, Some(vec![0.0, 1.0]));
    let opaque = codec::decode_with_alpha(&png_of(&[0, 0, 0], 1, 1, ExtendedColorType::Rgb8)).unwrap();
    assert_eq!(opaque.alpha, None);
}
