//! What holds for every triangle, every mesh and every level of every shape.

use std::collections::HashMap;

use geometry::shapes::{ShapeError, cuboid, disc, icosphere, teapot, torus, uv_sphere};
use geometry::{Barycentric, Mesh, Plane, Triangle};
use glam::{Mat4, Vec3, vec3};
use proptest::prelude::*;
use testkit::{Law, ensure, ensure_close, strategy};

/// The spacing of f32 above 1: an operation with a result up to x is off by at most x · EPSILON / 2.
const EPSILON: f32 = f32::EPSILON;

#[test]
fn barycentric_coordinates_sum_to_one_and_reproduce_the_point() {
    let anywhere = (strategy::coordinate(2.0), strategy::coordinate(2.0))
        .prop_map(|(beta, gamma)| Barycentric::from_beta_gamma(beta, gamma));
    let inputs = (strategy::triangle(10.0), prop_oneof![strategy::inside(0.01), anywhere]);
    Law::new("α + β + γ = 1 and αa + βb + γc is the point, inside and outside (L48)")
        .demand("inside", 0.3)
        .demand("outside", 0.3)
        .holds_for(inputs, |(triangle, weights), seen| {
            let p = triangle.point(weights);
            let got = triangle.barycentric(p).expect("the strategy gives no slivers");
            seen.class("inside", got.is_inside());
            seen.class("outside", got.alpha.min(got.beta).min(got.gamma) < 0.0);
            // α = 1 − β − γ with |β|, |γ| ≤ 2: four operations, no result above 5.
            ensure_close("sum", got.alpha + got.beta + got.gamma, 1.0, 4.0 * 5.0 * EPSILON)?;
            // Weights up to 5 on coordinates up to 10: five operations, no result above 100; p came in the same way.
            ensure_close("point", triangle.point(got), p, 5.0 * 100.0 * EPSILON)
        });
}

#[test]
fn barycentric_coordinates_of_a_point_off_the_plane_are_those_of_its_foot() {
    let inputs = (strategy::triangle(10.0), strategy::inside(0.05), strategy::coordinate(5.0));
    Law::new("a point above the triangle has the coordinates of the point below it").holds_for(
        inputs,
        |(triangle, weights, height), _| {
            let n = triangle.normal().expect("no slivers");
            let foot = triangle.point(weights);
            let got = triangle.barycentric(foot + height * n).expect("no slivers");
            // Eight operations with no result above 20 make the point. A weight is a distance over a height of the
            // triangle, at least 0.5 · 0.05 by the strategy; the third weight carries the errors of two.
            let bound = 2.0 * 8.0 * 20.0 * EPSILON / (0.5 * 0.05);
            ensure_close("weights", got.to_vec3(), weights.to_vec3(), bound)
        },
    );
}

#[test]
fn plane_has_its_front_where_the_triangle_has_it() {
    let inputs = (strategy::triangle(10.0), strategy::point(10.0));
    Law::new("the signed distance is that of the volume over the triangle, positive in front")
        .demand("front", 0.3)
        .demand("behind", 0.3)
        .holds_for(inputs, |(triangle, p), seen| {
            let distance = Plane::of_triangle(&triangle).expect("no slivers").signed_distance(p);
            seen.class("front", distance > 0.0);
            seen.class("behind", distance < 0.0);
            let [a, b, c] = triangle.corners().map(|q| q.as_dvec3() - p.as_dvec3());
            let by_volume = -a.dot(b.cross(c)) / (b - a).cross(c - a).length();
            // A rounded normal in two dot products and a difference: twelve roundings of numbers up to 30.
            ensure_close("distance", distance, by_volume as f32, 12.0 * 30.0 * EPSILON)
        });
}

#[test]
fn affine_map_keeps_fronts_in_front() {
    let mirrored = (strategy::affine(10.0), any::<bool>())
        .prop_map(|(map, mirror)| if mirror { map * Mat4::from_scale(vec3(1.0, -1.0, 1.0)) } else { map });
    let ball = icosphere(3).expect("level 3 is allowed");
    Law::new("a map of any handedness keeps volumes positive and normals outward")
        .demand("mirrored", 0.3)
        .holds_for(mirrored, |map, seen| {
            seen.class("mirrored", map.determinant() < 0.0);
            let mesh = ball.transformed(&map).expect("finite");
            ensure(volume(&mesh) > 0.0, || format!("volume {}", volume(&mesh)))?;
            // Scales of 4 : 1 and a shear by 1 (golden ratio squared : 1) stretch κ ≤ 10.5 : 1, which bends an angle
            // by at most asin((κ² − 1) / (κ² + 1)) = 79°. The ball's faces are within 6° of its normals: 85° < 90°.
            let least = least_cosine(&mesh);
            ensure(least > 0.0, || format!("cosine {least}"))
        });
}

