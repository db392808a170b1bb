//! Vertex normals: which way does the curved surface face that a mesh stands for? (L39)

use glam::{Vec2, Vec3, vec3};
use proptest::prelude::*;
use testkit::by_hand::{between, coordinate, point3};

use crate::exercise::{arguments, signature};
use crate::{Asker, Concept, Example, Exercise, Law, Misconception, Stop, Title, close, that};

const STUB: &str = r#"//! Vertex normals (L39, Fig 10.4).
//!
//! Give one unit normal for each position of a mesh: the mean direction of the normals of all triangles that meet there. It
//! stands for the normal of the curved surface that the mesh approximates.
//!
//! - `positions`: the vertices of the mesh.
//! - `triangles`: three indices into `positions` each; from the front the corners run anticlockwise, and there are the normals.
//! - You may count each triangle once, or larger ones more (their area, their angle at the vertex), as long as each counts.
//! - A triangle without area has no normal: it counts for nothing.
//! - The answer has as many normals as there are positions. Where no triangle with an area meets, it is `Vec3::ZERO`.
//!
//! glam: `u.cross(v)`, `v.normalize_or_zero()`. The cross product of two edges is the normal, longer for larger triangles.

use glam::Vec3;

pub fn vertex_normals(positions: &[Vec3], triangles: &[[usize; 3]]) -> Vec<Vec3> {
    todo!()
}
"#;

signature!((positions: &[Vec3], triangles: &[[usize; 3]]) -> Vec<Vec3>);

/// A unit normal is off by 2⁻²² a coordinate, a sum of eight by 2⁻¹⁹. The meshes here are such that no sum is shorter than a fifth
/// of what it is made of: 5 · 2⁻¹⁹ ≈ 1e-5. Corners on a circle are off by one rounding, which adds as much again.
const TOLERANCE: f32 = 3e-5;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "vertex_normals",
        concept: Concept::Shading,
        items: "L39",
        title: Title { english: "Vertex normals", dutch: "Hoekpuntnormalen" },
        prerequisites: &["face_normal"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "Looking for the triangles around each vertex is the long way. Go through the triangles once: what does each give to whom?",
            "Keep a list of sums, one for each position, all zero at first. Each triangle adds its normal to the sums of its three corners.",
            "vec![Vec3::ZERO; positions.len()], then for [i, j, k]: add (positions[j] - positions[i]).cross(positions[k] - positions[i]) to \
                all three, and at the end normalize_or_zero each sum.",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(each_counted_once), program!(weighted_by_angle), program!(vertex_by_vertex)],
        misconceptions: misconceptions(),
        explanation: "Adding cross products as they are counts each triangle by its area, and triangles without any take care of themselves. \
            Weighted by the angle at the vertex, the normal does not even depend on how a flat polygon was cut into triangles. A box \
            should keep its edges: then vertices are doubled, one for each side.",
        draw: super::drawing::vertex_normals,
        source: include_str!("vertex_normals.rs"),
    }
}

/// A mesh: positions and triangles.
type Mesh = (Vec<Vec3>, Vec<[usize; 3]>);

fn examples() -> Vec<Example> {
    // A roof over a ridge from (0, 0, 1) to (0, 2, 1), 45° steep at both sides.
    let ridge = [vec3(0.0, 0.0, 1.0), vec3(0.0, 2.0, 1.0)];
    let roof = vec![ridge[0], ridge[1], vec3(-1.0, 1.0, 0.0), vec3(1.0, 1.0, 0.0)];
    let half = 0.5_f32.sqrt();
    let sides = [vec3(-half, 0.0, half), vec3(half, 0.0, half)];
    let floor = vec![vec3(1.0, 1.0, 0.0), vec3(3.0, 1.0, 0.0), vec3(1.0, 2.0, 0.0), vec3(9.0, 9.0, 9.0)];
    vec![
        Example::new(
            "one triangle on the floor, and a position that no triangle meets",
            arguments![floor, vec![[0_usize, 1, 2]]],
            vec![Vec3::Z, Vec3::Z, Vec3::Z, Vec3::ZERO],
            TOLERANCE,
        ),
        Example::new(
            "a roof: along its ridge the normals point up",
            arguments![roof, vec![[0_usize, 1, 2], [1, 0, 3]]],
            vec![Vec3::Z, Vec3::Z, sides[0], sides[1]],
            TOLERANCE,
        ),
    ]
}

fn normal([a, b, c]: [Vec3; 3]) -> Vec3 {
    (b - a).cross(c - a).normalize_or_zero()
}

