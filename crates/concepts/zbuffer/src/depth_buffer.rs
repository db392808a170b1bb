//! What is the nearest depth so far in pixel (i, j)? (L16)

use std::ops::Range;

use canvas::{DepthImage, row_from_j};

use crate::DepthFormat;

/// The nearest depth so far, one a pixel. **Larger is nearer.**
///
/// The slides never say what is stored before the first polygon (E16); here it is the farthest value, so that the first
/// fragment wins. In 24 and 16 bits that value is the code of the far plane itself: as in hardware, what rounds to the far
/// plane is not drawn. In 32 bits it is farther than every number.
///
/// Rows are stored from the top down, as in [`canvas::Image`], so that bands of both match; pixels are named (i, j), j
/// upwards. In memory each pixel takes four bytes, whatever the format.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DepthBuffer {
    width: u32,
    height: u32,
    format: DepthFormat,
    codes: Vec<u32>,
}

impl DepthBuffer {
    /// A buffer of `width` × `height` pixels, cleared.
    ///
    /// ```
    /// use zbuffer::{DepthBuffer, DepthFormat};
    ///
    /// let mut depth = DepthBuffer::new(640, 480, DepthFormat::F32);
    /// assert_eq!(depth.get(3, 7), None);
    /// assert!(depth.test_and_set(3, 7, -0.25)); // the first is the nearest so far
    /// assert!(!depth.test_and_set(3, 7, -0.5)); // farther
    /// assert!(!depth.test_and_set(3, 7, -0.25)); // equal: the first stays
    /// assert_eq!(depth.get(3, 7), Some(-0.25));
    /// ```
    #[must_use]
    pub fn new(width: u32, height: u32, format: DepthFormat) -> Self {
        Self { width, height, format, codes: vec![0; width as usize * height as usize] }
    }

    /// Sets every pixel to the farthest depth.
    pub fn clear(&mut self) {
        self.codes.fill(0);
    }

    /// n_x, the number of pixels in a row.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// n_y, the number of rows.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// How depths are stored.
    #[must_use]
    pub fn format(&self) -> DepthFormat {
        self.format
    }

    /// The depth stored for pixel (i, j), rounded as the format has it; `None` if nothing was drawn there.
    ///
    /// # Panics
    /// If the pixel lies outside the buffer.
    #[must_use]
    pub fn get(&self, i: u32, j: u32) -> Option<f32> {
        assert!(i < self.width, "pixel column i = {i} outside a buffer of width {}", self.width);
        let row = row_from_j(j, self.height) as usize;
        let code = self.codes[row * self.width as usize + i as usize];
        (code > 0).then(|| self.format.depth(code))
    }

    /// Stores `z` for pixel (i, j) and says true if it is strictly nearer than what is stored (L16). A NaN never is.
    ///
    /// # Panics
    /// If the pixel lies outside the buffer.
    #[inline]
    pub fn test_and_set(&mut self, i: u32, j: u32, z: impl Into<f64>) -> bool {
        self.whole().test_and_set(i, j, z)
    }

    /// The buffer in bands of `rows` rows (the last may be lower), **from the top down**, for as many threads.
    ///
    /// `image.pixels_mut().chunks_mut(width * rows)` gives the same bands of a [`canvas::Image`], in the same order.
    ///
    /// ```
    /// use zbuffer::{DepthBuffer, DepthFormat};
    ///
    /// let mut depth = DepthBuffer::new(640, 480, DepthFormat::Bits24);
    /// let bands: Vec<_> = depth.bands_mut(200).collect();
    /// assert_eq!(bands[0].rows(), 280..480);
    /// assert_eq!(bands[2].rows(), 0..80);
    /// ```
    ///
    /// # Panics
    /// If `rows` is 0.
    pub fn bands_mut(&mut self, rows: u32) -> impl Iterator<Item = DepthBand<'_>> {
        assert!(rows > 0, "a band must have rows");
        let Self { width, height, format, .. } = *self;
        // Without columns there are no chunks, and so no bands.
        let chunk = (width as usize * rows as usize).max(1);
        self.codes.chunks_mut(chunk).zip(0_u32..).map(move |(codes, k)| {
            let end = height - k * rows;
            DepthBand { width, rows: end.saturating_sub(rows)..end, format, codes }
        })
    }

    /// The depths as an image.
    #[must_use]
    pub fn to_image(&self) -> DepthImage {
        let mut image = DepthImage::new(self.width, self.height);
        for j in 0..self.height {
            for i in 0..self.width {
                image.set(i, j, self.get(i, j).unwrap_or(DepthImage::NOTHING));
            }
        }
        image
    }

    fn whole(&mut self) -> DepthBand<'_> {
        DepthBand { width: self.width, rows: 0..self.height, format: self.format, codes: &mut self.codes }
    }
}