/// A closed shape at a level, its Euler characteristic and the volume of the true surface.
fn closed_shapes() -> impl Strategy<Value = (&'static str, Vec<Mesh>, i64, f64)> {
    let size = || 0.1_f32..10.0;
    let levels = |shape: &dyn Fn(u32) -> Result<Mesh, ShapeError>| -> Vec<Mesh> {
        (0..4).map(|level| shape(level).expect("small levels and sound sizes")).collect()
    };
    let ball = 4.0 / 3.0 * std::f64::consts::PI;
    prop_oneof![
        Just(("UV sphere", levels(&uv_sphere), 2, ball)),
        Just(("icosphere", levels(&icosphere), 2, ball)),
        (size(), size(), size()).prop_map(move |(x, y, z)| {
            let exact = f64::from(x) * f64::from(y) * f64::from(z);
            ("box", levels(&|level| cuboid(vec3(x, y, z), level)), 2, exact)
        }),
        (size(), 0.05_f32..0.95).prop_map(move |(major, ratio)| {
            let minor = ratio * major;
            let exact = 2.0 * std::f64::consts::PI.powi(2) * f64::from(major) * f64::from(minor).powi(2);
            ("torus", levels(&|level| torus(major, minor, level)), 0, exact)
        }),
    ]
}

#[test]
fn closed_shapes_are_watertight() {
    Law::new("each edge is used once in either direction, and V − E + F is that of the surface")
        .cases(64)
        .demand("torus", 0.1)
        .demand("box", 0.1)
        .holds_for(closed_shapes(), |(name, meshes, euler, _), seen| {
            seen.class("torus", name == "torus");
            seen.class("box", name == "box");
            for mesh in &meshes {
                let open = open_edges(mesh);
                ensure(open.is_empty(), || format!("{name}: open or doubled edges {open:?}"))?;
                let (v, e, f) = (mesh.positions().len() as i64, mesh.len() as i64 * 3 / 2, mesh.len() as i64);
                ensure(v - e + f == euler, || format!("{name}: V − E + F = {v} − {e} + {f}"))?;
                let places: std::collections::HashSet<_> =
                    mesh.positions().iter().map(|p| p.to_array().map(f32::to_bits)).collect();
                ensure(places.len() == mesh.positions().len(), || {
                    format!("{name}: a position occurs twice")
                })?;
            }
            Ok(())
        });
}

#[test]
fn finer_shapes_come_closer_to_the_surface() {
    Law::new("each level quarters the error of the volume").cases(64).holds_for(
        closed_shapes(),
        |(name, meshes, _, exact), _| {
            let errors: Vec<f64> = meshes.iter().map(|mesh| (exact - volume(mesh)) / exact).collect();
            // The error is c·h² (1 + d·h² …) with h the angle of an edge, so the ratio tends to 4; from level 1 to 2,
            // with h up to π/4, it is at least 3.5. The box is exact up to the rounding of its sizes.
            let rounding = f64::from(8.0 * EPSILON);
            for pair in errors.windows(2).skip(1) {
                ensure(-rounding <= pair[1] && pair[1] <= pair[0] / 3.5 + rounding, || {
                    format!("{name}: {errors:?}")
                })?;
            }
            ensure(errors[3] < 0.02, || format!("{name}: {errors:?}"))
        },
    );
}

#[test]
fn normals_agree_with_faces_the_better_the_finer() {
    Law::new("the angle between a face and its corner normals about halves with each level")
        .cases(64)
        .holds_for(closed_shapes(), |(name, meshes, _, _), _| {
            for (level, mesh) in meshes.iter().enumerate().skip(1) {
                // An edge spans at most h = 90° / 2^level (of a meridian, or of the torus's tube). A right triangle
                // with legs h touches the surface nowhere farther than h/√2 from a corner.
                let bound = std::f64::consts::FRAC_PI_2 / f64::from(1 << level);
                let angle = least_cosine(mesh).min(1.0).acos();
                ensure(angle <= bound, || format!("{name}, level {level}: {angle} rad, allowed {bound}"))?;
                let normals = mesh.normals().expect("every shape has normals");
                for n in &normals.values {
                    ensure_close("length", n.length(), 1.0, 2.0 * EPSILON)?;
                }
            }
            Ok(())
        });
}