/// Two triangles with a common edge from 0 to 1, folded there by an angle that is seen, but not too sharply.
fn folded() -> impl Strategy<Value = [Vec3; 4]> + Clone {
    (point3(3), point3(3), point3(3), point3(3)).prop_map(|(p, q, r, s)| [p, q, r, s]).prop_filter(
        "flat, sharp or a sliver",
        |&[p, q, r, s]| {
            let cosine = normal([p, q, r]).dot(normal([q, p, s]));
            let least = (q - p).cross(r - p).length().min((p - q).cross(s - q).length());
            least > 2.0 && (-0.5..0.95).contains(&cosine)
        },
    )
}

/// A tent: a top, number 0, above a ring of corners at equal steps, each at a height of its own.
fn tent(heights: impl Strategy<Value = Vec<f32>> + Clone) -> impl Strategy<Value = Mesh> + Clone {
    (point3(2), between(1, 3), heights).prop_map(|(top, radius, heights)| {
        let corners = heights.len();
        let step = std::f32::consts::TAU / corners as f32;
        let corner = |k: usize| (radius * Vec2::from_angle(step * k as f32)).extend(heights[k]);
        let positions = std::iter::once(top).chain((0..corners).map(|k| top + corner(k))).collect();
        let triangles = (0..corners).map(|k| [0, 1 + k, 1 + (k + 1) % corners]).collect();
        (positions, triangles)
    })
}

fn regular_tent() -> impl Strategy<Value = Mesh> + Clone {
    tent((3..=7_usize, coordinate(2)).prop_map(|(corners, height)| vec![height; corners]))
}

fn crooked_tent() -> impl Strategy<Value = Mesh> + Clone {
    tent(prop::collection::vec(coordinate(1), 4..=7))
}

fn ask(program: &Asker<'_>, positions: Vec<Vec3>, triangles: Vec<[usize; 3]>) -> Result<Vec<Vec3>, Stop> {
    let count = positions.len();
    let normals: Vec<Vec3> = program.ask(arguments![positions, triangles])?;
    that(normals.len() == count, || format!("{} normals for {count} positions", normals.len()))?;
    Ok(normals)
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "no_triangle_no_normal",
            2,
            "Where no triangle with an area meets, the answer is zero, and the other normals stay as they are.",
            "A position that belongs to nothing got a normal or a NaN, or a triangle without area spoilt others: what is zero divided by zero?",
        )
        .over((folded(), point3(3), point3(3)), |&([p, q, r, s], lonely, flat), program| {
            let triangles = vec![[0, 1, 2], [1, 0, 3]];
            let plain = ask(program, vec![p, q, r, s], triangles.clone())?;
            // Number 5 meets only a triangle from p to q and back, which has no area.
            let with = [triangles, vec![[0, 5, 5], [0, 1, 0]]].concat();
            let normals = ask(program, vec![p, q, r, s, lonely, flat], with)?;
            close("the normals where no triangle meets", normals[4..].to_vec(), vec![Vec3::ZERO; 2], TOLERANCE)?;
            close("the other normals", normals[..4].to_vec(), plain, TOLERANCE)
        }),
        Law::of(
            "one_triangle_gives_its_own",
            2,
            "A vertex of one triangle alone has that triangle's normal.",
            "Where a single triangle ends, its normal is the only one there is: is it added to all three of its corners, on the front, and 1 long?",
        )
        .over(folded(), |&[p, q, r, s], program| {
            let normals = ask(program, vec![p, q, r, s], vec![[0, 1, 2], [1, 0, 3]])?;
            close("the normal at 2", normals[2], normal([p, q, r]), TOLERANCE)?;
            close("the normal at 3", normals[3], normal([q, p, s]), TOLERANCE)
        }),
        Law::of(
            "between_two_triangles",
            3,
            "Along the common edge of two triangles the normal is 1 long, and lies between those of the two.",
            "The normal on the edge leans out of the fold, or knows only one of its sides, or has another length.",
        )
        .over(folded(), |&[p, q, r, s], program| {
            let normals = ask(program, vec![p, q, r, s], vec![[0, 1, 2], [1, 0, 3]])?;
            let (one, other) = (normal([p, q, r]), normal([q, p, s]));
            for (name, n) in ["n at 0", "n at 1"].into_iter().zip(normals) {
                close(&format!("|{name}|"), n.length(), 1.0, TOLERANCE)?;
                close(&format!("({name})·(edge)"), n.dot((q - p).normalize()), 0.0, TOLERANCE)?;
                // Nearer to each than they are to each other. No triangle here counts for less than a hundredth of the other.
                let nearer = n.dot(one).min(n.dot(other)) > one.dot(other) + 1e-4;
                that(nearer, || format!("{name} is {n}, not between {one} and {other}"))?;
            }
            Ok(())
        }),
        Law::of(
            "upright_on_a_regular_tent",
            2,
            "On top of a regular tent the normal points straight up, however many sides it has and wherever it stands.",
            "The sides lean to all directions alike, but the normal on top does not stand upright, or is not 1 long.",
        )
        .over(regular_tent(), |(positions, triangles), program| {
            let normals = ask(program, positions.clone(), triangles.clone())?;
            close("the normal on top", normals[0], Vec3::Z, TOLERANCE)
        }),
        Law::of(
            "order_does_not_matter",
            1,
            "The triangles in another order, and each begun at another corner, give the same.",
            "Some triangle or corner has more say than others because it is first or last.",
        )
        .over(crooked_tent(), |(positions, triangles), program| {
            let reordered = triangles.iter().rev().map(|&[i, j, k]| [j, k, i]).collect();
            let one = ask(program, positions.clone(), triangles.clone())?;
            let other = ask(program, positions.clone(), reordered)?;
            close("the normals in another order", other, one, TOLERANCE)
        }),
    ]
}

