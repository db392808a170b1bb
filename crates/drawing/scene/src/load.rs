//! Which file is it? A scene or a bare mesh comes in from the disk.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::sync::Arc;

use geometry::obj::{self, Import, ObjError};

use crate::SceneError;
use crate::frame::framed;
use crate::limits::{MOST_MESH_BYTES, MOST_SCENE_BYTES};
use crate::mtl::exponent_warning;
use crate::parse::{Source, parse};
use crate::scene::Scene;

/// OBJ files that were read, by their paths as the scene writes them.
pub(crate) type Imports = BTreeMap<String, Arc<Import>>;

/// A scene with all files it names.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// What the file says. Change it before [`crate::prepare()`] if you like; the settings are in it.
    pub scene: Scene,
    /// What was wrong but could be tolerated: a missing MTL file, say. One sentence each.
    pub warnings: Vec<String>,
    pub(crate) imports: Imports,
}

/// Reads a `.toml` scene or a `.obj` mesh.
///
/// A bare mesh is framed by itself: moved to the origin and scaled whatever its size and place, lit by a key and a fill
/// light, and seen from a little above and aside, all of it in the picture.
///
/// # Errors
/// [`SceneError`] with file, line and column, and what would be right.
pub fn load(path: &Path) -> Result<Loaded, SceneError> {
    let file = path.display().to_string();
    let extension = path.extension().map(|extension| extension.to_string_lossy().to_lowercase());
    match extension.as_deref() {
        Some("toml") => load_scene(path, &file),
        Some("obj") => load_mesh(path, &file),
        _ => Err(whole_file(
            &file,
            "this is neither a scene nor a mesh, going by its name",
            "name a .toml scene or a .obj mesh",
        )),
    }
}

impl Loaded {
    /// The scene that a text describes, with the OBJ files it names.
    ///
    /// - `file`: the name of the text in messages.
    /// - `folder`: what paths in it are relative to.
    ///
    /// # Errors
    /// As for [`load`].
    pub fn from_toml(text: &str, file: &str, folder: &Path) -> Result<Self, SceneError> {
        let parsed = parse(text, file)?;
        let source = Source { file, text };
        let mut loaded = Self { scene: parsed.scene, warnings: parsed.warnings, imports: Imports::new() };
        for (name, span) in &parsed.obj_paths {
            if !loaded.imports.contains_key(name) {
                let path = folder.join(name);
                // A missing file is a fault of the line that names it; what is wrong inside has a line of its own.
                let bytes = read(&path, MOST_MESH_BYTES).map_err(|reason| {
                    source.fault(span, reason, "paths are relative to the folder of the scene file")
                })?;
                let import = import(&path, &bytes, &mut loaded.warnings)?;
                loaded.imports.insert(name.clone(), import);
            }
        }
        Ok(loaded)
    }

    /// A scene that was built in memory, with the OBJ files it names, relative to `folder`.
    ///
    /// # Errors
    /// As for [`load`]; lines and columns are those of [`Scene::to_toml`].
    pub fn from_scene(scene: &Scene, folder: &Path) -> Result<Self, SceneError> {
        Self::from_toml(&scene.to_toml(), "the scene in memory", folder)
    }
}

/// Reads one OBJ text and the MTL files beside it; what could be borne is added to `warnings`.
fn import(path: &Path, bytes: &[u8], warnings: &mut Vec<String>) -> Result<Arc<Import>, SceneError> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let mut load_mtl = |mtl: &str| read(&folder.join(mtl), MOST_MESH_BYTES);
    let import = obj::parse(bytes, &path.display().to_string(), &mut load_mtl)?;
    warnings.extend(import.warnings.iter().map(ToString::to_string));
    let exponents = exponent_warning(&import.materials);
    warnings.extend(exponents.map(|warning| format!("{}: {warning}", path.display())));
    Ok(Arc::new(import))
}

fn load_scene(path: &Path, file: &str) -> Result<Loaded, SceneError> {
    let bytes = read(path, MOST_SCENE_BYTES)
        .map_err(|reason| whole_file(file, &reason, "name a scene file that can be read"))?;
    let text = String::from_utf8(bytes).map_err(|error| {
        let valid = error.utf8_error().valid_up_to();
        let text = String::from_utf8_lossy(error.as_bytes());
        let source = Source { file, text: &text };
        source.fault(&(valid..valid), "the text is not UTF-8 from here on", "save it as UTF-8")
    })?;
    Loaded::from_toml(&text, file, path.parent().unwrap_or(Path::new("")))
}

fn load_mesh(path: &Path, file: &str) -> Result<Loaded, SceneError> {
    let bytes = read(path, MOST_MESH_BYTES)
        .map_err(|reason| whole_file(file, &reason, "name a mesh file that can be read"))?;
    // The scene names the mesh as its neighbour, so that it can be written beside it.
    let name = path.file_name().map_or_else(|| file.to_owned(), |name| name.to_string_lossy().into_owned());
    let mut warnings = Vec::new();
    let import = import(path, &bytes, &mut warnings)?;
    let scene = framed(&import.mesh, &name)
        .map_err(|problem| whole_file(file, &problem, "a mesh needs corners that lie apart"))?;
    Ok(Loaded { scene, warnings, imports: Imports::from([(name, import)]) })
}

/// The contents of a regular file of at most `most` bytes. Devices and pipes, which may never end, are refused.
fn read(path: &Path, most: u64) -> Result<Vec<u8>, String> {
    let shown = path.display();
    let about = fs::metadata(path).map_err(|error| format!("cannot read {shown}: {error}"))?;
    if !about.is_file() {
        return Err(format!("cannot read {shown}: it is not a file"));
    }
    if about.len() > most {
        return Err(format!("{shown} has {} bytes; at most {most} are read", about.len()));
    }
    fs::read(path).map_err(|error| format!("cannot read {shown}: {error}"))
}

fn whole_file(file: &str, problem: &str, remedy: &str) -> SceneError {
    SceneError {
        file: file.to_owned(),
        line: None,
        column: None,
        problem: problem.to_owned(),
        remedy: remedy.to_owned(),
    }
}

impl From<ObjError> for SceneError {
    fn from(error: ObjError) -> Self {
        Self {
            file: error.file,
            line: error.line,
            column: None,
            problem: error.problem,
            remedy: error.remedy,
        }
    }
}
