//! What is drawn and traced? One mesh, seen by one camera, under one light: the same for everybody.

pub(crate) mod layers;
pub(crate) mod sphere;

use canvas::Rgb;
use geometry::Mesh;
use glam::{Mat4, Vec3, vec3};
use lighting::{Highlight, Light, Material};
use transforms::opengl::opengl_clip_from_camera;
use transforms::{Camera, Pipeline, ViewVolume};

/// Where the eye is; it looks at the origin.
const EYE: Vec3 = vec3(1.2, 0.9, 2.4);
/// The vertical angle of view, degrees.
const FOV_Y: f32 = 45.0;
/// Near and far, as coordinates along the gaze: around the sphere and around all layers.
const NEAR: f32 = -0.5;
const FAR: f32 = -10.0;

/// Light from everywhere.
pub(crate) const AMBIENT: Rgb = Rgb::splat(0.1);
/// The one point light, above and to the left of the eye; white.
pub(crate) const LIGHT: Vec3 = vec3(-2.0, 4.0, 5.0);
/// c_r and p of the one material. The highlight is white, and Blinn's.
pub(crate) const DIFFUSE: Rgb = Rgb::new(0.6, 0.25, 0.1);
pub(crate) const SPECULAR: f32 = 0.3;
pub(crate) const EXPONENT: f32 = 32.0;
/// Blinn's form: h needs a square root, and every peer pays for it.
pub(crate) const HIGHLIGHT: Highlight = Highlight::Blinn;

/// The material in our own words.
pub(crate) fn material() -> Material {
    Material { diffuse: DIFFUSE, specular: Rgb::splat(SPECULAR), exponent: EXPONENT }
}

/// The lights in our own words.
pub(crate) fn lights() -> [Light; 2] {
    [Light::Ambient { color: AMBIENT }, Light::Point { position: LIGHT, color: Rgb::ONE }]
}

/// From where the world is seen, on a screen of `width` × `height`.
pub(crate) fn view(width: u32, height: u32) -> Pipeline {
    let camera = Camera::look_at(EYE, Vec3::ZERO, Vec3::Y).expect("the eye is not at the origin");
    let aspect = width as f32 / height as f32;
    let volume = ViewVolume::from_fov_y(FOV_Y.to_radians(), aspect, NEAR, FAR).expect("0 > near > far");
    Pipeline::new(camera, volume, width, height).expect("a screen with pixels")
}

/// The same projection as the books have it, for peers: visible points have w > 0, the near plane z = −w, y upwards.
pub(crate) fn opengl_clip_from_world(view: &Pipeline) -> Mat4 {
    opengl_clip_from_camera(&view.volume()) * view.camera_from_world()
}

/// How far in front of the eye a point lies whose z by OpenGL's projection, after division, is `z`.
pub(crate) fn distance_from_opengl_z(z: f32) -> f32 {
    2.0 * NEAR * FAR / ((FAR - NEAR) * z - (FAR + NEAR))
}

/// A mesh that is drawn, and its name in the table.
pub(crate) struct Scene {
    /// Short, as the table has it.
    pub(crate) name: &'static str,
    /// World coordinates, with a normal at every corner, and with as many normals as positions, so that one index
    /// serves both.
    pub(crate) mesh: Mesh,
}

impl Scene {
    /// 1,002,252 triangles; those that are seen cover 1.6 pixels on average.
    pub(crate) fn million() -> Self {
        Self { name: "1M", mesh: sphere::bumpy(289) }
    }

    /// 69,312 triangles; those that are seen cover 23 pixels on average.
    pub(crate) fn thousands() -> Self {
        Self { name: "69k", mesh: sphere::bumpy(76) }
    }

    /// 12 triangles that cover the screen eight times.
    pub(crate) fn fill(view: &Pipeline) -> Self {
        Self { name: "fill", mesh: layers::back_to_front(view) }
    }

    /// The normals, one a position.
    pub(crate) fn normals(&self) -> &[Vec3] {
        &self.mesh.normals().expect("scenes have normals").values
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distance_is_undone_from_opengls_depth() {
        let view = view(320, 200);
        for p_world in [vec3(0.3, 0.2, -0.7), vec3(0.1, -0.4, 0.9)] {
            let clip = opengl_clip_from_world(&view) * p_world.extend(1.0);
            let distance = -(view.camera_from_world() * p_world.extend(1.0)).z;
            // Depth near 1 is stored with 2⁻²⁴, and 1/w has a slope of at most distance² · (1/0.5 − 1/10) / 2 there.
            assert!((distance_from_opengl_z(clip.z / clip.w) - distance).abs() < 1e-5, "{p_world}");
        }
    }

    #[test]
    fn every_scene_has_a_unit_normal_for_each_position() {
        for scene in [Scene::thousands(), Scene::fill(&view(320, 200))] {
            let normals = scene.mesh.normals().expect("normals");
            assert_eq!(scene.normals().len(), scene.mesh.positions().len());
            assert_eq!(normals.triangles, scene.mesh.triangles());
            assert!(scene.normals().iter().all(|n| n.is_normalized()));
        }
    }
}
