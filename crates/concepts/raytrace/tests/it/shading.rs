//! The three shadings, mirrors and glass, seen through `ray_color`.

use std::sync::Arc;

use canvas::Rgb;
use geometry::{Barycentric, Indexed, Mesh, Plane, Ray, Sphere, shapes};
use glam::{Mat4, Vec3, vec3};
use lighting::{Highlight, Light, Material, SurfacePoint, lit};
use proptest::prelude::*;
use raytrace::{
    Interpolation, Object, Optics, Settings, Shape, Surface, TracedMesh, World, local_color, nearest,
    ray_color,
};
use testkit::{Law, assert_close, ensure_close, strategy};

const CORNERS: [Vec3; 3] = [vec3(-1.0, -2.0, 0.5), vec3(3.0, -1.0, -0.5), vec3(0.5, 2.5, 1.0)];

fn corner_normals() -> [Vec3; 3] {
    [vec3(-0.5, 0.1, 1.0), vec3(0.6, -0.2, 0.9), vec3(0.1, 0.5, 1.2)].map(Vec3::normalize)
}

fn surface() -> Surface {
    Surface::opaque(Material { diffuse: Rgb::new(0.7, 0.4, 0.2), specular: Rgb::splat(0.5), exponent: 12.0 })
}

fn lamps() -> Vec<Light> {
    vec![
        Light::Ambient { color: Rgb::new(0.1, 0.2, 0.1) },
        Light::Point { position: vec3(2.0, 3.0, 4.0), color: Rgb::new(0.9, 0.8, 0.7) },
    ]
}

/// One triangle with normals, its corners in the given order.
fn triangle_world(interpolation: Interpolation, corner_order: [u32; 3]) -> World {
    let normals = Indexed { values: corner_normals().to_vec(), triangles: vec![corner_order] };
    let mesh = Mesh::new(CORNERS.to_vec(), vec![corner_order]).unwrap().with_normals(normals).unwrap();
    let shape = Shape::Mesh(Arc::new(TracedMesh::new(mesh)));
    let mut world = World::new(vec![Object::new(shape, Mat4::IDENTITY, vec![surface()]).unwrap()], lamps());
    world.interpolation = interpolation;
    world
}

fn model(p_world: Vec3, n: Vec3, eye: Vec3) -> Rgb {
    let at = SurfacePoint { p_world, n, to_eye: (eye - p_world).normalize() };
    lit(&surface().material, &lamps(), Highlight::Blinn, &at, |_| true)
}

/// How far two computations of the lighting model at one point of the triangle lie apart.
///
/// Coordinates up to 4 put the point 6ε off: after division by the distance to lamp (at least 2.9) and eye (7) the
/// directions are off by 2ε and 1ε, and by 2ε each for their length; h, their sum (at least 1.6 long), by 6ε. Weights that
/// are off by 2ε, on top of interpolation and length, put n 6ε off. So h·n is off by 13.5ε with its own rounding, and its
/// 12th power times 0.5 · 0.9 by 5.4 times that: 73ε. Diffuse light adds 0.7 · 0.9 · 12ε.
const MODEL: f32 = 81.0 * f32::EPSILON;

#[test]
fn flat_gives_one_colour_a_triangle_gouraud_an_affine_one_and_phong_the_models_own() {
    let eye = vec3(0.5, 0.25, 8.0);
    Law::new("each shading is what its slide says").cases(200).demand("apart", 0.3).holds_for(
        strategy::inside(0.01),
        |weights: Barycentric, seen| {
            let p = weights.interpolate(CORNERS[0], CORNERS[1], CORNERS[2]);
            let color = |interpolation| {
                let world = triangle_world(interpolation, [0, 1, 2]);
                ray_color(&world, &Ray::through(eye, p), 0.0, f32::INFINITY, &Settings::default())
            };
            let face = (CORNERS[1] - CORNERS[0]).cross(CORNERS[2] - CORNERS[0]).normalize();
            let centroid = (CORNERS[0] + CORNERS[1] + CORNERS[2]) / 3.0;
            ensure_close("flat", color(Interpolation::Flat), model(centroid, face, eye), MODEL)?;

            let [n0, n1, n2] = corner_normals();
            let [c0, c1, c2] = [(0, n0), (1, n1), (2, n2)].map(|(k, n)| model(CORNERS[k], n, eye));
            let gouraud = weights.interpolate(c0, c1, c2);
            ensure_close("Gouraud", color(Interpolation::Gouraud), gouraud, MODEL)?;

            let phong = model(p, weights.interpolate(n0, n1, n2).normalize(), eye);
            ensure_close("Phong", color(Interpolation::Phong), phong, MODEL)?;
            seen.class("apart", phong.distance(gouraud) > 0.02);
            Ok(())
        },
    );
}

