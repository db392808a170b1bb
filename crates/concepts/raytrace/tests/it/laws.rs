//! What holds for every ray, triangle and world.

use std::sync::Arc;

use geometry::{Mesh, Plane, Ray, Sphere, Triangle, shapes};
use glam::{Mat4, Vec3, vec3};
use proptest::prelude::*;
use raytrace::triangle::{Solution, System, cramer, elimination, inverse, raytri, system, watertight};
use raytrace::{Object, Shape, Surface, TracedMesh, World};
use raytrace::{any_hit, any_hit_brute, nearest, nearest_brute, optics, viewing_ray, visible_interval};
use testkit::{Law, Outcome, ensure, ensure_close, strategy};
use transforms::Pipeline;

const EPS: f32 = f32::EPSILON;

#[test]
fn three_ways_to_solve_the_system() {
    let inputs = strategy::triangle(5.0).prop_flat_map(|triangle| {
        let ray = prop_oneof![strategy::ray_at(triangle, 10.0), strategy::ray(10.0)];
        (Just(triangle), ray)
    });
    Law::new("Cramer's rule, the inverse and elimination agree")
        .demand("hit", 0.2)
        .demand("miss", 0.2)
        .holds_for(inputs, |(triangle, ray), seen| {
            let system = system(&ray, &triangle);
            let solutions = [cramer(&system), inverse(&system), elimination(&system)];
            // Ill-conditioned systems have no digits to agree in.
            if is_ill_conditioned(&system) {
                return Ok(());
            }
            let [Some(a), Some(b), Some(c)] = solutions else {
                return ensure(false, || format!("not all are solved: {solutions:?}"));
            };
            seen.class("hit", a.weights().is_inside());
            seen.class("miss", !a.weights().is_inside());
            let bound = rounding(&system, &a);
            let close = |a: Solution, b: Solution| -> Outcome {
                ensure_close("β", a.beta, b.beta, bound.beta)?;
                ensure_close("γ", a.gamma, b.gamma, bound.gamma)?;
                ensure_close("t", a.t, b.t, bound.t)
            };
            close(a, b)?;
            close(a, c)
        });
}

fn is_ill_conditioned(system: &System) -> bool {
    let columns = [system.matrix.x_axis, system.matrix.y_axis, system.matrix.z_axis];
    let volume: f32 = columns.iter().map(|column| column.length()).product();
    system.matrix.determinant().abs() < 1e-3 * volume
}

/// How far rounding can carry the unknowns of a solution.
///
/// Each is a quotient of determinants, each made of six products with three roundings, summed with five more: 16 roundings
/// of at most the product of its columns' lengths. Elimination with partial pivoting may let entries grow fourfold; solving
/// once more than Cramer does doubles that.
fn rounding(system: &System, solution: &Solution) -> Solution {
    let [p, q, d] = [system.matrix.x_axis, system.matrix.y_axis, system.matrix.z_axis].map(Vec3::length);
    let r = system.rhs.length();
    let share = 128.0 * EPS / system.matrix.determinant().abs();
    let bound = |numerator: f32, x: f32| share * (numerator + x.abs() * p * q * d);
    Solution {
        beta: bound(r * q * d, solution.beta),
        gamma: bound(p * r * d, solution.gamma),
        t: bound(p * q * r, solution.t),
    }
}

#[test]
fn the_slides_test_and_the_watertight_one() {
    let inputs = strategy::triangle(5.0).prop_flat_map(|triangle| {
        let ray = prop_oneof![strategy::ray_at(triangle, 10.0), strategy::ray(10.0)];
        (Just(triangle), ray)
    });
    Law::new("raytri and the watertight test agree where rounding does not decide")
        .demand("decided", 0.8)
        .demand("hit", 0.2)
        .demand("miss", 0.2)
        .holds_for(inputs, |(triangle, ray), seen| {
            let system = system(&ray, &triangle);
            let Some(solution) = cramer(&system).filter(|_| !is_ill_conditioned(&system)) else {
                return Ok(());
            };
            // Where rounding decides between inside and outside, or before and behind, only one of the two need be right.
            let (weights, bound) = (solution.weights(), rounding(&system, &solution));
            let is_decided = weights.beta.abs() > bound.beta
                && weights.gamma.abs() > bound.gamma
                && weights.alpha.abs() > bound.beta + bound.gamma + 2.0 * EPS
                && solution.t.abs() > bound.t;
            seen.class("decided", is_decided);
            if !is_decided {
                return Ok(());
            }
            let slide = raytri(&ray, &triangle, 0.0, 1e9);
            let ours = watertight(&ray, &triangle, 0.0, 1e9);
            seen.class("hit", ours.is_some());
            seen.class("miss", ours.is_none());
            ensure(slide.is_some() == ours.is_some(), || format!("raytri {slide:?}, watertight {ours:?}"))
        });
}

