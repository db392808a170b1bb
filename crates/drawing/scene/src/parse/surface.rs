//! What shines, and what does it shine on? The `[[light]]` and `[material.NAME]` tables of a scene file.

use std::collections::BTreeMap;

use lighting::{Light, Material, Rgb};
use raytrace::{Optics, Surface};

use super::BRIGHTEST;
use super::table::Table;
use super::value::{Value, plain};
use crate::SceneError;
use crate::limits::{GREATEST_EXPONENT, GREATEST_REFRACTIVE_INDEX};

/// The light of one `[[light]]` table.
pub(super) fn light(value: &Value<'_>) -> Result<Light, SceneError> {
    let kinds = "say kind = \"point\", \"directional\" or \"ambient\"";
    let kind = value.any_table()?.need("kind", kinds)?;
    let color = |table: &Table<'_>| table.get("color").map_or(Ok(Rgb::ONE), |value| value.color(BRIGHTEST));
    match kind.text()? {
        "ambient" => {
            let table = value.table(&["kind", "color"])?;
            Ok(Light::Ambient { color: color(&table)? })
        }
        "directional" => {
            let table = value.table(&["kind", "to-light", "color"])?;
            let to_light = table.need("to-light", "say where the light comes from: to-light = [x, y, z]")?;
            Ok(Light::Directional { to_light: to_light.direction()?, color: color(&table)? })
        }
        "point" => {
            let table = value.table(&["kind", "position", "color"])?;
            let position = table.need("position", "say where the light is: position = [x, y, z]")?;
            Ok(Light::Point { position: position.vector()?, color: color(&table)? })
        }
        other => Err(kind.fault(format!("\"{}\" is no kind of light", plain(other)), kinds)),
    }
}

/// The surfaces of the `[material.NAME]` tables.
pub(super) fn materials(root: &Table<'_>) -> Result<BTreeMap<String, Surface>, SceneError> {
    let Some(value) = root.get("material") else {
        return Ok(BTreeMap::new());
    };
    let named = value.any_table()?;
    named.entries().map(|(name, value)| Ok((name, surface(&value)?))).collect()
}

fn surface(value: &Value<'_>) -> Result<Surface, SceneError> {
    let table = value.table(&["diffuse", "specular", "exponent", "mirror", "glass", "opacity"])?;
    let diffuse = table.need("diffuse", "say its colour: diffuse = [red, green, blue]")?.color(1.0)?;
    let mut material = Material::new(diffuse, Material::default().exponent);
    if let Some(value) = table.get("specular") {
        material.specular = value.color(1.0)?;
    }
    if let Some(value) = table.get("exponent") {
        let must_be = format!(
            "from 0 to {GREATEST_EXPONENT}: above that the highlight, computed in f32, is off by half a step of 255"
        );
        material.exponent = value.number_where(&must_be, |p| (0.0..=GREATEST_EXPONENT).contains(&p))?;
    }
    Ok(Surface { material, optics: optics(&table)? })
}

/// What the surface does beyond the lighting model; a table names one of them at most.
fn optics(table: &Table<'_>) -> Result<Optics, SceneError> {
    match (table.get("mirror"), table.get("glass"), table.get("opacity")) {
        (None, None, None) => Ok(Optics::Opaque),
        (Some(mirror), None, None) => Ok(Optics::Mirror { reflectance: mirror.color(1.0)? }),
        (None, Some(glass), None) => self::glass(&glass),
        (None, None, Some(opacity)) => {
            let must_be = "from 0, invisible, to 1, opaque";
            let opacity = opacity.number_where(must_be, |share| (0.0..=1.0).contains(&share))?;
            Ok(Optics::Dissolved { opacity })
        }
        (_, _, Some(opacity)) => Err(opacity.fault(
            "`opacity` stands beside `mirror` or `glass`",
            "choose one; glass is clear by itself, see its `tint`",
        )),
        (Some(_), Some(glass), None) => {
            Err(glass.fault("both `mirror` and `glass` are there", "choose one; glass mirrors by itself"))
        }
    }
}

fn glass(value: &Value<'_>) -> Result<Optics, SceneError> {
    let table = value.table(&["index", "tint"])?;
    let index = table.need("index", "say its refractive index: glass = { index = 1.5 }")?;
    let must_be = format!("from 1 to {GREATEST_REFRACTIVE_INDEX}: window glass has 1.5, water 1.33");
    let refractive_index =
        index.number_where(&must_be, |n| (1.0..=GREATEST_REFRACTIVE_INDEX).contains(&n))?;
    let transmittance = table.get("tint").map_or(Ok(Rgb::ONE), |value| value.color(1.0))?;
    Ok(Optics::Glass { refractive_index, transmittance })
}
