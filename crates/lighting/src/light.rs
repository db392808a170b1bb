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
        /// l: the unit direction *towards* the light, world space.
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
            Self::Directional { to_light, color } => Some(Illumination {
                to_light,
                distance: f32::INFINITY,
                color,
            }),
            Self::Point { position, color } => {
                let way = position - p_world;
                let to_light = way.try_normalize()?;
                Some(Illumination {
                    to_light,
                    distance: way.length(),
                    color,
                })
            }
        }
    }
}

/// The sum of all ambient light, c_a.
#[must_use]
pub fn ambient(lights: &[Light]) -> Rgb {
    let color = |light: &Light| {
        if let Light::Ambient { color } = light {
            *color
        } else {
            Rgb::ZERO
        }
    };
    lights.iter().map(color).sum()
}
