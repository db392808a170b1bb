//! Which shapes come ready-made? Spheres, box, torus, disc and teapot, as fine as you like.
//!
//! All of them lie around the origin with y up, carry the exact normals of the surface they approximate and texture
//! coordinates, and take a `level`: each level more cuts every edge in two, so there are about four times as many
//! triangles, and the distance to the true surface is about a quarter (L39 measures that).
//!
//! | shape | size | triangles | closed |
//! |---|---|---|---|
//! | [`uv_sphere`] | radius 1 | 4m(4m − 2), m = 2^level | yes |
//! | [`icosphere`] | radius 1 | 20m² | yes |
//! | [`cuboid`] | as asked | 12m² | yes |
//! | [`torus`] | as asked | 64m² | yes |
//! | [`disc`] | as asked | 6m(2m − 1) | no |
//! | [`teapot`] | 3.15 high, foot on y = 0 | 256m² − 16m | no |
//!
//! Triangles that meet share their positions by index, seams of the texture and hard edges included: those are seams in
//! the other attributes only. So a closed shape is watertight: each edge is used once in either direction.
//!
//! Read [`uv_sphere`] first; [`bezier`] is what the teapot is made of.

pub mod bezier;
mod cuboid;
mod disc;
mod icosphere;
mod surface;
mod teapot;
mod teapot_patches;
mod torus;
mod uv_sphere;

pub use cuboid::cuboid;
pub use disc::disc;
pub use icosphere::icosphere;
pub use teapot::teapot;
pub use torus::torus;
pub use uv_sphere::uv_sphere;

/// The greatest subdivision level that a shape accepts; with it, the largest shape has four million triangles.
pub const GREATEST_LEVEL: u32 = 7;

/// Why a shape cannot be made.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ShapeError {
    /// A level beyond [`GREATEST_LEVEL`].
    #[error("{shape}: level {level} is too fine; the greatest is {GREATEST_LEVEL}")]
    LevelTooGreat {
        /// The shape that was asked for.
        shape: &'static str,
        /// The level that was asked for.
        level: u32,
    },
    /// A size that makes no surface.
    #[error("{shape}: {what} must be {must_be}, but is {value}")]
    BadSize {
        /// The shape that was asked for.
        shape: &'static str,
        /// Which size.
        what: &'static str,
        /// What is allowed.
        must_be: &'static str,
        /// The value that was asked for.
        value: f32,
    },
}

/// 2^level: how many pieces an edge of the coarsest shape is cut into.
fn pieces(shape: &'static str, level: u32) -> Result<u32, ShapeError> {
    if level > GREATEST_LEVEL {
        return Err(ShapeError::LevelTooGreat { shape, level });
    }
    Ok(1 << level)
}

/// `value`, if it is a length that a surface can have.
fn positive(shape: &'static str, what: &'static str, value: f32) -> Result<f32, ShapeError> {
    // Above half the range of f32 a diameter would overflow.
    if 0.0 < value && value <= 0.5 * f32::MAX {
        Ok(value)
    } else {
        Err(ShapeError::BadSize { shape, what, must_be: "finite and greater than 0", value })
    }
}

#[cfg(test)]
mod tests {
    use glam::vec3;

    use super::*;

    #[test]
    fn level_beyond_the_greatest_is_an_error_that_names_it() {
        let error = icosphere(20).unwrap_err();
        assert_eq!(error, ShapeError::LevelTooGreat { shape: "icosphere", level: 20 });
        assert_eq!(error.to_string(), "icosphere: level 20 is too fine; the greatest is 7");
        assert!(uv_sphere(8).is_err() && torus(2.0, 0.5, 8).is_err() && disc(1.5, 8).is_err());
        assert!(cuboid(vec3(1.0, 2.0, 3.0), 8).is_err() && teapot(u32::MAX).is_err());
    }

    #[test]
    fn triangle_counts_are_those_of_the_table() {
        for level in 0..4 {
            let m = 1_usize << level;
            assert_eq!(uv_sphere(level).unwrap().len(), 4 * m * (4 * m - 2));
            assert_eq!(icosphere(level).unwrap().len(), 20 * m * m);
            assert_eq!(cuboid(vec3(1.0, 2.0, 3.0), level).unwrap().len(), 12 * m * m);
            assert_eq!(torus(2.0, 0.5, level).unwrap().len(), 64 * m * m);
            assert_eq!(disc(1.5, level).unwrap().len(), 6 * m * (2 * m - 1));
            assert_eq!(teapot(level).unwrap().len(), 256 * m * m - 16 * m);
        }
    }

    #[test]
    fn sizes_that_make_no_surface_are_errors() {
        for bad in [0.0, -1.0, f32::NAN, f32::INFINITY, f32::MAX] {
            assert!(disc(bad, 1).is_err(), "{bad}");
            assert!(cuboid(vec3(1.0, bad, 3.0), 1).is_err(), "{bad}");
            assert!(torus(bad, 0.5, 1).is_err() && torus(2.0, bad, 1).is_err(), "{bad}");
        }
        let error = torus(0.5, 2.0, 1).unwrap_err();
        assert_eq!(error.to_string(), "torus: minor must be less than major, but is 2");
    }
}
