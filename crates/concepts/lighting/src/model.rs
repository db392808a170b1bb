//! What colour has the surface, all light taken together? The Phong and the Blinn–Phong lighting model (L32, L34).
//!
//! Both are empirical and local: no law of nature, and no other surface takes part (L35). They can reflect more than they
//! receive: 0.8·(0.2 + 1) + 1 = 1.96 of a light of 1 (E8). Clamping happens once, at output.

use glam::Vec3;

use crate::{Highlight, Illumination, Light, Material, Rgb, lambert, light};

/// One light by Phong's lighting model: c_r c_l max(0, n·l) + c_l max(0, e·r)^p (L32, without the ambient term).
///
/// - `n`, `to_eye` and the light's `to_light`: unit vectors in one common space.
/// - Result: linear RGB, not clamped; zero where the light is behind the surface (E3).
///
/// ```
/// use glam::{Vec3, vec3};
/// use lighting::{Illumination, Material, phong};
///
/// let light = Illumination { to_light: vec3(0.6, 0.0, 0.8), distance: f32::INFINITY, color: Vec3::ONE };
/// let c = phong(&Material::new(vec3(0.5, 0.25, 0.0), 8.0), Vec3::Z, vec3(-0.6, 0.0, 0.8), &light);
/// assert!(c.abs_diff_eq(vec3(1.4, 1.2, 1.0), 1e-6)); // brighter than white: the model is empirical (L35)
/// ```
#[must_use]
pub fn phong(material: &Material, n: Vec3, to_eye: Vec3, light: &Illumination) -> Rgb {
    reflected(material, n, to_eye, light, Highlight::Phong)
}

/// One light by the Blinn–Phong lighting model: c_r c_l max(0, n·l) + c_l max(0, h·n)^p (L34, without the ambient term).
///
/// Arguments and result as for [`phong`]; for a highlight as wide the exponent must be about four times as large (E4).
#[must_use]
pub fn blinn_phong(material: &Material, n: Vec3, to_eye: Vec3, light: &Illumination) -> Rgb {
    reflected(material, n, to_eye, light, Highlight::Blinn)
}

/// All lights together: c_r c_a + Σ (c_r c_l max(0, n·l) + c_l highlight^p), over the lights that reach the point.
///
/// Ambient light multiplies the diffuse colour (L28).
///
/// - `p_world`: the point. `n`, `to_eye`: unit vectors, world space.
/// - `reaches`: whether a light arrives unhindered; a ray tracer asks a shadow ray (L56), a rasterizer says yes.
#[must_use]
pub fn lit(
    material: &Material,
    lights: &[Light],
    highlight: Highlight,
    at: &SurfacePoint,
    reaches: impl Fn(&Illumination) -> bool,
) -> Rgb {
    let ambient = material.diffuse * light::ambient(lights);
    let from_lights = lights
        .iter()
        .filter_map(|light| light.illumination(at.p_world))
        .filter(|light| lambert(at.n, light.to_light) > 0.0 && reaches(light))
        .map(|light| reflected(material, at.n, at.to_eye, &light, highlight));
    from_lights.fold(ambient, |sum, color| sum + color)
}

/// A point of a surface as a lighting model sees it (L22).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// The point, world space.
    pub p_world: Vec3,
    /// n: the unit normal on the side of the eye, world space. On the other side it is a surface seen from behind, lit as
    /// its front would be.
    pub n: Vec3,
    /// e: the unit direction towards the eye, world space.
    pub to_eye: Vec3,
}

fn reflected(material: &Material, n: Vec3, to_eye: Vec3, light: &Illumination, highlight: Highlight) -> Rgb {
    let diffuse = material.diffuse * lambert(n, light.to_light);
    let specular = material.specular * highlight.at(n, light.to_light, to_eye, material.exponent);
    light.color * (diffuse + specular)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lectures_own_numbers_leave_the_range_that_a_slide_promises() {
        // E8: c_r = 0.8, c_a = 0.2, c_l = 1, everything head-on: 0.8·(0.2 + 1) + 1 = 1.96, not between 0 and 1.
        let lights = [
            Light::Ambient { color: Rgb::splat(0.2) },
            Light::Directional { to_light: Vec3::Z, color: Rgb::ONE },
        ];
        let at = SurfacePoint { p_world: Vec3::ZERO, n: Vec3::Z, to_eye: Vec3::Z };
        let c = lit(&Material::new(Rgb::splat(0.8), 32.0), &lights, Highlight::Phong, &at, |_| true);
        assert!((c.x - 1.96).abs() < 1e-6, "{c}");
    }

    #[test]
    fn a_light_that_does_not_reach_the_point_leaves_only_the_ambient_part() {
        let lights = [
            Light::Ambient { color: Rgb::new(0.1, 0.2, 0.3) },
            Light::Point { position: Vec3::new(0.0, 0.0, 5.0), color: Rgb::ONE },
        ];
        let at = SurfacePoint { p_world: Vec3::ZERO, n: Vec3::Z, to_eye: Vec3::Z };
        let c = lit(&Material::new(Rgb::splat(0.5), 32.0), &lights, Highlight::Blinn, &at, |_| false);
        assert_eq!(c, Rgb::new(0.05, 0.1, 0.15));
    }
}