/// Closed meshes: round and sharp ones, and one with a hole through it.
fn closed_meshes() -> Vec<Mesh> {
    vec![
        shapes::icosphere(0).unwrap(),
        shapes::icosphere(2).unwrap(),
        shapes::cuboid(vec3(1.0, 2.0, 3.0), 1).unwrap(),
        shapes::torus(2.0, 0.75, 1).unwrap(),
        shapes::uv_sphere(1).unwrap(),
    ]
}

#[derive(Clone, Copy, Debug)]
enum Aim {
    Anywhere,
    Corner,
    Edge,
    /// Along an edge: the triangles beside it may be seen edge-on.
    AlongEdge,
}

/// The line from `from` by `aim`, at or along something of the mesh.
fn aimed(mesh: &Mesh, aim: Aim, triangle: usize, from: Vec3, mix: f32) -> Ray {
    let Triangle { a, b, c } = mesh.triangle(triangle % mesh.len());
    match aim {
        Aim::Anywhere => Ray::through(from, 0.3 * a + 0.3 * b - 0.1 * c),
        Aim::Corner => Ray::through(from, a),
        // Half of an edge is exact; other points lie beside it by a rounding.
        Aim::Edge => Ray::through(from, if mix < 0.5 { 0.5 * (a + b) } else { a + mix * (b - a) }),
        Aim::AlongEdge => Ray::new(a + 2.0 * (a - b), b - a),
    }
}

fn aim() -> impl Strategy<Value = Aim> {
    prop_oneof![Just(Aim::Anywhere), Just(Aim::Corner), Just(Aim::Edge), Just(Aim::AlongEdge)]
}

/// Points of the cube, some with coordinates in common with corners of the meshes, so that rays run along axes.
fn viewpoint() -> impl Strategy<Value = Vec3> {
    let whole = (-4..=4_i8, -4..=4_i8, -4..=4_i8).prop_map(|(x, y, z)| vec3(x.into(), y.into(), z.into()));
    prop_oneof![strategy::point(6.0), whole]
}

#[test]
fn a_line_crosses_a_closed_mesh_an_even_number_of_times() {
    let meshes = closed_meshes();
    Law::new("a line crosses a closed mesh an even number of times")
        .cases(20_000)
        .demand("crosses", 0.5)
        .demand("at a corner", 0.1)
        .demand("at an edge", 0.1)
        .demand("along an edge", 0.1)
        .demand("crosses more than twice", 0.02)
        .holds_for(
            (0..meshes.len(), aim(), 0..1000_usize, viewpoint(), 0.0_f32..1.0),
            |(m, aim, triangle, from, mix), seen| {
                let ray = aimed(&meshes[m], aim, triangle, from, mix);
                let hits = |k: &usize| {
                    watertight(&ray, &meshes[m].triangle(*k), f32::NEG_INFINITY, f32::INFINITY).is_some()
                };
                let crossings = (0..meshes[m].len()).filter(hits).count();
                seen.class("crosses", crossings > 0);
                seen.class("at a corner", matches!(aim, Aim::Corner) && crossings > 0);
                seen.class("at an edge", matches!(aim, Aim::Edge) && crossings > 0);
                seen.class("along an edge", matches!(aim, Aim::AlongEdge) && crossings > 0);
                seen.class("crosses more than twice", crossings > 2);
                ensure(crossings.is_multiple_of(2), || format!("{crossings} crossings"))
            },
        );
}

