//! What is interpolated between the corners? Positions and normals in the world, and for Gouraud shading colours: once a
//! vertex, eight vertices at a time.

use fearless_simd::prelude::*;
use fearless_simd::{Level, Simd, dispatch, f32x4, f32x8};
use geometry::mesh::normal_matrix;
use glam::{Mat3, Mat4, Vec3};
use lighting::fast::{Points, Vectors, lit};
use rayon::prelude::*;
use zbuffer::fast::{load_columns, store_columns};

use crate::{Lighting, Object, Shading, World};

/// Three numbers that are loaded as four.
pub(crate) type Padded = [f32; 4];

/// How many vertices one task works on.
const IN_A_TASK: usize = 1 << 12;

/// Attributes of all objects' vertices, one object after the other.
#[derive(Debug, Default)]
pub(crate) struct Attributes {
    /// World space, in the order of the positions.
    pub(crate) positions: Vec<Padded>,
    /// World space, unit length, on the front, in the order of the normals. NaN where a mesh has none.
    pub(crate) normals: Vec<Padded>,
    /// For Gouraud shading, seen from the front, where [`Lit::Vertices`].
    pub(crate) colors: Vec<Padded>,
    /// How the objects' colours are found.
    pub(crate) lit: Vec<Lit>,
    /// Where each object's normals begin.
    pub(crate) first_normal: Vec<u32>,
    /// Whether an object's map mirrors.
    pub(crate) is_mirrored: Vec<bool>,
}

/// Where the colours at the corners come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Lit {
    /// From [`Attributes::colors`]: each vertex has one normal and one material, and was lit once.
    Vertices,
    /// From the slide's functions, for each triangle that is seen.
    Triangles,
}

impl Attributes {
    /// Works out what `shading` needs.
    pub(crate) fn prepare(&mut self, world: &World, shading: Shading, lighting: &Lighting) {
        if shading == Shading::Flat {
            // Nothing is interpolated.
            return;
        }
        let objects = world.objects;
        self.is_mirrored.clear();
        self.is_mirrored.extend(objects.iter().map(|object| object.world_from_object.determinant() < 0.0));
        self.first_normal.clear();
        let mut count = 0;
        for object in objects {
            self.first_normal.push(count as u32);
            count += normals_of(object);
        }
        self.normals.resize(count, [0.0; 4]);
        self.positions.resize(objects.iter().map(|object| object.mesh.positions().len()).sum(), [0.0; 4]);
        let (mut positions, mut normals) = (self.positions.as_mut_slice(), self.normals.as_mut_slice());
        for object in objects {
            let own = positions.split_off_mut(..object.mesh.positions().len()).unwrap_or_default();
            to_world(&object.world_from_object, object.mesh.positions(), own);
            let own = normals.split_off_mut(..normals_of(object)).unwrap_or_default();
            if let Some(given) = object.mesh.normals() {
                turn(object, &given.values, own);
            }
        }
        self.light(objects, shading, lighting);
    }

    /// Lights the vertices of those objects whose vertices have one normal and one material each.
    fn light(&mut self, objects: &[Object], shading: Shading, lighting: &Lighting) {
        self.lit.clear();
        self.lit.extend(objects.iter().map(|object| {
            let mesh = object.mesh;
            let is_simple = mesh.normals_follow_positions()
                && normals_of(object) == mesh.positions().len()
                && !mesh.has_materials();
            if shading == Shading::Gouraud && is_simple { Lit::Vertices } else { Lit::Triangles }
        }));
        if !self.lit.contains(&Lit::Vertices) {
            return;
        }
        self.colors.resize(self.positions.len(), [0.0; 4]);
        let mut first = 0;
        for (k, object) in objects.iter().enumerate() {
            let count = object.mesh.positions().len();
            let range = first..first + count;
            first += count;
            if self.lit[k] == Lit::Triangles {
                continue;
            }
            let start = self.first_normal[k] as usize;
            let normals = &self.normals[start..start + count];
            let material = object.material(0);
            let tasks = self.colors[range.clone()].par_chunks_mut(IN_A_TASK);
            let points = self.positions[range].par_chunks(IN_A_TASK).zip(normals.par_chunks(IN_A_TASK));
            tasks.zip(points).for_each(|(colors, (positions, normals))| {
                dispatch!(Level::new(), simd => light_all(simd, &material, lighting, positions, normals, colors));
            });
        }
    }
}

/// How many normals an object's mesh has.
fn normals_of(object: &Object) -> usize {
    object.mesh.normals().map_or(0, |normals| normals.values.len())
}

