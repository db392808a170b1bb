//! What is on the screen? Every vertex of every part, and every triangle sorted by rows.

use geometry::Mesh;
use glam::Mat4;
use rayon::prelude::*;
use transforms::Pipeline;

use crate::clip::Viewport;
use crate::fast::bins::{BAND_ROWS, Chunk, Piece, Sorting};
use crate::fast::vertices::{Rest, ToScreen, Vertex};

/// Which sides of triangles are drawn. The front is the side from which the corners run anticlockwise.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Faces {
    /// Both: the slide's way, and the only one for surfaces with a border.
    #[default]
    Both,
    /// Fronts only. On a closed surface around something solid no back is seen, and half the work is saved. (Of both, a back is nearer in the very
    /// few pixels whose center lies between the true outline and the snapped one.)
    Front,
}

/// A mesh at a place in the world.
#[derive(Clone, Copy, Debug)]
pub struct MeshInstance<'a> {
    /// The triangles.
    pub mesh: &'a Mesh,
    /// Affine and finite. A map that mirrors keeps fronts fronts, as in [`Mesh::transformed`].
    pub world_from_object: Mat4,
}

/// The number of a triangle, counted through all parts in drawing order.
pub type Number = u32;

/// The number that stands for no triangle.
pub const NONE: Number = i32::MAX as u32;

/// How many triangles one task sorts.
const IN_A_CHUNK: usize = 1 << 13;

/// How many vertices one task transforms.
const VERTICES_IN_A_TASK: usize = 1 << 13;

/// All triangles of all parts on the screen, sorted by bands of rows. Kept from picture to picture, it needs no new memory.
#[derive(Debug, Default)]
pub struct Projected {
    pub(crate) vertices: Vec<Vertex>,
    /// What rounding left over of each vertex.
    pub(crate) rests: Vec<Rest>,
    /// Where each part's vertices, triangles and chunks begin.
    firsts: Vec<First>,
    chunks: Vec<Chunk>,
    /// For each band the chunks that reach it, in drawing order.
    in_band: Vec<Vec<u32>>,
    pub(crate) size: (u32, u32),
}

/// Where something of a part begins, counted through all parts.
#[derive(Clone, Copy, Debug)]
struct First {
    vertex: usize,
    number: Number,
    chunk: usize,
}

impl Projected {
    /// Brings all parts to the screen, in place of what was there before.
    ///
    /// # Panics
    /// If the screen is too large for [`crate::project`], or if there are 2³¹ − 1 triangles or more.
    pub fn project(&mut self, parts: &[MeshInstance], pipeline: &Pipeline, faces: Faces) {
        self.size = (pipeline.width(), pipeline.height());
        self.place(parts);
        let viewport = Viewport::new(self.size.0, self.size.1);
        let clip_from_world = pipeline.clip_from_world();
        let ways: Vec<ToScreen> = parts
            .iter()
            .map(|part| ToScreen { world_from_object: part.world_from_object, clip_from_world, viewport })
            .collect();

        let mut pending = (self.vertices.as_mut_slice(), self.rests.as_mut_slice());
        for (part, way) in parts.iter().zip(&ways) {
            let positions = part.mesh.positions();
            let (vertices, later_vertices) = pending.0.split_at_mut(positions.len());
            let (rests, later_rests) = pending.1.split_at_mut(positions.len());
            let to =
                vertices.par_chunks_mut(VERTICES_IN_A_TASK).zip(rests.par_chunks_mut(VERTICES_IN_A_TASK));
            let tasks = positions.par_chunks(VERTICES_IN_A_TASK).zip(to);
            tasks.for_each(|(positions, (vertices, rests))| way.vertices(positions, vertices, rests));
            pending = (later_vertices, later_rests);
        }
        self.sort(parts, &ways, faces);
    }

    /// Counts vertices and triangles.
    fn place(&mut self, parts: &[MeshInstance]) {
        self.firsts.clear();
        let (mut vertices, mut triangles, mut chunks) = (0, 0_u64, 0);
        for part in parts {
            self.firsts.push(First { vertex: vertices, number: triangles as Number, chunk: chunks });
            vertices += part.mesh.positions().len();
            triangles += part.mesh.len() as u64;
            chunks += part.mesh.len().div_ceil(IN_A_CHUNK);
        }
        assert!(triangles < u64::from(NONE), "{triangles} triangles cannot be numbered");
        self.vertices.resize(vertices, [0.0; 4]);
        self.rests.resize(vertices, [0.0; 4]);
    }

