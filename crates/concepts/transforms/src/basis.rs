//! Which way are right, up and backwards? An orthonormal basis says (L6), and a matrix carries one to another (L11).

use glam::{Mat3, Vec3};

/// A right-handed orthonormal basis: `u` × `v` = `w`, all of unit length.
///
/// For a camera (Fig 4.8): u points right, v up, w backwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Basis {
    /// u, to the right.
    pub u: Vec3,
    /// v, upwards.
    pub v: Vec3,
    /// w, against the gaze.
    pub w: Vec3,
}

/// Why two directions span no camera frame.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum DegenerateBasis {
    /// The gaze is the zero vector: the target is the eye.
    #[error("the gaze direction is zero: the camera must look at a point other than its own position")]
    ZeroGaze,
    /// The up vector is zero.
    #[error("the up vector is zero")]
    ZeroUp,
    /// Up and gaze lie on one line, so that nothing says which way is right.
    #[error("up {up} is parallel to the gaze {gaze}: choose an up vector that leaves the line of sight")]
    UpParallelToGaze {
        /// The gaze as it was given.
        gaze: Vec3,
        /// The up vector as it was given.
        up: Vec3,
    },
    /// A NaN or an infinity.
    #[error("{name} is {value}: not a finite direction")]
    NotFinite {
        /// Which vector.
        name: &'static str,
        /// Its value.
        value: Vec3,
    },
}

/// Below this sine of their angle, up and gaze count as parallel: the cross product of two rounded unit vectors is wrong
/// by about one `f32::EPSILON`, so at this sine u is still good to about a thousandth.
const PARALLEL_SINE: f64 = 1024.0 * f32::EPSILON as f64;

impl Basis {
    /// The camera frame of Fig 4.8 (L6): w = −gaze/‖gaze‖, u = up×w/‖up×w‖, v = w×u.
    ///
    /// - `gaze`: where the camera looks; `up`: roughly upwards. Both in world space, any length but zero.
    ///
    /// # Errors
    /// [`DegenerateBasis`] if a vector is zero or not finite, or if they are parallel.
    ///
    /// ```
    /// use glam::{Vec3, vec3};
    /// use transforms::Basis;
    ///
    /// let basis = Basis::from_gaze_and_up(vec3(0.0, 0.0, -4.0), vec3(0.0, 2.0, 1.0))?;
    /// assert_eq!((basis.u, basis.v, basis.w), (Vec3::X, Vec3::Y, Vec3::Z));
    /// # Ok::<(), transforms::DegenerateBasis>(())
    /// ```
    pub fn from_gaze_and_up(gaze: Vec3, up: Vec3) -> Result<Self, DegenerateBasis> {
        for (name, value) in [("gaze", gaze), ("up", up)] {
            if !value.is_finite() {
                return Err(DegenerateBasis::NotFinite { name, value });
            }
        }
        // In f64, so that directions of 1e-30 or 1e30 lose nothing in their squared lengths.
        let w = (-gaze.as_dvec3()).try_normalize().ok_or(DegenerateBasis::ZeroGaze)?;
        let up_unit = up.as_dvec3().try_normalize().ok_or(DegenerateBasis::ZeroUp)?;
        let right = up_unit.cross(w);
        if right.length() < PARALLEL_SINE {
            return Err(DegenerateBasis::UpParallelToGaze { gaze, up });
        }
        let u = right.normalize();
        let v = w.cross(u);
        Ok(Self { u: u.as_vec3(), v: v.as_vec3(), w: w.as_vec3() })
    }

    /// R_uvw, the matrix with rows u, v, w: it carries u, v, w to x, y, z (L11). Its transpose is its inverse.
    #[must_use]
    pub fn rows(&self) -> Mat3 {
        Mat3::from_cols(self.u, self.v, self.w).transpose()
    }
}

/// M = R_abcᵀ · R_uvw: the rotation that carries u, v, w of `from` to those of `to` (L11, exercise 6.10).
///
/// The slide asks for 4×4 and answers 3×3 (E15); 3×3 is enough, since a rotation moves no origin. Two bases of opposite
/// handedness give a matrix with determinant −1, which is no rotation (E15).
///
/// ```
/// use glam::Vec3;
/// use transforms::{Basis, change_of_basis};
///
/// let from = Basis { u: Vec3::X, v: Vec3::Y, w: Vec3::Z };
/// let to = Basis { u: Vec3::Y, v: Vec3::Z, w: Vec3::X };
/// let m = change_of_basis(&from, &to);
/// assert_eq!((m * from.u, m * from.v, m * from.w), (to.u, to.v, to.w));
/// ```
#[must_use]
pub fn change_of_basis(from: &Basis, to: &Basis) -> Mat3 {
    to.rows().transpose() * from.rows()
}

/// M⁻¹ = R_uvwᵀ · R_abc: undoes [`change_of_basis`] with the same arguments (L12, exercise 6.11).
#[must_use]
pub fn change_of_basis_inverse(from: &Basis, to: &Basis) -> Mat3 {
    from.rows().transpose() * to.rows()
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::vec3;

    #[test]
    fn up_along_the_gaze_is_an_error_that_names_both() {
        let (gaze, up) = (vec3(1.0, 2.0, 3.0), vec3(-2.0, -4.0, -6.0));
        assert_eq!(Basis::from_gaze_and_up(gaze, up), Err(DegenerateBasis::UpParallelToGaze { gaze, up }));
    }

    #[test]
    fn zero_and_nan_directions_are_errors_that_name_the_vector() {
        assert_eq!(Basis::from_gaze_and_up(Vec3::ZERO, Vec3::Y), Err(DegenerateBasis::ZeroGaze));
        assert_eq!(Basis::from_gaze_and_up(Vec3::X, Vec3::ZERO), Err(DegenerateBasis::ZeroUp));
        let broken = Basis::from_gaze_and_up(Vec3::X, vec3(0.0, f32::NAN, 0.0));
        assert!(matches!(broken, Err(DegenerateBasis::NotFinite { name: "up", .. })), "{broken:?}");
    }

    #[test]
    fn tiny_and_huge_directions_are_as_good_as_unit_ones() {
        let usual = Basis::from_gaze_and_up(vec3(1.0, 2.0, -3.0), vec3(0.5, 4.0, 1.0)).unwrap();
        let extreme =
            Basis::from_gaze_and_up(1e-30 * vec3(1.0, 2.0, -3.0), 1e30 * vec3(0.5, 4.0, 1.0)).unwrap();
        assert!(usual.u.abs_diff_eq(extreme.u, 1e-6) && usual.v.abs_diff_eq(extreme.v, 1e-6));
    }

    #[test]
    fn bases_of_opposite_handedness_give_a_mirror_not_a_rotation() {
        // E15: the slide does not ask for equal handedness.
        let right = Basis { u: Vec3::X, v: Vec3::Y, w: Vec3::Z };
        let left = Basis { u: Vec3::X, v: Vec3::Y, w: Vec3::NEG_Z };
        assert_eq!(change_of_basis(&right, &left).determinant(), -1.0);
    }
}
