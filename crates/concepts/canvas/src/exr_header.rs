//! What does the header of an OpenEXR file claim, before anything is allocated for it?
//!
//! The reader of the format believes the header: a damaged file of 9 KB made it ask for 126 GB, and an allocation that
//! fails ends the program. So the claims are added up here first. Everything else in the header is left to the reader.
//!
//! A file is a magic number, a version with flags, and one header a part. A header is a list of attributes (name, NUL,
//! type, NUL, size as i32, value), closed by a NUL; a file of several parts closes the list of headers by another NUL.
//! All numbers are little-endian.

/// The magic number and the version come before the first header.
const START: usize = 8;
/// The flag in the version for a file of several parts.
const SEVERAL_PARTS: u32 = 1 << 12;
/// A channel takes its name, at least one letter, a NUL, and 16 bytes in the list of channels.
const SHORTEST_CHANNEL: usize = 18;
/// Bytes of the widest sample, `f32` or `u32`.
const WIDEST_SAMPLE: u64 = 4;
/// The numbers of the compressions DWAA and DWAB.
const DWA: [u8; 2] = [8, 9];

/// What the headers of a file claim; of several parts, and of attributes that come twice, the worst.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Claims {
    /// The bytes that the pixels of the largest part take in memory. Never less than the truth; more if channels have
    /// long names. Saturates.
    pub(crate) bytes: u64,
    /// The pixels are compressed by DWAA or DWAB. These carry sizes of their own among the compressed pixels, which
    /// the reader believes too: one flipped bit, and it asked for 560 TB.
    pub(crate) dwa: bool,
}

/// The claims of all headers; `None` if they are damaged or cut off.
pub(crate) fn claims(file: &[u8]) -> Option<Claims> {
    let version = u32::from_le_bytes(file.get(4..START)?.try_into().ok()?);
    let mut rest = file.get(START..)?;
    let mut worst = Claims::default();
    loop {
        let part = part_claims(&mut rest)?;
        worst = Claims { bytes: worst.bytes.max(part.bytes), dwa: worst.dwa || part.dwa };
        if version & SEVERAL_PARTS == 0 || *rest.first()? == 0 {
            return Some(worst);
        }
    }
}

/// Takes one header off the front of `rest`.
fn part_claims(rest: &mut &[u8]) -> Option<Claims> {
    let (mut pixels, mut channels, mut dwa) = (0, 0, false);
    loop {
        let name = take_text(rest)?;
        if name.is_empty() {
            let bytes = WIDEST_SAMPLE.saturating_mul(channels).saturating_mul(pixels);
            return Some(Claims { bytes, dwa });
        }
        let _type = take_text(rest)?;
        let size = i32::from_le_bytes(take(rest, 4)?.try_into().ok()?);
        let value = take(rest, usize::try_from(size).ok()?)?;
        match name {
            b"dataWindow" => pixels = pixels_in(value)?.max(pixels),
            b"channels" => channels = ((value.len() / SHORTEST_CHANNEL) as u64).max(channels),
            b"compression" => dwa |= DWA.contains(value.first()?),
            _ => {}
        }
    }
}

/// The number of pixels of a window, given as x and y of its first and of its last pixel. The reader of the format takes
/// them in either order, and so must this.
fn pixels_in(window: &[u8]) -> Option<u64> {
    let (corners, []) = window.as_chunks::<4>() else {
        return None;
    };
    let [x_first, y_first, x_last, y_last] = <[[u8; 4]; 4]>::try_from(corners).ok()?.map(i32::from_le_bytes);
    let length = |first: i32, last: i32| u64::from(first.abs_diff(last)) + 1;
    Some(length(x_first, x_last).saturating_mul(length(y_first, y_last)))
}

/// Takes the text up to the next NUL, and the NUL.
fn take_text<'a>(rest: &mut &'a [u8]) -> Option<&'a [u8]> {
    let length = rest.iter().position(|byte| *byte == 0)?;
    let text = take(rest, length)?;
    take(rest, 1)?;
    Some(text)
}

fn take<'a>(rest: &mut &'a [u8], length: usize) -> Option<&'a [u8]> {
    let (front, back) = rest.split_at_checked(length)?;
    *rest = back;
    Some(front)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Format, Image, Rgb, codec};

    /// A file of 5 × 3 pixels, and where the four numbers of its data window are.
    fn file_and_window() -> (Vec<u8>, usize) {
        let file = codec::encode(&Image::new(5, 3, Rgb::X), Format::Exr).unwrap();
        let name = b"dataWindow\0box2i\0";
        let window = file.windows(name.len()).position(|bytes| bytes == name).unwrap() + name.len() + 4;
        (file, window)
    }

    #[test]
    fn three_channels_of_five_by_three_pixels_claim_180_bytes() {
        assert_eq!(claims(&file_and_window().0), Some(Claims { bytes: 4 * 3 * 5 * 3, dwa: false }));
    }

    /// What the file claims with another data window: x and y of its first and of its last pixel.
    fn claimed_with_window(numbers: [i32; 4]) -> Option<u64> {
        let (mut file, window) = file_and_window();
        file[window..][..16].copy_from_slice(numbers.map(i32::to_le_bytes).as_flattened());
        claims(&file).map(|claims| claims.bytes)
    }

    #[test]
    fn the_largest_window_there_is_saturates() {
        assert_eq!(claimed_with_window([i32::MIN, i32::MIN, i32::MAX, i32::MAX]), Some(u64::MAX));
    }

    #[test]
    fn a_window_with_its_corners_swapped_is_as_large() {
        assert_eq!(claimed_with_window([0, 0, -1_000_000_000, 20]), Some(4 * 3 * 1_000_000_001 * 21));
    }

    #[test]
    fn the_larger_of_several_parts_counts() {
        let (one_part, _) = file_and_window();
        // Two parts: the header twice, the second with 7 columns, and a NUL to close the list.
        let header = &one_part[START..START + header_length(&one_part)];
        let mut wide = header.to_vec();
        let window = file_and_window().1 - START;
        wide[window + 8..][..4].copy_from_slice(&6_i32.to_le_bytes());
        let version = (2 | SEVERAL_PARTS).to_le_bytes();
        for parts in [[header, &wide], [&wide, header]] {
            let file = [&one_part[..4], &version, parts[0], parts[1], &[0]].concat();
            assert_eq!(claims(&file).map(|claims| claims.bytes), Some(4 * 3 * 7 * 3));
        }
    }

    #[test]
    fn dwa_compression_is_noticed() {
        let (mut file, _) = file_and_window();
        let name = b"compression\0compression\0";
        let number = file.windows(name.len()).position(|bytes| bytes == name).unwrap() + name.len() + 4;
        for compression in 0..=9 {
            file[number] = compression;
            assert_eq!(claims(&file).unwrap().dwa, compression >= 8, "compression {compression}");
        }
    }

    #[test]
    fn a_header_that_is_cut_off_claims_nothing() {
        let (file, _) = file_and_window();
        let end = START + header_length(&file);
        assert!((0..end).all(|length| claims(&file[..length]).is_none()));
        assert!(claims(&file[..end]).is_some());
    }

    fn header_length(file: &[u8]) -> usize {
        let mut rest = &file[START..];
        part_claims(&mut rest).unwrap();
        file.len() - START - rest.len()
    }
}