#[test]
fn a_triangle_that_shows_its_back_has_all_its_normals_negated() {
    // The other corner order: the face looks away from the eye, and the normals, as they stand, towards it. By the rule
    // they are negated, so the light before the triangle does not reach it.
    let eye = vec3(0.5, 0.25, 8.0);
    for interpolation in [Interpolation::Gouraud, Interpolation::Phong] {
        let world = triangle_world(interpolation, [0, 2, 1]);
        let ray = Ray::through(eye, (CORNERS[0] + CORNERS[1] + CORNERS[2]) / 3.0);
        let color = ray_color(&world, &ray, 0.0, f32::INFINITY, &Settings::default());
        let ambient = surface().material.diffuse * Rgb::new(0.1, 0.2, 0.1);
        assert_close("only ambient light", color, ambient, MODEL);
    }
    // Without normals the face's own is turned to the eye, and both orders look alike.
    let flat = [[0, 1, 2], [0, 2, 1]].map(|order| {
        let world = triangle_world(Interpolation::Flat, order);
        ray_color(&world, &Ray::through(eye, Vec3::ZERO), 0.0, f32::INFINITY, &Settings::default())
    });
    assert_close("flat", flat[0], flat[1], MODEL);
    assert!(flat[0].x > 0.2);
}

#[test]
fn a_mirroring_transform_keeps_fronts_in_front() {
    let mesh = shapes::icosphere(2).unwrap();
    let mirror = Mat4::from_scale(vec3(-1.5, 1.0, 0.7));
    let traced = |mesh| Shape::Mesh(Arc::new(TracedMesh::new(mesh)));
    let instance = Object::new(traced(mesh.clone()), mirror, vec![surface()]).unwrap();
    let moved =
        Object::new(traced(mesh.transformed(&mirror).unwrap()), Mat4::IDENTITY, vec![surface()]).unwrap();
    let ray = Ray::through(vec3(1.0, 2.0, 5.0), vec3(0.3, 0.1, 0.2));
    let [a, b] = [instance, moved].map(|object| {
        let world = World::new(vec![object], lamps());
        let hit = nearest(&world, &ray, 0.0, f32::INFINITY).unwrap();
        assert!(hit.is_front(&ray));
        (hit, world.shading_normal(&hit), local_color(&world, &ray, 0.0, f32::INFINITY))
    });
    // The moved corners, below 2, are rounded by ε/2 a coordinate; the ray is five long and meets the face at a cosine
    // above 0.3: t is off by 0.87ε / 1.5, and by ε/4 for its own rounding in either.
    assert_close("t", a.0.t, b.0.t, 2.0 * f32::EPSILON);
    // The same 0.87ε, at both ends of a height of 0.16 or more, put the weights 11ε off, between normals that are at most
    // 0.6 apart: 7ε. Each normal was transformed and brought to unit length in f32 once more: 4ε, and 2ε for their mean.
    assert_close("normal", a.1, b.1, 13.0 * f32::EPSILON);
    assert_close("colour", a.2, b.2, MODEL);
}

