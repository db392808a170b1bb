//! The fast search finds what the slide's loop finds, bit by bit: one ray or eight, whatever they are aimed at, at any scale.

use std::sync::Arc;

use geometry::{Mesh, Plane, Ray, Sphere, Triangle, shapes};
use glam::{Mat4, Vec3, vec3};
use proptest::prelude::*;
use raytrace::fast::{any_hit_each, nearest_each};
use raytrace::{HitRecord, Object, Shape, Surface, TracedMesh, World, any_hit_brute, nearest_brute};
use testkit::{Law, Outcome, ensure, strategy};

fn traced(mesh: Mesh) -> Shape {
    Shape::Mesh(Arc::new(TracedMesh::new(mesh)))
}

fn object(shape: Shape, map: Mat4) -> Object {
    Object::new(shape, map, vec![Surface::default()]).expect("a map that can be undone")
}

/// Two meshes that stand in several places, a sphere and a plane.
fn world(maps: &[Mat4]) -> World {
    let (round, sharp) =
        (shapes::torus(2.0, 0.75, 2).unwrap(), shapes::cuboid(vec3(1.0, 2.0, 3.0), 2).unwrap());
    let [round, sharp] = [round, sharp].map(|mesh| Arc::new(TracedMesh::new(mesh)));
    let shape = |k: usize| match k % 5 {
        0 | 2 => Shape::Mesh(round.clone()),
        1 => Shape::Mesh(sharp.clone()),
        3 => Shape::Sphere(Sphere::new(vec3(0.2, -0.1, 0.3), 1.5)),
        _ => Shape::Plane(Plane::new(vec3(0.0, -1.0, 0.0), vec3(0.1, 1.0, 0.2).normalize())),
    };
    World::new(maps.iter().enumerate().map(|(k, map)| object(shape(k), *map)).collect(), Vec::new())
}

/// The first map is the identity: a mesh in place takes a shorter way.
fn maps() -> impl Strategy<Value = Vec<Mat4>> {
    let others = proptest::collection::vec(strategy::affine(5.0), 0..8);
    others.prop_map(|others| std::iter::once(Mat4::IDENTITY).chain(others).collect())
}

/// A fan of rays from a point: at a corner, at the middle of an edge, along that edge, then beside them, ever farther.
fn fan(triangle: &Triangle, from: Vec3, step: Vec3, count: usize) -> Vec<Ray> {
    let Triangle { a, b, .. } = *triangle;
    let target = |k: usize| match k % 3 {
        0 => a,
        1 => 0.5 * (a + b),
        _ => a + 0.25 * (b - a),
    };
    (0..count).map(|k| Ray::through(from, target(k) + (k / 3) as f32 * step)).collect()
}

fn met(world: &World, ray: &Ray, t0: f32, t1: f32) -> Option<HitRecord> {
    let hit = nearest_brute(world, ray, t0, t1)?;
    Some(HitRecord {
        t: hit.t,
        object: hit.object as u32,
        triangle: hit.triangle as u32,
        weights: hit.weights,
    })
}

/// Both questions, all rays at once, against the slide's loop for each.
fn same_answers(world: &World, rays: &[Ray], t0: f32, t1: f32) -> Outcome {
    let mut nearest = vec![None; rays.len()];
    nearest_each(world, rays, t0, t1, &mut nearest);
    // Ends of their own: where the first hit is, and a little beyond.
    let ends: Vec<f32> = nearest
        .iter()
        .enumerate()
        .map(|(k, met)| met.map_or(t1, |met: HitRecord| if k % 2 == 0 { met.t } else { met.t + met.t.abs() }))
        .collect();
    let mut any = vec![false; rays.len()];
    any_hit_each(world, rays, t0, &ends, &mut any);
    for (k, ray) in rays.iter().enumerate() {
        let slow = met(world, ray, t0, t1);
        ensure(nearest[k] == slow, || format!("ray {k}, {ray:?}: fast {:?}, slow {slow:?}", nearest[k]))?;
        let slow = any_hit_brute(world, ray, t0, ends[k]);
        ensure(any[k] == slow, || format!("ray {k}, {ray:?}: any hit fast {}, slow {slow}", any[k]))?;
    }
    Ok(())
}

/// Aims at triangles of the torus, of which there are as many as this at least.
const AIMS: usize = 500;

#[test]
fn packets_and_the_slides_loop_find_the_same() {
    Law::new("eight rays at once find what the slide's loop finds for each, bit by bit")
        .cases(300)
        .demand("hit", 0.3)
        .demand("several objects", 0.5)
        .demand("narrow", 0.3)
        .demand("before t0 = 0", 0.2)
        .holds_for(
            (maps(), 0..AIMS, strategy::point(6.0), strategy::point(1.0), -4_i8..0, any::<bool>()),
            |(maps, aim, from, step, narrow, behind), seen| {
                let world = world(&maps);
                let corners = world.objects()[0].corners(aim).unwrap();
                let triangle = Triangle::new(corners[0], corners[1], corners[2]);
                let rays = fan(&triangle, from, 10_f32.powi(narrow.into()) * step, 21);
                let t0 = if behind { -3.0 } else { 0.0 };
                seen.class("hit", met(&world, &rays[0], t0, f32::INFINITY).is_some());
                seen.class("several objects", maps.len() > 2);
                seen.class("narrow", narrow < -2);
                seen.class("before t0 = 0", behind);
                same_answers(&world, &rays, t0, f32::INFINITY)
            },
        );
}

