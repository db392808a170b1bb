//! What is one object, to a renderer? A mesh, its surfaces, and a matrix for each copy.

use std::sync::{Arc, OnceLock};

use geometry::obj::Import;
use geometry::polygon::{MOST_TESTS, Shape as Outline, triangulate};
use geometry::{Aabb, Mesh, MeshError, Sphere, shapes};
use glam::{DVec3, Mat4, Vec3};
use lighting::Material;
use raytrace::{Optics, Surface, TracedMesh};

use super::smoothing::smooth;
use crate::RenderError;
use crate::limits::{FAR_IN_SIZES, GREATEST_COORDINATE};
use crate::load::Imports;
use crate::mtl::{material_of, surface_of};
use crate::scene::{Object, Scene, Shape};

/// One object of the scene, ready to draw: its mesh, surfaces and copies.
#[derive(Debug)]
pub(crate) struct PreparedObject {
    pub(crate) mesh: Mesh,
    /// Whether `mesh` stands for the unit ball, which the ray tracer has exactly.
    is_ball: bool,
    /// What the mesh's material numbers point into; at least one.
    pub(crate) surfaces: Vec<Surface>,
    /// The materials as rasterizers want them: all opaque.
    pub(crate) materials: Vec<Material>,
    /// One for each copy.
    pub(crate) world_from_object: Vec<Mat4>,
    traced: OnceLock<Arc<TracedMesh>>,
}

impl PreparedObject {
    /// The mesh, surfaces and places of one object.
    pub(super) fn new(
        object: &Object,
        scene: &Scene,
        imports: &Imports,
    ) -> Result<PreparedObject, RenderError> {
        let import = if let Shape::Obj { path, .. } = &object.shape { imports.get(path) } else { None };
        let (surfaces, materials) = match (&object.material, import) {
            // The reader has seen to it that the name is known.
            (Some(name), _) => {
                let surface = scene.materials.get(name).copied().unwrap_or_default();
                (vec![surface], vec![surface.material])
            }
            (None, Some(import)) if !import.materials.is_empty() => (
                import.materials.iter().map(surface_of).collect(),
                import.materials.iter().map(material_of).collect(),
            ),
            (None, _) => (vec![Surface::default()], vec![Material::default()]),
        };
        let groups = import.map_or(&[][..], |import| &import.smoothing);
        let mesh = smooth(mesh(&object.shape, imports)?, groups, object.crease_degrees.to_radians());
        let mesh = without_invisible(mesh, &surfaces);
        let world_from_shape = product(&object.transforms);
        let shape_from_object = Mat4::from_scale(Vec3::splat(radius(&object.shape)));
        let placed = |copy: Mat4| copy * world_from_shape * shape_from_object;
        let world_from_object = if object.instances.is_empty() {
            vec![placed(Mat4::IDENTITY)]
        } else {
            object.instances.iter().map(|copy| placed(product(copy))).collect()
        };
        Ok(PreparedObject {
            is_ball: matches!(object.shape, Shape::Sphere { .. }) && !mesh.is_empty(),
            mesh,
            materials,
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

    /// Says so if a copy lies so far from the origin that f32 rounds its shape visibly.
    pub(super) fn distance_warning(&self, object: usize) -> Option<String> {
        let corners: Vec<Vec3> = self.corners_world().collect();
        let boxes = corners.chunks(8).map(|copy| Aabb::from_points(copy.iter().copied()));
        let is_far = |copy: &Aabb| {
            let distance = copy.min.abs().max(copy.max.abs()).max_element();
            distance > FAR_IN_SIZES * copy.size().max_element()
        };
        let far = boxes.filter(|copy| copy.size().max_element() > 0.0).find(is_far)?;
        Some(format!(
            "object {object} (counted from 0) is {:.1} wide but lies up to {:.1} from the origin, where f32 positions have steps \
             of {:.1e}: its shape is rounded visibly; move the scene to the origin, eye and lights too",
            far.size().max_element(),
            far.min.abs().max(far.max.abs()).max_element(),
            f32::EPSILON * far.min.abs().max(far.max.abs()).max_element(),
        ))
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

/// The mesh without the triangles that cannot be seen at all: those of opacity 0.
fn without_invisible(mesh: Mesh, surfaces: &[Surface]) -> Mesh {
    let is_invisible = |surface: &Surface| surface.optics == Optics::Dissolved { opacity: 0.0 };
    if !surfaces.iter().any(is_invisible) {
        return mesh;
    }
    // As everywhere, a number beyond the list means its last surface.
    let surface = |k: usize| &surfaces[(mesh.material(k) as usize).min(surfaces.len() - 1)];
    mesh.filtered(|k| !is_invisible(surface(k)))
}

fn mesh(shape: &Shape, imports: &Imports) -> Result<Mesh, RenderError> {
    Ok(match shape {
        Shape::Sphere { level, .. } | Shape::Icosphere { level, .. } => shapes::icosphere(*level)?,
        Shape::UvSphere { level, .. } => shapes::uv_sphere(*level)?,
        Shape::Cuboid { size, level } => shapes::cuboid(*size, *level)?,
        Shape::Torus { major, minor, level } => shapes::torus(*major, *minor, *level)?,
        Shape::Disc { radius, level } => shapes::disc(*radius, *level)?,
        Shape::Teapot { level } => shapes::teapot(*level)?,
        Shape::Polygons { polygons } => cut(polygons)?,
        Shape::Obj { path, fit } => {
            let import = imports.get(path).ok_or_else(|| RenderError::NotLoaded { path: path.clone() })?;
            if *fit { fitted(&import.mesh)? } else { in_place(import)? }
        }
    })
}

/// Each polygon cut into triangles, a re-entrant one too, as the faces of an OBJ file are.
fn cut(polygons: &[Vec<Vec3>]) -> Result<Mesh, MeshError> {
    let (mut triangles, mut first, mut tests_left) = (Vec::new(), 0_u32, MOST_TESTS);
    for polygon in polygons {
        let points: Vec<DVec3> = polygon.iter().map(|corner| corner.as_dvec3()).collect();
        // The reader has refused polygons for which the tests run out.
        let (own, _) = triangulate(&points, &mut tests_left).unwrap_or((Vec::new(), Outline::WithoutArea));
        triangles.extend(own.iter().map(|corners| corners.map(|corner| first + corner as u32)));
        first += polygon.len() as u32;
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
