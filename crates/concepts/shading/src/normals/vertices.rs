//! Which corners meet in one vertex? Those whose positions have equal coordinates, whatever their indices.

use std::collections::HashMap;

use geometry::Mesh;
use glam::Vec3;

/// The corner `at` (0, 1, 2) of triangle `triangle`.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    pub(super) triangle: u32,
    pub(super) at: u32,
}

/// Which corners meet where: positions with equal coordinates are one vertex.
pub(super) struct Vertices {
    /// The vertex of each position.
    pub(super) of_position: Vec<u32>,
    /// All corners, those of one vertex side by side, in the order of the triangles.
    corners: Vec<Corner>,
    /// Where the corners of each vertex begin; one entry more than there are vertices.
    begins: Vec<usize>,
}

impl Vertices {
    pub(super) fn of(mesh: &Mesh) -> Self {
        let of_position = merged(mesh.positions());
        let vertex_count = of_position.iter().max().map_or(0, |last| *last as usize + 1);
        let corners = || {
            (0..).zip(mesh.triangles()).flat_map(|(triangle, t)| {
                (0..).zip(t).map(move |(at, position)| (*position, Corner { triangle, at }))
            })
        };
        // Counting sort: how many corners each vertex has, then where they begin, then the corners themselves.
        let mut begins = vec![0; vertex_count + 1];
        corners().for_each(|(position, _)| begins[of_position[position as usize] as usize + 1] += 1);
        (0..vertex_count).for_each(|v| begins[v + 1] += begins[v]);
        let mut free = begins.clone();
        let mut sorted = vec![Corner { triangle: 0, at: 0 }; 3 * mesh.len()];
        for (position, corner) in corners() {
            let slot = &mut free[of_position[position as usize] as usize];
            sorted[*slot] = corner;
            *slot += 1;
        }
        Self { of_position, corners: sorted, begins }
    }

    /// The corners of each vertex.
    pub(super) fn fans(&self) -> impl Iterator<Item = &[Corner]> {
        self.begins.windows(2).map(|ends| &self.corners[ends[0]..ends[1]])
    }
}

/// A number for each position, the same for equal coordinates, counted in order of appearance.
fn merged(positions: &[Vec3]) -> Vec<u32> {
    let mut numbers = HashMap::with_capacity(positions.len());
    let number = |p: &Vec3| {
        let next = numbers.len() as u32;
        // Adding 0 turns −0 into 0: equal coordinates then have equal bits.
        *numbers.entry((*p + 0.0).to_array().map(f32::to_bits)).or_insert(next)
    };
    positions.iter().map(number).collect()
}
