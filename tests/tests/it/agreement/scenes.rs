//! Random scenes: loose triangles, and curved shapes.

use canvas::Rgb;
use geometry::Mesh;
use glam::{Mat4, vec3};
use lighting::{Light, Material};
use proptest::prelude::*;
use testkit::strategy;
use transforms::{Camera, Pipeline, ViewVolume};

use crate::agreement::stage::Stage;

pub(crate) fn camera_and_volume() -> impl Strategy<Value = Pipeline> {
    let eye = (strategy::unit_vector(), 4.0_f32..9.0).prop_map(|(direction, distance)| distance * direction);
    (eye, strategy::point(1.0), 0.4_f32..1.2, 24_u32..60, 24_u32..60, strategy::unit_vector())
        .prop_filter("up along the gaze", |(eye, target, .., up)| {
            (*target - *eye).normalize().cross(*up).length() > 0.2
        })
        .prop_map(|(eye, target, fov_y, width, height, up)| {
            let camera = Camera::look_at(eye, target, up).expect("checked");
            let aspect = width as f32 / height as f32;
            let volume = ViewVolume::from_fov_y(fov_y, aspect, -0.5, -30.0).expect("a valid volume");
            Pipeline::new(camera, volume, width, height).expect("a valid pipeline")
        })
}

pub(crate) fn lights() -> impl Strategy<Value = Vec<Light>> {
    (strategy::unit_vector(), strategy::point(8.0)).prop_map(|(to_light, position)| {
        vec![
            Light::Ambient { color: Rgb::new(0.10, 0.12, 0.15) },
            Light::Directional { to_light, color: Rgb::new(0.7, 0.6, 0.5) },
            Light::Point { position, color: Rgb::new(0.3, 0.4, 0.5) },
        ]
    })
}

pub(crate) fn material() -> impl Strategy<Value = Material> {
    ((0.1_f32..0.9, 0.1_f32..0.9, 0.1_f32..0.9), 1.0_f32..20.0).prop_map(|(diffuse, exponent)| Material {
        diffuse: Rgb::from(diffuse),
        specular: Rgb::splat(0.3),
        exponent,
    })
}

/// Loose triangles that hide and pierce each other; some reach behind the eye.
pub(crate) fn triangle_soup() -> impl Strategy<Value = Stage> {
    let triangles = proptest::collection::vec((strategy::triangle(3.0), material()), 1..14);
    let behind = strategy::triangle(12.0);
    (triangles, behind, material(), camera_and_volume(), lights()).prop_map(
        |(mut triangles, large, material, pipeline, lights)| {
            triangles.push((large, material));
            let meshes = triangles.into_iter().map(|(t, material)| {
                let mesh = Mesh::new(t.corners().to_vec(), vec![[0, 1, 2]]).expect("a mesh");
                (mesh, Mat4::IDENTITY, material)
            });
            Stage { meshes: meshes.collect(), lights, pipeline }
        },
    )
}

/// Curved shapes with shared edges and smooth normals, bent by any affine map, mirrored ones too.
pub(crate) fn curved_shapes() -> impl Strategy<Value = Stage> {
    let shape = (0_u32..4, strategy::affine(1.5), any::<bool>(), material()).prop_map(
        |(kind, m, mirrored, material)| {
            let mesh = match kind {
                0 => geometry::shapes::icosphere(2),
                1 => geometry::shapes::torus(1.0, 0.4, 2),
                2 => geometry::shapes::cuboid(vec3(1.0, 1.5, 0.7), 1),
                _ => geometry::shapes::disc(1.2, 2),
            };
            let flip = if mirrored { Mat4::from_scale(vec3(-1.0, 1.0, 1.0)) } else { Mat4::IDENTITY };
            (mesh.expect("a shape"), m * flip, material)
        },
    );
    (proptest::collection::vec(shape, 1..4), camera_and_volume(), lights())
        .prop_map(|(meshes, pipeline, lights)| Stage { meshes, lights, pipeline })
}
