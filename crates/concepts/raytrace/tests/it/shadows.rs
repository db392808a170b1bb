//! No surface throws a shadow on itself by rounding (E12).

use std::sync::Arc;

use canvas::Rgb;
use geometry::{Mesh, Plane, Ray, Sphere, shapes};
use glam::{Mat4, Vec3, vec3};
use lighting::{Illumination, Light, Material};
use raytrace::shadow::{is_lit, light_share};
use raytrace::{Hit, Interpolation, Object, Search, Shape, Surface, TracedMesh, World, local_color, nearest};

/// How many shadow tests were made, and how many of them saw the surface itself.
#[derive(Debug, Default, PartialEq)]
struct Count {
    tests: usize,
    false_shadows: usize,
}

/// Looks at the only object of a world, which must be convex, with a grid of rays from `eye`, and sends a shadow ray
/// wherever the normal looks to the light.
fn self_shadows(world: &World, eye: Vec3, target: Vec3, radius: f32, lights: &[Light]) -> Count {
    const N: i32 = 120;
    let (u, v) = (target - eye).normalize().any_orthonormal_pair();
    let mut count = Count::default();
    for k in 0..N * N {
        let place = |k: i32| (k as f32 + 0.37) / N as f32 * 2.0 - 1.0;
        let ray = Ray::through(eye, target + radius * (place(k % N) * u + place(k / N) * v));
        let Some(hit) = nearest(world, &ray, 0.0, f32::INFINITY) else {
            continue;
        };
        for light in lights.iter().filter_map(|light| light.illumination(hit.point)) {
            if seen_normal(world, &ray, &hit).dot(light.to_light) > 0.0 {
                count.tests += 1;
                count.false_shadows += usize::from(!is_lit(world, &ray, &hit, &light));
            }
        }
    }
    count
}

fn seen_normal(world: &World, ray: &Ray, hit: &Hit) -> Vec3 {
    let n = world.shading_normal(hit);
    if hit.is_front(ray) { n } else { -n }
}

fn world_of(shape: Shape, map: Mat4, interpolation: Interpolation) -> World {
    let mut world = World::new(vec![Object::new(shape, map, vec![Surface::default()]).unwrap()], Vec::new());
    world.interpolation = interpolation;
    world
}

fn lights(center: Vec3, radius: f32) -> [Light; 3] {
    let color = Rgb::ONE;
    [
        Light::Directional { to_light: vec3(0.48, 0.6, 0.64), color },
        Light::Point { position: center + radius * vec3(1.3, 0.9, -0.4), color },
        Light::Point { position: center + radius * vec3(-40.0, 13.0, 90.0), color },
    ]
}

/// An instance of unit radius about the origin, blown up, squashed and carried away.
fn far_away() -> Mat4 {
    Mat4::from_translation(vec3(3000.0, -500.0, 70.0)) * Mat4::from_scale(vec3(7.0, 5.0, 6.0))
}

#[test]
fn a_ball_at_distance_3_30_and_300_has_no_false_shadow() {
    let mesh = Arc::new(TracedMesh::new(shapes::icosphere(3).unwrap()));
    let shapes = [
        (Shape::Sphere(Sphere::new(Vec3::ZERO, 1.0)), Interpolation::Phong),
        (Shape::Mesh(mesh.clone()), Interpolation::Flat),
        (Shape::Mesh(mesh.clone()), Interpolation::Gouraud),
        (Shape::Mesh(mesh), Interpolation::Phong),
    ];
    for (shape, interpolation) in shapes {
        for (map, center, radius) in [
            (Mat4::IDENTITY, Vec3::ZERO, 1.0),
            (Mat4::from_translation(vec3(31.0, -7.0, 12.0)), vec3(31.0, -7.0, 12.0), 1.0),
            (far_away(), vec3(3000.0, -500.0, 70.0), 7.0),
        ] {
            let world = world_of(shape.clone(), map, interpolation);
            for distance in [3.0, 30.0, 300.0] {
                let eye = center + distance * radius * vec3(0.36, 0.48, 0.8);
                let count = self_shadows(&world, eye, center, radius, &lights(center, radius));
                assert!(count.tests > 4000, "{count:?}");
                assert_eq!(count.false_shadows, 0, "{interpolation:?} at {distance}: {count:?}");
            }
        }
    }
}

