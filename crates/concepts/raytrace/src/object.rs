//! Where is a shape in the world, and how does a ray find into its space?

use std::sync::Arc;

use geometry::{Aabb, Barycentric, Plane, Sphere};
use glam::{DAffine3, DMat3, DVec3, Mat4, Vec3};

use crate::TracedMesh;
use crate::space::SpaceRay;
use crate::surface::Surface;
use crate::triangle::watertight::point_in_plane;

/// The form of a thing, in its own space.
#[derive(Clone, Debug)]
pub enum Shape {
    /// Triangles, shared by all objects that have the same ones.
    Mesh(Arc<TracedMesh>),
    /// An exact ball.
    Sphere(Sphere),
    /// An unbounded plane.
    Plane(Plane),
}

impl Shape {
    /// The t at which a ray in the shape's space crosses a sphere or plane; nothing for a mesh.
    pub(crate) fn crossings(&self, ray: &SpaceRay) -> impl Iterator<Item = f32> + use<> {
        let both = match self {
            Self::Mesh(_) => [None; 2],
            Self::Sphere(s) => crate::sphere::crossings(ray, s).map_or([None; 2], |both| both.map(Some)),
            Self::Plane(p) => [crate::plane::crossing(ray, p), None],
        };
        both.into_iter().flatten().map(|t| t as f32)
    }
}

/// A shape somewhere in the world.
#[derive(Clone, Debug)]
pub struct Object {
    shape: Shape,
    surfaces: Vec<Surface>,
    world_from_object: DAffine3,
    object_from_world: DAffine3,
    /// Turns normals: the inverse transpose of the map. Under a map that mirrors, the front stays the front.
    normal_matrix: DMat3,
    /// Around the object in the world; `None` for a plane.
    bounds: Option<Aabb>,
    /// Whether the map is the identity, so that a ray need not be carried anywhere.
    is_in_place: bool,
    /// The size of the numbers that arise between the object's space and the world's.
    scale: f64,
}

/// Why there is no such object.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ObjectError {
    /// The matrix cannot be undone, so that no ray finds into the object's space.
    #[error("the transform {0} flattens space or is not finite: every axis must keep a length")]
    Singular(Mat4),
    /// The last row is not (0, 0, 0, 1).
    #[error("the transform {0} is not affine: its last row must be 0 0 0 1")]
    NotAffine(Mat4),
    /// No surface was given.
    #[error("an object needs at least one surface")]
    NoSurface,
    /// Its coordinates leave the range of f32.
    #[error("the object is too large, or too far away, for 32-bit numbers")]
    TooLarge,
    /// A radius, centre or normal that makes no shape.
    #[error(
        "a sphere needs a finite centre and a positive radius, a plane a finite offset and a normal that is not zero"
    )]
    Degenerate,
}

impl Object {
    /// The shape, carried into the world by an affine map.
    ///
    /// - `surfaces`: by the mesh's material index; an index beyond the list means the last surface. Spheres and planes
    ///   have the first.
    ///
    /// # Errors
    /// [`ObjectError`] if the map is not affine, cannot be undone or leads out of range, if there is no surface, or if
    /// a sphere or plane is degenerate.
    ///
    /// ```
    /// use geometry::Sphere;
    /// use glam::{Mat4, Vec3, vec3};
    /// use raytrace::{Object, Shape, Surface};
    ///
    /// let ball = Shape::Sphere(Sphere::new(Vec3::ZERO, 1.0));
    /// let egg = Mat4::from_scale(vec3(1.0, 1.4, 1.0));
    /// assert!(Object::new(ball.clone(), egg, vec![Surface::default()]).is_ok());
    /// assert!(Object::new(ball, Mat4::from_scale(vec3(1.0, 0.0, 1.0)), vec![Surface::default()]).is_err());
    /// ```
    pub fn new(shape: Shape, world_from_object: Mat4, surfaces: Vec<Surface>) -> Result<Self, ObjectError> {
        if surfaces.is_empty() {
            return Err(ObjectError::NoSurface);
        }
        if world_from_object.row(3) != glam::Vec4::W {
            return Err(ObjectError::NotAffine(world_from_object));
        }
        let forth = DAffine3::from_mat4(world_from_object.as_dmat4());
        let back = forth.inverse();
        if !(forth.matrix3.determinant() != 0.0 && back.is_finite() && forth.is_finite()) {
            return Err(ObjectError::Singular(world_from_object));
        }
        let (bounds, scale) = extent(&shape, &forth)?;
        let normal_matrix = back.matrix3.transpose();
        Ok(Self {
            shape,
            surfaces,
            world_from_object: forth,
            object_from_world: back,
            normal_matrix,
            bounds,
            is_in_place: forth == DAffine3::IDENTITY,
            scale,
        })
    }

    /// The shape, in its own space.
    #[must_use]
    pub fn shape(&self) -> &Shape {
        &self.shape
    }

    /// The surface of a triangle; see [`Object::new`] for indices beyond the list.
    #[must_use]
    pub fn surface(&self, triangle: usize) -> &Surface {
        let material = match &self.shape {
            Shape::Mesh(traced) => traced.mesh().material(triangle) as usize,
            Shape::Sphere(_) | Shape::Plane(_) => 0,
        };
        &self.surfaces[material.min(self.surfaces.len() - 1)]
    }

