//! Laws of vertex normals (L39).

use std::f32::consts::PI;

use geometry::shapes::{icosphere, uv_sphere};
use geometry::{Indexed, Mesh};
use glam::{Mat4, Quat, Vec3};
use proptest::prelude::*;
use shading::vertex_normals;
use testkit::{Law, ensure, ensure_close, strategy};

use crate::model;

fn corner_normal(normals: &Indexed<Vec3>, triangle: usize, at: usize) -> Vec3 {
    normals.values[normals.triangles[triangle][at] as usize]
}

/// For each corner of a mesh inscribed in the unit sphere: how far its normal lies from the radius, and the greatest angle
/// between the radius and a face that meets there.
fn errors_at_corners(ball: &Mesh) -> Vec<(f32, f32)> {
    let normals = vertex_normals(ball, PI);
    let mut greatest = vec![0.0_f32; ball.positions().len()];
    let corners = || (0..ball.len()).flat_map(|k| (0..3).map(move |at| (k, at)));
    let position = |k: usize, at: usize| ball.triangles()[k][at] as usize;
    for (k, at) in corners() {
        let n = ball.triangle(k).normal().unwrap();
        let p = position(k, at);
        greatest[p] = greatest[p].max(n.angle_between(ball.positions()[p]));
    }
    let error = |(k, at)| {
        let p = position(k, at);
        (corner_normal(&normals, k, at).angle_between(ball.positions()[p]), greatest[p])
    };
    corners().map(error).collect()
}

/// `acos` of a cosine that is off by one rounding, near 1: √(2 · 2⁻²³), as [`Vec3::angle_between`] can be.
const ANGLE_ROUNDING: f32 = 5e-4;

#[test]
fn vertex_normals_of_a_ball_are_no_farther_from_the_radius_than_the_faces() {
    // The plane of three points of a sphere is perpendicular to the axis of the circle through them, so a face normal
    // makes the same angle with the radius at each corner. A mean of directions within a cone about the radius (less than a
    // right angle wide) lies within it too.
    let ball = (0_u32..4, any::<bool>(), strategy::rotation()).prop_map(|(level, ico, turn)| {
        let mesh = if ico { icosphere(level) } else { uv_sphere(level) };
        mesh.unwrap().transformed(&Mat4::from_mat3(turn)).unwrap()
    });
    Law::new("vertex normals of a ball lie within the faces' angle of the radius").cases(64).holds_for(
        ball,
        |ball, _| {
            for (error, greatest) in errors_at_corners(&ball) {
                ensure(error <= greatest + ANGLE_ROUNDING, || {
                    format!("{error} rad, though faces differ by {greatest}")
                })?;
            }
            Ok(())
        },
    );
}

#[test]
fn vertex_normals_of_a_ball_get_better_with_each_level() {
    // The circle around a face has half the radius on the next level, and with it falls the bound of the law above.
    let greatest =
        |errors: &[(f32, f32)]| errors.iter().fold((0.0_f32, 0.0_f32), |g, e| (g.0.max(e.0), g.1.max(e.1)));
    let levels: Vec<_> =
        (1..=5).map(|level| greatest(&errors_at_corners(&icosphere(level).unwrap()))).collect();
    for (coarse, fine) in levels.iter().zip(&levels[1..]) {
        assert!(fine.1 < 0.6 * coarse.1, "{levels:?}");
        assert!(fine.0 <= fine.1, "{levels:?}");
    }
    let (smooth, faceted) = levels[4];
    assert!(smooth < 0.1 * faceted, "{levels:?}");
}

/// The three sides of a box at the origin, each cut by one of its diagonals, moved by an affine map.
fn box_corner(affine: Mat4, through_corner: [bool; 3]) -> Mesh {
    let p = |x, y, z| affine.transform_point3(Vec3::new(x, y, z));
    let (x, y, z) = (1.0, 2.0, 3.0);
    let positions = vec![
        p(0.0, 0.0, 0.0),
        p(x, 0.0, 0.0),
        p(0.0, y, 0.0),
        p(0.0, 0.0, z),
        p(x, y, 0.0),
        p(0.0, y, z),
        p(x, 0.0, z),
    ];
    let cut = |([a, b, c, d], through): ([u32; 4], bool)| {
        if through { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] }
    };
    let squares = [[0, 2, 4, 1], [0, 3, 5, 2], [0, 1, 6, 3]];
    Mesh::new(positions, squares.into_iter().zip(through_corner).flat_map(cut).collect()).unwrap()
}

