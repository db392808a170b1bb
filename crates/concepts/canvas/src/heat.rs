//! Which colour stands for more?
//!
//! A ramp from black through purple, red and orange to white, whose lightness rises evenly: it reads in grey too, and
//! to those who tell few colours apart.

use crate::{Rgb, srgb};

/// The ramp at each eighth, as 8-bit sRGB. Computed in CIE LCh: lightness 0, 12.5, … 100; the hue turns from purple
/// over red to yellow; as colourful as the screen can show at that lightness, less a margin.
const HEAT: [[u8; 3]; 9] = [
    [0, 0, 0],
    [57, 5, 74],
    [112, 14, 86],
    [168, 25, 90],
    [228, 37, 80],
    [248, 107, 76],
    [250, 165, 104],
    [252, 214, 156],
    [255, 255, 255],
];

/// The colour at a place in [0, 1] of the ramp. Between the eighths the encoded values are interpolated: they are
/// nearly proportional to lightness, light is not.
pub(crate) fn heat(place: f32) -> Rgb {
    let eighths = place * (HEAT.len() - 1) as f32;
    let below = (eighths as usize).min(HEAT.len() - 2);
    let encoded = |eighth: usize| Rgb::from(HEAT[eighth].map(|step| f32::from(step) / 255.0));
    let between = encoded(below).lerp(encoded(below + 1), eighths - below as f32);
    Rgb::from(between.to_array().map(srgb::decode))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heat_gets_lighter_in_proportion() {
        // CIE L* of each eighth is 12.5 more than that of the one below; a rounded 8-bit step is up to 0.2 of L*.
        let lightness = |color: Rgb| {
            let y = color.dot(Rgb::new(0.2126, 0.7152, 0.0722));
            if y > 0.008_856 { 116.0 * y.cbrt() - 16.0 } else { 903.3 * y }
        };
        for eighth in 0..=8 {
            assert!(
                (lightness(heat(eighth as f32 / 8.0)) - 12.5 * eighth as f32).abs() < 0.2,
                "eighth {eighth}"
            );
        }
        let along: Vec<f32> = (0..=800).map(|n| lightness(heat(n as f32 / 800.0))).collect();
        assert!(along.windows(2).all(|pair| pair[0] < pair[1]));
    }
}