#[test]
fn without_mirrors_and_glass_the_recursive_colour_is_the_slides() {
    let mesh = Arc::new(TracedMesh::new(shapes::torus(1.5, 0.6, 2).unwrap()));
    let floor = Shape::Plane(Plane::new(vec3(0.0, -1.0, 0.0), vec3(0.1, 1.0, 0.0).normalize()));
    let objects = [Shape::Mesh(mesh), floor]
        .map(|shape| Object::new(shape, Mat4::from_rotation_x(0.4), vec![surface()]));
    let mut lights = lamps();
    lights.push(Light::Directional { to_light: vec3(0.48, 0.6, 0.64), color: Rgb::new(0.3, 0.2, 0.5) });
    let world = World::new(objects.map(Result::unwrap).to_vec(), lights);
    Law::new("ray_color is local_color where nothing mirrors")
        .demand("lit", 0.3)
        .demand("hit", 0.5)
        .holds_for((strategy::point(6.0), strategy::point(1.5)), |(from, to), seen| {
            let ray = Ray::through(from, to);
            let slide = local_color(&world, &ray, 0.0, f32::INFINITY);
            let ours = ray_color(&world, &ray, 0.0, f32::INFINITY, &Settings::default());
            seen.class("hit", slide != world.background);
            seen.class("lit", slide.max_element() > 0.2);
            // The same sum of at most ambient light, two diffuse and two specular terms in another order: four sums on
            // either side, each rounded by half an ε of what is there.
            ensure_close("colour", ours, slide, 2.0 * 4.0 * 0.5 * f32::EPSILON * slide.max_element())
        });
}

/// A black object of the given optics in a world of even light: only what mirrors and glass do is left.
fn even_world(shape: Shape, optics: Optics) -> World {
    let black = Surface { material: Material::matt(Rgb::ZERO), optics };
    let mut world = World::new(vec![Object::new(shape, Mat4::IDENTITY, vec![black]).unwrap()], lamps());
    world.background = Rgb::new(0.2, 0.5, 0.8);
    world
}

#[test]
fn a_clear_ball_in_even_light_is_invisible() {
    // What Fresnel reflects and what passes add up to all (L24): in a white furnace the ball vanishes, but for the rays
    // that max_depth cuts off, and those see the same background.
    let glass = Optics::Glass { refractive_index: 1.5, transmittance: Rgb::ONE };
    let ball = Shape::Sphere(Sphere::new(vec3(0.2, 0.1, -0.3), 1.0));
    let mesh = Shape::Mesh(Arc::new(TracedMesh::new(shapes::icosphere(3).unwrap())));
    for world in [even_world(ball, glass), even_world(mesh, glass)] {
        for max_depth in [0, 1, 5] {
            let settings = Settings { max_depth, ..Settings::default() };
            for k in 0..200 {
                let ray = Ray::through(
                    vec3(1.0, 2.0, 5.0),
                    vec3((k % 20) as f32 / 8.0 - 1.2, (k / 20) as f32 / 4.0 - 1.2, 0.0),
                );
                let color = ray_color(&world, &ray, 0.0, f32::INFINITY, &settings);
                // At most six times share · a + (1 − share) · b, of numbers below 1: four roundings by ε/2 each.
                assert_close("background", color, world.background, 6.0 * 4.0 * 0.5 * f32::EPSILON);
            }
        }
    }
}

#[test]
fn a_tinted_ball_tints_once_a_surface() {
    let tint = Rgb::new(0.9, 0.6, 0.3);
    // Index 1: nothing is bent and nothing reflected.
    let world = even_world(
        Shape::Sphere(Sphere::new(Vec3::ZERO, 1.0)),
        Optics::Glass { refractive_index: 1.0, transmittance: tint },
    );
    let ray = Ray::through(vec3(1.0, 2.0, 5.0), Vec3::ZERO);
    let color = ray_color(&world, &ray, 0.0, f32::INFINITY, &Settings::default());
    // Two products on either side, below 1.
    assert_close("twice the tint", color, tint * tint * world.background, 4.0 * 0.5 * f32::EPSILON);
}

