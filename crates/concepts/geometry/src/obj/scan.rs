//! What does each line of the OBJ text say? A line that is wrong is an error with its number and a remedy.

use std::collections::HashMap;
use std::ops::Range;

use glam::{DVec3, Vec2, Vec3};

use super::indices::{Indices, Kind, Place};
use super::message::{ObjError, Warnings, quoted};
use super::text::{self, number};

/// What a sound OBJ text says.
pub(super) struct Scan {
    /// The name of the text in messages.
    pub(super) source: String,
    /// The vertices that faces use, less `origin`.
    pub(super) positions: Attribute<Vec3>,
    /// Their texture coordinates; (0, 0) at a corner without.
    pub(super) texture: Attribute<Vec2>,
    /// Their normals; zero at a corner without.
    pub(super) normals: Attribute<Vec3>,
    /// What was subtracted from every vertex, so that a mesh far away keeps its digits in f32.
    pub(super) origin: DVec3,
    /// The faces, in the order of the file.
    pub(super) faces: Vec<Face>,
    /// The names of used materials, with the first line that uses them.
    pub(super) used: Vec<Reference>,
    /// The material files, with the first line that names them.
    pub(super) libraries: Vec<Reference>,
    /// Whether any corner has a normal.
    pub(super) has_normals: bool,
    /// Whether any corner has texture coordinates.
    pub(super) has_texture: bool,
}

/// Values, and for each corner of each face the index of its value.
#[derive(Default)]
pub(super) struct Attribute<T> {
    pub(super) values: Vec<T>,
    pub(super) indices: Vec<u32>,
}

impl<T: Copy> Attribute<T> {
    /// Takes from `all` the values that corners use, in the order of their first use. `indices` has a place in `all` for each corner.
    fn used(all: &[T], indices: &[usize]) -> Self {
        let mut numbers = vec![None; all.len()];
        let mut used = Self { values: Vec::new(), indices: Vec::with_capacity(indices.len()) };
        for index in indices {
            let number = *numbers[*index].get_or_insert_with(|| {
                used.values.push(all[*index]);
                used.values.len() as u32 - 1
            });
            used.indices.push(number);
        }
        used
    }
}

/// A face of the file.
pub(super) struct Face {
    pub(super) line: usize,
    /// The places of its corners in the lists of indices.
    pub(super) corners: Range<usize>,
    /// Its place in [`Scan::used`].
    pub(super) material: Option<usize>,
    /// Its smoothing group: 0 for `s off`, `None` if no `s` came before.
    pub(super) smoothing: Option<u32>,
}

/// A name and the line where it is used first.
pub(super) struct Reference {
    pub(super) name: String,
    pub(super) line: usize,
}

impl Scan {
    /// Checks the text in `bytes`.
    pub(super) fn of(bytes: &[u8], source: &str, warnings: &mut Warnings) -> Result<Self, ObjError> {
        let text = text::decode(bytes, source)?;
        let mut scanner = Scanner::new(source);
        for line in text::lines(text) {
            scanner.line = line.number;
            scanner.statement(&line.text, warnings)?;
        }
        scanner.finish()
    }
}

/// A mesh farther from the origin than so many times its own size is moved there: f32 would leave its shape less than
/// 18 of its 24 bits.
const FAR: f64 = 64.0;

/// The middle of the box around the points if that is far away for its size, else 0.
fn origin(points: impl Iterator<Item = DVec3> + Clone) -> DVec3 {
    let low = points.clone().fold(DVec3::INFINITY, DVec3::min);
    let high = points.fold(DVec3::NEG_INFINITY, DVec3::max);
    let (middle, size) = (0.5 * (low + high), (high - low).max_element());
    if middle.abs().max_element() > FAR * size { middle } else { DVec3::ZERO }
}

struct Scanner {
    scan: Scan,
    line: usize,
    /// The vertices as the file has them, already divided by w.
    vertices: Vec<DVec3>,
    /// First (0, 0), which stands for a corner without texture coordinates; then those of the file.
    texture: Vec<Vec2>,
    /// First zero, which stands for a corner without a normal; then those of the file.
    normals: Vec<Vec3>,
    /// For each corner of each face its place in `vertices`, `texture` and `normals`.
    corners: [Vec<usize>; 3],
    indices: Indices,
    material: Option<usize>,
    smoothing: Option<u32>,
    places: HashMap<String, usize>,
}

