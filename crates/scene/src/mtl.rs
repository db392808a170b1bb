//! What does a material of an MTL file look like here?

use geometry::obj::ObjMaterial;
use lighting::{Material, Rgb};
use raytrace::{Optics, Surface};

use crate::limits::{GREATEST_EXPONENT, GREATEST_REFRACTIVE_INDEX};

/// The surface of an MTL material; what the file does not say is as in [`Material::default`].
///
/// | MTL | here |
/// |---|---|
/// | `Kd` | diffuse, at most 1 |
/// | `Ks` | specular, at most 1; 0 for `illum` 0 and 1, which have no highlight |
/// | `Ns` | exponent of the halfway form (L34) |
/// | `illum` 3, 5, 8 | mirror that reflects `Ks` |
/// | `illum` 4, 6, 7, 9, or `d` < 1 | glass of index `Ni` that lets 1 − `d` through (all of it for d = 1) |
/// | `Ka` | left out: ambient light multiplies the diffuse colour (L28) |
pub(crate) fn surface_of(mtl: &ObjMaterial) -> Surface {
    let default = Material::default();
    let has_highlight = !matches!(mtl.illumination_model, Some(0 | 1));
    let specular = if has_highlight { mtl.specular.unwrap_or(default.specular) } else { Rgb::ZERO };
    let material = Material {
        diffuse: share(mtl.diffuse.unwrap_or(default.diffuse)),
        specular: share(specular),
        exponent: mtl.exponent.unwrap_or(default.exponent).clamp(0.0, GREATEST_EXPONENT),
    };
    Surface { material, optics: optics_of(mtl) }
}

fn optics_of(mtl: &ObjMaterial) -> Optics {
    let dissolve = mtl.dissolve.unwrap_or(1.0);
    match mtl.illumination_model {
        Some(3 | 5 | 8) => Optics::Mirror { reflectance: share(mtl.specular.unwrap_or(Rgb::ONE)) },
        Some(4 | 6 | 7 | 9) => glass(mtl, if dissolve < 1.0 { 1.0 - dissolve } else { 1.0 }),
        _ if dissolve < 1.0 => glass(mtl, 1.0 - dissolve),
        _ => Optics::Opaque,
    }
}

fn glass(mtl: &ObjMaterial, through: f32) -> Optics {
    Optics::Glass {
        refractive_index: mtl.refractive_index.unwrap_or(1.0).clamp(1.0, GREATEST_REFRACTIVE_INDEX),
        transmittance: Rgb::splat(through.clamp(0.0, 1.0)),
    }
}

/// A share of light, 0 to 1 (L24); files know colours beyond.
fn share(color: Rgb) -> Rgb {
    color.clamp(Rgb::ZERO, Rgb::ONE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::vec3;

    #[test]
    fn each_line_of_the_table_holds() {
        let red = ObjMaterial {
            diffuse: Some(vec3(0.7, 0.1, 0.05)),
            specular: Some(vec3(0.2, 0.3, 4.0)),
            exponent: Some(25.0),
            ..ObjMaterial::default()
        };
        let surface = surface_of(&red);
        assert_eq!(surface.material.diffuse, vec3(0.7, 0.1, 0.05));
        assert_eq!(surface.material.specular, vec3(0.2, 0.3, 1.0));
        assert_eq!((surface.material.exponent, surface.optics), (25.0, Optics::Opaque));

        let matt = ObjMaterial { illumination_model: Some(1), ..red.clone() };
        assert_eq!(surface_of(&matt).material.specular, Rgb::ZERO);
        let mirror = ObjMaterial { illumination_model: Some(3), ..red.clone() };
        assert_eq!(surface_of(&mirror).optics, Optics::Mirror { reflectance: vec3(0.2, 0.3, 1.0) });
        for (model, is_mirror) in (0..=10).map(|model| (model, matches!(model, 3 | 5 | 8))) {
            let optics = surface_of(&ObjMaterial { illumination_model: Some(model), ..red.clone() }).optics;
            assert_eq!(matches!(optics, Optics::Mirror { .. }), is_mirror, "illum {model}");
            assert_eq!(
                matches!(optics, Optics::Glass { .. }),
                matches!(model, 4 | 6 | 7 | 9),
                "illum {model}"
            );
        }
        // Without a word about its index, glass bends nothing.
        let thin = surface_of(&ObjMaterial { dissolve: Some(0.5), ..red.clone() }).optics;
        assert_eq!(thin, Optics::Glass { refractive_index: 1.0, transmittance: Rgb::splat(0.5) });
        let pane = ObjMaterial { dissolve: Some(0.25), refractive_index: Some(1.33), ..red };
        let through = Optics::Glass { refractive_index: 1.33, transmittance: Rgb::splat(0.75) };
        assert_eq!(surface_of(&pane).optics, through);
    }

    #[test]
    fn a_material_without_a_word_is_the_default() {
        assert_eq!(surface_of(&ObjMaterial::default()), Surface::default());
    }
}
