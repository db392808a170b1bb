//! Which number in a file stands for how much light?
//!
//! The eye tells dark tones apart better than light ones, so a file of 256 steps spends more of them on the dark end.
//! The curve between light and file is that of IEC 61966-2-1 (sRGB): nearly a power of 2.4, with a straight piece near
//! black. Light is what may be added and averaged; encoded values may not. Half the light of white, for one, is not
//! step 128 but step 188:
//!
//! ```
//! use canvas::srgb;
//! assert_eq!(srgb::to_u8(0.5), 188);
//! assert!((srgb::from_u8(128) - 0.2159).abs() < 1e-4); // step 128 is a fifth of the light
//! ```
//!
//! [`encode`] is also where colours are clamped to [0, 1], once, on their way out (E8). Read [`mod@crate::codec`] next.

/// Light up to here is encoded by the straight piece of the curve, more by the power: where the two pieces meet. The
/// standard rounds it to 0.0031308, where they miss each other by 3e-8, so that the curve would step back there.
const KNEE_LINEAR: f64 = 0.003_130_668_442_500_6;
/// The slope of the straight piece.
const SLOPE: f64 = 12.92;
/// The power piece is (1 + 0.055) · x^(1/2.4) − 0.055: stretched and shifted to meet the straight one.
const OFFSET: f64 = 0.055;
/// The exponent of the power piece.
const GAMMA: f64 = 2.4;

/// The encoded value, in [0, 1], of an amount of light of one channel.
///
/// 12.92 · x up to x = 0.0031307, and 1.055 · x^(1/2.4) − 0.055 above (IEC 61966-2-1). This is the one place where
/// colours are clamped (E8).
///
/// - `linear`: light, proportional to power; 0 is black, 1 is the white of the file. Less than 0 counts as 0, more
///   than 1 as 1, infinities likewise; NaN counts as 0, for a file has no step for it.
///
/// ```
/// use canvas::srgb::encode;
/// assert!((encode(0.2) - 0.4845).abs() < 1e-4);
/// assert_eq!(encode(1.96), 1.0); // the slide's .8(.2+1)+1
/// ```
#[must_use]
pub fn encode(linear: f32) -> f32 {
    // In f64: in f32, rounding would part the two pieces again, and white would come out as 0.99999994.
    let x = f64::from(clamped(linear));
    (if x <= KNEE_LINEAR { SLOPE * x } else { (1.0 + OFFSET) * x.powf(1.0 / GAMMA) - OFFSET }) as f32
}

/// The light, in [0, 1], of an encoded value of one channel: the inverse of [`encode`].
///
/// y / 12.92 up to y = 0.04045, and ((y + 0.055) / 1.055)^2.4 above (IEC 61966-2-1).
///
/// - `encoded`: in [0, 1] as a file gives it. Other values are clamped as in [`encode`], NaN counts as 0.
///
/// ```
/// use canvas::srgb::decode;
/// assert!((decode(0.4845) - 0.2).abs() < 1e-4);
/// ```
#[must_use]
pub fn decode(encoded: f32) -> f32 {
    let y = f64::from(clamped(encoded));
    (if y <= SLOPE * KNEE_LINEAR { y / SLOPE } else { ((y + OFFSET) / (1.0 + OFFSET)).powf(GAMMA) }) as f32
}

/// The nearest of the 256 steps of an 8-bit file for an amount of light; clamped as in [`encode`].
#[must_use]
pub fn to_u8(linear: f32) -> u8 {
    nearest_step(linear, u8::MAX.into()) as u8
}

/// The light that a step of an 8-bit file stands for. [`to_u8`] gives the step back, exactly.
#[must_use]
pub fn from_u8(step: u8) -> f32 {
    decode(f32::from(step) / f32::from(u8::MAX))
}

/// The nearest of the 65,536 steps of a 16-bit file for an amount of light; clamped as in [`encode`].
#[must_use]
pub fn to_u16(linear: f32) -> u16 {
    nearest_step(linear, u16::MAX)
}

/// The light that a step of a 16-bit file stands for. [`to_u16`] gives the step back, exactly.
#[must_use]
pub fn from_u16(step: u16) -> f32 {
    decode(f32::from(step) / f32::from(u16::MAX))
}

/// [`to_u8`] for many pixels: looks the step up instead of computing a power, with the same result in a tenth of the
/// time.
#[derive(Clone, Debug)]
pub struct EightBitSteps {
    /// The least light of steps 1 to 255, and a light that none reaches.
    least: [f32; 256],
    /// The step of the darkest light of each of equally wide cells from 0 to 1: where to begin looking.
    begin: [u8; CELLS + 1],
}

/// So narrow a cell meets at most one step, but for the first few.
const CELLS: usize = 4096;

impl EightBitSteps {
    /// Finds the least light of each step.
    #[must_use]
    pub fn new() -> Self {
        let mut least = [f32::INFINITY; 256];
        for (below, least) in least.iter_mut().take(255).enumerate() {
            *least = least_light_above(below as u8);
        }
        let darkest = |cell: usize| cell as f32 / CELLS as f32;
        let step = |light: f32| least.partition_point(|least| *least <= light) as u8;
        Self { least, begin: std::array::from_fn(|cell| step(darkest(cell))) }
    }