#[test]
fn a_ray_from_inside_a_closed_convex_mesh_leaves_it_once() {
    let mesh = shapes::icosphere(2).unwrap();
    Law::new("a ray from inside a ball of triangles leaves it once")
        .cases(4000)
        .demand("at a corner", 0.2)
        .holds_for(
            (aim(), 0..320_usize, strategy::point(0.4), 0.0_f32..1.0),
            |(aim, triangle, from, mix), seen| {
                let aim = if matches!(aim, Aim::AlongEdge) { Aim::Corner } else { aim };
                seen.class("at a corner", matches!(aim, Aim::Corner));
                let ray = aimed(&mesh, aim, triangle, from, mix);
                let hits = (0..mesh.len())
                    .filter(|k| watertight(&ray, &mesh.triangle(*k), 0.0, f32::INFINITY).is_some());
                let count = hits.count();
                ensure(count == 1, || format!("{count} hits"))
            },
        );
}

fn world_of(maps: &[Mat4]) -> World {
    let meshes: Vec<_> = closed_meshes().into_iter().map(|mesh| Arc::new(TracedMesh::new(mesh))).collect();
    let shape = |k: usize| match k % 7 {
        5 => Shape::Sphere(Sphere::new(vec3(0.2, -0.1, 0.3), 1.5)),
        6 => Shape::Plane(Plane::new(vec3(0.0, -1.0, 0.0), vec3(0.1, 1.0, 0.2).normalize())),
        m => Shape::Mesh(meshes[m].clone()),
    };
    let object = |k: usize| {
        Object::new(shape(k), maps[k], vec![Surface::default()]).expect("a map that can be undone")
    };
    // The first object stands twice in the same place: every hit on it is a tie.
    World::new((0..maps.len()).chain([0]).map(object).collect(), Vec::new())
}

/// Maps for a world of `world_of`.
fn maps() -> impl Strategy<Value = Vec<Mat4>> {
    proptest::collection::vec(strategy::affine(5.0), 1..10)
}

#[test]
fn brute_force_and_the_hierarchy_find_the_same() {
    Law::new("brute force and the hierarchy find the same hit, bit by bit")
        .cases(1500)
        .demand("hit", 0.3)
        .demand("miss", 0.05)
        .demand("front", 0.2)
        .demand("back", 0.05)
        .demand("a bounded interval", 0.3)
        .demand("a tie", 0.2)
        .demand("a sphere and a plane too", 0.2)
        .holds_for((maps(), aim(), viewpoint(), 0..1000_usize, 0.1_f32..4.0), |input, seen| {
            let (maps, aim, from, triangle, t1) = input;
            let world = world_of(&maps);
            // The first object is an icosahedron, and stands twice.
            let corners = world.objects()[0].corners(triangle % 20).unwrap();
            let mesh = Mesh::new(corners.to_vec(), vec![[0, 1, 2]]).unwrap();
            let ray = aimed(&mesh, aim, 0, from, 0.25);
            let t1 = if t1 > 2.0 { f32::INFINITY } else { t1 };
            let (fast, slow) = (nearest(&world, &ray, 0.0, t1), nearest_brute(&world, &ray, 0.0, t1));
            seen.class("hit", slow.is_some());
            seen.class("miss", slow.is_none());
            seen.class("front", slow.is_some_and(|hit| hit.is_front(&ray)));
            seen.class("back", slow.is_some_and(|hit| !hit.is_front(&ray)));
            seen.class("a bounded interval", t1.is_finite());
            seen.class("a tie", slow.is_some_and(|hit| hit.object == 0));
            seen.class("a sphere and a plane too", maps.len() >= 7);
            ensure(fast == slow, || format!("hierarchy {fast:?}, brute force {slow:?}"))?;
            let (fast, slow) = (any_hit(&world, &ray, 0.0, t1), any_hit_brute(&world, &ray, 0.0, t1));
            ensure(fast == slow, || format!("any hit: hierarchy {fast}, brute force {slow}"))
        });
}