impl Scanner {
    fn new(source: &str) -> Self {
        let scan = Scan {
            source: source.to_owned(),
            positions: Attribute::default(),
            texture: Attribute::default(),
            normals: Attribute::default(),
            origin: DVec3::ZERO,
            faces: Vec::new(),
            used: Vec::new(),
            libraries: Vec::new(),
            has_normals: false,
            has_texture: false,
        };
        Self {
            scan,
            line: 0,
            vertices: Vec::new(),
            texture: vec![Vec2::ZERO],
            normals: vec![Vec3::ZERO],
            corners: Default::default(),
            indices: Indices::default(),
            material: None,
            smoothing: None,
            places: HashMap::new(),
        }
    }

    fn statement(&mut self, text: &str, warnings: &mut Warnings) -> Result<(), ObjError> {
        // A '#' begins a comment, but in the name of a material or a file it is a letter.
        let code = text.split('#').next().unwrap_or_default();
        let mut words = code.split_whitespace();
        let Some(keyword) = words.next() else {
            return Ok(());
        };
        let name = || text.trim_start().strip_prefix(keyword).unwrap_or_default().trim();
        match keyword {
            "v" => self.vertex(words),
            "vt" => self.texture(words),
            "vn" => self.normal(words),
            "f" | "fo" => self.face(words),
            "usemtl" => {
                self.use_material(name());
                Ok(())
            }
            "mtllib" => self.library(name()),
            "s" => {
                self.smoothing_group(words.next().unwrap_or_default(), warnings);
                Ok(())
            }
            "o" | "g" | "mg" | "lod" | "vp" | "bevel" | "c_interp" | "d_interp" => Ok(()),
            other => {
                warnings.add(
                    &self.scan.source,
                    Some(self.line),
                    format!("{} is left out{}", quoted(other), what(other)),
                );
                Ok(())
            }
        }
    }

