//! Do two pictures show the same, and if not, where do they differ?
//!
//! Differences are measured between **encoded** values: sRGB in [0, 1] after clamping ([`srgb::encode`]). What matters
//! is what a viewer sees: 1/255 is one step of an 8-bit file, and equal differences look about equally strong in dark
//! and in light parts. Linear light would call a visible error in the dark small and an invisible one in a highlight
//! large. A pixel differs by the greatest difference of its three channels, so that a wrong hue cannot hide in an
//! average.

use thiserror::Error;

use crate::heat::heat;
use crate::{Image, Rgb, row_from_j, srgb};

/// Two pictures of different sizes have no pixels to compare.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("the pictures differ in size ({} × {} and {} × {} pixels): only pictures of one size can be compared", a.0, a.1, b.0, b.1)]
pub struct SizeMismatch {
    /// Width and height of the first picture, in pixels.
    pub a: (u32, u32),
    /// Width and height of the second picture, in pixels.
    pub b: (u32, u32),
}

/// How much two pictures differ, from [`difference`]. All differences are encoded (sRGB), in [0, 1].
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// The number of pixels that differ by more than the threshold, and of those with a NaN: a NaN is within no threshold.
    pub over_threshold: usize,
    /// The number of pixels that are NaN in either picture.
    pub not_a_number: usize,
    /// The greatest difference of any pixel; 0 if there are no pixels.
    pub greatest: f32,
    /// The pixel (i, j), j upwards, that differs most; of several, the first in reading order. `None` if none differs.
    pub greatest_at: Option<(u32, u32)>,
    /// The mean over all pixels; 0 if there are no pixels.
    pub mean: f32,
    width: u32,
    height: u32,
    /// The difference of each pixel, rows from the top down.
    per_pixel: Vec<f32>,
}

/// What differs between two pictures of one size.
///
/// A pixel's difference is the greatest, over its channels, of |encode(a) − encode(b)| ([`srgb::encode`]). A NaN in
/// either picture counts as the greatest difference, 1, even where the other has it too: a NaN is never right.
///
/// - `threshold`: in [0, 1]; a pixel is counted if its difference is greater, or if it has a NaN, whatever the threshold.
///
/// ```
/// use canvas::{Image, Rgb, difference, srgb};
/// let a = Image::new(4, 3, Rgb::ZERO);
/// let mut b = a.clone();
/// b.set(2, 1, Rgb::new(0.0, srgb::from_u8(51), 0.0)); // 51/255 = 0.2
/// let found = difference(&a, &b, 1.0 / 255.0)?;
/// assert_eq!((found.over_threshold, found.greatest_at), (1, Some((2, 1))));
/// assert!((found.greatest - 0.2).abs() < 1e-6);
/// # Ok::<(), canvas::SizeMismatch>(())
/// ```
///
/// # Errors
/// [`SizeMismatch`] if width or height differ.
pub fn difference(a: &Image, b: &Image, threshold: f32) -> Result<Difference, SizeMismatch> {
    let (width, height) = (a.width(), a.height());
    if (width, height) != (b.width(), b.height()) {
        return Err(SizeMismatch { a: (width, height), b: (b.width(), b.height()) });
    }
    let per_pixel: Vec<f32> =
        a.pixels().iter().zip(b.pixels()).map(|(a, b)| visible_difference(*a, *b)).collect();

    let is_nan = |(a, b): (&Rgb, &Rgb)| a.is_nan() || b.is_nan();
    let nan: Vec<bool> = a.pixels().iter().zip(b.pixels()).map(is_nan).collect();

    let greatest = per_pixel.iter().copied().fold(0.0, f32::max);
    let first_greatest = per_pixel.iter().position(|d| greatest > 0.0 && *d == greatest);
    // In f64: a long sum of f32 would lose its small terms.
    let sum: f64 = per_pixel.iter().copied().map(f64::from).sum();
    Ok(Difference {
        over_threshold: per_pixel.iter().zip(&nan).filter(|(d, nan)| **nan || **d > threshold).count(),
        not_a_number: nan.iter().filter(|nan| **nan).count(),
        greatest,
        greatest_at: first_greatest.map(|place| pixel_at(place, width, height)),
        mean: (sum / per_pixel.len().max(1) as f64) as f32,
        width,
        height,
        per_pixel,
    })
}