#[test]
fn a_plane_and_a_box_have_no_false_shadow() {
    let tilted = Plane::new(vec3(1.0, -2.0, 0.5), vec3(0.2, 1.0, -0.3).normalize());
    let cuboid = Shape::Mesh(Arc::new(TracedMesh::new(shapes::cuboid(vec3(1.0, 2.0, 3.0), 2).unwrap())));
    for distance in [3.0, 30.0, 300.0, 3000.0] {
        let eye = distance * vec3(0.36, 0.8, 0.48);
        for shape in [Shape::Plane(tilted), cuboid.clone()] {
            let world = world_of(shape, Mat4::from_rotation_y(0.3), Interpolation::Flat);
            let count = self_shadows(&world, eye, Vec3::ZERO, 1.0, &lights(Vec3::ZERO, 2.0));
            assert!(count.tests > 4000, "{count:?}");
            assert_eq!(count.false_shadows, 0, "{distance}: {count:?}");
        }
    }
}

#[test]
fn a_shadow_ray_without_offset_meets_its_own_surface() {
    // E12: the slide's ray p + t·l with t > 0 starts on the surface, as f32 rounds it: on this ball, inside every other
    // time.
    let world = world_of(Shape::Sphere(Sphere::new(Vec3::ZERO, 1.0)), Mat4::IDENTITY, Interpolation::Phong);
    let to_light = vec3(0.48, 0.6, 0.64);
    let mut count = Count::default();
    for k in 0..1000 {
        let ray = Ray::through(vec3(1.0, 2.0, 30.0), vec3(0.0, 0.6 * (k as f32 / 1000.0), 0.0));
        let hit = nearest(&world, &ray, 0.0, f32::INFINITY).unwrap();
        if hit.normal.dot(to_light) > 0.0 {
            count.tests += 1;
            let slide = Ray::new(hit.point, to_light);
            count.false_shadows += usize::from(raytrace::any_hit(&world, &slide, 0.0, f32::INFINITY));
        }
    }
    assert!(count.false_shadows > count.tests / 10, "{count:?}");
}

#[test]
fn a_point_light_throws_no_shadow_of_what_lies_behind_it() {
    let wall = |z: f32| Shape::Plane(Plane::new(vec3(0.0, 0.0, z), Vec3::Z));
    let object = |z| Object::new(wall(z), Mat4::IDENTITY, vec![Surface::default()]).unwrap();
    let lamp = Light::Point { position: vec3(1.0, 2.0, 3.0), color: Rgb::ONE };
    let world = World::new(vec![object(0.0), object(9.0)], vec![lamp]);
    let ray = Ray::new(vec3(0.0, 0.0, 5.0), Vec3::NEG_Z);
    let hit = nearest(&world, &ray, 0.0, f32::INFINITY).unwrap();
    let light = lamp.illumination(hit.point).unwrap();
    assert!(is_lit(&world, &ray, &hit, &light));
    // E12: the slide's t in [0, ∞] finds the wall behind the lamp.
    assert!(!is_lit(&world, &ray, &hit, &Illumination { distance: f32::INFINITY, ..light }));
}

#[test]
fn what_stands_between_throws_its_shadow() {
    let floor =
        Object::new(Shape::Plane(Plane::new(Vec3::ZERO, Vec3::Y)), Mat4::IDENTITY, vec![Surface::default()]);
    let ball = Shape::Sphere(Sphere::new(vec3(0.0, 2.0, 0.0), 1.0));
    let sun = Light::Directional { to_light: Vec3::Y, color: Rgb::ONE };
    let ambient = Light::Ambient { color: Rgb::splat(0.25) };
    let matt = Surface::opaque(Material::matt(Rgb::ONE));
    let world = World::new(
        vec![floor.unwrap(), Object::new(ball, Mat4::IDENTITY, vec![matt]).unwrap()],
        vec![sun, ambient],
    );
    let below_the_ball = Ray::through(vec3(8.0, 1.0, 0.0), vec3(0.5, 0.0, 0.0));
    let beside_it = Ray::through(vec3(8.0, 1.0, 0.0), vec3(1.5, 0.0, 0.0));
    let diffuse = Material::default().diffuse;
    assert_eq!(local_color(&world, &below_the_ball, 0.0, 99.0), 0.25 * diffuse);
    assert!(local_color(&world, &beside_it, 0.0, 99.0).x > diffuse.x);
}

