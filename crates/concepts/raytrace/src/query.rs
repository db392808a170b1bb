//! Which object does the ray meet first, and does it meet any at all? (L43, L47, L52)
//!
//! Each question is answered twice: by the slide's loop over all objects, and through the hierarchies. A law holds one
//! to the other, exactly: same object, same triangle, same t.

use geometry::{Barycentric, Ray};
use glam::Vec3;

use crate::object::Shape;
use crate::space::SpaceRay;
use crate::triangle::TriangleHit;
use crate::world::World;
use crate::{TracedMesh, fast};

/// How to search.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Search {
    /// Through the hierarchies of boxes.
    #[default]
    Hierarchy,
    /// By the slide's loop over everything.
    BruteForce,
}

/// What a ray met, and where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The place on the ray, e + t·d.
    pub t: f32,
    /// The object, by its place in [`World::objects`].
    pub object: usize,
    /// The triangle of the object's mesh; 0 for a sphere or plane.
    pub triangle: usize,
    /// The place in the triangle; corner a for a sphere or plane.
    pub weights: Barycentric,
    /// The point, world space. More accurate than e + t·d: it lies on the surface, to within rounding of its coordinates.
    pub point: Vec3,
    /// The geometric unit normal, world space, on the front: from where a triangle's corners run anticlockwise, outside a
    /// sphere.
    pub normal: Vec3,
    /// How far off the surface, along the normal, a ray that leaves here must start so as not to meet it again (E12).
    pub clearance: f32,
}

impl Hit {
    /// The geometric normal on the side from which `ray` came.
    #[must_use]
    pub fn normal_towards(&self, ray: &Ray) -> Vec3 {
        if self.is_front(ray) { self.normal } else { -self.normal }
    }

    /// Whether `ray` sees the front.
    #[must_use]
    pub fn is_front(&self, ray: &Ray) -> bool {
        self.normal.dot(ray.direction) <= 0.0
    }
}

/// The first half of a [`Hit`]: which object the ray hits, and where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HitRecord {
    /// The place on the ray, e + t·d.
    pub t: f32,
    /// The object, by its place in [`World::objects`].
    pub object: u32,
    /// The triangle of the object's mesh; 0 for a sphere or plane.
    pub triangle: u32,
    /// The place in the triangle; corner a for a sphere or plane.
    pub weights: Barycentric,
}

/// The hit with the smallest t of those with t0 < t < t1: the slide's loop over all objects (L43, L47).
///
/// Of several with equal t the lowest object wins, in it the lowest triangle.
///
/// - `ray`: world space, direction of any length.
/// - `None` too for a ray that is not finite or has no direction.
#[must_use]
pub fn nearest_brute(world: &World, ray: &Ray, t0: f32, t1: f32) -> Option<Hit> {
    let mut nearest = Nearest::new(t0, t1);
    nearest.in_all_objects(world, &SpaceRay::new(ray)?);
    nearest.met().map(|met| world.hit(ray, &met))
}

/// The same hit as [`nearest_brute`] finds, through the hierarchies: in the time of a few dozen boxes.
///
/// ```
/// use geometry::{Mesh, Ray};
/// use glam::{Mat4, Vec3, vec3};
/// use raytrace::{Object, Shape, Surface, TracedMesh, World, nearest, nearest_brute};
///
/// let corners = vec![vec3(0.0, 0.0, 0.0), vec3(4.0, 0.0, 0.0), vec3(0.0, 8.0, 0.0)];
/// let mesh = std::sync::Arc::new(TracedMesh::new(Mesh::new(corners, vec![[0, 1, 2]])?));
/// let behind = Mat4::from_translation(vec3(0.0, 0.0, -3.0));
/// let object = |at| Object::new(Shape::Mesh(mesh.clone()), at, vec![Surface::default()]);
/// let world = World::new(vec![object(behind)?, object(Mat4::IDENTITY)?], Vec::new());
///
/// let ray = Ray::new(vec3(1.0, 2.0, 5.0), vec3(0.0, 0.0, -1.0));
/// let hit = nearest(&world, &ray, 0.0, f32::INFINITY).unwrap();
/// assert_eq!((hit.object, hit.t, hit.weights.gamma, hit.normal), (1, 5.0, 0.25, Vec3::Z));
/// assert_eq!(nearest_brute(&world, &ray, 0.0, f32::INFINITY), Some(hit));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn nearest(world: &World, ray: &Ray, t0: f32, t1: f32) -> Option<Hit> {
    fast::nearest(world, ray, t0, t1).map(|met| world.hit(ray, &met))
}

/// Everything that the ray's line meets, −∞ < t < ∞, in the order in which the slide's loop comes to it (L43): object by
/// object, triangle by triangle.
///
/// [`nearest_brute`] keeps the one with the smallest t between t0 and t1.
#[must_use]
pub fn all_met(world: &World, ray: &Ray) -> Vec<HitRecord> {
    let Some(ray) = SpaceRay::new(ray) else { return Vec::new() };
    let mut all = Vec::new();
    for (k, object) in world.objects().iter().enumerate() {
        let ray = object.ray_from_world(&ray);
        let met = |triangle, hit: TriangleHit| HitRecord {
            t: hit.t,
            object: k as u32,
            triangle,
            weights: hit.weights,
        };
        match object.shape() {
            Shape::Mesh(traced) => all.extend(traced.hits(&ray).map(|(triangle, hit)| met(triangle, hit))),
            shape => {
                let hit = |t| met(0, TriangleHit { t, weights: Barycentric::A });
                all.extend(shape.crossings(&ray).map(hit));
            }
        }
    }
    all
}

