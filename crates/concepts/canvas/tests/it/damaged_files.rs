//! A damaged file ends in an image or an error: never in a panic, a hang or all of the memory.

use canvas::{CodecError, Format, Image, Rgb, codec};
use testkit::damage::{self, Random};

/// Damaged files of each format.
const FILES: u32 = 1000;

/// Both formats say within so many bytes what the rest holds.
const HEADER: usize = 400;

fn picture() -> Image {
    Image::from_fn(37, 21, |i, j| {
        Rgb::new(0.03 * i as f32, 0.05 * j as f32, 0.2 * ((7 * i + 3 * j) % 11) as f32)
    })
}

fn survives(format: Format) {
    let file = codec::encode(&picture(), format).unwrap();
    let outcomes = damage::none_hangs(FILES, move |case| {
        codec::decode(&damage::bytes(&file, HEADER, &mut Random::new(case.into())))
    });
    let refused = outcomes.iter().filter(|outcome| outcome.is_err()).count();
    // If nearly all files were refused at the door, or hardly any damage were noticed, the test would say little.
    assert!(FILES as usize / 4 < refused, "only {refused} of {FILES} files were refused");
    let at_the_door =
        outcomes.iter().filter(|outcome| matches!(outcome, Err(CodecError::UnknownContent))).count();
    assert!(at_the_door < FILES as usize / 4, "{at_the_door} of {FILES} files were refused at the door");
}

#[test]
fn damaged_8_bit_png_files_are_survived() {
    survives(Format::Png8);
}

#[test]
fn damaged_16_bit_png_files_are_survived() {
    survives(Format::Png16);
}

#[test]
fn damaged_openexr_files_are_survived() {
    survives(Format::Exr);
}

#[test]
fn a_file_cut_off_anywhere_is_an_error() {
    let small = Image::new(3, 2, Rgb::new(0.2, 1.5, 0.7));
    for format in [Format::Png8, Format::Png16, Format::Exr] {
        let file = codec::encode(&small, format).unwrap();
        // The last 12 bytes of a PNG only say that it ends; its pixels are complete without them.
        let end = if format == Format::Exr { file.len() } else { file.len() - 12 };
        for length in 0..end {
            assert!(codec::decode(&file[..length]).is_err(), "{format:?} cut off after {length} bytes");
        }
    }
}

/// The file with the numbers of a window replaced: x and y of its first and of its last pixel.
fn with_window(name: &str, numbers: [i32; 4]) -> Vec<u8> {
    let mut file = codec::encode(&picture(), Format::Exr).unwrap();
    let attribute = [name.as_bytes(), b"\0box2i\0"].concat();
    let place =
        file.windows(attribute.len()).position(|bytes| bytes == attribute).unwrap() + attribute.len() + 4;
    file[place..][..16].copy_from_slice(numbers.map(i32::to_le_bytes).as_flattened());
    file
}

#[test]
fn openexr_files_that_claim_huge_windows_are_refused() {
    let extremes = [i32::MIN, -1_000_000_000, -1, 0, 40, 1 << 30, i32::MAX];
    for x_first in extremes {
        for x_last in extremes {
            let columns = x_first.abs_diff(x_last);
            if columns < 1000 {
                continue;
            }
            // The data window must be refused by its claim, before the reader of the format allocates anything for it.
            let error = codec::decode(&with_window("dataWindow", [x_first, 0, x_last, 20])).unwrap_err();
            assert!(error.to_string().contains("its header claims"), "{columns} columns: {error}");
            let outcome = codec::decode(&with_window("displayWindow", [x_first, 0, x_last, 20]));
            assert!(outcome.is_err(), "a display window of {columns} columns was read");
        }
    }
}

#[test]
fn a_panic_in_the_openexr_reader_is_an_error() {
    // 4 × 4 pixels, B44 compression, two bytes damaged: the reader subtracts below zero. Builds without overflow checks
    // wrap around there and read some image.
    let outcome = codec::decode(include_bytes!("../data/overflowing_b44.exr"));
    if cfg!(debug_assertions) {
        assert!(matches!(outcome, Err(CodecError::Unreadable { .. })), "{outcome:?}");
    }
}