#[test]
fn shadow_rays_to_a_lamp_and_to_the_sun_find_the_same() {
    Law::new("rays from many places to one lamp, and side by side to the sun, find the same")
        .cases(200)
        .holds_for(
            (maps(), 0..AIMS, strategy::point(6.0), any::<bool>()),
            |(maps, aim, light, is_sun), _| {
                let world = world(&maps);
                let start = |k: usize| {
                    let [a, b, c] = world.objects()[0].corners(aim + k / 4).unwrap();
                    let weights = [(0.5, 0.25), (0.1, 0.8), (0.0, 0.5), (0.0, 0.0)][k % 4];
                    a + weights.0 * (b - a) + weights.1 * (c - a)
                };
                let ray = |k: usize| {
                    if is_sun { Ray::new(start(k), light) } else { Ray::through(start(k), light) }
                };
                same_answers(
                    &world,
                    &(0..16).map(ray).collect::<Vec<_>>(),
                    0.0,
                    if is_sun { 9.0 } else { 1.0 },
                )
            },
        );
}

#[test]
fn the_same_is_found_at_any_scale_and_any_distance() {
    // Sizes and places for which f32 loses all digits of a triangle, and sizes near the ends of its range.
    let ball = shapes::icosphere(2).unwrap();
    Law::new("however small, large or far away a mesh is, the fast search finds what the slide's loop finds")
        .cases(400)
        .demand("tiny", 0.2)
        .demand("huge", 0.2)
        .demand("hit", 0.2)
        .holds_for(
            (-20_i32..20, strategy::point(1.0), -6_i32..6, 0..320_usize, strategy::point(3.0)),
            |(scale, at, distance, aim, from), seen| {
                let size = 10_f32.powi(scale);
                let center = size * 10_f32.powi(distance) * at;
                let positions = ball.positions().iter().map(|p| size * *p + center).collect();
                let mesh = ball.clone().with_positions(positions).unwrap();
                let triangle = mesh.triangle(aim);
                let world = World::new(vec![object(traced(mesh), Mat4::IDENTITY)], Vec::new());
                let rays = fan(&triangle, center + size * from, 0.01 * size * at, 16);
                seen.class("tiny", scale < -10);
                seen.class("huge", scale > 8);
                seen.class("hit", met(&world, &rays[0], 0.0, f32::INFINITY).is_some());
                same_answers(&world, &rays, 0.0, f32::INFINITY)
            },
        );
}

#[test]
fn the_first_of_equal_triangles_is_found_and_those_without_area_are_not() {
    let mesh = shapes::icosphere(2).unwrap();
    let needle = |[a, b, _]: &[u32; 3]| [*a, *b, *a];
    let twice = mesh.triangles().iter().flat_map(|t| [needle(t), *t, *t, [t[1], t[2], t[0]]]).collect();
    let world = World::new(
        vec![object(traced(Mesh::new(mesh.positions().to_vec(), twice).unwrap()), Mat4::IDENTITY)],
        Vec::new(),
    );
    Law::new("a mesh with every triangle three times, once turned round, and with needles")
        .cases(200)
        .holds_for((0..mesh.len(), strategy::point(3.0), strategy::point(0.1)), |(aim, from, step), _| {
            same_answers(&world, &fan(&mesh.triangle(aim), from, step, 16), 0.0, f32::INFINITY)
        });
}

/// Without optimization an eighth of the million: the whole takes ten seconds there.
const AIMED: usize = if cfg!(debug_assertions) { 1 << 17 } else { 1 << 20 };

#[test]
fn no_ray_from_inside_a_ball_slips_through_a_corner_or_an_edge() {
    let mesh = shapes::icosphere(4).unwrap();
    let world = World::new(vec![object(traced(mesh.clone()), Mat4::IDENTITY)], Vec::new());
    let mut met = [None; 64];
    for block in 0..AIMED / 64 {
        // Points of an inner ball of radius 0.6, on a spiral.
        let turn = block as f32 * 2.399_963;
        let from = 0.6
            * (block as f32 * 0.618_034).fract()
            * vec3(turn.cos(), turn.sin(), (7.0 * turn).sin()).normalize();
        let rays = fan(&mesh.triangle(block % mesh.len()), from, Vec3::ZERO, 64);
        let rays: Vec<Ray> = rays
            .iter()
            .enumerate()
            .map(|(k, ray)| {
                // At corners and middles as they are; else anywhere along the edge.
                let Triangle { a, b, .. } = mesh.triangle((block + k) % mesh.len());
                if k % 3 == 2 { Ray::through(from, a + k as f32 / 64.0 * (b - a)) } else { *ray }
            })
            .collect();
        nearest_each(&world, &rays, 0.0, f32::INFINITY, &mut met);
        assert!(met.iter().all(Option::is_some), "from {from}, block {block}");
    }
}