#[test]
fn equal_objects_in_one_place_give_the_first() {
    Law::new("of equally near hits the lowest object wins").cases(200).demand("hit", 0.3).holds_for(
        (strategy::affine(3.0), viewpoint()),
        |(map, from), seen| {
            let mesh = Arc::new(TracedMesh::new(shapes::icosphere(1).unwrap()));
            let twin = || Object::new(Shape::Mesh(mesh.clone()), map, vec![Surface::default()]).unwrap();
            let world = World::new(vec![twin(), twin(), twin()], Vec::new());
            let hit =
                nearest(&world, &Ray::through(from, map.transform_point3(Vec3::ZERO)), 0.0, f32::INFINITY);
            seen.class("hit", hit.is_some());
            ensure(hit.is_none_or(|hit| hit.object == 0), || format!("{hit:?}"))
        },
    );
}

#[test]
fn smallest_t_wins() {
    Law::new("no triangle is hit before the nearest hit").cases(300).demand("several", 0.2).holds_for(
        (maps(), viewpoint(), strategy::point(3.0)),
        |(maps, from, to), seen| {
            let world = world_of(&maps);
            let ray = Ray::through(from, to);
            let Some(first) = nearest(&world, &ray, 0.0, f32::INFINITY) else {
                return Ok(());
            };
            let second = nearest(&world, &ray, first.t, f32::INFINITY);
            seen.class("several", second.is_some());
            // L47: t orders the points of a ray by their distance from the eye.
            let farther = |t: f32| ray.at(t).distance(from) >= ray.at(first.t).distance(from);
            ensure(second.is_none_or(|hit| hit.t > first.t && farther(hit.t)), || {
                format!("{first:?}, {second:?}")
            })?;
            // In (0, t of the nearest) there is nothing.
            ensure(!any_hit_brute(&world, &ray, 0.0, first.t), || format!("something is before {first:?}"))
        },
    );
}

#[test]
fn a_viewing_ray_pierces_its_own_pixel() {
    let pipeline = (strategy::camera(), strategy::view_volume());
    Law::new("p(0) = e, p(1) = s, and every point of a viewing ray lies in its pixel").holds_for(
        (pipeline, -0.5_f32..639.5, -0.5_f32..399.5, 1.0_f32..20.0),
        |((camera, volume), i, j, t), _| {
            let pipeline = Pipeline::new(camera, volume, 640, 400).expect("valid volumes only");
            let ray = viewing_ray(&pipeline, i, j);
            ensure(ray.at(0.0) == camera.eye(), || "p(0) is not e".to_owned())?;
            let (t0, _) = visible_interval(&volume);
            // The eye lies up to 18 from the origin, and s is rounded to that; near ≥ 0.2.
            let s = camera.camera_from_world().transform_point3(ray.at(t0));
            ensure_close("depth of s", s.z, volume.near, 64.0 * EPS * 20.0)?;
            // A world point is known to 4 roundings of numbers up to 18 + 20·6, camera coordinates to 8 more; on the
            // screen 640 pixels are at least 0.5 wide, at depth 0.2 t.
            let screen = pipeline.trace(ray.at(t)).screen.expect("before the eye").truncate();
            let bound = 16.0 * EPS * (18.0 + 8.0 * t) * 640.0 / (0.5 * t) + 16.0 * EPS * 640.0 * 8.0;
            ensure_close("pixel", screen, glam::vec2(i, j), bound)
        },
    );
}

#[test]
fn snells_law_is_reversible() {
    Law::new("light that is sent back through a surface goes back the way it came")
        .cases(1000)
        .demand("refracted", 0.4)
        .demand("totally reflected", 0.1)
        .holds_for(
            (strategy::unit_vector(), strategy::unit_vector(), 0.4_f32..2.5),
            |(d, n, ratio), seen| {
                let n = if d.dot(n) > 0.0 { -n } else { n };
                let behind = optics::refracted(d, n, ratio);
                let share = optics::fresnel(-d.dot(n), ratio);
                seen.class("refracted", behind.is_some());
                seen.class("totally reflected", behind.is_none());
                ensure((0.0..=1.0).contains(&share), || format!("reflected share {share}"))?;
                let Some(behind) = behind else {
                    return ensure_close("share", share, 1.0, 0.0);
                };
                let (sin_before, sin_behind) = (d.cross(n).length(), behind.cross(n).length());
                ensure_close("n₁ sin θ₁ = n₂ sin θ₂", ratio * sin_before, sin_behind, 16.0 * EPS)?;
                // Near the critical angle the way back magnifies a rounding by 1/cos θ₂; below 0.01 it says nothing.
                let cos_behind = -behind.dot(n);
                if cos_behind < 0.01 || -d.dot(n) < 0.01 {
                    return Ok(());
                }
                let back = optics::refracted(-behind, -n, ratio.recip());
                ensure(back.is_some(), || "the way back is closed".to_owned())?;
                let bound = 64.0 * EPS / (cos_behind * -d.dot(n));
                ensure_close("the way back", -back.unwrap_or_default(), d, bound)?;
                ensure_close(
                    "share on the way back",
                    optics::fresnel(cos_behind, ratio.recip()),
                    share,
                    bound,
                )
            },
        );
}

