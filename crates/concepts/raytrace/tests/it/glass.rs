//! Where do mirrors and glass send a ray, and how much of it? Places and shares, known without the code.

use std::sync::Arc;

use canvas::Rgb;
use geometry::{Barycentric, Indexed, Mesh, Plane, Ray, Sphere};
use glam::{Mat4, Vec3, vec3};
use lighting::{Light, Material};
use raytrace::{
    Object, Optics, Settings, Shape, Surface, TracedMesh, World, any_hit, nearest, optics, ray_color, shadow,
};
use testkit::assert_close;

const EPS: f32 = f32::EPSILON;

fn object(shape: Shape, surface: Surface) -> Object {
    Object::new(shape, Mat4::IDENTITY, vec![surface]).unwrap()
}

fn black(optics: Optics) -> Surface {
    Surface { material: Material::matt(Rgb::ZERO), optics }
}

fn glass(refractive_index: f32) -> Optics {
    Optics::Glass { refractive_index, transmittance: Rgb::ONE }
}

fn color(world: &World, ray: Ray) -> Rgb {
    ray_color(world, &ray, 0.0, f32::INFINITY, &Settings::default())
}

/// The triangle z = 0 around the origin, its front up for the order 0, 1, 2, with the same normal `n` at its corners.
fn tilted(corner_order: [u32; 3], n: Vec3, optics: Optics) -> Object {
    let corners = vec![vec3(-3.0, -2.0, 0.0), vec3(4.0, -3.0, 0.0), vec3(0.5, 5.0, 0.0)];
    let normals = Indexed { values: vec![n.normalize()], triangles: vec![[0; 3]] };
    let mesh = Mesh::new(corners, vec![corner_order]).unwrap().with_normals(normals).unwrap();
    object(Shape::Mesh(Arc::new(TracedMesh::new(mesh))), black(optics))
}

#[test]
fn at_brewsters_angle_only_light_across_the_plane_is_reflected() {
    // Where tan θ = n, refracted and reflected ray are at right angles, and light that swings along the plane of incidence
    // is not reflected. Across it the share is ((1 − n²) / (1 + n²))², and half the light swings that way.
    for n in [1.3_f32, 1.5, 2.4] {
        let cos = (1.0 + n * n).sqrt().recip();
        let across = (1.0 - n * n) / (1.0 + n * n);
        // A dozen roundings of numbers around 1.
        assert_close("share", optics::fresnel(cos, n.recip()), 0.5 * across * across, 12.0 * EPS);
    }
}

#[test]
fn a_ball_of_glass_is_a_burning_glass() {
    // Rays along the axis meet at n / (2 (n − 1)) radii behind the middle: at 1.5 for n = 1.5, nearer for those off the
    // axis. A ray at a tenth of the radius misses that place by about a thousandth.
    let lamp = Surface::opaque(Material::matt(Rgb::ONE));
    let world = World::new(
        vec![
            object(Shape::Sphere(Sphere::new(Vec3::ZERO, 1.0)), black(glass(1.5))),
            object(Shape::Sphere(Sphere::new(vec3(0.0, 0.0, -1.5), 0.02)), lamp),
        ],
        vec![Light::Ambient { color: Rgb::ONE }],
    );
    for (x, y) in [(0.1, 0.0), (-0.06, 0.08), (0.0, -0.1)] {
        // Each surface reflects 0.04 of it.
        let through = color(&world, Ray::new(vec3(x, y, 5.0), Vec3::NEG_Z)).x;
        assert!((0.9..0.95).contains(&through), "{through} of the lamp is seen at ({x}, {y})");
    }
    assert!(color(&world, Ray::new(vec3(0.8, 0.0, 5.0), Vec3::NEG_Z)).x < 0.1);
}

#[test]
fn glass_has_its_own_colour_on_its_front_only() {
    let surface = Surface { material: Material::matt(Rgb::splat(0.25)), optics: glass(1.0) };
    let ball = object(Shape::Sphere(Sphere::new(vec3(0.2, -0.1, 0.3), 1.0)), surface);
    let mut world = World::new(vec![ball], vec![Light::Ambient { color: Rgb::ONE }]);
    world.background = Rgb::splat(0.5);
    let seen = color(&world, Ray::new(vec3(0.3, 0.1, 5.0), vec3(0.05, 0.0, -1.0)));
    // Of index 1: nothing is bent or reflected, and the background is seen through two surfaces, one of them a front.
    assert_close("colour", seen, Rgb::splat(0.25 + 0.5), 4.0 * EPS);
}

#[test]
fn a_mirror_with_smooth_normals_never_sends_a_ray_into_itself() {
    // The normal leans so far that it would mirror this ray into the face; the face's own mirrors it into the open.
    let half = Optics::Mirror { reflectance: Rgb::splat(0.5) };
    let mut world = World::new(vec![tilted([0, 1, 2], vec3(-1.0, 0.0, 1.0), half)], Vec::new());
    world.background = Rgb::ONE;
    for d in [vec3(-1.0, 0.0, -0.2), vec3(-1.0, 0.1, -0.3)] {
        assert!(optics::mirrored(d, vec3(-1.0, 0.0, 1.0).normalize()).z < 0.0);
        assert_eq!(color(&world, Ray::new(-2.0 * d, d)), Rgb::splat(0.5), "{d}");
    }
}