fn slide(positions: &[Vec3], triangles: &[[usize; 3]]) -> Vec<Vec3> {
    let mut sums = vec![Vec3::ZERO; positions.len()];
    for &[i, j, k] in triangles {
        // Twice the area long: larger triangles count more.
        let normal = (positions[j] - positions[i]).cross(positions[k] - positions[i]);
        for corner in [i, j, k] {
            sums[corner] += normal;
        }
    }
    sums.into_iter().map(|sum| sum.normalize_or_zero()).collect()
}

fn each_counted_once(positions: &[Vec3], triangles: &[[usize; 3]]) -> Vec<Vec3> {
    let mut sums = vec![Vec3::ZERO; positions.len()];
    for corners in triangles {
        let [a, b, c] = corners.map(|corner| positions[corner]);
        let normal = (b - a).cross(c - a).normalize_or_zero();
        corners.iter().for_each(|corner| sums[*corner] += normal);
    }
    sums.iter().map(|sum| sum.normalize_or_zero()).collect()
}

fn weighted_by_angle(positions: &[Vec3], triangles: &[[usize; 3]]) -> Vec<Vec3> {
    let mut sums = vec![Vec3::ZERO; positions.len()];
    for &[i, j, k] in triangles {
        for [at, next, last] in [[i, j, k], [j, k, i], [k, i, j]] {
            let (to_next, to_last) = (positions[next] - positions[at], positions[last] - positions[at]);
            let normal = to_next.cross(to_last);
            if normal != Vec3::ZERO {
                sums[at] += normal.normalize() * to_next.angle_between(to_last);
            }
        }
    }
    sums.into_iter().map(Vec3::normalize_or_zero).collect()
}

fn vertex_by_vertex(positions: &[Vec3], triangles: &[[usize; 3]]) -> Vec<Vec3> {
    let normal_at = |vertex: usize| {
        let around = triangles.iter().filter(|corners| corners.contains(&vertex));
        let sum: Vec3 = around
            .map(|&[i, j, k]| {
                let (a, b, c) = (positions[i], positions[j], positions[k]);
                a.cross(b) + b.cross(c) + c.cross(a)
            })
            .sum();
        if sum.length() > 1e-3 { sum / sum.length() } else { Vec3::ZERO }
    };
    (0..positions.len()).map(normal_at).collect()
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(sum_not_normalized),
            looks_like: "the sums are not brought to unit length",
            help: "A sum of normals points the right way, but is as long as its triangles make it. Normals are 1 long.",
        },
        Misconception {
            program: program!(divided_by_the_count),
            looks_like: "the sum is divided by the number of triangles",
            help: "The mean of two unit vectors is shorter than 1 unless they are the same (E7): normalize it.",
        },
        Misconception {
            program: program!(the_last_triangle),
            looks_like: "only the last triangle at a vertex counts",
            help: "Each triangle is added to its corners' sums: `+=`, not `=`.",
        },
        Misconception {
            program: program!(nan_for_no_triangle),
            looks_like: "positions that no triangle meets get NaN",
            help: "Their sum is zero, and zero divided by its length is NaN: `normalize_or_zero`.",
        },
        Misconception {
            program: program!(nan_for_no_area),
            looks_like: "a triangle without area spoils the normals of its corners",
            help: "Its cross product is zero and has no direction. Added to a sum, one NaN makes all of it NaN.",
        },
        Misconception {
            program: program!(as_on_a_ball),
            looks_like: "the position itself is taken for the normal",
            help: "That is right for a ball around the origin, and for nothing else. Ask the triangles.",
        },
        Misconception {
            program: program!(on_the_back),
            looks_like: "the normals point to the back",
            help: "u×v and v×u are opposite: with anticlockwise corners (b − a)×(c − a) is on the front.",
        },
        Misconception {
            program: program!(to_its_first_corner),
            looks_like: "a triangle's normal is added to its first corner only",
            help: "All three corners of a triangle get its normal.",
        },
        Misconception {
            program: program!(one_for_all),
            looks_like: "all vertices have the same normal",
            help: "The mean is taken around each vertex by itself, not over the whole mesh.",
        },
    ]
}