    fn vertex<'a>(&mut self, words: impl Iterator<Item = &'a str>) -> Result<(), ObjError> {
        let numbers = self.numbers(words)?;
        let (&[x, y, z], rest) =
            numbers.split_first_chunk().ok_or_else(|| self.wrong_count("v", numbers.len()))?;
        let w = match rest {
            [w] => *w,
            // x y z and a colour, with or without its opacity.
            [] | [_, _, _] | [_, _, _, _] => 1.0,
            _ => return Err(self.wrong_count("v", numbers.len())),
        };
        let p = DVec3::new(x, y, z) / w;
        if !p.as_vec3().is_finite() {
            let remedy = "write w = 1 or leave it out";
            return Err(self.error(format!("the vertex divided by its w = {w} is out of range"), remedy));
        }
        self.indices.add(Kind::Vertex);
        self.vertices.push(p);
        Ok(())
    }

    fn texture<'a>(&mut self, words: impl Iterator<Item = &'a str>) -> Result<(), ObjError> {
        let numbers = self.numbers(words)?;
        let (u, v) = match numbers[..] {
            [u] => (u, 0.0),
            [u, v] | [u, v, _] => (u, v),
            _ => return Err(self.wrong_count("vt", numbers.len())),
        };
        self.indices.add(Kind::Texture);
        self.texture.push(Vec2::new(u as f32, v as f32));
        Ok(())
    }

    fn normal<'a>(&mut self, words: impl Iterator<Item = &'a str>) -> Result<(), ObjError> {
        let numbers = self.numbers(words)?;
        let [x, y, z] = numbers[..] else {
            return Err(self.wrong_count("vn", numbers.len()));
        };
        self.indices.add(Kind::Normal);
        self.normals.push(DVec3::new(x, y, z).as_vec3());
        Ok(())
    }

    fn face<'a>(&mut self, words: impl Iterator<Item = &'a str>) -> Result<(), ObjError> {
        let start = self.corners[0].len();
        for word in words {
            let place = Place { file: &self.scan.source, line: self.line };
            let [v, vt, vn] = self.indices.corner(word, place)?;
            self.scan.has_texture |= vt.is_some();
            self.scan.has_normals |= vn.is_some();
            // Counted from 1: of the vertices, 1 is the first; of the others, the first stands for none.
            for (places, index) in self.corners.iter_mut().zip([v.map(|v| v - 1), vt, vn]) {
                places.push(index.unwrap_or(0) as usize);
            }
        }
        let corners = start..self.corners[0].len();
        if corners.len() < 3 {
            let problem = format!("a face with {} corners", corners.len());
            return Err(self.error(problem, "a face needs at least 3"));
        }
        let (line, material, smoothing) = (self.line, self.material, self.smoothing);
        self.scan.faces.push(Face { line, corners, material, smoothing });
        Ok(())
    }

    /// Without a name, the faces that follow have the default material.
    fn use_material(&mut self, name: &str) {
        if name.is_empty() {
            self.material = None;
            return;
        }
        let place = *self.places.entry(name.to_owned()).or_insert_with(|| {
            self.scan.used.push(Reference { name: name.to_owned(), line: self.line });
            self.scan.used.len() - 1
        });
        self.material = Some(place);
    }

    fn smoothing_group(&mut self, word: &str, warnings: &mut Warnings) {
        match (word, word.parse()) {
            ("off", _) => self.smoothing = Some(0),
            ("on", _) => self.smoothing = Some(1),
            (_, Ok(group)) => self.smoothing = Some(group),
            _ => warnings.add(
                &self.scan.source,
                Some(self.line),
                format!("smoothing group {} is left out: write a number, or off", quoted(word)),
            ),
        }
    }

    fn library(&mut self, name: &str) -> Result<(), ObjError> {
        /// More material files than this are a mistake or an attack: each is a file to open.
        const MOST: usize = 64;
        if name.is_empty() {
            return Err(
                self.error("mtllib without a file", "write the name of a file, as in: mtllib pot.mtl")
            );
        }
        if self.scan.libraries.iter().all(|known| known.name != name) {
            if self.scan.libraries.len() == MOST {
                return Err(self.error(format!("more than {MOST} material files"), "merge them into one"));
            }
            self.scan.libraries.push(Reference { name: name.to_owned(), line: self.line });
        }
        Ok(())
    }

    /// Looks at the text as a whole, now that all is counted.
    fn finish(mut self) -> Result<Scan, ObjError> {
        self.indices.check_ahead(&self.scan.source)?;
        if self.scan.faces.is_empty() {
            let problem = if self.indices.count(Kind::Vertex) == 0 {
                "no vertices and no faces"
            } else {
                "vertices, but no faces"
            };
            let remedy = "an OBJ file needs lines such as 'v 0 0 0' and 'f 1 2 3'";
            return Err(ObjError::new(&self.scan.source, None, problem, remedy));
        }
        let [vertices, texture, normals] = &self.corners;
        let Attribute { values, indices } = Attribute::used(&self.vertices, vertices);
        self.scan.origin = origin(values.iter().copied());
        let values = values.iter().map(|p| (p - self.scan.origin).as_vec3()).collect();
        self.scan.positions = Attribute { values, indices };
        self.scan.texture = Attribute::used(&self.texture, texture);
        self.scan.normals = Attribute::used(&self.normals, normals);
        Ok(self.scan)
    }

    fn numbers<'a>(&self, words: impl Iterator<Item = &'a str>) -> Result<Vec<f64>, ObjError> {
        words.map(|word| number(word, &self.scan.source, self.line)).collect()
    }

    fn wrong_count(&self, keyword: &str, count: usize) -> ObjError {
        let expected = match keyword {
            "v" => "3 (x y z), 4 (with w) or 6 (with a colour)",
            "vt" => "1 to 3 (u v w)",
            _ => "3 (x y z)",
        };
        self.error(format!("'{keyword}' with {count} numbers"), format!("write {expected}"))
    }

    fn error(&self, problem: impl Into<String>, remedy: impl Into<String>) -> ObjError {
        Place { file: &self.scan.source, line: self.line }.error(problem, remedy)
    }
}

/// What a keyword that is left out stands for, if it is a known one.
fn what(keyword: &str) -> &'static str {
    match keyword {
        "l" => ": lines are not drawn",
        "p" => ": points are not drawn",
        "cstype" | "deg" | "bmat" | "step" | "curv" | "curv2" | "surf" | "parm" | "trim" | "hole"
        | "scrv" | "sp" | "end" | "con" => ": curved surfaces are not read, export as polygons",
        "usemap" | "maplib" => ": textures are not read",
        _ => "",
    }
}
