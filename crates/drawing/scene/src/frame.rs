//! From where does one look at a mesh that nobody has described? From a little above and aside, near enough to fill the
//! picture, with the light over the left shoulder.

use std::collections::BTreeMap;

use geometry::Mesh;
use glam::{Vec3, vec3};
use lighting::{Light, Rgb};
use transforms::Basis;

use crate::parse::CREASE_DEGREES;
use crate::prepare::fitted;
use crate::scene::{Lens, Object, Scene, Settings, Shape, View};

/// The vertical field of view: that of a portrait lens, so that nothing bulges.
const FOV_DEGREES: f32 = 30.0;

/// The mesh takes up this share of the picture in the direction in which it is larger.
const FILLED: f32 = 0.86;

/// Directions from the mesh to the eye, best first, for a mesh whose front looks along +z. The first is a three-quarter view.
const TO_EYE: [Vec3; 4] =
    [vec3(0.55, 0.4, 1.0), vec3(-1.0, 0.5, 0.6), vec3(0.3, 1.0, 0.5), vec3(-0.6, 0.3, -1.0)];

/// The top third of a mesh must lie this much farther along −z than all of it, in halves of the box's diagonal, before its
/// front is taken to be there. Less may be chance.
const LEAN: f32 = 0.1;

/// A flat mesh is seen well enough if its normals are this cosine away from a right angle with the gaze, on average.
const LEAST_COSINE: f32 = 0.2;

/// The scene of one mesh, file `name` in the scene's folder. Fails with a sentence if there is nothing to see.
pub(crate) fn framed(mesh: &Mesh, name: &str) -> Result<Scene, String> {
    let mesh = fitted(mesh).map_err(|error| error.to_string())?;
    let size = mesh.aabb().size();
    if size.max_element() <= 0.0 {
        return Err("all corners of the mesh lie in one point".to_owned());
    }
    let settings = Settings::default();
    let aspect = settings.size.0 as f32 / settings.size.1 as f32;
    let basis = Basis::from_gaze_and_up(-to_eye(&mesh), Vec3::Y).map_err(|error| error.to_string())?;
    Ok(Scene {
        camera: view(&mesh, &basis, aspect),
        background: vec3(0.045, 0.055, 0.075),
        lights: lights(&basis),
        materials: BTreeMap::new(),
        objects: vec![Object {
            shape: Shape::Obj { path: name.to_owned(), fit: true },
            material: None,
            transforms: Vec::new(),
            instances: Vec::new(),
            crease_degrees: CREASE_DEGREES,
        }],
        settings,
    })
}

/// The first direction from which the mesh is not seen edge-on, or that from which it is seen best.
fn to_eye(mesh: &Mesh) -> Vec3 {
    let seen = |direction: Vec3| {
        let crosses = (0..mesh.len()).map(|k| mesh.triangle(k).cross());
        let (facing, area) = crosses.fold((0.0, 0.0), |(facing, area), cross| {
            (facing + cross.dot(direction.normalize()).abs(), area + cross.length())
        });
        // A mesh without area shows nothing from anywhere.
        if area > 0.0 { facing / area } else { 0.0 }
    };
    let front = if looks_along_minus_z(mesh) { vec3(1.0, 1.0, -1.0) } else { Vec3::ONE };
    let directions = TO_EYE.map(|direction| front * direction);
    let well_seen = directions.into_iter().find(|direction| seen(*direction) >= LEAST_COSINE);
    let best = || directions.into_iter().max_by(|a, b| seen(*a).total_cmp(&seen(*b)));
    well_seen.or_else(best).unwrap_or(TO_EYE[0])
}

/// Which way is its front? Files do not say, and both ways are common. What has a head carries it high and in front.
fn looks_along_minus_z(mesh: &Mesh) -> bool {
    let bounds = mesh.aabb();
    let mean_z_above = |least_y: f32| {
        let corners = mesh.triangles().iter().flatten().map(|index| mesh.positions()[*index as usize]);
        let high = corners.filter(|p| p.y >= least_y);
        let (sum, count) =
            high.fold((0.0_f64, 0.0_f64), |(sum, count), p| (sum + f64::from(p.z), count + 1.0));
        if count > 0.0 { (sum / count) as f32 } else { 0.0 }
    };
    let top_third = bounds.max.y - bounds.size().y / 3.0;
    mean_z_above(top_third) < mean_z_above(bounds.min.y) - LEAN
}

/// The view along −w that just holds the mesh, and the mesh in the middle of the picture.
fn view(mesh: &Mesh, basis: &Basis, aspect: f32) -> View {
    let tan_y = FILLED * (0.5 * FOV_DEGREES.to_radians()).tan();
    let tan_x = aspect * tan_y;
    let seen: Vec<Vec3> = mesh
        .triangles()
        .iter()
        .flatten()
        .map(|index| mesh.positions()[*index as usize])
        .map(|p| vec3(p.dot(basis.u), p.dot(basis.v), p.dot(basis.w)))
        .collect();
    // From distance d before the origin, a point at (x, y, z) appears at (x, y) / (d − z).
    let (mut x0, mut y0, mut distance) = (0.0, 0.0, 0.0);
    // Moving the middle changes the distance, which changes the middle, less and less.
    for _ in 0..4 {
        let needed = |p: &Vec3| p.z + ((p.x - x0).abs() / tan_x).max((p.y - y0).abs() / tan_y);
        distance = seen.iter().map(needed).fold(0.0, f32::max);
        let middle = |at: &dyn Fn(&Vec3) -> f32| {
            let (low, high) = seen
                .iter()
                .filter(|p| p.z < distance)
                .map(|p| at(p) / (distance - p.z))
                .fold((f32::INFINITY, f32::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
            if low <= high { 0.5 * (low + high) * distance } else { 0.0 }
        };
        let (dx, dy) = (middle(&|p| p.x - x0), middle(&|p| p.y - y0));
        (x0, y0) = (x0 + dx, y0 + dy);
    }
    let target = x0 * basis.u + y0 * basis.v;
    View {
        eye: target + distance * basis.w,
        target,
        up: Vec3::Y,
        lens: Lens::FieldOfView { degrees: FOV_DEGREES, near: None, far: None },
    }
}

/// A key light over the viewer's left shoulder, a dim cool one from the right, and a little from everywhere.
fn lights(basis: &Basis) -> Vec<Light> {
    let from = |x: f32, y: f32, z: f32| (x * basis.u + y * basis.v + z * basis.w).normalize();
    vec![
        Light::Ambient { color: Rgb::splat(0.12) },
        Light::Directional { to_light: from(-0.6, 0.8, 0.8), color: vec3(0.82, 0.79, 0.74) },
        Light::Directional { to_light: from(0.9, 0.1, 0.5), color: vec3(0.16, 0.19, 0.24) },
    ]
}
