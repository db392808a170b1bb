//! What color does a ray see? The slide's `raycolor` (L57), and what it grows into with mirrors and glass (L58).

use canvas::Rgb;
use geometry::Ray;
use glam::Vec3;
use lighting::{Highlight, Light, Material, SurfacePoint, lit};

use crate::optics::{fresnel, mirrored, refracted};
use crate::picture::Settings;
use crate::query::{Hit, Search, nearest, nearest_brute};
use crate::shadow::{is_lit, light_share};
use crate::surface::Optics;
use crate::world::{Interpolation, World};

/// The slide's `raycolor`: ambient light, and from each light that no object hides, diffuse light and highlight; the
/// background where nothing is hit with t0 < t < t1 (L55, L57).
///
/// Mirrors and glass are surfaces like any other here, and shading is Phong's. [`ray_color`] has the rest.
///
/// ```
/// use canvas::Rgb;
/// use geometry::{Ray, Sphere};
/// use glam::{Mat4, Vec3, vec3};
/// use lighting::{Light, Material};
/// use raytrace::{Object, Shape, Surface, World, local_color};
///
/// let surface = Surface::opaque(Material::matt(Rgb::new(0.5, 0.25, 1.0)));
/// let ball = Object::new(Shape::Sphere(Sphere::new(Vec3::ZERO, 1.0)), Mat4::IDENTITY, vec![surface])?;
/// let sun = Light::Directional { to_light: vec3(0.0, 0.8, 0.6), color: Rgb::ONE };
/// let world = World::new(vec![ball], vec![sun]);
/// // At (0, 0, 1) the normal is z, so n·l = 0.6.
/// let c = local_color(&world, &Ray::new(vec3(0.0, 0.0, 5.0), Vec3::NEG_Z), 0.0, f32::INFINITY);
/// assert!(c.abs_diff_eq(Rgb::new(0.3, 0.15, 0.6), 1e-6));
/// # Ok::<(), raytrace::ObjectError>(())
/// ```
#[must_use]
pub fn local_color(world: &World, ray: &Ray, t0: f32, t1: f32) -> Rgb {
    let Some(hit) = nearest(world, ray, t0, t1) else {
        return world.background;
    };
    let at = point_of_hit(world, ray, &hit);
    let material = &world.surface(&hit).material;
    lit(material, &world.lights, world.highlight, &at, |light| is_lit(world, ray, &hit, light))
}

/// The colour that a ray sees, recursively (L58): local light as in [`local_color`], by the world's shading, plus what
/// mirrors reflect and what glass reflects and lets through.
///
/// - The ray counts hits with t0 < t < t1; the rays that it gives rise to, from 0 to infinity.
/// - `settings.max_depth`: how many mirrors, glass and half-transparent surfaces may follow one another. A ray beyond
///   that sees the background, as if it left the scene; so does a ray that hits nothing, and one that can add no more
///   than [`LEAST_SHARE`] of what it sees.
/// - Glass lit from inside shows no highlight: local light counts only where a ray meets the front.
/// - Result: linear RGB, not clamped (E8).
#[must_use]
pub fn ray_color(world: &World, ray: &Ray, t0: f32, t1: f32, settings: &Settings) -> Rgb {
    color_of_share(world, ray, (t0, t1), 1.0, settings)
}

/// Share of a pixel's light below which a ray is not followed: 1/1024 of a step of an 8-bit file.
///
/// Glass splits each ray in two, so that n surfaces ask for up to 2ⁿ rays; all but a few of them carry next to nothing.
pub const LEAST_SHARE: f32 = 1.0 / (1024.0 * 255.0);

/// [`ray_color`] of a ray of which only `share` reaches the eye.
fn color_of_share(world: &World, ray: &Ray, (t0, t1): (f32, f32), share: f32, settings: &Settings) -> Rgb {
    let hit = match settings.search {
        Search::Hierarchy => nearest(world, ray, t0, t1),
        Search::BruteForce => nearest_brute(world, ray, t0, t1),
    };
    let Some(hit) = hit else { return world.background };
    let local = if shows_light(world, ray, &hit) { light_on(world, ray, &hit, settings) } else { Rgb::ZERO };
    let cast = Cast { world, ray, settings, share };
    with_optics(&cast, &hit, local)
}

