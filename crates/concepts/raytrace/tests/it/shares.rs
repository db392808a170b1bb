//! How much of what a ray sees reaches the eye? Rays of which too little does are not followed.

use std::sync::Arc;

use canvas::Rgb;
use geometry::{Plane, Ray, Sphere, shapes};
use glam::{Mat4, Vec3, vec3};
use lighting::{Light, Material};
use raytrace::{
    LEAST_SHARE, Object, Optics, Search, Settings, Shape, Surface, TracedMesh, World, ray_color, render,
};
use testkit::assert_close;
use transforms::{Camera, Pipeline, ViewVolume};

fn plane(p: Vec3, n: Vec3, surface: Surface) -> Object {
    Object::new(Shape::Plane(Plane::new(p, n)), Mat4::IDENTITY, vec![surface]).unwrap()
}

/// A pane 4 wide, 3 high and 0.1 thick in the plane of this z.
fn pane(z: f32, optics: Optics) -> Object {
    let box_ = shapes::cuboid(vec3(4.0, 3.0, 0.1), 0).unwrap();
    let surface = Surface { material: Material::matt(Rgb::ZERO), optics };
    let at = Mat4::from_translation(vec3(0.0, 0.0, z));
    Object::new(Shape::Mesh(Arc::new(TracedMesh::new(box_))), at, vec![surface]).unwrap()
}

fn clear_glass() -> Optics {
    Optics::Glass { refractive_index: 1.5, transmittance: Rgb::ONE }
}

fn color(world: &World, ray: &Ray, max_depth: u32) -> Rgb {
    ray_color(world, ray, 0.0, f32::INFINITY, &Settings { max_depth, ..Settings::default() })
}

#[test]
fn mirror_image_too_faint_to_be_seen_is_the_background() {
    // Between two mirrors that face each other and return half: the k-th image counts 2⁻ᵏ, and 2⁻¹⁸ is less than the least
    // share. What comes after the 17th is the background, however deep the recursion may be.
    assert!(0.5_f32.powi(17) >= LEAST_SHARE && 0.5_f32.powi(18) < LEAST_SHARE);
    let surface = Surface {
        material: Material::matt(Rgb::splat(0.25)),
        optics: Optics::Mirror { reflectance: Rgb::splat(0.5) },
    };
    let left = plane(Vec3::ZERO, Vec3::X, surface);
    let right = plane(vec3(3.0, 0.0, 0.0), Vec3::NEG_X, surface);
    let world = World::new(vec![left, right], vec![Light::Ambient { color: Rgb::ONE }]);
    let ray = Ray::new(vec3(1.0, 0.0, 0.0), vec3(1.0, 0.1, 0.0));
    assert_ne!(color(&world, &ray, 16), color(&world, &ray, 17));
    assert_eq!(color(&world, &ray, 17), color(&world, &ray, 64));
}

#[test]
fn two_panes_of_glass_take_no_longer_however_deep_the_recursion() {
    // By the depth alone this would be 2³² rays. Clear glass before a white background takes nothing away.
    let mut world = World::new(vec![pane(0.0, clear_glass()), pane(-1.0, clear_glass())], Vec::new());
    world.background = Rgb::ONE;
    for direction in [vec3(0.1, 0.05, -1.0), vec3(0.8, 0.1, -0.5)] {
        let ray = Ray::new(-3.0 * direction, direction);
        // Thousands of shares are added up, each rounded.
        assert_close("color", color(&world, &ray, 32), Rgb::ONE, 1e-4);
    }
}

#[test]
fn half_transparent_surface_mixes_its_own_light_and_what_is_behind() {
    let ambient = vec![Light::Ambient { color: Rgb::ONE }];
    let world = |opacity: f32| {
        let surface =
            Surface { material: Material::matt(vec3(0.8, 0.4, 0.0)), optics: Optics::Dissolved { opacity } };
        let mut world = World::new(vec![plane(Vec3::ZERO, Vec3::Z, surface)], ambient.clone());
        world.background = vec3(0.0, 0.2, 1.0);
        world
    };
    let front = Ray::new(vec3(0.0, 0.0, 2.0), vec3(0.3, 0.1, -1.0));
    let back = Ray::new(vec3(0.0, 0.0, -2.0), vec3(0.3, 0.1, 1.0));
    for ray in [front, back] {
        // Two roundings of numbers up to 1.
        assert_close("half", color(&world(0.5), &ray, 3), vec3(0.4, 0.3, 0.5), 2.0 * f32::EPSILON);
        assert_eq!(color(&world(0.0), &ray, 3), vec3(0.0, 0.2, 1.0));
        assert_eq!(color(&world(1.0), &ray, 3), vec3(0.8, 0.4, 0.0));
    }
}

#[test]
fn half_transparent_surface_throws_half_a_shadow() {
    let floor = plane(Vec3::ZERO, Vec3::Y, Surface::opaque(Material::matt(Rgb::ONE)));
    let surface =
        Surface { material: Material::matt(Rgb::ZERO), optics: Optics::Dissolved { opacity: 0.25 } };
    let roof = plane(vec3(0.0, 5.0, 0.0), Vec3::Y, surface);
    let sun = Light::Directional { to_light: Vec3::Y, color: Rgb::ONE };
    let world = World::new(vec![floor, roof], vec![sun]);
    let seen = color(&world, &Ray::new(vec3(0.0, 1.0, 0.0), vec3(0.3, -1.0, 0.0)), 3);
    assert_close("light", seen, Rgb::splat(0.75), 2.0 * f32::EPSILON);
}

#[test]
fn both_searches_stop_at_the_same_rays() {
    let ball = Object::new(
        Shape::Sphere(Sphere::new(vec3(0.2, 0.1, -0.5), 0.4)),
        Mat4::IDENTITY,
        vec![Surface {
            material: Material::new(vec3(0.3, 0.6, 0.2), 20.0),
            optics: Optics::Dissolved { opacity: 0.4 },
        }],
    );
    let lamp = Light::Point { position: vec3(2.0, 3.0, 4.0), color: Rgb::ONE };
    let mut world =
        World::new(vec![pane(0.0, clear_glass()), ball.unwrap(), pane(-1.0, clear_glass())], vec![lamp]);
    world.background = vec3(0.1, 0.2, 0.4);
    let camera = Camera::look_at(vec3(1.5, 0.5, 4.0), Vec3::ZERO, Vec3::Y).unwrap();
    let volume = ViewVolume::from_fov_y(0.8, 1.5, -1.0, -20.0).unwrap();
    let pipeline = Pipeline::new(camera, volume, 9, 6).unwrap();
    let by = |search| {
        render(&world, &pipeline, &Settings { max_depth: 32, search, ..Settings::default() }, &|_| ())
    };
    assert_eq!(by(Search::Hierarchy), by(Search::BruteForce));
}
