//! Three equations, one per coordinate, in three unknowns β, γ and t (L50). Three ways to solve them (L51).

use geometry::{Barycentric, Ray, Triangle};
use glam::{Mat3, Vec3};

/// A·x = b with x = (β, γ, t) (L50).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct System {
    /// A: its columns are a − b, a − c and d.
    pub matrix: Mat3,
    /// b: the right-hand side a − e.
    pub rhs: Vec3,
}

/// x = (β, γ, t): where the ray's line crosses the triangle's plane, inside the triangle or not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution {
    /// β, the weight of corner b.
    pub beta: f32,
    /// γ, the weight of corner c.
    pub gamma: f32,
    /// The place on the ray.
    pub t: f32,
}

impl Solution {
    /// α, β, γ with α = 1 − β − γ (L48).
    #[must_use]
    pub fn weights(&self) -> Barycentric {
        Barycentric::from_beta_gamma(self.beta, self.gamma)
    }

    fn from_vec3(x: Vec3) -> Self {
        Self { beta: x.x, gamma: x.y, t: x.z }
    }
}

/// The system for e + t·d = a + β(b − a) + γ(c − a) (L50), unknowns on the left:
///
/// ```text
/// ⎛ x_a − x_b   x_a − x_c   x_d ⎞ ⎛ β ⎞   ⎛ x_a − x_e ⎞
/// ⎜ y_a − y_b   y_a − y_c   y_d ⎟ ⎜ γ ⎟ = ⎜ y_a − y_e ⎟
/// ⎝ z_a − z_b   z_a − z_c   z_d ⎠ ⎝ t ⎠   ⎝ z_a − z_e ⎠
/// ```
///
/// ```
/// use geometry::{Ray, Triangle};
/// use glam::{Mat3, Vec3, vec3};
/// use raytrace::triangle::system;
///
/// // The lecture's example (L54).
/// let s = system(&Ray::new(Vec3::ONE, Vec3::NEG_ONE), &Triangle::new(Vec3::X, Vec3::Y, Vec3::Z));
/// assert_eq!(s.matrix, Mat3::from_cols(vec3(1.0, -1.0, 0.0), vec3(1.0, 0.0, -1.0), vec3(-1.0, -1.0, -1.0)));
/// assert_eq!(s.rhs, vec3(0.0, -1.0, -1.0)); // the slide has each row times −1
/// ```
#[must_use]
pub fn system(ray: &Ray, triangle: &Triangle) -> System {
    System {
        matrix: Mat3::from_cols(triangle.a - triangle.b, triangle.a - triangle.c, ray.direction),
        rhs: triangle.a - ray.origin,
    }
}

/// By Cramer's rule: each unknown is det(A with its column replaced by b) / det A (L51). `None` if parallel (E11).
#[must_use]
pub fn cramer(system: &System) -> Option<Solution> {
    let Mat3 { x_axis: p, y_axis: q, z_axis: d } = system.matrix;
    let r = system.rhs;
    let determinant = system.matrix.determinant();
    if is_parallel(determinant, [p, q, d]) {
        return None;
    }
    let replaced = [Mat3::from_cols(r, q, d), Mat3::from_cols(p, r, d), Mat3::from_cols(p, q, r)];
    let [beta, gamma, t] = replaced.map(|matrix| matrix.determinant() / determinant);
    Some(Solution { beta, gamma, t })
}

/// By the inverse: x = A⁻¹·b (L51). `None` if parallel (E11).
#[must_use]
pub fn inverse(system: &System) -> Option<Solution> {
    let Mat3 { x_axis: p, y_axis: q, z_axis: d } = system.matrix;
    if is_parallel(system.matrix.determinant(), [p, q, d]) {
        return None;
    }
    Some(Solution::from_vec3(system.matrix.inverse() * system.rhs))
}

/// By Gaussian elimination with partial pivoting, then back-substitution (L51). `None` if parallel (E11).
#[must_use]
pub fn elimination(system: &System) -> Option<Solution> {
    elimination_watched(system, |_, _| ())
}

/// What [`elimination`] does to the rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RowOperation {
    /// Two rows change places, so that the largest pivot of the column comes up (or a row stays where it is).
    Exchange {
        /// The column of the pivot; its row is the one of the same number.
        column: usize,
        /// The row that had the largest.
        with: usize,
    },
    /// A multiple of the pivot's row is taken from a row below, whose number in the pivot's column becomes 0.
    Subtract {
        /// The column of the pivot; its row is the one of the same number.
        column: usize,
        /// The row that changes.
        from: usize,
        /// How many times the pivot's row is taken.
        factor: f32,
    },
}

