//! What does a pixel cost where there are few triangles? Eight layers, each over the whole screen.

use geometry::{Indexed, Mesh};
use glam::{Vec3, vec3};
use transforms::Pipeline;

/// How many times every pixel is covered.
pub(crate) const LAYERS: usize = 8;
/// Beyond the screen's edges, as a share of its half: a sample on the border is inside for everybody.
const MARGIN: f32 = 1.05;
/// How far from the eye the first layer stands, how much nearer each next one comes, and how much a layer leans.
const FARTHEST: f32 = 5.0;
const STEP: f32 = 0.4;
const LEAN: f32 = 0.04;

/// Twelve triangles in the view of this camera, the farthest first: four layers of one triangle that sticks out of the
/// screen, between them four of two triangles with a common diagonal. All fronts; drawn in this order every fragment is
/// nearer than what was there.
pub(crate) fn back_to_front(view: &Pipeline) -> Mesh {
    let (mut positions, mut normals, mut triangles) = (Vec::new(), Vec::new(), Vec::new());
    for layer in 0..LAYERS {
        let first = positions.len() as u32;
        let distance = FARTHEST - STEP * layer as f32;
        let corners: &[(f32, f32)] = if layer % 2 == 0 {
            triangles.push([first, first + 1, first + 2]);
            &[(-1.0, -1.0), (3.0, -1.0), (-1.0, 3.0)]
        } else {
            triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
            &[(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
        };
        for &(x, y) in corners {
            positions.push(on_screen(view, MARGIN * x, MARGIN * y, distance + LEAN * x));
            let n_camera = vec3(0.2 * x, 0.15 * y, 1.0).normalize();
            normals.push(view.camera().world_from_camera().transform_vector3(n_camera));
        }
    }
    let normals = Indexed { values: normals, triangles: triangles.clone() };
    let mesh = Mesh::new(positions, triangles).expect("indices of the layers");
    mesh.with_normals(normals).expect("a normal for each position")
}

/// The point of the world that is seen at (x, y), where the screen is [−1, 1]², this far in front of the eye.
fn on_screen(view: &Pipeline, x: f32, y: f32, distance: f32) -> Vec3 {
    let volume = view.volume();
    let scale = distance / -volume.near;
    let p_camera = vec3(x * volume.right * scale, y * volume.top * scale, -distance);
    view.camera().world_from_camera().transform_point3(p_camera)
}

#[cfg(test)]
mod tests {
    use zbuffer::{project, rasterize};

    use super::*;
    use crate::scenes::view;

    #[test]
    fn twelve_triangles_cover_every_pixel_eight_times_each_time_nearer() {
        let view = view(192, 108);
        let mesh = back_to_front(&view);
        assert_eq!(mesh.len(), 12);
        let mut layers = vec![Vec::new(); 192 * 108];
        for k in 0..mesh.len() {
            for triangle in project(&view.clip_from_world(), 192, 108, &mesh.triangle(k)).triangles() {
                rasterize(&triangle, 192, 108, |at| layers[(at.j * 192 + at.i) as usize].push(at.z));
            }
        }
        assert!(layers.iter().all(|z| z.len() == LAYERS));
        assert!(layers.iter().all(|z| z.is_sorted_by(|far, near| far < near)), "drawn back to front");
    }

    #[test]
    fn all_layers_show_their_fronts() {
        let view = view(192, 108);
        let mesh = back_to_front(&view);
        let eye = view.camera().eye();
        for triangle in (0..mesh.len()).map(|k| mesh.triangle(k)) {
            assert!(triangle.normal().expect("no sliver").dot(eye - triangle.a) > 0.0);
        }
    }
}
