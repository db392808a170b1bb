//! Which materials do the faces name? Those of the MTL files.

use std::collections::{HashMap, HashSet};

use super::material::ObjMaterial;
use super::message::{ObjError, Warnings, quoted};
use super::mtl_scan;
use super::scan::Scan;

/// All materials of all files, the default first.
pub(super) struct Library {
    pub(super) materials: Vec<ObjMaterial>,
    /// The place of each material in the list. Of several with one name it is the first.
    numbers: HashMap<String, u32>,
}

/// So many material files may one `mtllib` name.
const MOST_NAMES: usize = 16;

impl Library {
    /// Reads the files that the OBJ text names. One that cannot be had is a warning.
    pub(super) fn load(
        scan: &Scan,
        load_mtl: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
        warnings: &mut Warnings,
    ) -> Result<Self, ObjError> {
        let mut library = Self { materials: vec![ObjMaterial::default()], numbers: HashMap::new() };
        let (mut names_read, mut files_read) = (HashSet::new(), HashSet::new());
        for reference in &scan.libraries {
            // One name with spaces in it, or several names: the text does not say. More than a few are no list.
            let whole = load_mtl(&reference.name);
            let names: Vec<&str> = reference.name.split_whitespace().collect();
            let files = match (whole, &names[..]) {
                (Err(_), [_, _, ..]) if names.len() <= MOST_NAMES => {
                    names.iter().map(|name| (*name, load_mtl(name))).collect()
                }
                (whole, _) => vec![(reference.name.as_str(), whole)],
            };
            for (name, bytes) in files {
                if !files_read.insert(name) {
                    continue;
                }
                match bytes {
                    Ok(bytes) => library.add(mtl_scan::scan(&bytes, name, &mut names_read, warnings)?),
                    Err(reason) => warnings.add(
                        &scan.source,
                        Some(reference.line),
                        format!(
                            "material file {} cannot be read ({reason}); the default is used",
                            quoted(name)
                        ),
                    ),
                }
            }
        }
        Ok(library)
    }

    /// The number of the material for each name that the OBJ text uses; the default, 0, for unknown ones.
    pub(super) fn numbers_of(&self, scan: &Scan, warnings: &mut Warnings) -> Vec<u32> {
        let number = |reference: &super::scan::Reference| {
            self.numbers.get(&reference.name).copied().unwrap_or_else(|| {
                let message = format!("no material {}; the default is used", quoted(&reference.name));
                warnings.add(&scan.source, Some(reference.line), message);
                0
            })
        };
        scan.used.iter().map(number).collect()
    }

    fn add(&mut self, materials: Vec<ObjMaterial>) {
        for material in materials {
            if !self.numbers.contains_key(&material.name) {
                self.numbers.insert(material.name.clone(), self.materials.len() as u32);
                self.materials.push(material);
            }
        }
    }
}
