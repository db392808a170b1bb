//! What does the eye see? A truncated pyramid (L7), given by its window on the near plane.

use glam::{Vec3, vec3};

use crate::projection;

/// A viewing volume (Fig 7.7): the window [`left`, `right`] × [`bottom`, `top`] on the view plane w = `near`, seen from the
/// eye, as far as w = `far`.
///
/// `near` and `far` are w-coordinates in camera space and therefore **negative**: 0 > near > far. The slides never say so
/// (E2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewVolume {
    /// l: the u-coordinate of the window's left side.
    pub left: f32,
    /// r: the u-coordinate of the window's right side; greater than `left`.
    pub right: f32,
    /// b: the v-coordinate of the window's lower side.
    pub bottom: f32,
    /// t: the v-coordinate of the window's upper side; greater than `bottom`.
    pub top: f32,
    /// n: the w-coordinate of the near plane, which is the view plane; negative.
    pub near: f32,
    /// f: the w-coordinate of the far plane; less than `near`.
    pub far: f32,
}

/// How far from ±1 a corner of the volume may land: half a pixel on a screen 1000 wide. A volume that rounding moves farther
/// than that would give a picture that looks wrong without saying so.
const CORNER_TOLERANCE: f32 = 1e-3;

/// Why six numbers are no viewing volume.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum DegenerateVolume {
    /// A NaN or an infinity.
    #[error("{name} is {value}: not a finite number")]
    NotFinite {
        /// Which number.
        name: &'static str,
        /// Its value.
        value: f32,
    },
    /// l ≥ r.
    #[error("left = {left} must be less than right = {right}")]
    NoWidth {
        /// l.
        left: f32,
        /// r.
        right: f32,
    },
    /// b ≥ t.
    #[error("bottom = {bottom} must be less than top = {top}")]
    NoHeight {
        /// b.
        bottom: f32,
        /// t.
        top: f32,
    },
    /// n ≥ 0 or f ≥ 0: the plane does not lie before the eye.
    #[error("{name} = {value} must be negative: the camera looks along −w, so what it sees has negative w")]
    NotBeforeTheEye {
        /// Which plane.
        name: &'static str,
        /// Its w-coordinate.
        value: f32,
    },
    /// f ≥ n.
    #[error(
        "far = {far} must be less than near = {near}: both are negative, and the far plane lies farther out"
    )]
    NoDepth {
        /// n.
        near: f32,
        /// f.
        far: f32,
    },
    /// The field of view is not an angle between 0 and π.
    #[error("the field of view is {0} radians: it must lie between 0 and π (180°)")]
    FieldOfView(f32),
    /// The aspect ratio is not positive.
    #[error("the aspect ratio is {0}: width over height must be positive")]
    AspectRatio(f32),
    /// The numbers are valid one by one, but so extreme that the matrices overflow or lose everything.
    #[error("the volume is too extreme for 32-bit numbers: {0}")]
    TooExtreme(ViewVolume),
}

impl std::fmt::Display for ViewVolume {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { left, right, bottom, top, near, far } = self;
        write!(f, "left {left}, right {right}, bottom {bottom}, top {top}, near {near}, far {far}")
    }
}

impl ViewVolume {
    /// The symmetric volume with a vertical field of view of `fov_y` radians, between 0 and π, and a window `aspect` times
    /// as wide as high.
    ///
    /// # Errors
    /// [`DegenerateVolume`] if an argument is out of range.
    ///
    /// ```
    /// use std::f32::consts::FRAC_PI_2;
    /// use transforms::ViewVolume;
    ///
    /// let volume = ViewVolume::from_fov_y(FRAC_PI_2, 1.5, -2.0, -50.0)?;
    /// assert!((volume.top - 2.0).abs() < 1e-6 && (volume.right - 3.0).abs() < 1e-6);
    /// # Ok::<(), transforms::DegenerateVolume>(())
    /// ```
    pub fn from_fov_y(fov_y: f32, aspect: f32, near: f32, far: f32) -> Result<Self, DegenerateVolume> {
        if !(fov_y > 0.0 && fov_y < std::f32::consts::PI) {
            return Err(DegenerateVolume::FieldOfView(fov_y));
        }
        if !(aspect > 0.0 && aspect.is_finite()) {
            return Err(DegenerateVolume::AspectRatio(aspect));
        }
        let top = -near * (0.5 * fov_y).tan();
        let right = aspect * top;
        let volume = Self { left: -right, right, bottom: -top, top, near, far };
        volume.validate()?;
        Ok(volume)
    }