/// [`elimination`], which tells each operation with the rows after it: one row per equation, right-hand side last.
pub fn elimination_watched(
    system: &System,
    mut watch: impl FnMut(RowOperation, &[[f32; 4]; 3]),
) -> Option<Solution> {
    let columns = [system.matrix.x_axis, system.matrix.y_axis, system.matrix.z_axis];
    // One row per equation, right-hand side last.
    let mut rows: [[f32; 4]; 3] =
        std::array::from_fn(|k| [columns[0][k], columns[1][k], columns[2][k], system.rhs[k]]);
    for column in 0..3 {
        // The largest pivot: dividing by a small one would magnify the rounding of everything below.
        let largest = (column..3).max_by(|&k, &l| rows[k][column].abs().total_cmp(&rows[l][column].abs()))?;
        rows.swap(column, largest);
        watch(RowOperation::Exchange { column, with: largest }, &rows);
        let pivot_row = rows[column];
        if pivot_row[column] == 0.0 {
            return None;
        }
        for below in column + 1..3 {
            let factor = rows[below][column] / pivot_row[column];
            for k in column..4 {
                rows[below][k] -= factor * pivot_row[k];
            }
            // That was the aim; what rounding leaves there is never asked for.
            rows[below][column] = 0.0;
            watch(RowOperation::Subtract { column, from: below, factor }, &rows);
        }
    }
    // The product of the pivots is the determinant, but for its sign.
    if is_parallel(rows[0][0] * rows[1][1] * rows[2][2], columns) {
        return None;
    }
    let t = rows[2][3] / rows[2][2];
    let gamma = (rows[1][3] - rows[1][2] * t) / rows[1][1];
    let beta = (rows[0][3] - rows[0][1] * gamma - rows[0][2] * t) / rows[0][0];
    Some(Solution { beta, gamma, t })
}

/// A determinant is computed with about a dozen roundings of products of one entry per column: below this share of the
/// product of the columns' lengths, nothing of it is known but noise.
const NOISE: f32 = 8.0 * f32::EPSILON;

/// Whether a determinant is too small for its columns to tell it from 0, or is not finite: the ray is parallel to the
/// plane, or the triangle has no area (E11).
pub(super) fn is_parallel(determinant: f32, columns: [Vec3; 3]) -> bool {
    let volume: f32 = columns.iter().map(|column| column.length()).product();
    !(determinant.abs() > NOISE * volume && volume.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::vec3;

    #[test]
    fn all_three_find_whole_numbers_exactly() {
        // β = 2, γ = −1, t = 3 put into the left-hand side by hand.
        let matrix = Mat3::from_cols(vec3(1.0, 2.0, 0.0), vec3(4.0, -1.0, 3.0), vec3(2.0, 0.0, 1.0));
        let system = System { matrix, rhs: vec3(4.0, 5.0, 0.0) };
        let want = Solution { beta: 2.0, gamma: -1.0, t: 3.0 };
        for solve in [cramer, inverse, elimination] {
            let got = solve(&system).unwrap();
            for (got, want) in [(got.beta, want.beta), (got.gamma, want.gamma), (got.t, want.t)] {
                assert!((got - want).abs() < 1e-5, "{got} is not {want}");
            }
        }
    }

    #[test]
    fn parallel_rays_and_triangles_without_area_have_no_solution() {
        let triangle = Triangle::new(vec3(0.0, 0.0, 2.0), vec3(3.0, 0.0, 2.0), vec3(0.0, 5.0, 2.0));
        let needle = Triangle::new(vec3(0.0, 0.0, 2.0), vec3(1.0, 2.0, 3.0), vec3(2.0, 4.0, 4.0));
        for (ray, triangle) in [
            (Ray::new(vec3(1.0, 1.0, 7.0), vec3(0.3, 0.7, 0.0)), triangle),
            (Ray::new(vec3(1.0, 1.0, 7.0), vec3(0.3, 0.7, -1.0)), needle),
            (Ray::new(vec3(1.0, 1.0, f32::NAN), vec3(0.3, f32::NAN, -1.0)), triangle),
        ] {
            for solve in [cramer, inverse, elimination] {
                assert_eq!(solve(&system(&ray, &triangle)), None);
            }
        }
    }

    #[test]
    fn elimination_tells_what_it_does() {
        // The largest of the first column is in the second row.
        let matrix = Mat3::from_cols(vec3(1.0, 2.0, 0.0), vec3(4.0, -1.0, 3.0), vec3(2.0, 0.0, 1.0));
        let mut told = Vec::new();
        let solution =
            elimination_watched(&System { matrix, rhs: vec3(4.0, 5.0, 0.0) }, |operation, rows| {
                told.push((operation, *rows));
            });
        assert_eq!(solution, elimination(&System { matrix, rhs: vec3(4.0, 5.0, 0.0) }));
        assert_eq!(told[0].0, RowOperation::Exchange { column: 0, with: 1 });
        assert_eq!(told[0].1[0], [2.0, -1.0, 0.0, 5.0]);
        assert_eq!(told[1].0, RowOperation::Subtract { column: 0, from: 1, factor: 0.5 });
        assert_eq!(told[1].1[1], [0.0, 4.5, 2.0, 1.5]);
        assert_eq!(told.len(), 6);
    }

    #[test]
    fn elimination_needs_its_pivoting() {
        // The first pivot would be 0 without an exchange of rows.
        let matrix = Mat3::from_cols(vec3(0.0, 2.0, 1.0), vec3(3.0, 0.0, 1.0), vec3(1.0, 1.0, 0.0));
        let got = elimination(&System { matrix, rhs: vec3(9.0, 5.0, 3.0) }).unwrap();
        for (got, want) in [(got.beta, 1.0), (got.gamma, 2.0), (got.t, 3.0)] {
            assert!((got - want).abs() < 1e-6, "{got} is not {want}");
        }
    }
}