    fn sort(&mut self, parts: &[MeshInstance], ways: &[ToScreen], faces: Faces) {
        let mut tasks = Vec::new();
        for (index, part) in parts.iter().enumerate() {
            let First { vertex, number, .. } = self.firsts[index];
            let sorting = Sorting {
                index,
                part,
                vertices: &self.vertices[vertex..vertex + part.mesh.positions().len()],
                to_screen: ways[index],
                size: self.size,
                faces,
                is_mirrored: part.world_from_object.determinant() < 0.0,
                first: number,
            };
            let starts = (0..part.mesh.len()).step_by(IN_A_CHUNK);
            tasks.extend(starts.map(|start| (sorting, start..part.mesh.len().min(start + IN_A_CHUNK))));
        }
        self.chunks.resize_with(tasks.len(), Chunk::default);
        let chunks = self.chunks.par_iter_mut().zip(tasks);
        chunks.for_each(|(chunk, (sorting, triangles))| chunk.fill(&sorting, triangles));
        self.in_band.iter_mut().for_each(Vec::clear);
        self.in_band.resize_with(self.bands() as usize, Vec::new);
        for (k, chunk) in self.chunks.iter().enumerate() {
            for band in chunk.bands() {
                self.in_band[band as usize].push(k as u32);
            }
        }
    }

    /// How many bands of [`BAND_ROWS`] rows the screen has; the last may be cut short.
    #[must_use]
    pub fn bands(&self) -> u32 {
        self.size.1.div_ceil(BAND_ROWS)
    }

    /// The chunks that reach band `b`, in drawing order.
    pub(crate) fn chunks_in(&self, b: u32) -> impl Iterator<Item = &Chunk> {
        self.in_band[b as usize].iter().map(|k| &self.chunks[*k as usize])
    }

    /// The vertices of triangle `k` of a part on the screen, and what rounding left over of them.
    #[inline(always)]
    pub(crate) fn corners(&self, part: usize, mesh: &Mesh, k: usize) -> [(&Vertex, &Rest); 3] {
        let (vertices, rests) = (self.vertices_of(part), self.rests_of(part));
        let indices = mesh.triangles()[k];
        three!(c => (&vertices[indices[c] as usize], &rests[indices[c] as usize]))
    }

    /// The vertices of a part, and perhaps some after them.
    #[inline(always)]
    pub(crate) fn vertices_of(&self, part: usize) -> &[Vertex] {
        &self.vertices[self.firsts[part].vertex..]
    }

    /// What rounding left over of them.
    #[inline(always)]
    pub(crate) fn rests_of(&self, part: usize) -> &[Rest] {
        &self.rests[self.firsts[part].vertex..]
    }

    /// The part of a triangle.
    ///
    /// # Panics
    /// If there are no parts.
    #[must_use]
    pub fn part_of(&self, number: Number) -> usize {
        // Parts without triangles begin where the next one does.
        self.firsts.partition_point(|first| first.number <= number) - 1
    }

    /// Where the vertices of a part begin, counted through the positions of all parts.
    ///
    /// # Panics
    /// If there is no such part.
    #[must_use]
    pub fn first_vertex(&self, part: usize) -> usize {
        self.firsts[part].vertex
    }

    /// The number of a part's first triangle.
    ///
    /// # Panics
    /// If there is no such part.
    #[must_use]
    pub fn first_number(&self, part: usize) -> Number {
        self.firsts[part].number
    }

    /// What clipping left of a triangle.
    pub(crate) fn pieces_of(&self, number: Number) -> &[Piece] {
        let first = self.firsts[self.part_of(number)];
        let chunk = first.chunk + (number - first.number) as usize / IN_A_CHUNK;
        let pieces = &self.chunks[chunk].pieces;
        let start = pieces.partition_point(|piece| piece.number < number);
        let end = pieces.partition_point(|piece| piece.number <= number);
        &pieces[start..end]
    }
}