    /// Whether the numbers describe a volume: finite, l < r, b < t, 0 > n > f, and not too extreme for the matrices.
    ///
    /// # Errors
    /// [`DegenerateVolume`] names the first thing that is wrong.
    pub fn validate(&self) -> Result<(), DegenerateVolume> {
        let Self { left, right, bottom, top, near, far } = *self;
        let named = [
            ("near", near),
            ("far", far),
            ("left", left),
            ("right", right),
            ("bottom", bottom),
            ("top", top),
        ];
        for (name, value) in named {
            if !value.is_finite() {
                return Err(DegenerateVolume::NotFinite { name, value });
            }
        }
        for (name, value) in [("near", near), ("far", far)] {
            if value >= 0.0 {
                return Err(DegenerateVolume::NotBeforeTheEye { name, value });
            }
        }
        if left >= right {
            return Err(DegenerateVolume::NoWidth { left, right });
        }
        if bottom >= top {
            return Err(DegenerateVolume::NoHeight { bottom, top });
        }
        if far >= near {
            return Err(DegenerateVolume::NoDepth { near, far });
        }
        if !self.has_usable_matrix() {
            return Err(DegenerateVolume::TooExtreme(*self));
        }
        Ok(())
    }

    /// The window's width over its height.
    #[must_use]
    pub fn aspect(&self) -> f32 {
        (self.right - self.left) / (self.top - self.bottom)
    }

    /// Whether the matrices carry two opposite corners to (1, 1, 1) and (−1, −1, −1), to within [`CORNER_TOLERANCE`].
    ///
    /// f·n or 2/(r − l) can leave the range of f32, and r − l or n − f can be lost in the rounding of their own terms.
    fn has_usable_matrix(&self) -> bool {
        let Self { left, right, bottom, top, near, far } = *self;
        let m =
            projection::scale(self) * projection::center(self) * projection::perspective_unchecked(near, far);
        let spread = far / near;
        let corners = [(vec3(right, top, near), 1.0), (vec3(left * spread, bottom * spread, far), -1.0)];
        m.is_finite()
            && corners.iter().all(|(corner, want)| {
                let clip = m * corner.extend(1.0);
                (clip.truncate() / clip.w).abs_diff_eq(Vec3::splat(*want), CORNER_TOLERANCE)
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const VOLUME: ViewVolume =
        ViewVolume { left: -1.0, right: 3.0, bottom: -2.0, top: 1.0, near: -1.5, far: -40.0 };

    #[test]
    fn each_degenerate_number_is_named() {
        use DegenerateVolume::*;
        let errors = [
            (ViewVolume { right: -1.0, ..VOLUME }, NoWidth { left: -1.0, right: -1.0 }),
            (ViewVolume { top: -3.0, ..VOLUME }, NoHeight { bottom: -2.0, top: -3.0 }),
            (ViewVolume { far: -1.5, ..VOLUME }, NoDepth { near: -1.5, far: -1.5 }),
            (ViewVolume { near: 1.5, ..VOLUME }, NotBeforeTheEye { name: "near", value: 1.5 }),
            (ViewVolume { far: 0.0, ..VOLUME }, NotBeforeTheEye { name: "far", value: 0.0 }),
        ];
        for (volume, error) in errors {
            assert_eq!(volume.validate(), Err(error));
        }
        let nan = ViewVolume { bottom: f32::NAN, ..VOLUME };
        assert!(matches!(nan.validate(), Err(NotFinite { name: "bottom", .. })));
        assert_eq!(VOLUME.validate(), Ok(()));
    }

    #[test]
    fn volumes_that_32_bits_cannot_hold_are_refused() {
        let far_away = ViewVolume { near: -1e30, far: -1e31, ..VOLUME };
        let too_thin = ViewVolume { near: -1.0, far: -1.000_000_1, ..VOLUME };
        let too_far_aside = ViewVolume { left: 1e7, right: 1e7 + 1.0, ..VOLUME };
        let too_near = ViewVolume { near: -1e-44, ..VOLUME };
        for volume in [far_away, too_thin, too_far_aside, too_near] {
            assert!(matches!(volume.validate(), Err(DegenerateVolume::TooExtreme(_))), "{volume}");
        }
    }

    #[test]
    fn fields_of_view_outside_zero_to_pi_are_refused() {
        for fov_y in [0.0, -1.0, std::f32::consts::PI, 3.2, f32::NAN] {
            let error = ViewVolume::from_fov_y(fov_y, 1.0, -1.0, -10.0);
            assert!(matches!(error, Err(DegenerateVolume::FieldOfView(_))), "{fov_y}: {error:?}");
        }
    }

    #[test]
    fn aspect_ratios_that_are_not_positive_and_finite_are_refused_as_such() {
        for aspect in [0.0, -1.5, f32::INFINITY, f32::NEG_INFINITY, f32::NAN] {
            let error = ViewVolume::from_fov_y(1.0, aspect, -1.0, -10.0);
            assert!(matches!(error, Err(DegenerateVolume::AspectRatio(_))), "{aspect}: {error:?}");
        }
    }

    #[test]
    fn the_aspect_ratio_is_width_over_height() {
        // 4 wide and 3 high; then 5 wide and 2 high, off to one side.
        assert_eq!(VOLUME.aspect(), 4.0 / 3.0);
        assert_eq!(ViewVolume { left: 2.0, right: 7.0, bottom: 3.0, top: 5.0, ..VOLUME }.aspect(), 2.5);
    }
}