/// The greatest difference of a channel of two colours, encoded, in [0, 1].
fn visible_difference(a: Rgb, b: Rgb) -> f32 {
    if a.is_nan() || b.is_nan() {
        return 1.0;
    }
    if a == b {
        return 0.0; // The common case, and encoding takes time.
    }
    let encoded = |color: Rgb| Rgb::from(color.to_array().map(srgb::encode));
    (encoded(a) - encoded(b)).abs().max_element()
}

/// The pixel (i, j), j upwards, whose place among the rows from the top down is given.
fn pixel_at(place: usize, width: u32, height: u32) -> (u32, u32) {
    let (row, column) = (place / width as usize, place % width as usize);
    // `row_from_j` is its own inverse.
    (column as u32, row_from_j(row as u32, height))
}

impl Difference {
    /// A picture of the differences: black where there is none, through purple, red and orange to white where it is 1.
    ///
    /// The scale is fixed, so that two heat maps can be compared, and logarithmic, so that one step of an 8-bit file
    /// can be seen: a difference of d takes the place log₂(1 + 255 d) / 8 on the ramp. 1, 3, 7, 15, 31, 63, 127 and 255
    /// steps of an 8-bit file are 1 to 8 eighths of the way up. The ramp's lightness (CIE L*) is proportional to the
    /// place, so that it also reads in grey.
    ///
    /// ```
    /// use canvas::{Image, Rgb, difference};
    /// let (a, b) = (Image::new(3, 2, Rgb::ZERO), Image::new(3, 2, Rgb::X)); // 255 steps of red
    /// assert_eq!(difference(&a, &b, 0.0)?.heat_map().get(2, 0), Rgb::ONE);
    /// # Ok::<(), canvas::SizeMismatch>(())
    /// ```
    #[must_use]
    pub fn heat_map(&self) -> Image {
        let colors = self.per_pixel.iter().map(|d| heat((1.0 + 255.0 * d).log2() / 8.0)).collect();
        Image::from_rows(self.width, self.height, colors).expect("one colour for each difference")
    }
}