#[test]
fn glass_with_smooth_normals_never_sends_a_ray_back_through_its_face() {
    // Seen from behind, so from inside the glass; the normals lean so far that Snell's law about them would let the ray
    // out on the side that it came from. Then all of it is reflected.
    let n = vec3(-0.6, 0.0, 0.8);
    let d = vec3(0.98, 0.0, -0.2).normalize();
    assert!(optics::refracted(d, n, 1.5).is_some_and(|behind| behind.z > 0.0));
    let half = Optics::Glass { refractive_index: 1.5, transmittance: Rgb::splat(0.5) };
    let mut world = World::new(vec![tilted([0, 2, 1], -n, half)], Vec::new());
    world.background = Rgb::ONE;
    assert_eq!(color(&world, Ray::new(-2.0 * d, d)), Rgb::ONE);
}

#[test]
fn beside_glass_too_nothing_behind_a_lamp_throws_a_shadow() {
    let floor = object(Shape::Plane(Plane::new(Vec3::ZERO, Vec3::Y)), Surface::default());
    let ceiling = object(Shape::Plane(Plane::new(vec3(0.0, 5.0, 0.0), Vec3::NEG_Y)), Surface::default());
    let far_ball = object(Shape::Sphere(Sphere::new(vec3(50.0, 1.0, 0.0), 1.0)), black(glass(1.5)));
    let world = World::new(vec![floor, ceiling, far_ball], Vec::new());
    let ray = Ray::new(vec3(1.0, 2.0, 0.5), vec3(-0.5, -1.0, 0.25));
    let hit = nearest(&world, &ray, 0.0, f32::INFINITY).unwrap();
    let lamp = |y: f32| Light::Point { position: vec3(0.3, y, 0.2), color: Rgb::ONE };
    for (y, share) in [(4.0, Rgb::ONE), (6.0, Rgb::ZERO)] {
        let light = lamp(y).illumination(hit.point).unwrap();
        let both = [raytrace::Search::Hierarchy, raytrace::Search::BruteForce];
        let shares = both.map(|search| shadow::light_share(&world, &ray, &hit, &light, search));
        assert_eq!(shares, [share; 2], "lamp at {y}");
    }
}

#[test]
fn where_a_mesh_is_hollow_shadow_rays_start_from_the_face() {
    // Normals that lean inwards: the smooth surface would lie below the face, in which no ray may start.
    let corners = [vec3(-1.0, -2.0, 0.0), vec3(3.0, -1.0, 0.0), vec3(0.5, 2.5, 0.0)];
    let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    let lean = |sign: f32| corners.map(|c| (Vec3::Z + sign * 0.3 * (c - middle)).normalize());
    let weights = Barycentric::from_beta_gamma(0.3, 0.45);
    let p = weights.interpolate(corners[0], corners[1], corners[2]);
    let start = |sign: f32| shadow::onto_smooth_surface(p, corners, lean(sign), weights);
    assert_eq!(start(-1.0), p);
    assert!(start(1.0).z > p.z + 0.1);
}

#[test]
fn a_hit_on_a_plane_lies_on_it_whatever_the_length_of_its_normal() {
    let plane = Plane { normal: vec3(0.5, 3.0, -1.0), offset: 2.0 };
    let world = World::new(vec![object(Shape::Plane(plane), Surface::default())], Vec::new());
    let hit =
        nearest(&world, &Ray::new(vec3(1.0, 7.0, 2.0), vec3(0.2, -1.0, 0.4)), 0.0, f32::INFINITY).unwrap();
    // Coordinates below 8, rounded once, times the normal's.
    assert_close("n · p", plane.normal.dot(hit.point), plane.offset, (0.5 + 3.0 + 1.0) * 8.0 * EPS);
}

#[test]
fn a_mesh_too_small_for_the_boxes_arithmetic_still_throws_a_shadow() {
    // In the mesh's own space the ray starts at 10³¹, beyond what the tests of boxes may multiply.
    let ball = geometry::shapes::icosphere(1).unwrap();
    let shape = Shape::Mesh(Arc::new(TracedMesh::new(ball)));
    let object = Object::new(shape, Mat4::from_scale(Vec3::splat(1e-25)), vec![Surface::default()]).unwrap();
    let world = World::new(vec![object], Vec::new());
    let ray = Ray::new(vec3(0.0, 0.0, 1e6), Vec3::NEG_Z);
    assert!(nearest(&world, &ray, 0.0, f32::INFINITY).is_some());
    assert!(any_hit(&world, &ray, 0.0, f32::INFINITY));
}

#[test]
fn glass_bends_a_ray_about_the_smooth_normal() {
    let n = vec3(0.3, 0.0, 1.0).normalize();
    let bent = optics::refracted(Vec3::NEG_Z, n, 1.5_f32.recip()).unwrap();
    // Bent by 16.7° − 11.0°: two units farther that is 0.2 beside the straight way.
    assert!(bent.x < -0.09);
    let lamp = Surface::opaque(Material::matt(Rgb::ONE));
    let ball = object(Shape::Sphere(Sphere::new(2.0 * bent, 0.05)), lamp);
    let world =
        World::new(vec![tilted([0, 1, 2], n, glass(1.5)), ball], vec![Light::Ambient { color: Rgb::ONE }]);
    assert!(color(&world, Ray::new(3.0 * Vec3::Z, Vec3::NEG_Z)).x > 0.9);
}
