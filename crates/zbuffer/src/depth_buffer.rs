//! What is the nearest depth so far in pixel (i, j)? (L16) And how small a difference can the buffer tell? (L20)

use std::ops::Range;

use canvas::{DepthImage, row_from_j};
use transforms::ViewVolume;

/// How a depth is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DepthFormat {
    /// As it is, an `f32`; any finite depth.
    F32,
    /// In 24 bits: canonical z, −1 to 1, rounded to the nearest of 2²⁴ − 1 equal steps.
    Bits24,
    /// In 16 bits: canonical z, −1 to 1, rounded to the nearest of 2¹⁶ − 1 equal steps.
    Bits16,
}

impl DepthFormat {
    /// The bits that a depth takes: 32, 24 or 16.
    #[must_use]
    pub fn bits(self) -> u32 {
        match self {
            Self::F32 => 32,
            Self::Bits24 => 24,
            Self::Bits16 => 16,
        }
    }

    /// The whole number that stands for depth `z`: the larger, the nearer. 0 stands for the farthest depth, and for NaN.
    ///
    /// In 24 and 16 bits z is clamped to −1…1. In 32 bits nothing is lost.
    ///
    /// ```
    /// use zbuffer::DepthFormat;
    ///
    /// assert_eq!(DepthFormat::Bits16.code(-1.0), 0);
    /// assert_eq!(DepthFormat::Bits16.code(0.5), 49_151); // 0.75 · 65,535 = 49,151.25
    /// assert_eq!(DepthFormat::Bits16.code(1.0), 65_535);
    /// ```
    #[must_use]
    #[inline]
    pub fn code(self, z: f32) -> u32 {
        match self {
            Self::F32 if z.is_nan() => 0,
            Self::F32 => ordered_bits(z),
            // In f64 the 24 bits of z and those of the code fit without rounding; `as` turns NaN into 0.
            Self::Bits24 | Self::Bits16 => {
                (0.5 * (f64::from(z) + 1.0) * self.steps() + 0.5).clamp(0.0, self.steps()) as u32
            }
        }
    }

    /// The depth that a code stands for.
    fn depth(self, code: u32) -> f32 {
        match self {
            Self::F32 => from_ordered_bits(code),
            Self::Bits24 | Self::Bits16 => (2.0 * f64::from(code) / self.steps() - 1.0) as f32,
        }
    }

    /// 2^b − 1, for b bits.
    fn steps(self) -> f64 {
        ((1_u64 << self.bits()) - 1) as f64
    }
}

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
    pub fn test_and_set(&mut self, i: u32, j: u32, z: f32) -> bool {
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
    pub fn test_and_set(&mut self, i: u32, j: u32, z: f32) -> bool {
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

/// The least difference in distance, in world units, that the format can store at a `distance` before the eye (L20): two
/// surfaces closer together than that fight for the pixel.
///
/// Canonical z is (n+f)/(n−f) + 2fn/((n−f)·distance), so it changes by 2fn/((n−f)·distance²) a world unit: the step grows
/// with the **square** of the distance. This is the format alone, to first order in the step; the rounding of the
/// vertices comes on top.
///
/// - `distance`: along the gaze, positive: −z_camera, from −near to −far.
///
/// ```
/// use transforms::ViewVolume;
/// use zbuffer::{DepthFormat, depth_buffer::step_at};
///
/// let volume = ViewVolume { left: -0.1, right: 0.1, bottom: -0.1, top: 0.1, near: -0.1, far: -1000.0 };
/// // A hundred units away, 16 bits cannot tell surfaces 1.5 units apart; 24 bits can tell 6 thousandths.
/// assert_eq!(format!("{:.2}", step_at(DepthFormat::Bits16, &volume, 100.0)), "1.53");
/// assert_eq!(format!("{:.4}", step_at(DepthFormat::Bits24, &volume, 100.0)), "0.0060");
/// ```
///
/// # Panics
/// Unless `distance` is positive.
#[must_use]
pub fn step_at(format: DepthFormat, volume: &ViewVolume, distance: f32) -> f32 {
    assert!(distance > 0.0, "distance {distance} is not before the eye");
    let (n, f, distance) = (f64::from(volume.near), f64::from(volume.far), f64::from(distance));
    let z_per_unit = 2.0 * f * n / ((n - f) * distance * distance);
    let z = (n + f) / (n - f) + 2.0 * f * n / ((n - f) * distance);
    let z_step = match format {
        DepthFormat::F32 => {
            let z = z as f32;
            f64::from(z) - f64::from(z.next_down())
        }
        DepthFormat::Bits24 | DepthFormat::Bits16 => 2.0 / format.steps(),
    };
    (z_step / z_per_unit) as f32
}

/// The bits of `z` rearranged so that whole numbers have the order of the depths. At least 1 for −∞ and above.
fn ordered_bits(z: f32) -> u32 {
    const SIGN: u32 = 1 << 31;
    // Adding 0 turns −0 into +0: equal depths get equal codes.
    let bits = (z + 0.0).to_bits();
    if bits & SIGN == 0 { bits | SIGN } else { !bits }
}

fn from_ordered_bits(code: u32) -> f32 {
    const SIGN: u32 = 1 << 31;
    f32::from_bits(if code & SIGN == 0 { !code } else { code & !SIGN })
}
