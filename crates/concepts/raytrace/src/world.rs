//! What is there to see, and what lights it? (L22, L43)

use canvas::Rgb;
use fearless_simd::Level;
use geometry::Aabb;
use glam::Vec3;
use lighting::{Highlight, Light};

use crate::fast::tree::Tree;
use crate::object::Object;
use crate::query::Hit;
use crate::surface::{Optics, Surface};

/// Where the normal comes from that the lighting model is given, and where the model is evaluated.
///
/// The three shadings of the rasterizer, by the same rules: L37, L38 and L40. A corner without a normal has the face's.
/// Spheres and planes have their exact normal in all three.
///
/// One rule turns normals to the eye: if the triangle's front (by its corner order, in world space) looks away from the
/// start of the ray, *all* its normals are negated, whichever way each of them looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Interpolation {
    /// One colour a triangle: the model at its centroid, with the normal of the face (L37).
    Flat,
    /// The model at the three corners with their normals, and the colours interpolated (L38).
    Gouraud,
    /// The normals interpolated and renormalized (E7), and the model at the point itself (L40).
    #[default]
    Phong,
}

/// Everything that a picture is made of, but for the camera.
#[derive(Clone, Debug)]
pub struct World {
    objects: Vec<Object>,
    tree: Tree,
    /// What the processor can do.
    level: Level,
    /// The planes, which fit into no box.
    unbounded: Vec<u32>,
    has_glass: bool,
    /// The longest side of the box around all that fits into one.
    size: f32,
    /// Any number of lights; their light adds up (L24).
    pub lights: Vec<Light>,
    /// What a ray sees that hits nothing (L55).
    pub background: Rgb,
    /// The form of the highlight (L31, L34).
    pub highlight: Highlight,
    /// The shading.
    pub interpolation: Interpolation,
}

impl World {
    /// The world of these objects and lights, with black background, Blinn's highlight and Phong shading.
    ///
    /// ```
    /// use canvas::Rgb;
    /// use geometry::{Ray, Sphere};
    /// use glam::{Mat4, Vec3, vec3};
    /// use raytrace::{Object, Shape, Surface, World, nearest};
    ///
    /// let ball = Shape::Sphere(Sphere::new(Vec3::ZERO, 1.0));
    /// let moved = Mat4::from_translation(vec3(0.0, 0.0, -5.0));
    /// let mut world = World::new(vec![Object::new(ball, moved, vec![Surface::default()])?], Vec::new());
    /// world.background = Rgb::new(0.1, 0.2, 0.4);
    /// assert_eq!(nearest(&world, &Ray::new(Vec3::ZERO, Vec3::NEG_Z), 0.0, 9.0).unwrap().t, 4.0);
    /// # Ok::<(), raytrace::ObjectError>(())
    /// ```
    #[must_use]
    pub fn new(objects: Vec<Object>, lights: Vec<Light>) -> Self {
        let boxes: Vec<Aabb> = objects.iter().map(|object| object.bounds().unwrap_or(Aabb::EMPTY)).collect();
        let unbounded =
            (0..objects.len()).filter(|k| objects[*k].bounds().is_none()).map(|k| k as u32).collect();
        let whole = boxes.iter().fold(Aabb::EMPTY, |whole, own| whole.union(*own));
        let is_glass =
            |surface: &Surface| matches!(surface.optics, Optics::Glass { .. } | Optics::Dissolved { .. });
        let has_glass = objects.iter().flat_map(Object::surfaces).any(is_glass);
        Self {
            tree: Tree::new(&boxes),
            level: Level::new(),
            objects,
            unbounded,
            has_glass,
            size: if whole.is_empty() { 0.0 } else { whole.size().max_element() },
            lights,
            background: Rgb::ZERO,
            highlight: Highlight::default(),
            interpolation: Interpolation::default(),
        }
    }

    /// The longest side of the box around all objects but planes.
    pub(crate) fn size(&self) -> f32 {
        self.size
    }

    /// The objects; a [`Hit`] names one by its place in this list.
    #[must_use]
    pub fn objects(&self) -> &[Object] {
        &self.objects
    }

    /// The surface that was hit.
    #[must_use]
    pub fn surface(&self, hit: &Hit) -> &Surface {
        self.objects[hit.object].surface(hit.triangle)
    }

    /// The unit normal for the lighting model, world space, on the side of the surface's front: that of the face, or,
    /// unless shading is flat and where the mesh has normals, the interpolated and renormalized one (E7).
    #[must_use]
    pub fn shading_normal(&self, hit: &Hit) -> Vec3 {
        if self.interpolation == Interpolation::Flat {
            return hit.normal;
        }
        let Some([n0, n1, n2]) = self.objects[hit.object].corner_normals(hit.triangle) else {
            return hit.normal;
        };
        // Opposite normals may cancel; then they say nothing.
        hit.weights.interpolate(n0, n1, n2).try_normalize().unwrap_or(hit.normal)
    }

    /// Whether any surface is glass or half transparent: else a shadow ray need not know what it meets.
    pub(crate) fn has_glass(&self) -> bool {
        self.has_glass
    }

    pub(crate) fn tree(&self) -> &Tree {
        &self.tree
    }

    pub(crate) fn level(&self) -> Level {
        self.level
    }

    pub(crate) fn unbounded(&self) -> &[u32] {
        &self.unbounded
    }
}
