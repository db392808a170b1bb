//! Worlds without symmetry: a few small meshes that may pierce each other, lights, and a camera that sees them.

use canvas::Rgb;
use geometry::Mesh;
use geometry::shapes::{cuboid, icosphere, torus};
use glam::{Mat4, vec3};
use lighting::{Highlight, Light, Material};
use proptest::prelude::*;
use shading::{Object, World};
use testkit::strategy;
use transforms::{Camera, Pipeline, ViewVolume};

/// What a [`World`] borrows, and from where it is seen.
#[derive(Clone, Debug)]
pub(crate) struct Model {
    objects: Vec<(Mesh, Mat4)>,
    materials: Vec<Material>,
    lights: Vec<Light>,
    pub(crate) pipeline: Pipeline,
}

impl Model {
    pub(crate) fn show<T>(&self, look: impl FnOnce(&World) -> T) -> T {
        let objects: Vec<_> = self
            .objects
            .iter()
            .map(|(mesh, matrix)| Object { mesh, world_from_object: *matrix, materials: &self.materials })
            .collect();
        let background = Rgb::new(0.1, 0.2, 0.4);
        look(&World { objects: &objects, lights: &self.lights, background, highlight: Highlight::Blinn })
    }
}

/// One to three objects near the origin, seen from eight units away; the near plane cuts some of them.
pub(crate) fn model() -> impl Strategy<Value = Model> {
    let objects = prop::collection::vec((mesh(), strategy::affine(1.5)), 1..4);
    (objects, prop::collection::vec(material(), 0..3), lights(), pipeline())
        .prop_map(|(objects, materials, lights, pipeline)| Model { objects, materials, lights, pipeline })
}

/// A ball, a box, a ring or loose triangles; every second one without normals, every second one with a material for each triangle.
pub(crate) fn mesh() -> impl Strategy<Value = Mesh> {
    let loose = prop::collection::vec(strategy::triangle(2.0), 1..8).prop_map(|triangles| {
        let positions = triangles.iter().flat_map(geometry::Triangle::corners).collect();
        Mesh::new(positions, (0..triangles.len() as u32).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect())
            .unwrap()
    });
    let shapes = [icosphere(0), icosphere(1), cuboid(vec3(1.0, 2.0, 3.0), 0), torus(1.5, 0.5, 0)];
    let shape = prop::sample::select(shapes.map(Result::unwrap).to_vec());
    (prop_oneof![loose, shape], any::<bool>(), any::<bool>(), 0_usize..4).prop_map(
        |(mesh, without_normals, with_materials, zeros)| {
            let mesh = if without_normals { mesh.without_normals() } else { with_zeros(mesh, zeros) };
            let materials = (0..mesh.len() as u32).map(|k| k * k % 5).collect();
            if with_materials { mesh.with_materials(materials).unwrap() } else { mesh }
        },
    )
}

/// The mesh with the first few of its normals taken away: zero means none given.
fn with_zeros(mesh: Mesh, count: usize) -> Mesh {
    let Some(mut normals) = mesh.normals().cloned() else { return mesh };
    normals.values.iter_mut().take(count).for_each(|n| *n = glam::Vec3::ZERO);
    mesh.with_normals(normals).unwrap()
}

pub(crate) fn color() -> impl Strategy<Value = Rgb> + Clone {
    (0.0_f32..1.0, 0.0_f32..1.0, 0.0_f32..1.0).prop_map(Rgb::from)
}

pub(crate) fn material() -> impl Strategy<Value = Material> + Clone {
    (color(), color(), 1.0_f32..80.0).prop_map(|(diffuse, specular, exponent)| Material {
        diffuse,
        specular,
        exponent,
    })
}

/// An ambient, a directional and a point light.
pub(crate) fn lights() -> impl Strategy<Value = Vec<Light>> + Clone {
    (color(), (strategy::unit_vector(), color()), (strategy::unit_vector(), color())).prop_map(
        |(ambient, (to_light, directional), (way, point))| {
            vec![
                Light::Ambient { color: 0.2 * ambient },
                Light::Directional { to_light, color: directional },
                Light::Point { position: 9.0 * way, color: point },
            ]
        },
    )
}

/// 45 × 37 pixels: three bands of rows, the last of them lower.
fn pipeline() -> impl Strategy<Value = Pipeline> {
    (strategy::unit_vector(), strategy::point(0.5), 0.5_f32..8.0).prop_map(|(way, target, near)| {
        let camera = Camera::look_at(8.0 * way, target, way.any_orthogonal_vector());
        let volume = ViewVolume::from_fov_y(0.6, 45.0 / 37.0, -near, -30.0).unwrap();
        Pipeline::new(camera.unwrap(), volume, 45, 37).unwrap()
    })
}