#[test]
fn rays_that_are_no_rays_give_no_nan() {
    let number = || {
        prop_oneof![
            Just(0.0_f32),
            Just(f32::NAN),
            Just(f32::INFINITY),
            Just(f32::MAX),
            Just(-f32::MAX),
            Just(1e-40),
            Just(-1e-30),
            Just(f32::MIN_POSITIVE),
            Just(1e20),
            Just(1.0),
            -3.0_f32..3.0,
        ]
    };
    let vector = || (number(), number(), number()).prop_map(Vec3::from);
    let world = world_of(&[Mat4::IDENTITY; 7]);
    Law::new("hostile rays give no NaN, and the same hit both ways")
        .cases(4000)
        .demand("hit", 0.02)
        .holds_for((vector(), vector(), number(), number()), |(origin, direction, t0, t1), seen| {
            let ray = Ray::new(origin, direction);
            let (fast, slow) = (nearest(&world, &ray, t0, t1), nearest_brute(&world, &ray, t0, t1));
            seen.class("hit", slow.is_some());
            ensure(fast == slow, || format!("hierarchy {fast:?}, brute force {slow:?}"))?;
            let Some(hit) = slow else { return Ok(()) };
            let sound = hit.t.is_finite() && hit.normal.is_normalized() && hit.weights.to_vec3().is_finite();
            ensure(sound && !hit.point.is_nan() && hit.clearance >= 0.0, || format!("{hit:?}"))?;
            let slide = raytri(&ray, &Triangle::new(Vec3::X, Vec3::Y, Vec3::Z), t0, t1);
            ensure(slide.is_none_or(|hit| hit.t.is_finite()), || format!("{slide:?}"))
        });
}

#[test]
fn the_nearest_of_all_that_is_met_is_the_nearest_hit() {
    let inputs = strategy::ray(1.5);
    let ball = Object::new(Shape::Sphere(Sphere::new(vec3(0.5, 0.0, -1.0), 1.5)), Mat4::IDENTITY, surfaces());
    let floor =
        Object::new(Shape::Plane(Plane::new(vec3(0.0, -1.0, 0.0), Vec3::Y)), Mat4::IDENTITY, surfaces());
    let mesh = Arc::new(TracedMesh::new(shapes::icosphere(2).unwrap()));
    let at = Mat4::from_translation(vec3(-1.0, 0.5, 0.25)) * Mat4::from_scale(vec3(1.0, 2.0, 0.5));
    let mesh = Object::new(Shape::Mesh(mesh), at, surfaces());
    let world = World::new(vec![ball.unwrap(), mesh.unwrap(), floor.unwrap()], Vec::new());
    Law::new("the first of all that the line meets is the nearest hit").demand("several", 0.1).holds_for(
        inputs,
        |ray, seen| {
            let (t0, t1) = (0.5, 20.0);
            let all = raytrace::all_met(&world, &ray);
            let between = all.iter().filter(|met| t0 < met.t && met.t < t1);
            seen.class("several", between.clone().count() > 1);
            // Of equal ones the first stays, as in the slide's loop.
            let first = between.min_by(|a, b| a.t.total_cmp(&b.t)).map(|met| world.hit(&ray, met));
            let nearest = nearest_brute(&world, &ray, t0, t1);
            ensure(first == nearest, || format!("{first:?}, not {nearest:?}"))
        },
    );
}

fn surfaces() -> Vec<Surface> {
    vec![Surface::default()]
}
