//! From where does the eye look, and how much does it see? The `[camera]` table of a scene file.

use transforms::{Camera, DegenerateBasis, DegenerateCamera, DegenerateVolume, ViewVolume};

use super::table::Table;
use super::value::Value;
use crate::SceneError;
use crate::scene::{Lens, View};

/// The view of the `[camera]` table; it has a frame, and a volume as far as its planes are given.
pub(super) fn camera(value: &Value<'_>) -> Result<View, SceneError> {
    let table = value.table(&["eye", "target", "up", "fov", "window", "near", "far"])?;
    let eye = table.need("eye", "say where the eye is: eye = [x, y, z]")?.vector()?;
    let target_value = table.need("target", "say what it looks at: target = [x, y, z]")?;
    let target = target_value.vector()?;
    let up_value = table.get("up");
    let up = up_value.as_ref().map_or(Ok(glam::Vec3::Y), Value::vector)?;
    Camera::look_at(eye, target, up).map_err(|error| {
        let about_up = matches!(
            error,
            DegenerateCamera::Basis(DegenerateBasis::ZeroUp | DegenerateBasis::UpParallelToGaze { .. })
        );
        let place = up_value.as_ref().filter(|_| about_up).unwrap_or(&target_value);
        place.fault(
            error.to_string(),
            "eye, target and up must span a frame: up = [0, 1, 0] unless the eye looks along y",
        )
    })?;
    Ok(View { eye, target, up, lens: lens(&table)? })
}

fn lens(table: &Table<'_>) -> Result<Lens, SceneError> {
    let plane = |key: &str| table.get(key).map(|value| w_coordinate(key, &value)).transpose();
    let (near, far) = (plane("near")?, plane("far")?);
    if let (Some(near), Some(far), Some(value)) = (near, far, table.get("far"))
        && far >= near
    {
        return Err(volume_fault(&value, &DegenerateVolume::NoDepth { near, far }));
    }
    match (table.get("fov"), table.get("window")) {
        (Some(_), Some(window)) => {
            Err(window.fault("both `fov` and `window` are there", "choose one: an angle or a window"))
        }
        (None, None) => {
            Err(table
                .fault("`camera.fov` is missing", "say how much the eye sees: fov = 40 (degrees, vertical)"))
        }
        (Some(fov), None) => {
            let degrees =
                fov.number_where("an angle between 0 and 180 degrees", |fov| 0.0 < fov && fov < 180.0)?;
            // The window must exist for some planes at least; an angle like 1e-30 has none.
            let (n, f) = (near.unwrap_or(-1.0), far.unwrap_or(near.map_or(-2.0, |n| 2.0 * n)));
            ViewVolume::from_fov_y(degrees.to_radians(), 1.0, n.max(0.5 * f), f)
                .map_err(|error| volume_fault(&fov, &error))?;
            Ok(Lens::FieldOfView { degrees, near, far })
        }
        (None, Some(window)) => self::window(table, &window).map(Lens::Window),
    }
}

fn window(camera: &Table<'_>, value: &Value<'_>) -> Result<ViewVolume, SceneError> {
    let table = value.table(&["left", "right", "bottom", "top"])?;
    let side = |key: &str| table.need(key, "a window has left, right, bottom and top")?.number();
    let plane = |key: &str| {
        let remedy = "a window lies on the near plane: say near and far, both negative";
        w_coordinate(key, &camera.need(key, remedy)?)
    };
    let volume = ViewVolume {
        left: side("left")?,
        right: side("right")?,
        bottom: side("bottom")?,
        top: side("top")?,
        near: plane("near")?,
        far: plane("far")?,
    };
    volume.validate().map_err(|error| volume_fault(value, &error))?;
    Ok(volume)
}

/// The w-coordinate of the near or far plane, which is negative as on the slides (E2).
fn w_coordinate(key: &str, value: &Value<'_>) -> Result<f32, SceneError> {
    let w = value.number()?;
    if w < 0.0 {
        return Ok(w);
    }
    let name = if key == "near" { "near" } else { "far" };
    let error = DegenerateVolume::NotBeforeTheEye { name, value: w };
    let remedy = if w > 0.0 {
        format!("write {key} = {}", -w)
    } else {
        format!("write a negative number, {key} = -0.1")
    };
    Err(value.fault(error.to_string(), remedy))
}

fn volume_fault(value: &Value<'_>, error: &DegenerateVolume) -> SceneError {
    value.fault(error.to_string(), "a viewing volume needs left < right, bottom < top and far < near < 0")
}