#[test]
fn two_mirrors_face_to_face_reflect_as_often_as_max_depth_allows() {
    let mirror = Surface {
        material: Material::matt(Rgb::ZERO),
        optics: Optics::Mirror { reflectance: Rgb::splat(0.5) },
    };
    let wall = |z: f32| {
        Object::new(Shape::Plane(Plane::new(vec3(0.0, 0.0, z), Vec3::Z)), Mat4::IDENTITY, vec![mirror])
            .unwrap()
    };
    let mut world = World::new(vec![wall(-2.0), wall(3.0)], Vec::new());
    world.background = Rgb::ONE;
    for max_depth in [0, 1, 2, 10] {
        let settings = Settings { max_depth, ..Settings::default() };
        let color =
            ray_color(&world, &Ray::new(Vec3::ZERO, vec3(0.1, 0.0, 1.0)), 0.0, f32::INFINITY, &settings);
        // Each mirror halves, and the last ray, which may not go on, sees the background.
        assert_eq!(color, Rgb::splat(0.5_f32.powi(max_depth as i32 + 1)));
    }
}

#[test]
fn a_mirror_shows_what_is_before_it() {
    let mirror = Surface {
        material: Material::matt(Rgb::ZERO),
        optics: Optics::Mirror { reflectance: Rgb::new(1.0, 0.5, 0.25) },
    };
    let wall = Shape::Plane(Plane::new(vec3(0.0, 0.0, -2.0), Vec3::Z));
    let lamp = Surface::opaque(Material::matt(Rgb::new(0.8, 0.6, 0.4)));
    let ball = Shape::Sphere(Sphere::new(vec3(4.0, 0.0, 0.0), 0.5));
    let world = World::new(
        vec![
            Object::new(wall, Mat4::IDENTITY, vec![mirror]).unwrap(),
            Object::new(ball, Mat4::IDENTITY, vec![lamp]).unwrap(),
        ],
        vec![Light::Ambient { color: Rgb::ONE }],
    );
    // Down to the wall at (2, 0, −2) and up again to the ball.
    let ray = Ray::new(Vec3::ZERO, vec3(1.0, 0.0, -1.0));
    let color = ray_color(&world, &ray, 0.0, f32::INFINITY, &Settings::default());
    // One product by the light and one by the mirror, below 1.
    assert_close("the ball, by way of the mirror", color, Rgb::new(0.8, 0.3, 0.1), 2.0 * 0.5 * f32::EPSILON);
}

#[test]
fn materials_beyond_the_list_are_the_last_surface() {
    let mesh =
        Mesh::new(CORNERS.to_vec(), vec![[0, 1, 2], [0, 2, 1]]).unwrap().with_materials(vec![1, 7]).unwrap();
    let last = Surface::opaque(Material::matt(Rgb::X));
    let shape = Shape::Mesh(Arc::new(TracedMesh::new(mesh)));
    let object = Object::new(shape, Mat4::IDENTITY, vec![surface(), last]).unwrap();
    assert_eq!((*object.surface(0), *object.surface(1)), (last, last));
}

#[test]
fn colours_are_never_nan() {
    let number = || prop_oneof![Just(0.0_f32), Just(1e30), Just(-1e18), Just(1e-20), -2.0_f32..2.0];
    let vector = || (number(), number(), number()).prop_map(Vec3::from);
    let glass = Optics::Glass { refractive_index: 1.5, transmittance: Rgb::ONE };
    let mut world = even_world(Shape::Mesh(Arc::new(TracedMesh::new(shapes::icosphere(1).unwrap()))), glass);
    world.lights.push(Light::Point { position: Vec3::ZERO, color: Rgb::ONE });
    Law::new("no colour is NaN").cases(3000).demand("hit", 0.05).holds_for(
        (vector(), vector()),
        |(from, to), seen| {
            let ray = Ray::through(from, to);
            let color = ray_color(&world, &ray, 0.0, f32::INFINITY, &Settings::default());
            seen.class("hit", nearest(&world, &ray, 0.0, f32::INFINITY).is_some());
            testkit::ensure(color.is_finite(), || format!("{color}"))
        },
    );
}
