//! Is each line of the OBJ text sound? And what does it come to, written plainly?
//!
//! tobj reports no lines, fills in indices that are missing and splits a mesh at every change of material. So the scan
//! checks each line, remembers the materials of the faces itself, and writes a plain text that says the same with
//! nothing but three- and two-number vertices and faces with all three indices counted from the start. Where a corner
//! has no texture coordinates or no normal it names the first of the plain text, which are zeros put there for that.

use std::collections::HashMap;
use std::fmt::Write;

use glam::{DVec3, Vec3};

use super::indices::{Indices, Kind, Place};
use super::message::{ObjError, Warnings, quoted};
use super::text::{self, number};

/// What a sound OBJ text says.
pub(super) struct Scan {
    /// The name of the text in messages.
    pub(super) source: String,
    /// The vertices, less `origin`, and faces for tobj.
    pub(super) plain: String,
    /// What was subtracted from every vertex, so that a mesh far away keeps its digits in f32.
    pub(super) origin: DVec3,
    /// One entry for each face of the plain text.
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

/// What the scan knows of a face and tobj does not.
pub(super) struct Face {
    pub(super) line: usize,
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
        let mut scanner = Scanner::new(source, text.len());
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
    /// The vertices at the corners of all faces, counted from 1.
    corners: Vec<u64>,
    indices: Indices,
    material: Option<usize>,
    smoothing: Option<u32>,
    places: HashMap<String, usize>,
}

impl Scanner {
    fn new(source: &str, length: usize) -> Self {
        let mut plain = String::with_capacity(length);
        plain.push_str("vt 0 0\nvn 0 0 0\n");
        let scan = Scan {
            source: source.to_owned(),
            plain,
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
            corners: Vec::new(),
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
        self.write(format_args!("vt {u} {v}\n"));
        Ok(())
    }

    fn normal<'a>(&mut self, words: impl Iterator<Item = &'a str>) -> Result<(), ObjError> {
        let numbers = self.numbers(words)?;
        let [x, y, z] = numbers[..] else {
            return Err(self.wrong_count("vn", numbers.len()));
        };
        self.indices.add(Kind::Normal);
        self.write(format_args!("vn {x} {y} {z}\n"));
        Ok(())
    }

    fn face<'a>(&mut self, words: impl Iterator<Item = &'a str>) -> Result<(), ObjError> {
        self.scan.plain.push('f');
        let mut corners = 0;
        for word in words {
            let place = Place { file: &self.scan.source, line: self.line };
            let [v, vt, vn] = self.indices.corner(word, place)?;
            self.scan.has_texture |= vt.is_some();
            self.scan.has_normals |= vn.is_some();
            let [v, vt, vn] = [v.unwrap_or(0), after_zeros(vt), after_zeros(vn)];
            self.corners.push(v);
            self.write(format_args!(" {v}/{vt}/{vn}"));
            corners += 1;
        }
        self.scan.plain.push('\n');
        if corners < 3 {
            return Err(self.error(format!("a face with {corners} corners"), "a face needs at least 3"));
        }
        self.scan.faces.push(Face { line: self.line, material: self.material, smoothing: self.smoothing });
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
        self.write_vertices();
        Ok(self.scan)
    }

    /// Writes the vertices, last of all, since only now it is known where the mesh lies.
    fn write_vertices(&mut self) {
        let used = self.corners.iter().map(|index| self.vertices[*index as usize - 1]);
        self.scan.origin = origin(used);
        for p in std::mem::take(&mut self.vertices) {
            // A vertex that no face uses may lie anywhere.
            let p = (p - self.scan.origin).clamp(Vec3::MIN.as_dvec3(), Vec3::MAX.as_dvec3());
            self.write(format_args!("v {} {} {}\n", p.x, p.y, p.z));
        }
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

    fn write(&mut self, words: std::fmt::Arguments<'_>) {
        self.scan.plain.write_fmt(words).expect("a String takes all that is written");
    }
}

/// The number in the plain text of a texture coordinate or normal: the zeros for corners without come first.
fn after_zeros(index: Option<u64>) -> u64 {
    index.map_or(1, |index| index + 1)
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