#[test]
fn glass_throws_a_tinted_shadow() {
    let tint = Rgb::new(0.9, 0.5, 0.1);
    let glass = Surface {
        material: Material::matt(Rgb::ZERO),
        optics: raytrace::Optics::Glass { refractive_index: 1.5, transmittance: tint },
    };
    let ball = Object::new(Shape::Sphere(Sphere::new(vec3(0.0, 2.0, 0.0), 1.0)), Mat4::IDENTITY, vec![glass]);
    let floor =
        Object::new(Shape::Plane(Plane::new(Vec3::ZERO, Vec3::Y)), Mat4::IDENTITY, vec![Surface::default()]);
    let world = World::new(vec![ball.unwrap(), floor.unwrap()], Vec::new());
    let ray = Ray::through(vec3(8.0, 0.5, 0.0), vec3(0.25, 0.0, 0.0));
    let hit = nearest(&world, &ray, 0.0, 9.0).unwrap();
    let sun = Illumination { to_light: Vec3::Y, distance: f32::INFINITY, color: Rgb::ONE };
    // In and out again: twice the tint.
    assert_eq!(light_share(&world, &ray, &hit, &sun, Search::Hierarchy), tint * tint);
    assert_eq!(light_share(&world, &ray, &hit, &sun, Search::BruteForce), tint * tint);
}

#[test]
fn a_coarse_mesh_has_no_dark_triangles_where_the_smooth_surface_is_lit() {
    // An icosphere of 80 triangles: many faces near the terminator look away from the light, but not their normals.
    let coarse = shapes::icosphere(1).unwrap();
    let smooth = world_of(
        Shape::Mesh(Arc::new(TracedMesh::new(coarse.clone()))),
        Mat4::IDENTITY,
        Interpolation::Phong,
    );
    let eye = vec3(2.0, -3.0, 1.5);
    let count = self_shadows(&smooth, eye, Vec3::ZERO, 1.0, &lights(Vec3::ZERO, 1.0));
    assert!(count.tests > 4000 && count.false_shadows == 0, "{count:?}");

    // The same from the flat faces.
    let faces_away = |ray: &Ray, hit: &Hit| {
        let to_light = vec3(0.48, 0.6, 0.64);
        seen_normal(&smooth, ray, hit).dot(to_light) > 0.0 && hit.normal_towards(ray).dot(to_light) < 0.0
    };
    let mut dark = 0;
    for k in 0..10_000 {
        let ray = Ray::through(eye, vec3((k % 100) as f32 / 50.0 - 1.0, 0.0, (k / 100) as f32 / 50.0 - 1.0));
        dark += usize::from(nearest(&smooth, &ray, 0.0, 9.0).is_some_and(|hit| faces_away(&ray, &hit)));
    }
    assert!(dark > 100, "{dark}");
}

/// A mesh that is only a square of two triangles, to be seen from either side.
#[test]
fn the_back_of_an_open_surface_is_lit_as_well() {
    let corners =
        vec![vec3(-1.0, 0.0, -1.0), vec3(1.0, 0.0, -1.0), vec3(1.0, 0.0, 1.0), vec3(-1.0, 0.0, 1.0)];
    let mesh = Mesh::new(corners, vec![[0, 1, 2], [0, 2, 3]]).unwrap();
    let shape = Shape::Mesh(Arc::new(TracedMesh::new(mesh)));
    let world = world_of(shape, Mat4::from_rotation_z(0.4), Interpolation::Phong);
    for eye in [vec3(0.3, 5.0, 0.7), vec3(0.3, -5.0, 0.7)] {
        let light = Light::Point { position: 2.0 * eye + Vec3::X, color: Rgb::ONE };
        let count = self_shadows(&world, eye, Vec3::ZERO, 0.5, &[light]);
        assert_eq!(count, Count { tests: 120 * 120, false_shadows: 0 });
    }
}