#[test]
fn teapot_is_open_only_where_the_real_one_is() {
    for level in 0..4 {
        let pot = teapot(level).expect("small level");
        let open = open_edges(&pot);
        let loops = loops(&open);
        // The circles of body and lid pass four patches, those of handle and spout two.
        let cuts = 2 << level;
        let mut lengths: Vec<_> = loops.iter().map(Vec::len).collect();
        lengths.sort_unstable();
        assert_eq!(lengths, [2 * cuts, 2 * cuts, 2 * cuts, 2 * cuts, 4 * cuts, 4 * cuts], "level {level}");
        for circle in loops.iter().filter(|circle| circle.len() == 4 * cuts) {
            // Rim and lid end at the same height, at radius 1.4 and 1.3: the slit.
            assert!(circle.iter().all(|k| pot.positions()[*k as usize].y == 2.4));
        }
    }
}

#[test]
fn teapot_normals_agree_with_its_faces_the_better_the_finer() {
    let mut last = f64::INFINITY;
    for level in 1..5 {
        let pot = teapot(level).expect("small level");
        assert!(pot.normals().unwrap().values.iter().all(|n| (n.length() - 1.0).abs() <= 2.0 * EPSILON));
        let angle = least_cosine(&pot).acos();
        // The sharpest bend is the spout's lip; about half the angle remains with each level.
        assert!(angle < 0.75 * last, "level {level}: {angle} after {last}");
        last = angle;
    }
}

#[test]
fn disc_is_flat_round_and_faces_up() {
    for level in 0..4 {
        let plate = disc(1.5, level).expect("small level");
        let edge = loops(&open_edges(&plate));
        assert_eq!(edge.len(), 1);
        assert!(
            edge[0].iter().all(|k| (plate.positions()[*k as usize].length() - 1.5).abs() <= 2.0 * EPSILON)
        );
        for k in 0..plate.len() {
            assert_eq!(plate.triangle(k).normal(), Some(Vec3::Y));
        }
    }
}

/// The volume inside a closed mesh: positive if its fronts are outside.
fn volume(mesh: &Mesh) -> f64 {
    let six_volumes = |t: Triangle| t.a.as_dvec3().dot(t.b.as_dvec3().cross(t.c.as_dvec3()));
    (0..mesh.len()).map(|k| six_volumes(mesh.triangle(k))).sum::<f64>() / 6.0
}

/// The cosine of the greatest angle between a face and a normal at one of its corners.
fn least_cosine(mesh: &Mesh) -> f64 {
    let cosine = |k: usize| {
        let face = mesh.triangle(k).normal().expect("no triangle of a shape is without area").as_dvec3();
        let corners = mesh.corner_normals(k).expect("every corner of a shape has a normal");
        corners.iter().map(|n| face.dot(n.as_dvec3().normalize())).fold(f64::INFINITY, f64::min)
    };
    (0..mesh.len()).map(cosine).fold(f64::INFINITY, f64::min)
}

/// The directed edges that are not met by exactly one edge the other way.
fn open_edges(mesh: &Mesh) -> Vec<(u32, u32)> {
    let mut counts: HashMap<(u32, u32), u32> = HashMap::new();
    for [a, b, c] in mesh.triangles() {
        for edge in [(*a, *b), (*b, *c), (*c, *a)] {
            *counts.entry(edge).or_default() += 1;
        }
    }
    let count = |edge: (u32, u32)| counts.get(&edge).copied().unwrap_or(0);
    counts.keys().copied().filter(|(a, b)| (count((*a, *b)), count((*b, *a))) != (1, 1)).collect()
}

/// The closed loops that directed edges form, each as its points.
fn loops(edges: &[(u32, u32)]) -> Vec<Vec<u32>> {
    let mut next: HashMap<u32, u32> = edges.iter().copied().collect();
    assert_eq!(next.len(), edges.len(), "two open edges start in one point");
    let mut loops = Vec::new();
    while let Some(start) = next.keys().min().copied() {
        let mut points = Vec::new();
        let mut at = start;
        while let Some(to) = next.remove(&at) {
            points.push(at);
            at = to;
        }
        assert_eq!(at, start, "open edges that close no loop");
        loops.push(points);
    }
    loops
}