    /// The corners of a triangle of a mesh, world space; `None` for other shapes.
    #[must_use]
    pub fn corners(&self, triangle: usize) -> Option<[Vec3; 3]> {
        let Shape::Mesh(traced) = &self.shape else {
            return None;
        };
        let corners = traced.mesh().triangle(triangle).corners();
        if self.is_in_place {
            return Some(corners);
        }
        Some(corners.map(|corner| self.to_world(corner.as_dvec3()).as_vec3()))
    }

    /// The unit normals at the corners of a triangle, world space, on the side of its front; `None` for other shapes
    /// and where the mesh has none.
    #[must_use]
    pub fn corner_normals(&self, triangle: usize) -> Option<[Vec3; 3]> {
        let Shape::Mesh(traced) = &self.shape else {
            return None;
        };
        let normals = traced.mesh().corner_normals(triangle)?;
        if self.is_in_place {
            // A mesh's normals have unit length.
            return Some(normals);
        }
        let normals = normals.map(|n| self.normal_to_world(n.as_dvec3()));
        normals.iter().all(|n| *n != Vec3::ZERO).then_some(normals)
    }

    pub(crate) fn surfaces(&self) -> &[Surface] {
        &self.surfaces
    }

    /// Whether the object's space is the world's.
    pub(crate) fn is_in_place(&self) -> bool {
        self.is_in_place
    }

    /// A ray of the world in the object's space.
    #[inline(always)]
    pub(crate) fn ray_from_world(&self, ray: &SpaceRay) -> SpaceRay {
        if self.is_in_place { *ray } else { ray.transformed(&self.object_from_world) }
    }

    pub(crate) fn bounds(&self) -> Option<Aabb> {
        self.bounds
    }

    pub(crate) fn scale(&self) -> f64 {
        self.scale
    }

    /// The point that a ray hit near `p_object`, exactly on the surface, and the unit normal there; world space.
    pub(crate) fn point_and_normal(
        &self,
        triangle: usize,
        weights: Barycentric,
        p_object: DVec3,
    ) -> (DVec3, Vec3) {
        let (p, n) = match &self.shape {
            Shape::Mesh(traced) => {
                let corners = traced.mesh().triangle(triangle).corners();
                let [a, b, c] = corners.map(|corner| corner.as_dvec3());
                (point_in_plane(&corners, weights), (b - a).cross(c - a).normalize_or_zero())
            }
            Shape::Sphere(sphere) => {
                let p = crate::sphere::onto(sphere, p_object);
                (p, (p - sphere.center.as_dvec3()).normalize_or_zero())
            }
            Shape::Plane(plane) => {
                (crate::plane::onto(plane, p_object), plane.normal.as_dvec3().normalize_or_zero())
            }
        };
        (self.to_world(p), self.normal_to_world(n))
    }

    fn normal_to_world(&self, n_object: DVec3) -> Vec3 {
        if self.is_in_place {
            return n_object.as_vec3();
        }
        (self.normal_matrix * n_object).normalize_or_zero().as_vec3()
    }

    fn to_world(&self, p_object: DVec3) -> DVec3 {
        if self.is_in_place {
            return p_object;
        }
        self.world_from_object.transform_point3(p_object)
    }
}

/// Rounding of a box to f32, several times over, as a share of its largest coordinate.
const BOX_SLACK: f64 = 4.0 * f32::EPSILON as f64;

/// The box around the shape in the world, and the size of the numbers on the way there.
fn extent(shape: &Shape, world_from_object: &DAffine3) -> Result<(Option<Aabb>, f64), ObjectError> {
    let object_box = match shape {
        Shape::Mesh(traced) => traced.aabb(),
        Shape::Sphere(sphere) if sphere.center.is_finite() && sphere.radius > 0.0 => sphere.aabb(),
        Shape::Plane(plane) if plane.offset.is_finite() && plane.normal.try_normalize().is_some() => {
            return Ok((None, world_from_object.translation.length() + f64::from(plane.offset.abs())));
        }
        Shape::Sphere(_) | Shape::Plane(_) => return Err(ObjectError::Degenerate),
    };
    if object_box.is_empty() {
        return Ok((Some(Aabb::EMPTY), 0.0));
    }
    let corners = object_box.corners().map(|corner| corner.as_dvec3());
    let sizes = corners.map(|corner| {
        let m = &world_from_object.matrix3;
        (m.x_axis * corner.x).abs() + (m.y_axis * corner.y).abs() + (m.z_axis * corner.z).abs()
    });
    let scale = sizes.into_iter().fold(0.0, |size: f64, s| size.max(s.max_element()))
        + world_from_object.translation.abs().max_element();
    let slack = BOX_SLACK * scale;
    let world = corners.map(|corner| world_from_object.transform_point3(corner));
    let min = world.into_iter().fold(DVec3::INFINITY, DVec3::min) - slack;
    let max = world.into_iter().fold(DVec3::NEG_INFINITY, DVec3::max) + slack;
    let bounds = Aabb { min: min.as_vec3(), max: max.as_vec3() };
    if bounds.min.is_finite() && bounds.max.is_finite() {
        Ok((Some(bounds), scale))
    } else {
        Err(ObjectError::TooLarge)
    }
}