#[test]
fn vertex_normals_do_not_depend_on_how_flat_polygons_were_cut() {
    let inputs = (strategy::affine(5.0), any::<[bool; 3]>(), any::<[bool; 3]>());
    let law = Law::new("vertex normals do not see the cuts").demand("the unweighted mean sees them", 0.3);
    law.holds_for(inputs, |(affine, cuts, other_cuts), seen| {
        let meshes = [cuts, other_cuts].map(|cuts| box_corner(affine, cuts));
        // All triangles at the origin share one normal; the first triangle's first corner may lie elsewhere.
        let ours = meshes.each_ref().map(|mesh| {
            let normals = vertex_normals(mesh, PI);
            let at_origin = (0..mesh.len()).find(|k| mesh.triangles()[*k][0] == 0).unwrap();
            corner_normal(&normals, at_origin, 0)
        });
        let unweighted = meshes.each_ref().map(|mesh| {
            let around = (0..mesh.len()).filter(|k| mesh.triangles()[*k].contains(&0));
            around.map(|k| mesh.triangle(k).normal().unwrap()).sum::<Vec3>().normalize()
        });
        seen.class("the unweighted mean sees them", unweighted[0].distance(unweighted[1]) > 0.05);
        // Positions up to 15 from the origin are rounded by 15 · 2⁻²⁴, which tilts a side, at least 0.1 high, by 2e-5;
        // the sum of the three normals is at least 0.1 long.
        ensure_close("normal", ours[0], ours[1], 4e-4)
    });
}

#[test]
fn vertex_normals_are_unit_and_belong_to_both_sides_of_a_smooth_edge() {
    let inputs = (model::mesh(), strategy::affine(3.0), 0.0_f32..1.8);
    let law = Law::new("a smooth edge has one normal at each end, for both sides");
    law.demand("smooth", 0.3).demand("hard", 0.3).holds_for(inputs, |(mesh, affine, crease_angle), seen| {
        let mesh = mesh.transformed(&affine).unwrap();
        let normals = vertex_normals(&mesh, crease_angle);
        for n in &normals.values {
            ensure_close("length", n.length(), 1.0, 4.0 * f32::EPSILON)?;
        }
        let edges = shared_edges(&mesh);
        let angle = |[(k, _), (l, _)]: [(usize, usize); 2]| {
            let [n, m] = [k, l].map(|k| mesh.triangle(k).normal().unwrap());
            n.angle_between(m)
        };
        let smooth = |edge: &&[(usize, usize); 2]| angle(**edge) < crease_angle - ANGLE_ROUNDING;
        seen.class("smooth", edges.iter().any(|edge| smooth(&edge)));
        seen.class("hard", edges.iter().any(|edge| angle(*edge) > crease_angle + ANGLE_ROUNDING));
        for [(k, at), (l, other)] in edges.iter().filter(smooth).copied() {
            // The edge starts at corner `at` of one triangle and at corner `other` of the other, the opposite way round.
            let ours = [at, (at + 1) % 3].map(|at| corner_normal(&normals, k, at));
            let theirs = [(other + 1) % 3, other].map(|at| corner_normal(&normals, l, at));
            ensure(ours == theirs, || format!("triangles {k} and {l}: {ours:?}, {theirs:?}"))?;
        }
        Ok(())
    });
}

/// Pairs (triangle, corner where the edge starts) that run along the same edge in opposite directions.
fn shared_edges(mesh: &Mesh) -> Vec<[(usize, usize); 2]> {
    let ends = |(k, at): (usize, usize)| (mesh.triangles()[k][at], mesh.triangles()[k][(at + 1) % 3]);
    let sides: Vec<_> = (0..mesh.len()).flat_map(|k| (0..3).map(move |at| (k, at))).collect();
    let starts: std::collections::HashMap<_, _> = sides.iter().map(|side| (ends(*side), *side)).collect();
    let other = |side: &(usize, usize)| {
        let (from, to) = ends(*side);
        starts.get(&(to, from)).map(|other| [*side, *other])
    };
    sides.iter().filter_map(other).collect()
}

#[test]
fn turning_the_mesh_turns_its_normals() {
    let inputs = (model::mesh(), strategy::unit_vector(), -PI..PI);
    Law::new("vertex normals turn with the mesh").holds_for(inputs, |(mesh, axis, angle), _| {
        let turn = Quat::from_axis_angle(axis, angle);
        let turned = mesh.clone().without_normals().transformed(&Mat4::from_quat(turn)).unwrap();
        // 180°, so that no rounding decides between hard and smooth.
        let (before, after) = (vertex_normals(&mesh, PI), vertex_normals(&turned, PI));
        for k in 0..mesh.len() {
            for at in 0..3 {
                // A turned coordinate, up to 3.5, is a sum of three products: five roundings by 3.5 · 2⁻²⁴, in three
                // coordinates, at both ends of an edge. Edges are at least 0.1 long, with a sine of at least 0.05.
                let bound = 2.0 * 3.0_f32.sqrt() * 5.0 * 3.5 * (0.5 * f32::EPSILON) / (0.1 * 0.05);
                let (want, got) = (turn * corner_normal(&before, k, at), corner_normal(&after, k, at));
                ensure_close("normal", got, want, bound)?;
            }
        }
        Ok(())
    });
}