/// Some neighbouring rows of a [`DepthBuffer`], to be changed by one thread.
#[derive(Debug)]
pub struct DepthBand<'a> {
    width: u32,
    rows: Range<u32>,
    format: DepthFormat,
    codes: &'a mut [u32],
}

impl DepthBand<'_> {
    /// The rows j of the band, counted upwards in the whole buffer.
    #[must_use]
    pub fn rows(&self) -> Range<u32> {
        self.rows.clone()
    }

    /// As [`DepthBuffer::test_and_set`]; (i, j) counts in the whole buffer.
    ///
    /// # Panics
    /// If the pixel lies outside the band.
    #[inline]
    pub fn test_and_set(&mut self, i: u32, j: u32, z: impl Into<f64>) -> bool {
        let index = self.index(i, j);
        let code = self.format.code(z);
        let nearer = code > self.codes[index];
        if nearer {
            self.codes[index] = code;
        }
        nearer
    }

    /// Where in the band's pixels, rows from the top down, pixel (i, j) stands: here, and in the same band of an image.
    ///
    /// # Panics
    /// If the pixel lies outside the band.
    #[must_use]
    #[inline]
    pub fn index(&self, i: u32, j: u32) -> usize {
        assert!(i < self.width && self.rows.contains(&j), "pixel ({i}, {j}) outside rows {:?}", self.rows);
        let row = row_from_j(j - self.rows.start, self.rows.end - self.rows.start) as usize;
        row * self.width as usize + i as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn depths_come_back_as_the_format_has_them() {
        for (format, stored) in [(DepthFormat::F32, 0.3), (DepthFormat::Bits16, 19_661.0 / 65_535.0)] {
            let mut depth = DepthBuffer::new(4, 3, format);
            assert!(depth.test_and_set(1, 2, 0.3));
            assert_eq!(depth.get(1, 2), Some(stored), "{format:?}");
        }
    }

    #[test]
    fn equal_depths_are_equal_and_nan_is_never_nearer() {
        for format in [DepthFormat::F32, DepthFormat::Bits24, DepthFormat::Bits16] {
            let mut depth = DepthBuffer::new(4, 3, format);
            assert!(!depth.test_and_set(3, 1, f32::NAN));
            assert!(depth.test_and_set(3, 1, -0.0));
            assert!(!depth.test_and_set(3, 1, 0.0), "+0 is not nearer than −0 in {format:?}");
            assert!(!depth.test_and_set(3, 1, f32::NAN));
        }
    }

    #[test]
    fn the_far_plane_itself_is_drawn_in_32_bits_only() {
        for (format, drawn) in
            [(DepthFormat::F32, true), (DepthFormat::Bits24, false), (DepthFormat::Bits16, false)]
        {
            assert_eq!(DepthBuffer::new(2, 2, format).test_and_set(1, 0, -1.0), drawn, "{format:?}");
        }
    }

    #[test]
    fn memory_that_was_never_set_hides_polygons() {
        // E16: the slide's listing compares with a saved depth that nothing has been stored in; zeroed memory is a depth
        // in the middle of the volume, and the farther half of the scene is gone.
        let (zeroed, behind_the_middle) = (0.0_f32, -0.4);
        assert!(behind_the_middle <= zeroed);
        assert!(DepthBuffer::new(1, 1, DepthFormat::F32).test_and_set(0, 0, behind_the_middle));
    }

    #[test]
    fn bands_are_parts_of_the_buffer() {
        let mut depth = DepthBuffer::new(5, 7, DepthFormat::F32);
        for mut band in depth.bands_mut(3) {
            for j in band.rows() {
                assert!(band.test_and_set(2, j, 0.1 * j as f32));
            }
        }
        let column: Vec<_> = (0..7).map(|j| depth.get(2, j)).collect();
        let expected: Vec<_> = (0..7).map(|j| Some(0.1 * j as f32)).collect();
        assert_eq!(column, expected);
        assert_eq!(depth.get(3, 4), None);
        assert_eq!(DepthBuffer::new(0, 7, DepthFormat::F32).bands_mut(3).count(), 0);
    }
}
