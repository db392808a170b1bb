//! What is one object, to a renderer? A mesh, its surfaces, and a matrix for each copy.

use std::sync::{Arc, OnceLock};

use geometry::obj::Import;
use geometry::{Aabb, Mesh, MeshError, Sphere, shapes};
use glam::{DVec3, Mat4, Vec3};
use lighting::Material;
use raytrace::{Surface, TracedMesh};

use crate::RenderError;
use crate::limits::GREATEST_COORDINATE;
use crate::load::Imports;
use crate::mtl::surface_of;
use crate::scene::{Object, Scene, Shape};

/// One mesh and where its copies are.
#[derive(Debug)]
pub(crate) struct Part {
    pub(crate) mesh: Mesh,
    /// Whether `mesh` stands for the unit ball, which the ray tracer has exactly.
    is_ball: bool,
    /// What the mesh's material numbers point into; at least one.
    pub(crate) surfaces: Vec<Surface>,
    /// The same without optics, as rasterizers want it.
    pub(crate) materials: Vec<Material>,
    /// One for each copy.
    pub(crate) world_from_object: Vec<Mat4>,
    traced: OnceLock<Arc<TracedMesh>>,
}

impl Part {
    /// The mesh, surfaces and places of one object.
    pub(super) fn new(object: &Object, scene: &Scene, imports: &Imports) -> Result<Part, RenderError> {
        let mesh =
            shading::with_vertex_normals(mesh(&object.shape, imports)?, object.crease_degrees.to_radians());
        let surfaces = match &object.material {
            // The reader has seen to it that the name is known.
            Some(name) => vec![scene.materials.get(name).copied().unwrap_or_default()],
            None => file_surfaces(&object.shape, imports),
        };
        let world_from_shape = product(&object.transforms);
        let shape_from_object = Mat4::from_scale(Vec3::splat(radius(&object.shape)));
        let placed = |copy: Mat4| copy * world_from_shape * shape_from_object;
        let world_from_object = if object.instances.is_empty() {
            vec![placed(Mat4::IDENTITY)]
        } else {
            object.instances.iter().map(|copy| placed(product(copy))).collect()
        };
        Ok(Part {
            mesh,
            is_ball: matches!(object.shape, Shape::Sphere { .. }),
            materials: surfaces.iter().map(|surface| surface.material).collect(),
            surfaces,
            world_from_object,
            traced: OnceLock::new(),
        })
    }

    /// The shape as the ray tracer wants it. A mesh's hierarchy is built the first time and shared by all copies.
    pub(crate) fn traced_shape(&self) -> raytrace::Shape {
        if self.is_ball {
            return raytrace::Shape::Sphere(Sphere::new(Vec3::ZERO, 1.0));
        }
        let traced = self.traced.get_or_init(|| Arc::new(TracedMesh::new(self.mesh.clone())));
        raytrace::Shape::Mesh(traced.clone())
    }

    /// The corners of the box around the mesh, object space; none if it is empty.
    pub(super) fn box_corners(&self) -> impl Iterator<Item = Vec3> + use<> {
        let Aabb { min, max } = self.mesh.aabb();
        let corner = move |k: u32| {
            let side = |axis: usize| if k >> axis & 1 == 0 { min[axis] } else { max[axis] };
            Vec3::new(side(0), side(1), side(2))
        };
        let count = if self.mesh.is_empty() { 0 } else { 8 };
        (0..count).map(corner)
    }

    /// The corners of the boxes around all copies.
    pub(super) fn corners_world(&self) -> impl Iterator<Item = Vec3> + '_ {
        self.world_from_object
            .iter()
            .flat_map(|matrix| self.box_corners().map(move |corner| matrix.transform_point3(corner)))
    }

    /// By how much the mesh has to be enlarged to hold all that the part stands for: of an exact ball, the mesh is inside.
    pub(super) fn outwards(&self) -> f32 {
        if !self.is_ball {
            return 1.0;
        }
        let distance = |k: usize| {
            let triangle = self.mesh.triangle(k);
            triangle.corners()[0].dot(triangle.normal().unwrap_or_default()).abs()
        };
        let least = (0..self.mesh.len()).map(distance).fold(1.0, f32::min);
        if least > 0.0 { 1.0 / least } else { 1.0 }
    }

    /// Refuses an object that its transforms carry out of the range in which `f32` can compute with areas.
    pub(super) fn check_place(&self, object: usize) -> Result<(), RenderError> {
        let is_near = |p: Vec3| p.abs().max_element() <= GREATEST_COORDINATE;
        let finite = self.world_from_object.iter().all(Mat4::is_finite);
        if finite && self.corners_world().all(is_near) {
            Ok(())
        } else {
            Err(RenderError::FarAway { object })
        }
    }
}

