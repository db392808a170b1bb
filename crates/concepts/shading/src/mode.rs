//! How often is a surface asked for its colour: once a polygon, once a vertex, or once a pixel?
//!
//! | shading | the lighting model is evaluated | between | slide |
//! |---|---|---|---|
//! | flat | once a triangle, with its own normal | the same colour everywhere | L37 |
//! | Gouraud | at the three corners, with the vertex normals | *colours* are interpolated | L38 |
//! | Phong | in every pixel | *normals* are interpolated | L40 |
//!
//! **Phong shading is not the Phong lighting model** (L42): the model says how bright a point with a given normal is
//! ([`lighting::phong`]), the shading where normals between the vertices come from. Each goes with any of the other:
//! Phong shading with the Blinn–Phong model is what most pictures here show.

use canvas::Rgb;
use geometry::Barycentric;
use glam::Vec3;
use lighting::SurfacePoint;

use crate::{Facet, Lighting};

/// Where in a triangle the lighting model is evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Shading {
    /// One normal and one colour a triangle (L37).
    Flat,
    /// Colours at the corners, interpolated (L38).
    Gouraud,
    /// Normals at the corners, interpolated; a colour for each pixel (L40).
    #[default]
    Phong,
}

/// The colour of the whole triangle: the lighting model at its centroid, with its own normal (L37).
#[must_use]
pub fn flat_color(facet: &Facet, lighting: &Lighting) -> Rgb {
    lighting.color(&facet.material, centroid(facet), facet.face_normal)
}

fn centroid(facet: &Facet) -> Vec3 {
    let third = 1.0 / 3.0;
    facet.corners.a * third + facet.corners.b * third + facet.corners.c * third
}

/// c₀, c₁, c₂: the colours at the three corners, with the vertex normals (L38).
///
/// Between them [`Barycentric::interpolate`] gives αc₀ + βc₁ + γc₂, affine in the colours. A highlight that lies between
/// the corners is lost (L41).
#[must_use]
pub fn gouraud_colors(facet: &Facet, lighting: &Lighting) -> [Rgb; 3] {
    let corners = facet.corners.corners();
    std::array::from_fn(|k| lighting.color(&facet.material, corners[k], facet.corner_normals[k]))
}

/// The normal between the corners: αn₀ + βn₁ + γn₂, **brought back to unit length** (L40).
///
/// The slide leaves out the last step (E7). But the mean of two unit vectors is shorter than either: normals ±45° from the
/// middle meet at length 0.707, and 0.707³² = 1.5 · 10⁻⁵ of a highlight with exponent 32 is left.
///
/// `None` where the three cancel out.
///
/// ```
/// use geometry::Barycentric;
/// use glam::{Vec3, vec3};
/// use shading::mode::phong_normal;
///
/// let halfway = Barycentric { alpha: 0.5, beta: 0.5, gamma: 0.0 };
/// let n = phong_normal([vec3(0.6, 0.0, 0.8), vec3(-0.6, 0.0, 0.8), Vec3::Y], halfway);
/// assert_eq!(n, Some(Vec3::Z)); // without the last step: (0, 0, 0.8)
/// ```
#[must_use]
pub fn phong_normal([n0, n1, n2]: [Vec3; 3], weights: Barycentric) -> Option<Vec3> {
    let sum = weights.interpolate(n0, n1, n2);
    // Three unit vectors with weights up to 1: what is shorter than a few roundings has no direction.
    (sum.length() > 4.0 * f32::EPSILON).then(|| sum.normalize())
}

/// The colour of one pixel: the lighting model with the interpolated normal (L40).
#[must_use]
pub fn phong_color(facet: &Facet, lighting: &Lighting, weights: Barycentric) -> Rgb {
    lighting.color(&facet.material, facet.corners.point(weights), interpolated_normal(facet, weights))
}

fn interpolated_normal(facet: &Facet, weights: Barycentric) -> Vec3 {
    phong_normal(facet.corner_normals, weights).unwrap_or(facet.face_normal)
}

/// A triangle made ready for its pixels: what is computed once a triangle is computed.
#[derive(Clone, Copy, Debug)]
pub struct Surface<'a> {
    facet: Facet,
    lighting: Lighting<'a>,
    colors: Colors,
}