/// Positions in world space, each rounded as it would be alone.
fn to_world(world_from_object: &Mat4, positions: &[Vec3], own: &mut [Padded]) {
    let tasks = own.par_chunks_mut(IN_A_TASK).zip(positions.par_chunks(IN_A_TASK));
    tasks.for_each(|(own, positions)| {
        dispatch!(Level::new(), simd => move_all(simd, world_from_object, positions, own));
    });
}

#[inline(always)]
fn move_all<S: Simd>(simd: S, world_from_object: &Mat4, positions: &[Vec3], own: &mut [Padded]) {
    let [x, y, z, w] = world_from_object.to_cols_array_2d();
    let column = |c: [f32; 4]| Vectors::splat(simd, Vec3::new(c[0], c[1], c[2]));
    let (x, y, z, w) = (column(x), column(y), column(z), column(w));
    for (positions, own) in positions.chunks(8).zip(own.chunks_mut(8)) {
        let p = load(simd, positions);
        // In glam's order.
        let moved = w.plus(z.scaled(p.z).plus(y.scaled(p.y).plus(x.scaled(p.x))));
        put(simd, moved, own);
    }
}

/// Normals in world space, as [`crate::Facet`] turns them.
fn turn(object: &Object, normals: &[Vec3], own: &mut [Padded]) {
    let matrix = normal_matrix(&object.world_from_object);
    let tasks = own.par_chunks_mut(IN_A_TASK).zip(normals.par_chunks(IN_A_TASK));
    tasks.for_each(|(own, normals)| {
        dispatch!(Level::new(), simd => turn_all(simd, &matrix, normals, own));
    });
}

#[inline(always)]
fn turn_all<S: Simd>(simd: S, matrix: &Mat3, normals: &[Vec3], own: &mut [Padded]) {
    let (x, y, z) = (
        Vectors::splat(simd, matrix.x_axis),
        Vectors::splat(simd, matrix.y_axis),
        Vectors::splat(simd, matrix.z_axis),
    );
    let (nan, infinity) = (f32x8::splat(simd, f32::NAN), f32x8::splat(simd, f32::INFINITY));
    for (normals, own) in normals.chunks(8).zip(own.chunks_mut(8)) {
        let n = load(simd, normals);
        let n = x.scaled(n.x).plus(y.scaled(n.y)).plus(z.scaled(n.z));
        let scale = f32x8::splat(simd, 1.0) / n.dot(n).sqrt();
        // As `try_normalize`: no direction has what is too short or too long.
        let has_direction = scale.simd_gt(f32x8::splat(simd, 0.0)) & scale.simd_lt(infinity);
        put(simd, n.scaled(has_direction.select(scale, nan)), own);
    }
}

/// Up to eight vectors as columns.
#[inline(always)]
fn load<S: Simd>(simd: S, rows: &[Vec3]) -> Vectors<S> {
    let [x, y, z] = load_columns(simd, rows);
    Vectors { x, y, z }
}

/// Puts up to eight vectors into their places.
#[inline(always)]
fn put<S: Simd>(simd: S, vectors: Vectors<S>, own: &mut [Padded]) {
    store_columns([vectors.x, vectors.y, vectors.z, f32x8::splat(simd, 0.0)], own);
}

/// The colours of vertices that show their fronts.
#[inline(always)]
fn light_all<S: Simd>(
    simd: S,
    material: &lighting::Material,
    lighting: &Lighting,
    positions: &[Padded],
    normals: &[Padded],
    colors: &mut [Padded],
) {
    let blocks = positions.chunks(8).zip(normals.chunks(8)).zip(colors.chunks_mut(8));
    for ((positions, normals), colors) in blocks {
        let (p, n) = (columns(simd, positions), columns(simd, normals));
        let at = Points::seen_from(simd, lighting.eye, p, n);
        let color = lit(simd, material, lighting.lights, lighting.highlight, &at, |_, _, _, before| before);
        // A vertex without a normal has no colour, which the pixels that ask for it notice.
        let has_normal = n.x.simd_eq(n.x);
        let missing = f32x8::splat(simd, f32::NAN);
        put(simd, Vectors { x: has_normal.select(color.x, missing), ..color }, colors);
    }
}

/// Up to eight vectors as columns; what is missing is 0.
#[inline(always)]
fn columns<S: Simd>(simd: S, rows: &[Padded]) -> Vectors<S> {
    let mut eight = [[0.0; 4]; 8];
    eight[..rows.len()].copy_from_slice(rows);
    let (low, high) = eight.as_flattened().split_at(16);
    let low = f32x4::load_four_interleaved(simd, low);
    let high = f32x4::load_four_interleaved(simd, high);
    Vectors { x: low[0].combine(high[0]), y: low[1].combine(high[1]), z: low[2].combine(high[2]) }
}