/// Whether light on the surface counts: glass lit from inside shows none.
#[must_use]
pub fn shows_light(world: &World, ray: &Ray, hit: &Hit) -> bool {
    !matches!(world.surface(hit).optics, Optics::Glass { .. }) || hit.is_front(ray)
}

/// A ray that met a surface, and how much it counts.
pub(crate) struct Cast<'a> {
    pub(crate) world: &'a World,
    pub(crate) ray: &'a Ray,
    pub(crate) settings: &'a Settings,
    /// Share of what the ray sees that reaches the eye, 0 to 1; of the color channels, the largest.
    pub(crate) share: f32,
}

/// The local light, plus what a mirror reflects, glass reflects and lets through, or lies behind what is half transparent.
pub(crate) fn with_optics(cast: &Cast<'_>, hit: &Hit, local: Rgb) -> Rgb {
    match cast.world.surface(hit).optics {
        Optics::Opaque => local,
        Optics::Mirror { reflectance } => local + reflectance * reflected_color(cast, hit, reflectance),
        Optics::Glass { refractive_index, transmittance } => {
            local + glass_color(cast, hit, (refractive_index, transmittance))
        }
        Optics::Dissolved { opacity } => opacity * local + (1.0 - opacity) * color_behind(cast, hit, opacity),
    }
}

/// Where the lighting model is evaluated with Phong shading: at the hit, with the interpolated normal (L40, E7).
fn point_of_hit(world: &World, ray: &Ray, hit: &Hit) -> SurfacePoint {
    surface_point(ray, hit.point, shading_normal_towards(world, ray, hit))
}

fn surface_point(ray: &Ray, p_world: Vec3, n: Vec3) -> SurfacePoint {
    SurfacePoint { p_world, n, to_eye: (ray.origin - p_world).normalize_or(n) }
}

/// The shading normal by the one rule that turns it: if the front looks away from the ray's start, it is negated.
fn shading_normal_towards(world: &World, ray: &Ray, hit: &Hit) -> Vec3 {
    let n = world.shading_normal(hit);
    if hit.is_front(ray) { n } else { -n }
}

/// The light on the hit by the world's shading. Each light's shadow is that of the hit itself, whatever the shading:
/// interpolating shadows between corners would smear them over whole triangles.
fn light_on(world: &World, ray: &Ray, hit: &Hit, settings: &Settings) -> Rgb {
    let points = LightingPoints::new(world, ray, hit);
    let material = &world.surface(hit).material;
    let one_light = |light: &Light| {
        let unhindered = points.unhindered(material, light, world.highlight);
        match light.illumination(hit.point) {
            Some(arriving) if settings.shadows && unhindered != Rgb::ZERO => {
                unhindered * light_share(world, ray, hit, &arriving, settings.search)
            }
            _ => unhindered,
        }
    };
    world.lights.iter().map(one_light).sum()
}

/// Where the lighting model is evaluated, and with which weights: one point, or three for Gouraud shading (L37–L40).
pub(crate) struct LightingPoints {
    points: [(SurfacePoint, f32); 3],
    count: usize,
}

impl LightingPoints {
    pub(crate) fn new(world: &World, ray: &Ray, hit: &Hit) -> Self {
        let (points, count) = lighting_points(world, ray, hit);
        Self { points, count }
    }

    /// What one light gives where nothing hides it.
    pub(crate) fn unhindered(&self, material: &Material, light: &Light, highlight: Highlight) -> Rgb {
        self.points[..self.count].iter().fold(Rgb::ZERO, |sum, (at, weight)| {
            sum + *weight * lit(material, std::slice::from_ref(light), highlight, at, |_| true)
        })
    }
}

impl World {
    /// Where the lighting model is evaluated for the light on a hit, and by how much each evaluation counts: at one point, or
    /// at the three corners for Gouraud shading of a mesh (L37–L40).
    ///
    /// - `ray`: the one that hit, world space.
    #[must_use]
    pub fn lighting_points(&self, ray: &Ray, hit: &Hit) -> Vec<(SurfacePoint, f32)> {
        let (points, count) = lighting_points(self, ray, hit);
        points[..count].to_vec()
    }
}

