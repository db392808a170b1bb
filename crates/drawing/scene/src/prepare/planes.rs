//! Where do near and far plane lie if the scene does not say? Around what is seen, and no farther apart than depth bears.

use glam::{DVec2, DVec3, Mat4, Vec3};
use transforms::Camera;

use super::PreparedObject;

/// How many times as far as the near plane the far plane is fitted without need. Depth resolution is lost by this factor (L20): with
/// 1000, a 16-bit buffer still tells apart 1.5 % of the depth at the far end.
const FARTHEST_OVER_NEAREST: f32 = 1e3;

/// How many times as far it is fitted at most, to hold something visible close to the eye: a 32-bit buffer then still tells apart
/// 0.3 % of the depth at the far end.
const FARTHEST_OVER_VISIBLE: f32 = 1e5;

/// Room between the objects and the fitted planes, so that rounding cuts nothing off.
const ROOM: f32 = 0.01;

/// Near and far plane, as w-coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Planes {
    pub(super) near: f32,
    pub(super) far: f32,
    /// How near the eye something visible comes that a fitted near plane cuts off; no number if none does.
    pub(super) cut_from: Option<f32>,
}

/// Parts before a camera.
#[derive(Clone, Copy)]
pub(super) struct Sight<'a> {
    pub(super) camera: &'a Camera,
    pub(super) parts: &'a [PreparedObject],
    /// The greatest |x/w| and |y/w| in the window.
    pub(super) slopes: DVec2,
}

impl Sight<'_> {
    /// Near and far plane as given, or fitted to the objects where they are not.
    ///
    /// 1. Far is the farthest corner of all boxes around objects.
    /// 2. Near is the nearest, if that is not too close: a thousandth of far.
    /// 3. If it is, or lies behind the eye, the objects in question are cut by the sides of the viewing volume, triangle by triangle, and near is
    ///    the nearest point of what is left.
    /// 4. Even so it never is nearer than a hundred-thousandth of far. What that cuts off is reported.
    pub(super) fn planes(&self, (near, far): (Option<f32>, Option<f32>)) -> Planes {
        let (nearest, farthest) = self.extent();
        let far = far.unwrap_or_else(|| near.map_or(farthest, |near| farthest.min(2.0 * near)));
        if let Some(near) = near {
            return Planes { near, far, cut_from: None };
        }
        let comfortable = far / FARTHEST_OVER_NEAREST;
        let fitted = if nearest > far { nearest } else { 0.5 * far };
        if fitted <= comfortable {
            return Planes { near: fitted, far, cut_from: None };
        }
        let Some(visible) = self.nearest_visible(comfortable.into()) else {
            return Planes { near: comfortable, far, cut_from: None };
        };
        let (visible, limit) = (visible as f32, far / FARTHEST_OVER_VISIBLE);
        let near = ((1.0 - ROOM) * visible).min(limit);
        Planes { near, far, cut_from: (visible > limit).then_some(-visible) }
    }

    /// The w-coordinates between which all boxes around objects lie, with some room. The nearest may lie behind the eye.
    fn extent(&self) -> (f32, f32) {
        let camera_from_world = self.camera.camera_from_world();
        let w = |p_world: Vec3| camera_from_world.transform_point3(p_world).z;
        let corners = self.parts.iter().flat_map(PreparedObject::corners_world);
        let (farthest, nearest) = corners
            .map(w)
            .fold((f32::INFINITY, f32::NEG_INFINITY), |(far, near), w| (far.min(w), near.max(w)));
        if farthest >= 0.0 || !farthest.is_finite() {
            // Nothing to see; any volume will do.
            return (-1.0, -10.0);
        }
        ((1.0 - ROOM) * nearest, (1.0 + ROOM) * farthest)
    }

    /// The w-coordinate of the nearest visible point of all objects, if it is nearer than `w`.
    fn nearest_visible(&self, w: f64) -> Option<f64> {
        let camera_from_world = self.camera.camera_from_world();
        let mut nearest = w;
        for part in self.parts {
            for world_from_object in &part.world_from_object {
                let camera_from_object = camera_from_world * *world_from_object;
                let reaches =
                    part.box_corners().any(|p| f64::from(camera_from_object.transform_point3(p).z) > nearest);
                if reaches {
                    nearest = self.nearest_of(part, camera_from_object, nearest);
                }
            }
        }
        (nearest > w).then_some(nearest)
    }

    /// The greater of `nearest` and the greatest w-coordinate of what is visible of a part.
    fn nearest_of(&self, part: &PreparedObject, camera_from_object: Mat4, mut nearest: f64) -> f64 {
        let outwards = part.outwards();
        let place = |p| camera_from_object.transform_point3(outwards * p).as_dvec3();
        let positions: Vec<DVec3> = part.mesh.positions().iter().map(|p| place(*p)).collect();
        for triangle in part.mesh.triangles() {
            let corners = triangle.map(|index| positions[index as usize]);
            let may_be_nearer = corners.iter().any(|p| p.z > nearest) && corners.iter().any(|p| p.z < 0.0);
            if may_be_nearer {
                nearest = self.visible_part(&corners).iter().fold(nearest, |nearest, p| nearest.max(p.z));
            }
        }
        nearest
    }

    /// What of a triangle lies between the four planes through the eye and the sides of the window (Sutherland–Hodgman).
    fn visible_part(&self, corners: &[DVec3; 3]) -> Vec<DVec3> {
        let DVec2 { x, y } = self.slopes;
        // Inside is where plane · p ≥ 0; between opposite planes only points before the eye are.
        let planes = [
            DVec3::new(1.0, 0.0, -x),
            DVec3::new(-1.0, 0.0, -x),
            DVec3::new(0.0, 1.0, -y),
            DVec3::new(0.0, -1.0, -y),
        ];
        planes.iter().fold(corners.to_vec(), |polygon, plane| cut(&polygon, *plane))
    }
}

/// The part of a convex polygon where plane · p ≥ 0.
fn cut(polygon: &[DVec3], plane: DVec3) -> Vec<DVec3> {
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for (k, &to) in polygon.iter().enumerate() {
        let from = polygon[(k + polygon.len() - 1) % polygon.len()];
        let (d_from, d_to) = (plane.dot(from), plane.dot(to));
        if (d_from < 0.0) != (d_to < 0.0) {
            kept.push(from + (to - from) * (d_from / (d_from - d_to)));
        }
        if d_to >= 0.0 {
            kept.push(to);
        }
    }
    kept
}
