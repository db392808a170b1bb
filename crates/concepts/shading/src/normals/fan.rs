//! Which of the triangles around a vertex share a normal there, and which normal is it?

use geometry::{Indexed, Mesh};
use glam::{DVec3, Vec3};

use super::vertices::{Corner, Vertices};

/// The triangles with area around one vertex.
pub(super) struct Fan {
    blades: Vec<Blade>,
    /// The edges that end at the vertex: the vertex at the other end, the direction there, the blade. Sorted.
    spokes: Vec<(u32, DVec3, usize)>,
}

/// One triangle of a fan.
struct Blade {
    corner: Corner,
    n: DVec3,
    /// The angle of the triangle at the vertex, in radians.
    angle: f64,
}

impl Fan {
    pub(super) fn around(
        mesh: &Mesh,
        vertices: &Vertices,
        corners: &[Corner],
        faces: &[Option<Vec3>],
    ) -> Self {
        let mut fan = Self { blades: Vec::new(), spokes: Vec::new() };
        for corner in corners {
            let Some(n) = faces[corner.triangle as usize] else {
                continue;
            };
            let [here, next, last] = [0, 1, 2]
                .map(|k| mesh.triangles()[corner.triangle as usize][(corner.at as usize + k) % 3] as usize);
            let p = |position: usize| mesh.positions()[position].as_dvec3();
            let (to_next, to_last) = (p(next) - p(here), p(last) - p(here));
            let blade = fan.blades.len();
            fan.spokes.push((vertices.of_position[next], to_next, blade));
            fan.spokes.push((vertices.of_position[last], to_last, blade));
            let angle = to_next.cross(to_last).length().atan2(to_next.dot(to_last));
            fan.blades.push(Blade { corner: *corner, n: n.as_dvec3(), angle });
        }
        fan.spokes.sort_by_key(|(far_end, _, blade)| (*far_end, *blade));
        fan
    }

    /// For each blade the first blade of its group.
    pub(super) fn groups(&self, least_cosine: f64) -> Vec<usize> {
        let mut groups = Groups((0..self.blades.len()).collect());
        for edge in self.spokes.chunk_by(|a, b| a.0 == b.0) {
            let ring = self.ring_about(edge);
            for (k, &blade) in ring.iter().enumerate() {
                let next = ring[(k + 1) % ring.len()];
                // Rounding can carry the cosine of two opposite unit normals a hair below −1.
                if self.blades[blade].n.dot(self.blades[next].n).max(-1.0) >= least_cosine {
                    groups.join(blade, next);
                }
            }
        }
        (0..self.blades.len()).map(|blade| groups.first(blade)).collect()
    }

    /// The blades at one edge in the order in which their normals turn about it.
    ///
    /// All these normals are perpendicular to the edge, so they lie on a circle, and whoever is close enough to any
    /// other is close enough to a neighbour on the circle: there is no need to compare all pairs.
    fn ring_about(&self, edge: &[(u32, DVec3, usize)]) -> Vec<usize> {
        let mut ring: Vec<usize> = edge.iter().map(|(_, _, blade)| *blade).collect();
        if ring.len() > 2 {
            let u = self.blades[ring[0]].n;
            let v = edge[0].1.normalize().cross(u);
            let turn = |blade: usize| self.blades[blade].n.dot(v).atan2(self.blades[blade].n.dot(u));
            ring.sort_by(|a, b| turn(*a).total_cmp(&turn(*b)));
        }
        ring
    }

    /// One normal for each group, in the order of their first blades.
    pub(super) fn append_normals(&self, groups: &[usize], normals: &mut Indexed<Vec3>) {
        let mut sums = vec![(DVec3::ZERO, 0.0); self.blades.len()];
        for (blade, group) in self.blades.iter().zip(groups) {
            let (sum, angles) = &mut sums[*group];
            *sum += blade.angle * blade.n;
            *angles += blade.angle;
        }
        let mut shared = vec![None; self.blades.len()];
        for (blade, group) in self.blades.iter().zip(groups) {
            let Corner { triangle, at } = blade.corner;
            let (sum, angles) = sums[*group];
            let index = if sum.length() > CANCELLED * angles {
                *shared[*group].get_or_insert_with(|| append(normals, sum.normalize().as_vec3()))
            } else {
                append(normals, blade.n.as_vec3())
            };
            normals.triangles[triangle as usize][at as usize] = index;
        }
    }

    /// The corners of triangles without area take the first normal of the vertex, or none.
    pub(super) fn append_degenerate(
        &self,
        corners: &[Corner],
        faces: &[Option<Vec3>],
        normals: &mut Indexed<Vec3>,
    ) {
        let at_vertex = self.blades.first().map(|blade| blade.corner);
        let mut index =
            at_vertex.map(|corner| normals.triangles[corner.triangle as usize][corner.at as usize]);
        for corner in corners.iter().filter(|corner| faces[corner.triangle as usize].is_none()) {
            let index = *index.get_or_insert_with(|| append(normals, Vec3::ZERO));
            normals.triangles[corner.triangle as usize][corner.at as usize] = index;
        }
    }
}

/// A mean of unit normals shorter than this is rounding, not a direction: the normals are rounded to f32.
const CANCELLED: f64 = 4.0 * f32::EPSILON as f64;

fn append(normals: &mut Indexed<Vec3>, value: Vec3) -> u32 {
    normals.values.push(value);
    u32::try_from(normals.values.len() - 1).expect("fewer than 2^32 corners")
}

/// Which blades belong together: each points to an earlier one of its group, the first to itself.
struct Groups(Vec<usize>);

impl Groups {
    fn first(&mut self, mut blade: usize) -> usize {
        while self.0[blade] != blade {
            // Halving the path on the way keeps later walks short.
            self.0[blade] = self.0[self.0[blade]];
            blade = self.0[blade];
        }
        blade
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.first(a), self.first(b));
        self.0[a.max(b)] = a.min(b);
    }
}