    /// The nearest step for an amount of light, as [`to_u8`] gives it.
    ///
    /// ```
    /// use canvas::srgb::{EightBitSteps, to_u8};
    /// let steps = EightBitSteps::new();
    /// assert_eq!([0.2, 1.96, f32::NAN].map(|light| steps.nearest(light)), [124, 255, 0]);
    /// assert_eq!(to_u8(0.2), 124);
    /// ```
    #[must_use]
    #[inline]
    pub fn nearest(&self, linear: f32) -> u8 {
        // Cells are powers of two apart, so that the cell is never one too high. A NaN becomes 0: black.
        let clamped = linear.clamp(0.0, 1.0);
        let mut step = self.begin[(clamped * CELLS as f32) as usize];
        while self.least[usize::from(step)] <= clamped {
            step += 1;
        }
        step
    }
}

impl Default for EightBitSteps {
    fn default() -> Self {
        Self::new()
    }
}

/// The least `f32` that [`to_u8`] puts above a step, found by halving: positive floats are ordered as their bits are.
fn least_light_above(step: u8) -> f32 {
    let (mut not_above, mut above) = (0.0_f32.to_bits(), 1.0_f32.to_bits());
    while above - not_above > 1 {
        let middle = not_above.midpoint(above);
        if to_u8(f32::from_bits(middle)) > step {
            above = middle;
        } else {
            not_above = middle;
        }
    }
    f32::from_bits(above)
}

/// In [0, 1]; `max` returns its other argument for NaN, which is why it comes first.
#[allow(clippy::manual_clamp, reason = "f32::clamp would hand a NaN on")]
fn clamped(value: f32) -> f32 {
    value.max(0.0).min(1.0)
}

/// The encoded values are in [0, 1], so adding a half and cutting off is rounding to the nearest.
fn nearest_step(linear: f32, last_step: u16) -> u16 {
    (encode(linear) * f32::from(last_step) + 0.5) as u16
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn published_values_come_out() {
        // Light 0.18 (a grey card) is 0.4613561 encoded; 0.001 lies on the straight piece.
        assert!((encode(0.18) - 0.461_356_1).abs() < 1e-6);
        assert!((encode(0.001) - 0.012_92).abs() < 1e-8);
        assert_eq!((encode(0.0), encode(1.0)), (0.0, 1.0));
        assert_eq!((decode(0.0), decode(1.0)), (0.0, 1.0));
    }

    #[test]
    fn eight_bit_steps_of_known_light() {
        let steps: Vec<u8> = [0.0, 0.0002, 0.01, 0.214, 0.5, 0.75, 1.0].map(to_u8).to_vec();
        assert_eq!(steps, [0, 1, 25, 127, 188, 225, 255]);
    }

    #[test]
    fn all_256_steps_survive_the_round_trip() {
        assert!((0..=u8::MAX).all(|step| to_u8(from_u8(step)) == step));
    }

    #[test]
    fn all_65536_steps_survive_the_round_trip() {
        assert!((0..=u16::MAX).all(|step| to_u16(from_u16(step)) == step));
    }

    #[test]
    fn an_8_bit_step_is_257_16_bit_steps() {
        // 65535 / 255 = 257: PNG widens 8 to 16 bits in this way, and both must mean the same light.
        assert!((0..=u8::MAX).all(|step| to_u16(from_u8(step)) == 257 * u16::from(step)));
    }

    #[test]
    fn looked_up_steps_change_where_computed_steps_do() {
        let steps = EightBitSteps::new();
        // The last one is beyond all light.
        for least in steps.least.into_iter().take(255) {
            let (here, below) = (to_u8(least), to_u8(least.next_down()));
            assert_eq!(here, below + 1, "at {least}");
            assert_eq!((steps.nearest(least), steps.nearest(least.next_down())), (here, below));
        }
    }

    #[test]
    fn the_curve_rises_over_the_knee_without_a_step_back() {
        // Every f32 around the knee is tried.
        let rises = |curve: fn(f32) -> f32, knee: f64| {
            let (first, last) = ((knee as f32 * 0.999).to_bits(), (knee as f32 * 1.001).to_bits());
            (first..last).all(|bits| curve(f32::from_bits(bits)) <= curve(f32::from_bits(bits + 1)))
        };
        assert!(rises(encode, KNEE_LINEAR));
        assert!(rises(decode, SLOPE * KNEE_LINEAR));
    }

    #[test]
    fn light_outside_the_file_is_clamped_and_nan_is_black() {
        for (light, encoded) in
            [(1.96, 1.0), (f32::INFINITY, 1.0), (-0.3, 0.0), (f32::NEG_INFINITY, 0.0), (f32::NAN, 0.0)]
        {
            assert_eq!(encode(light), encoded, "encode({light})");
            assert_eq!(decode(light), encoded, "decode({light})");
        }
    }
}
