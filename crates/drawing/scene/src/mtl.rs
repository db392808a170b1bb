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
/// | `Ns` | exponent of the halfway form (L34), at most [`GREATEST_EXPONENT`] |
/// | `illum` 3, 5, 8 with `d` = 1 | mirror that reflects `Ks` |
/// | `illum` 4, 6, 7, 9 | glass of index `Ni`; with `d` < 1 it shows `d` of its own light and lets 1 − `d` through, without all of both |
/// | `d` < 1 with any other `illum` | half transparent, `d` · own + (1 − `d`) · what lies straight behind; 0 is invisible, `Ni` bends nothing |
/// | `Ka` | left out: ambient light multiplies the diffuse color (L28) |
pub(crate) fn surface_of(mtl: &ObjMaterial) -> Surface {
    let (material, optics) = (material_of(mtl), optics_of(mtl));
    let own = if matches!(optics, Optics::Glass { .. }) { dissolve(mtl).unwrap_or(1.0) } else { 1.0 };
    let material =
        Material { diffuse: own * material.diffuse, specular: own * material.specular, ..material };
    Surface { material, optics }
}

/// The material as rasterizers draw it: opaque, so with all of its own light.
pub(crate) fn material_of(mtl: &ObjMaterial) -> Material {
    let default = Material::default();
    let has_highlight = !matches!(mtl.illumination_model, Some(0 | 1));
    let specular = if has_highlight { mtl.specular.unwrap_or(default.specular) } else { Rgb::ZERO };
    Material {
        diffuse: share(mtl.diffuse.unwrap_or(default.diffuse)),
        specular: share(specular),
        exponent: mtl.exponent.unwrap_or(default.exponent).clamp(0.0, GREATEST_EXPONENT),
    }
}

fn optics_of(mtl: &ObjMaterial) -> Optics {
    match (mtl.illumination_model, dissolve(mtl)) {
        (Some(3 | 5 | 8), None) => Optics::Mirror { reflectance: share(mtl.specular.unwrap_or(Rgb::ONE)) },
        (Some(4 | 6 | 7 | 9), opacity) => Optics::Glass {
            refractive_index: mtl.refractive_index.unwrap_or(1.0).clamp(1.0, GREATEST_REFRACTIVE_INDEX),
            transmittance: Rgb::splat(opacity.map_or(1.0, |opacity| 1.0 - opacity)),
        },
        (_, Some(opacity)) => Optics::Dissolved { opacity },
        _ => Optics::Opaque,
    }
}

/// `d` if the material is not opaque: 0 or more, less than 1.
fn dissolve(mtl: &ObjMaterial) -> Option<f32> {
    mtl.dissolve.filter(|d| *d < 1.0).map(|d| d.max(0.0))
}

/// What becomes of an exponent that is too great, if one of these materials has such a one.
pub(crate) fn exponent_warning(materials: &[ObjMaterial]) -> Option<String> {
    let too_great = |mtl: &&ObjMaterial| mtl.exponent.is_some_and(|exponent| exponent > GREATEST_EXPONENT);
    let mtl = materials.iter().find(too_great)?;
    let exponent = mtl.exponent.unwrap_or_default();
    Some(format!(
        "material {:?} has Ns {exponent:e}; it is drawn with {GREATEST_EXPONENT}, above which f32 is off by half a step of 255",
        mtl.name
    ))
}

/// A share of light, 0 to 1 (L24); files know colors beyond.
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
        // Own light counts by d; without a glass model nothing is bent, whatever the index.
        let half = ObjMaterial { dissolve: Some(0.5), refractive_index: Some(1.33), ..red.clone() };
        assert_eq!(surface_of(&half).optics, Optics::Dissolved { opacity: 0.5 });
        assert_eq!(surface_of(&half).material, surface_of(&red).material);
        let pane = ObjMaterial {
            dissolve: Some(0.25),
            refractive_index: Some(1.33),
            illumination_model: Some(9),
            ..red.clone()
        };
        let through = Optics::Glass { refractive_index: 1.33, transmittance: Rgb::splat(0.75) };
        assert_eq!(surface_of(&pane).optics, through);
        assert_eq!(surface_of(&pane).material.diffuse, 0.25 * vec3(0.7, 0.1, 0.05));
        assert_eq!(material_of(&pane).diffuse, vec3(0.7, 0.1, 0.05));
        let clear = ObjMaterial { dissolve: None, refractive_index: None, ..pane };
        let all = Optics::Glass { refractive_index: 1.0, transmittance: Rgb::ONE };
        assert_eq!((surface_of(&clear).optics, surface_of(&clear).material), (all, material_of(&clear)));
    }

    #[test]
    fn a_material_without_a_word_is_the_default() {
        assert_eq!(surface_of(&ObjMaterial::default()), Surface::default());
    }
}