fn lighting_points(world: &World, ray: &Ray, hit: &Hit) -> ([(SurfacePoint, f32); 3], usize) {
    let object = &world.objects()[hit.object];
    // Phong's shading needs no corners.
    let faceted = world.interpolation != Interpolation::Phong;
    match (world.interpolation, faceted.then(|| object.corners(hit.triangle)).flatten()) {
        (Interpolation::Flat, Some([a, b, c])) => {
            let centroid = (a + b + c) / 3.0;
            ([(surface_point(ray, centroid, hit.normal_towards(ray)), 1.0); 3], 1)
        }
        (Interpolation::Gouraud, Some(corners)) => {
            let normals = object.corner_normals(hit.triangle).unwrap_or([hit.normal; 3]);
            let side = if hit.is_front(ray) { 1.0 } else { -1.0 };
            let weights = hit.weights.to_vec3();
            let points =
                std::array::from_fn(|k| (surface_point(ray, corners[k], side * normals[k]), weights[k]));
            (points, 3)
        }
        _ => ([(point_of_hit(world, ray, hit), 1.0); 3], 1),
    }
}

/// What a mirror shows: the color that the reflected ray sees, of which `share` is used.
fn reflected_color(cast: &Cast<'_>, hit: &Hit, share: Rgb) -> Rgb {
    let ray = cast.ray;
    let n = hit.normal_towards(ray);
    let d = ray.direction.normalize_or(-n);
    let direction = mirrored(d, shading_normal_towards(cast.world, ray, hit));
    // A smooth normal can mirror the ray into the flat face; then the face's own normal does it.
    let direction = if direction.dot(n) > 0.0 { direction } else { mirrored(d, n) };
    follow(cast, Ray::new(hit.point + hit.clearance * n, direction), share)
}

/// What glass shows: by Fresnel's share the reflected ray, for the rest the refracted one.
///
/// A ray enters where it meets the front and leaves where it meets the back; the surface's own geometry decides that, the
/// smooth normal only bends.
fn glass_color(cast: &Cast<'_>, hit: &Hit, glass: (f32, Rgb)) -> Rgb {
    let ((index, transmittance), ray) = (glass, cast.ray);
    let ratio = if hit.is_front(ray) { index.recip() } else { index };
    let n_face = hit.normal_towards(ray);
    let d = ray.direction.normalize_or(-n_face);
    let smooth = shading_normal_towards(cast.world, ray, hit);
    let n = if smooth.dot(d) < 0.0 { smooth } else { n_face };

    let share = fresnel(-d.dot(n), ratio);
    let behind = refracted(d, n, ratio).filter(|direction| direction.dot(n_face) < 0.0);
    let Some(direction) = behind else {
        return reflected_color(cast, hit, Rgb::ONE);
    };
    let start = hit.point - hit.clearance * n_face;
    let passing = (1.0 - share) * transmittance;
    let passed = transmittance * follow(cast, Ray::new(start, direction), passing);
    share * reflected_color(cast, hit, Rgb::splat(share)) + (1.0 - share) * passed
}

/// What lies behind a half-transparent surface: the color that the ray sees when it goes straight on.
fn color_behind(cast: &Cast<'_>, hit: &Hit, opacity: f32) -> Rgb {
    let start = hit.point - hit.clearance * hit.normal_towards(cast.ray);
    follow(cast, Ray::new(start, cast.ray.direction), Rgb::splat(1.0 - opacity))
}

/// The color that a ray of the next generation sees, of which the caller uses `share`; the background when there may be no
/// such ray or when it would count for too little.
fn follow(cast: &Cast<'_>, ray: Ray, share: Rgb) -> Rgb {
    let share = cast.share * share.max_element();
    match cast.settings.max_depth.checked_sub(1) {
        Some(max_depth) if share >= LEAST_SHARE => {
            let settings = Settings { max_depth, ..*cast.settings };
            color_of_share(cast.world, &ray, (0.0, f32::INFINITY), share, &settings)
        }
        _ => cast.world.background,
    }
}