#[derive(Clone, Copy, Debug)]
enum Colors {
    Flat(Rgb),
    Gouraud([Rgb; 3]),
    Phong,
}

impl<'a> Surface<'a> {
    /// Computes what `shading` computes once a triangle.
    #[must_use]
    pub fn new(shading: Shading, facet: Facet, lighting: Lighting<'a>) -> Self {
        let colors = match shading {
            Shading::Flat => Colors::Flat(flat_color(&facet, &lighting)),
            Shading::Gouraud => Colors::Gouraud(gouraud_colors(&facet, &lighting)),
            Shading::Phong => Colors::Phong,
        };
        Self { facet, lighting, colors }
    }

    /// The colour where the triangle's barycentric coordinates are `weights`, linear RGB, not clamped.
    #[must_use]
    pub fn color(&self, weights: Barycentric) -> Rgb {
        match self.colors {
            Colors::Flat(color) => color,
            Colors::Gouraud([c0, c1, c2]) => weights.interpolate(c0, c1, c2),
            Colors::Phong => phong_color(&self.facet, &self.lighting, weights),
        }
    }

    /// Where the lighting model was evaluated for that colour, and by how much each evaluation counts: the centroid for flat
    /// shading, the three corners for Gouraud's, the point itself for Phong's.
    #[must_use]
    pub fn lighting_points(&self, weights: Barycentric) -> Vec<(SurfacePoint, f32)> {
        let Self { facet, lighting, .. } = self;
        match self.colors {
            Colors::Flat(_) => vec![(lighting.surface_point(centroid(facet), facet.face_normal), 1.0)],
            Colors::Gouraud(_) => {
                let corners = facet.corners.corners().into_iter().zip(facet.corner_normals);
                let points = corners.map(|(corner, n)| lighting.surface_point(corner, n));
                points.zip(weights.to_vec3().to_array()).collect()
            }
            Colors::Phong => {
                let (p_world, n) = (facet.corners.point(weights), interpolated_normal(facet, weights));
                vec![(lighting.surface_point(p_world, n), 1.0)]
            }
        }
    }

    /// The unit normal there, on the side of the eye: that of the triangle for flat shading, the interpolated one otherwise
    /// (Gouraud shading itself uses it at the corners only).
    #[must_use]
    pub fn normal(&self, weights: Barycentric) -> Vec3 {
        match self.colors {
            Colors::Flat(_) => self.facet.face_normal,
            Colors::Gouraud(_) | Colors::Phong => interpolated_normal(&self.facet, weights),
        }
    }
}

#[cfg(test)]
mod tests {
    use geometry::Triangle;
    use glam::vec3;
    use lighting::{Highlight, Light, Material};

    use super::*;

    const MIDDLE: Barycentric = Barycentric { alpha: 0.5, beta: 0.5, gamma: 0.0 };

    #[test]
    fn without_the_last_step_a_highlight_between_the_corners_goes_out() {
        // E7: normals ±45° from the middle, the light and the eye straight above it, exponent 32.
        let (n0, n1) = (vec3(-1.0, 0.0, 1.0).normalize(), vec3(1.0, 0.0, 1.0).normalize());
        let slide = MIDDLE.interpolate(n0, n1, Vec3::Z);
        assert!((slide.length() - 0.707).abs() < 5e-4);
        let highlight = |n: Vec3| lighting::blinn_highlight(n, Vec3::Z, Vec3::Z, 32.0);
        assert!((highlight(slide) - 1.5e-5).abs() < 5e-7, "{}", highlight(slide));
        let ours = phong_normal([n0, n1, Vec3::Z], MIDDLE).unwrap();
        assert!(highlight(ours) > 0.999_99);
    }

    #[test]
    fn opposite_normals_leave_the_one_of_the_face() {
        assert_eq!(phong_normal([Vec3::X, Vec3::NEG_X, Vec3::Y], MIDDLE), None);
        let facet = Facet {
            corners: Triangle::new(Vec3::ZERO, vec3(2.0, 0.0, 0.0), vec3(0.0, 3.0, 0.0)),
            face_normal: Vec3::Z,
            corner_normals: [Vec3::X, Vec3::NEG_X, Vec3::Y],
            material: Material::default(),
        };
        let lighting = Lighting { lights: &[], highlight: Highlight::Blinn, eye: vec3(1.0, 2.0, 5.0) };
        assert_eq!(Surface::new(Shading::Phong, facet, lighting).normal(MIDDLE), Vec3::Z);
    }