/// Whether anything is met with t0 < t < t1, by the slide's loop (L56).
#[must_use]
pub fn any_hit_brute(world: &World, ray: &Ray, t0: f32, t1: f32) -> bool {
    nearest_brute(world, ray, t0, t1).is_some()
}

/// Whether anything is met with t0 < t < t1, through the hierarchies: for shadow rays, which need not know what (L56).
#[must_use]
pub fn any_hit(world: &World, ray: &Ray, t0: f32, t1: f32) -> bool {
    fast::any_hit(world, ray, t0, t1)
}

/// The best hit so far.
pub(crate) struct Nearest {
    t0: f32,
    t1: f32,
    object: u32,
    best: Option<HitRecord>,
}

impl Nearest {
    pub(crate) fn new(t0: f32, t1: f32) -> Self {
        Self { t0, t1, object: 0, best: None }
    }

    /// What was best, in the end.
    pub(crate) fn met(&self) -> Option<HitRecord> {
        self.best
    }

    /// Where hits may lie that are still of interest, ends included: an equally near one may win the tie.
    pub(crate) fn interval(&self) -> (f32, f32) {
        (self.t0, self.best.map_or(self.t1, |best| best.t))
    }

    /// Takes the hit if it is better than the best so far.
    #[inline]
    pub(crate) fn offer(&mut self, triangle: u32, hit: TriangleHit) {
        let key = (self.object, triangle);
        let better = match &self.best {
            None => self.t0 < hit.t && hit.t < self.t1,
            Some(best) => {
                self.t0 < hit.t && (hit.t < best.t || hit.t == best.t && key < (best.object, best.triangle))
            }
        };
        if better {
            self.best = Some(HitRecord { t: hit.t, object: self.object, triangle, weights: hit.weights });
        }
    }

    /// The next hits are on this object.
    pub(crate) fn enter(&mut self, object: usize) {
        self.object = object as u32;
    }

    /// Offers every hit of the slide's loop (L43).
    pub(crate) fn in_all_objects(&mut self, world: &World, ray: &SpaceRay) {
        for k in 0..world.objects().len() {
            self.in_object(world, k, ray, TracedMesh::nearest_brute);
        }
    }

    /// Offers the hits on one object; `in_mesh` says how its triangles are searched.
    #[inline(always)]
    pub(crate) fn in_object(
        &mut self,
        world: &World,
        k: usize,
        ray: &SpaceRay,
        in_mesh: impl FnOnce(&TracedMesh, &SpaceRay, &mut Self),
    ) {
        let object = &world.objects()[k];
        let ray = object.ray_from_world(ray);
        self.object = k as u32;
        match object.shape() {
            Shape::Mesh(traced) => in_mesh(traced, &ray, self),
            shape => {
                for t in shape.crossings(&ray) {
                    self.offer(0, TriangleHit { t, weights: Barycentric::A });
                }
            }
        }
    }
}

impl World {
    /// All about what was met: the point, the normal, and how far off the surface the next ray must start.
    ///
    /// - `ray`: the one that met it, world space.
    #[must_use]
    pub fn hit(&self, ray: &Ray, met: &HitRecord) -> Hit {
        let HitRecord { t, object, triangle, weights } = *met;
        let (object, triangle) = (object as usize, triangle as usize);
        let ray = SpaceRay::of(ray);
        let thing = &self.objects()[object];
        let p_object = thing.ray_from_world(&ray).at(f64::from(t));
        let (point, normal) = thing.point_and_normal(triangle, weights, p_object);
        let far = ray.origin.abs().max_element() + f64::from(t).abs() * ray.direction.abs().max_element();
        let clearance = clearance(point.abs().max_element(), thing.scale() + far);
        Hit { t, object, triangle, weights, point: point.as_vec3(), normal, clearance }
    }
}

/// How far off a surface a ray must start so as not to meet it again (E12).
///
/// The point lies on the surface but for two errors. Rounding it, and then the start of the new ray, to f32 moves each
/// coordinate by at most 2⁻²⁴ of it, twice; along a unit normal that is at most 2·√3·2⁻²⁴ of the largest coordinate:
/// four f32 epsilons (8·2⁻²⁴) are more than twice as much. What was computed before that, in f64, is wrong by a few
/// times 2⁻⁵³ of the numbers involved: 2⁻⁴⁰ leaves room for thousands of roundings.
fn clearance(largest_coordinate: f64, numbers_involved: f64) -> f32 {
    const OF_THE_POINT: f64 = 4.0 * f32::EPSILON as f64;
    const OF_THE_COMPUTATION: f64 = 1.0 / (1_u64 << 40) as f64;
    (OF_THE_POINT * largest_coordinate + OF_THE_COMPUTATION * numbers_involved) as f32
}
