//! How is a depth stored, and how small a difference can be told then? (L20)

use transforms::ViewVolume;

/// How a depth is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DepthFormat {
    /// Rounded to an `f32`; any finite depth.
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
    /// In 24 and 16 bits z is clamped to −1…1. Of an `f32` nothing is lost in 32 bits; an `f64` is rounded once, whatever the format.
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
    pub fn code(self, z: impl Into<f64>) -> u32 {
        let z: f64 = z.into();
        match self {
            Self::F32 if z.is_nan() => 0,
            Self::F32 => ordered_bits(z as f32),
            // In f64 the 24 bits of the code fit many times over; `as` turns NaN into 0.
            Self::Bits24 | Self::Bits16 => {
                (0.5 * (z + 1.0) * self.steps() + 0.5).clamp(0.0, self.steps()) as u32
            }
        }
    }

    /// The depth that a code stands for.
    pub(crate) fn depth(self, code: u32) -> f32 {
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
/// use zbuffer::{DepthFormat, depth_format::step_at};
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_step_grows_with_the_square_of_the_distance() {
        let volume = ViewVolume { left: -1.0, right: 1.0, bottom: -1.0, top: 1.0, near: -1.0, far: -1000.0 };
        let step = |format, distance| step_at(format, &volume, distance);
        // 2 / 65,535 over 2 · 1000 / (999 · 10²): 1.52 mm at 10 m, a hundred times that at 100 m.
        assert!((step(DepthFormat::Bits16, 10.0) - 0.001_524_4).abs() < 1e-7);
        assert!((step(DepthFormat::Bits16, 100.0) / step(DepthFormat::Bits16, 10.0) - 100.0).abs() < 1e-3);
        assert!((step(DepthFormat::Bits16, 10.0) / step(DepthFormat::Bits24, 10.0) - 256.0).abs() < 0.01);
        // Far away z is just above −1, where an f32 has steps of 2^−24: only twice as fine as 24 bits.
        assert!((step(DepthFormat::Bits24, 900.0) / step(DepthFormat::F32, 900.0) - 2.0).abs() < 1e-5);
    }
}