    #[test]
    fn flat_shading_asks_at_the_centroid() {
        // A lamp over the centroid (1, 1, 0), 4 high: n·l = 1 there and less elsewhere.
        let lights = [Light::Point { position: vec3(1.0, 1.0, 4.0), color: Rgb::ONE }];
        let facet = Facet {
            corners: Triangle::new(Vec3::ZERO, vec3(3.0, 0.0, 0.0), vec3(0.0, 3.0, 0.0)),
            face_normal: Vec3::Z,
            corner_normals: [Vec3::Z; 3],
            material: Material::matt(vec3(0.5, 0.25, 1.0)),
        };
        let lighting = Lighting { lights: &lights, highlight: Highlight::Blinn, eye: vec3(1.0, 2.0, 5.0) };
        assert!(flat_color(&facet, &lighting).abs_diff_eq(vec3(0.5, 0.25, 1.0), 1e-6));
        // At the corner (0, 0, 0): cos = 4/√18.
        let at_corner = gouraud_colors(&facet, &lighting)[0];
        assert!(at_corner.abs_diff_eq(vec3(0.5, 0.25, 1.0) * 4.0 / 18.0_f32.sqrt(), 1e-6));
    }

    #[test]
    fn gouraud_shading_asks_at_the_corners_with_the_vertex_normals() {
        let lights = [Light::Directional { to_light: Vec3::Z, color: vec3(1.0, 0.5, 2.0) }];
        let facet = Facet {
            corners: Triangle::new(Vec3::ZERO, vec3(3.0, 0.0, 0.0), vec3(0.0, 3.0, 0.0)),
            face_normal: Vec3::Z,
            corner_normals: [Vec3::Z, vec3(0.6, 0.0, 0.8), vec3(0.0, 0.8, 0.6)],
            material: Material::matt(vec3(0.5, 1.0, 0.25)),
        };
        let lighting = Lighting { lights: &lights, highlight: Highlight::Blinn, eye: vec3(1.0, 2.0, 5.0) };
        let full = vec3(0.5, 0.5, 0.5);
        assert_eq!(gouraud_colors(&facet, &lighting), [full, 0.8 * full, 0.6 * full]);
        let surface = Surface::new(Shading::Gouraud, facet, lighting);
        assert!(surface.color(MIDDLE).abs_diff_eq(0.9 * full, 1e-6));
    }

    #[test]
    fn the_model_evaluated_at_the_lighting_points_gives_the_color() {
        let lights = [Light::Point { position: vec3(1.0, 2.0, 4.0), color: vec3(1.0, 0.5, 2.0) }];
        let facet = Facet {
            corners: Triangle::new(Vec3::ZERO, vec3(3.0, 0.0, 0.0), vec3(0.0, 3.0, 0.0)),
            face_normal: Vec3::Z,
            corner_normals: [Vec3::Z, vec3(0.6, 0.0, 0.8), vec3(0.0, 0.8, 0.6)],
            material: Material::new(vec3(0.5, 1.0, 0.25), 8.0),
        };
        let lighting = Lighting { lights: &lights, highlight: Highlight::Blinn, eye: vec3(1.0, 2.0, 5.0) };
        let weights = Barycentric { alpha: 0.5, beta: 0.25, gamma: 0.25 };
        for (shading, count) in [(Shading::Flat, 1), (Shading::Gouraud, 3), (Shading::Phong, 1)] {
            let surface = Surface::new(shading, facet, lighting);
            let points = surface.lighting_points(weights);
            assert_eq!(points.len(), count);
            let color = |at: &SurfacePoint| lighting.color(&facet.material, at.p_world, at.n);
            let sum = points.iter().fold(Rgb::ZERO, |sum, (at, weight)| sum + color(at) * *weight);
            assert_eq!(sum, surface.color(weights), "{shading:?}");
        }
    }
}