/// One picture with the given ones in a row, left to right, standing on a common ground: pixel (i, 0) of each is in the
/// lowest row. Above lower pictures and in the gaps, `gap` columns wide, is `gap_color`. No pictures give an image
/// without pixels.
///
/// ```
/// use canvas::{Image, Rgb, side_by_side};
/// let (low, high) = (Image::new(3, 2, Rgb::X), Image::new(4, 5, Rgb::Y));
/// let row = side_by_side(&[&low, &high], 1, Rgb::ONE);
/// assert_eq!((row.width(), row.height()), (8, 5));
/// assert_eq!([row.get(2, 0), row.get(2, 2), row.get(3, 0), row.get(4, 0)], [Rgb::X, Rgb::ONE, Rgb::ONE, Rgb::Y]);
/// ```
///
/// # Panics
/// If the widths add up to more than a `u32` holds.
#[must_use]
pub fn side_by_side(images: &[&Image], gap: u32, gap_color: Rgb) -> Image {
    let gaps = images.len().saturating_sub(1) as u64 * u64::from(gap);
    let width = gaps + images.iter().map(|image| u64::from(image.width())).sum::<u64>();
    let width = u32::try_from(width).expect("the widths add up to no more than a u32 holds");
    let height = images.iter().map(|image| image.height()).max().unwrap_or(0);

    let mut row = Image::new(width, height, gap_color);
    let mut left = 0;
    for image in images {
        for j in 0..image.height() {
            for i in 0..image.width() {
                row.set(left + i, j, image.get(i, j));
            }
        }
        // After the last picture there is no gap; saturating, because nothing is drawn there.
        left = left.saturating_add(image.width()).saturating_add(gap);
    }
    row
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The colour whose encoded channels are these steps of an 8-bit file.
    fn steps(r: u8, g: u8, b: u8) -> Rgb {
        Rgb::from([r, g, b].map(srgb::from_u8))
    }

    fn differ(a: [Rgb; 6], b: [Rgb; 6], threshold: f32) -> Difference {
        let image = |pixels: [Rgb; 6]| Image::from_rows(3, 2, pixels.to_vec()).unwrap();
        difference(&image(a), &image(b), threshold).unwrap()
    }

    #[test]
    fn worked_numbers() {
        // Steps of 255: pixel differences 0, 1, 51 in the upper row and 102 (of 20, 102, 5), 0, 2 in the lower one.
        let a = [steps(9, 9, 9), steps(0, 7, 0), steps(0, 0, 60), steps(10, 200, 30), Rgb::X, steps(1, 2, 3)];
        let b = [steps(9, 9, 9), steps(0, 8, 0), steps(0, 0, 9), steps(30, 98, 25), Rgb::X, steps(1, 2, 5)];
        let found = differ(a, b, 1.5 / 255.0);
        assert_eq!(found.over_threshold, 3);
        assert_eq!(found.greatest_at, Some((0, 0)), "the lower row has j = 0");
        // Encoding and decoding each cost a few roundings of 6e-8.
        assert!((found.greatest - 102.0 / 255.0).abs() < 1e-6);
        assert!((found.mean - (1.0 + 51.0 + 102.0 + 2.0) / 6.0 / 255.0).abs() < 1e-6);
    }

    #[test]
    fn equal_pictures_differ_nowhere() {
        let a = [Rgb::X, Rgb::Y, Rgb::Z, Rgb::ONE, Rgb::splat(f32::INFINITY), Rgb::new(0.1, 2.0, -3.0)];
        let found = differ(a, a, 0.0);
        assert_eq!(
            (found.over_threshold, found.greatest, found.greatest_at, found.mean),
            (0, 0.0, None, 0.0)
        );
    }

    #[test]
    fn what_a_file_cannot_show_is_no_difference() {
        let a = [Rgb::splat(1.96); 6];
        assert_eq!(differ(a, [Rgb::ONE; 6], 0.0).greatest, 0.0);
    }

    #[test]
    fn nan_is_the_greatest_difference_also_against_itself() {
        let mut a = [Rgb::splat(0.3); 6];
        a[4].y = f32::NAN;
        for (b, threshold) in [(a, 0.5), ([Rgb::splat(0.3); 6], 0.5), (a, 1.0), ([Rgb::splat(0.3); 6], 2.0)] {
            let found = differ(a, b, threshold);
            assert_eq!((found.over_threshold, found.not_a_number), (1, 1), "no tolerance is wide enough");
            assert_eq!((found.greatest, found.greatest_at), (1.0, Some((1, 0))));
            assert!((found.mean - 1.0 / 6.0).abs() < 1e-6);
        }
    }

    #[test]
    fn pictures_of_different_sizes_are_refused_by_name() {
        let error = difference(&Image::new(3, 2, Rgb::X), &Image::new(2, 3, Rgb::X), 0.0).unwrap_err();
        assert_eq!(
            error.to_string(),
            "the pictures differ in size (3 × 2 and 2 × 3 pixels): only pictures of one size can be compared"
        );
    }

    #[test]
    fn images_without_pixels_do_not_differ() {
        let nothing = Image::new(0, 7, Rgb::X);
        let found = difference(&nothing, &nothing, 0.0).unwrap();
        assert_eq!((found.greatest, found.greatest_at, found.mean), (0.0, None, 0.0));
        assert_eq!(found.heat_map(), nothing);
    }

    #[test]
    fn heat_shows_one_8_bit_step_an_eighth_up() {
        let white = [Rgb::ONE; 6];
        let mut nearly = white;
        nearly[5] = steps(255, 254, 255);
        let heat_map = differ(white, nearly, 0.0).heat_map();
        assert_eq!(heat_map.get(1, 1), Rgb::ZERO);
        assert!(heat_map.get(2, 0).abs_diff_eq(steps(57, 5, 74), 1e-4));
    }

    #[test]
    fn pictures_of_different_heights_stand_on_one_ground() {
        let numbered =
            |width, height, red| Image::from_fn(width, height, |i, j| Rgb::new(red, i as f32, j as f32));
        let (a, b, c) = (numbered(2, 3, 1.0), numbered(3, 1, 2.0), numbered(1, 2, 3.0));
        let row = side_by_side(&[&a, &b, &c], 2, Rgb::splat(9.0));
        assert_eq!((row.width(), row.height()), (2 + 2 + 3 + 2 + 1, 3));
        assert_eq!(row.get(1, 2), Rgb::new(1.0, 1.0, 2.0));
        assert_eq!(row.get(6, 0), Rgb::new(2.0, 2.0, 0.0));
        assert_eq!(row.get(9, 1), Rgb::new(3.0, 0.0, 1.0));
        for (i, j) in [(2, 0), (3, 2), (4, 1), (7, 0), (8, 0), (9, 2)] {
            assert_eq!(row.get(i, j), Rgb::splat(9.0), "pixel ({i}, {j})");
        }
    }

    #[test]
    fn no_pictures_in_a_row_are_no_pixels() {
        assert_eq!(side_by_side(&[], 5, Rgb::ONE), Image::new(0, 0, Rgb::ONE));
    }
}
