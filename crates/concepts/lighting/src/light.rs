//! Where does light come from? A point, a direction, or everywhere (L24).

use glam::Vec3;

use crate::Rgb;

/// A source of light. Several may shine at once; their light adds up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Light {
    /// c_a: light from everywhere at once, a stand-in for all that bounces about (L28). Casts no shadow.
    Ambient {
        /// c_a, linear RGB.
        color: Rgb,
    },
    /// Light from infinitely far away, the same direction everywhere: the sun.
    Directional {
        /// l: the direction *towards* the light, world space; must have unit length, or the light counts more or less.
        to_light: Vec3,
        /// c_l, linear RGB.
        color: Rgb,
    },
    /// Light from one point to all sides. As in the lecture it does not fall off with distance (E6).
    Point {
        /// Where it is, world space.
        position: Vec3,
        /// c_l, linear RGB.
        color: Rgb,
    },
}

/// The light that arrives at one point from one source that has a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Illumination {
    /// l: the unit direction towards the light.
    pub to_light: Vec3,
    /// How far away the light is; infinite for a directional light. A shadow ray ends there (E12).
    pub distance: f32,
    /// c_l, linear RGB.
    pub color: Rgb,
}

impl Light {
    /// What arrives at `p_world`; `None` for ambient light, which has no direction, and for a point light at `p_world`
    /// itself.
    ///
    /// ```
    /// use glam::{Vec3, vec3};
    /// use lighting::Light;
    ///
    /// let lamp = Light::Point { position: vec3(1.0, 6.0, 3.0), color: Vec3::ONE };
    /// let light = lamp.illumination(vec3(1.0, 2.0, 0.0)).unwrap();
    /// assert_eq!((light.to_light, light.distance), (vec3(0.0, 0.8, 0.6), 5.0));
    /// ```
    #[must_use]
    pub fn illumination(&self, p_world: Vec3) -> Option<Illumination> {
        match *self {
            Self::Ambient { .. } => None,
            Self::Directional { to_light, color } => {
                Some(Illumination { to_light, distance: f32::INFINITY, color })
            }
            Self::Point { position, color } => {
                // In f64: squares of very large and very small distances leave the range of f32.
                let way = position.as_dvec3() - p_world.as_dvec3();
                let to_light = way.try_normalize()?.as_vec3();
                Some(Illumination { to_light, distance: way.length() as f32, color })
            }
        }
    }
}

/// The sum of all ambient light, c_a.
#[must_use]
pub fn ambient(lights: &[Light]) -> Rgb {
    let color = |light: &Light| {
        if let Light::Ambient { color } = light { *color } else { Rgb::ZERO }
    };
    lights.iter().map(color).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lamp_shines_from_any_distance() {
        for distance in [1e-22_f32, 1e-5, 1.0, 2e19, 1e30] {
            let lamp = Light::Point { position: distance * Vec3::new(0.6, 0.0, 0.8), color: Rgb::ONE };
            let light = lamp.illumination(Vec3::ZERO).expect("a direction");
            assert!(light.to_light.abs_diff_eq(Vec3::new(0.6, 0.0, 0.8), 2.0 * f32::EPSILON), "{distance}");
            assert!((light.distance / distance - 1.0).abs() < 2.0 * f32::EPSILON, "{distance}");
        }
    }
}
