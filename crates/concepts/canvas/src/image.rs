//! What colour has pixel (i, j)?

use glam::Vec3;

/// A colour in linear RGB (sRGB primaries): proportional to light, so that colours may be added and scaled. No upper end.
pub type Rgb = Vec3;

/// The row from the top that holds the pixels (·, j): j runs upwards, rows run down. Its own inverse.
///
/// ```
/// use canvas::row_from_j;
/// assert_eq!(row_from_j(0, 480), 479); // the lowest pixels are in the last row
/// ```
///
/// # Panics
/// If `j` is not less than `height`.
#[must_use]
pub fn row_from_j(j: u32, height: u32) -> u32 {
    assert!(j < height, "pixel row j = {j} outside an image of height {height}");
    height - 1 - j
}

/// A picture in linear RGB. Pixel (i, j) covers [i−½, i+½] × [j−½, j+½] of the screen; j runs upwards.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    width: u32,
    height: u32,
    pixels: Vec<Rgb>,
}

impl Image {
    /// An image of `width` × `height` pixels, all of them `background`.
    #[must_use]
    pub fn new(width: u32, height: u32, background: Rgb) -> Self {
        Self { width, height, pixels: vec![background; width as usize * height as usize] }
    }

    /// The image whose pixel (i, j) is `color(i, j)`, j upwards.
    #[must_use]
    pub fn from_fn(width: u32, height: u32, mut color: impl FnMut(u32, u32) -> Rgb) -> Self {
        let mut image = Self::new(width, height, Rgb::ZERO);
        for j in 0..height {
            for i in 0..width {
                image.set(i, j, color(i, j));
            }
        }
        image
    }

    /// The image of these pixels, rows from the top down as in a file; `None` if their number is not `width` × `height`.
    #[must_use]
    pub fn from_rows(width: u32, height: u32, pixels: Vec<Rgb>) -> Option<Self> {
        (pixels.len() == width as usize * height as usize).then_some(Self { width, height, pixels })
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

    /// The colour of pixel (i, j), j upwards.
    ///
    /// # Panics
    /// If the pixel lies outside the image.
    #[must_use]
    pub fn get(&self, i: u32, j: u32) -> Rgb {
        self.pixels[self.index(i, j)]
    }

    /// Gives pixel (i, j) a colour, j upwards.
    ///
    /// # Panics
    /// If the pixel lies outside the image.
    pub fn set(&mut self, i: u32, j: u32, color: Rgb) {
        let index = self.index(i, j);
        self.pixels[index] = color;
    }

    /// All pixels, rows from the top down as in a file.
    #[must_use]
    pub fn pixels(&self) -> &[Rgb] {
        &self.pixels
    }

    /// All pixels to be changed, rows from the top down as in a file.
    pub fn pixels_mut(&mut self) -> &mut [Rgb] {
        &mut self.pixels
    }

    /// The average of each n × n block of pixels: the last step of supersampling by an n × n grid.
    ///
    /// # Panics
    /// If `n` is 0 or does not divide width and height.
    #[must_use]
    pub fn box_downsampled(&self, n: u32) -> Self {
        assert!(
            n > 0 && self.width.is_multiple_of(n) && self.height.is_multiple_of(n),
            "{n} does not divide the image"
        );
        let (width, n) = (self.width as usize, n as usize);
        let mut pixels = Vec::with_capacity(self.pixels.len() / (n * n));
        for rows in self.pixels.chunks_exact((width * n).max(1)) {
            pixels.extend((0..width).step_by(n).map(|first| {
                // From the lowest row upwards, as one would count (i, j).
                let blocks = rows.chunks_exact(width).rev().map(|row| &row[first..first + n]);
                let sum = blocks.flatten().fold(Rgb::ZERO, |sum, color| sum + *color);
                sum / (n * n) as f32
            }));
        }
        Self { width: self.width / n as u32, height: self.height / n as u32, pixels }
    }

    fn index(&self, i: u32, j: u32) -> usize {
        assert!(i < self.width, "pixel column i = {i} outside an image of width {}", self.width);
        row_from_j(j, self.height) as usize * self.width as usize + i as usize
    }
}