fn sum_not_normalized(positions: &[Vec3], triangles: &[[usize; 3]]) -> Vec<Vec3> {
    let mut sums = vec![Vec3::ZERO; positions.len()];
    for &[i, j, k] in triangles {
        let normal = (positions[j] - positions[i]).cross(positions[k] - positions[i]);
        [i, j, k].into_iter().for_each(|corner| sums[corner] += normal);
    }
    sums
}

fn divided_by_the_count(positions: &[Vec3], triangles: &[[usize; 3]]) -> Vec<Vec3> {
    let mut sums = vec![(Vec3::ZERO, 0_u16); positions.len()];
    for &[i, j, k] in triangles {
        let normal = (positions[j] - positions[i]).cross(positions[k] - positions[i]).normalize_or_zero();
        for corner in [i, j, k] {
            sums[corner].0 += normal;
            sums[corner].1 += u16::from(normal != Vec3::ZERO);
        }
    }
    sums.into_iter().map(|(sum, count)| sum / f32::from(count.max(1))).collect()
}

fn the_last_triangle(positions: &[Vec3], triangles: &[[usize; 3]]) -> Vec<Vec3> {
    let mut normals = vec![Vec3::ZERO; positions.len()];
    for &[i, j, k] in triangles {
        let normal = (positions[j] - positions[i]).cross(positions[k] - positions[i]).normalize_or_zero();
        [i, j, k].into_iter().for_each(|corner| normals[corner] = normal);
    }
    normals
}

fn nan_for_no_triangle(positions: &[Vec3], triangles: &[[usize; 3]]) -> Vec<Vec3> {
    let mut sums = vec![Vec3::ZERO; positions.len()];
    for &[i, j, k] in triangles {
        let normal = (positions[j] - positions[i]).cross(positions[k] - positions[i]);
        [i, j, k].into_iter().for_each(|corner| sums[corner] += normal);
    }
    sums.into_iter().map(|sum| sum / sum.length()).collect()
}

fn nan_for_no_area(positions: &[Vec3], triangles: &[[usize; 3]]) -> Vec<Vec3> {
    let mut sums = vec![Vec3::ZERO; positions.len()];
    for &[i, j, k] in triangles {
        let normal = (positions[j] - positions[i]).cross(positions[k] - positions[i]);
        [i, j, k].into_iter().for_each(|corner| sums[corner] += normal / normal.length());
    }
    sums.into_iter().map(|sum| if sum == Vec3::ZERO { sum } else { sum / sum.length() }).collect()
}

fn as_on_a_ball(positions: &[Vec3], _triangles: &[[usize; 3]]) -> Vec<Vec3> {
    positions.iter().map(|p| p.normalize_or_zero()).collect()
}

fn on_the_back(positions: &[Vec3], triangles: &[[usize; 3]]) -> Vec<Vec3> {
    let mut sums = vec![Vec3::ZERO; positions.len()];
    for &[i, j, k] in triangles {
        let normal = (positions[k] - positions[i]).cross(positions[j] - positions[i]);
        [i, j, k].into_iter().for_each(|corner| sums[corner] += normal);
    }
    sums.into_iter().map(Vec3::normalize_or_zero).collect()
}

fn to_its_first_corner(positions: &[Vec3], triangles: &[[usize; 3]]) -> Vec<Vec3> {
    let mut sums = vec![Vec3::ZERO; positions.len()];
    for &[i, j, k] in triangles {
        sums[i] += (positions[j] - positions[i]).cross(positions[k] - positions[i]);
    }
    sums.into_iter().map(Vec3::normalize_or_zero).collect()
}

fn one_for_all(positions: &[Vec3], triangles: &[[usize; 3]]) -> Vec<Vec3> {
    let mut sums = vec![Vec3::ZERO; positions.len()];
    for &[i, j, k] in triangles {
        let normal = (positions[j] - positions[i]).cross(positions[k] - positions[i]);
        [i, j, k].into_iter().for_each(|corner| sums[corner] += normal);
    }
    vec![sums.iter().sum::<Vec3>().normalize_or_zero(); positions.len()]
}