fn product(transforms: &[crate::Transform]) -> Mat4 {
    transforms.iter().fold(Mat4::IDENTITY, |before, transform| transform.matrix() * before)
}

/// The radius by which a unit shape is scaled.
fn radius(shape: &Shape) -> f32 {
    match *shape {
        Shape::Sphere { radius, .. } | Shape::UvSphere { radius, .. } | Shape::Icosphere { radius, .. } => {
            radius
        }
        _ => 1.0,
    }
}

/// Without a material of its own, an OBJ file's are taken, and grey for everything else.
fn file_surfaces(shape: &Shape, imports: &Imports) -> Vec<Surface> {
    let import = if let Shape::Obj { path, .. } = shape { imports.get(path) } else { None };
    match import {
        Some(import) if !import.materials.is_empty() => import.materials.iter().map(surface_of).collect(),
        _ => vec![Surface::default()],
    }
}

fn mesh(shape: &Shape, imports: &Imports) -> Result<Mesh, RenderError> {
    Ok(match shape {
        Shape::Sphere { level, .. } | Shape::Icosphere { level, .. } => shapes::icosphere(*level)?,
        Shape::UvSphere { level, .. } => shapes::uv_sphere(*level)?,
        Shape::Cuboid { size, level } => shapes::cuboid(*size, *level)?,
        Shape::Torus { major, minor, level } => shapes::torus(*major, *minor, *level)?,
        Shape::Disc { radius, level } => shapes::disc(*radius, *level)?,
        Shape::Teapot { level } => shapes::teapot(*level)?,
        Shape::Polygons { polygons } => fans(polygons)?,
        Shape::Obj { path, fit } => {
            let import = imports.get(path).ok_or_else(|| RenderError::NotLoaded { path: path.clone() })?;
            if *fit { fitted(&import.mesh)? } else { in_place(import)? }
        }
    })
}

/// Each polygon as a fan around its first corner.
fn fans(polygons: &[Vec<Vec3>]) -> Result<Mesh, MeshError> {
    let mut triangles = Vec::new();
    let mut first = 0_u32;
    for polygon in polygons {
        let corners = polygon.len() as u32;
        triangles.extend((1..corners.saturating_sub(1)).map(|k| [first, first + k, first + k + 1]));
        first += corners;
    }
    Mesh::new(polygons.concat(), triangles)
}

/// The mesh with the middle of its box at the origin and a half diagonal of 1; a mesh in one point is only moved.
///
/// In f64, so that meshes of any size and at any distance from the origin keep all the digits they have.
pub(crate) fn fitted(mesh: &Mesh) -> Result<Mesh, MeshError> {
    let bounds = mesh.aabb();
    if bounds.is_empty() {
        return Ok(mesh.clone());
    }
    let (min, max) = (bounds.min.as_dvec3(), bounds.max.as_dvec3());
    let (center, half_diagonal) = (0.5 * (min + max), 0.5 * (max - min).length());
    let scale = if half_diagonal > 0.0 { half_diagonal.recip() } else { 1.0 };
    // A position that no triangle uses may lie anywhere, also where it overflows; it is never seen.
    let place = |p: &Vec3| (scale * (p.as_dvec3() - center)).as_vec3().clamp(Vec3::MIN, Vec3::MAX);
    mesh.clone().with_positions(mesh.positions().iter().map(place).collect())
}

/// The mesh of a file where the file has it, to the digits that f32 has there.
fn in_place(import: &Import) -> Result<Mesh, MeshError> {
    if import.origin == DVec3::ZERO {
        return Ok(import.mesh.clone());
    }
    let place = |p: &Vec3| (import.origin + p.as_dvec3()).as_vec3().clamp(Vec3::MIN, Vec3::MAX);
    import.mesh.clone().with_positions(import.mesh.positions().iter().map(place).collect())
}
