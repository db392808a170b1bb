//! Which materials do the faces name? Those of the MTL files.

use std::collections::HashMap;
use std::fmt::Write;

use glam::Vec3;

use super::material::ObjMaterial;
use super::message::{ObjError, Warnings, quoted};
use super::scan::Scan;
use super::text::{self, Line, number};

/// All materials of all files, the default first.
pub(super) struct Library {
    pub(super) materials: Vec<ObjMaterial>,
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
                match bytes {
                    Ok(bytes) => library.add(parse(&bytes, name, warnings)?),
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
            self.numbers.insert(material.name.clone(), self.materials.len() as u32);
            self.materials.push(material);
        }
    }
}

/// The materials in MTL text.
fn parse(bytes: &[u8], file: &str, warnings: &mut Warnings) -> Result<Vec<ObjMaterial>, ObjError> {
    let plain = scan(bytes, file, warnings)?;
    let (materials, _) = tobj::load_mtl_buf(&mut plain.as_bytes()).map_err(|reason| {
        ObjError::new(
            file,
            None,
            format!("the MTL reader refuses the text: {reason}"),
            "export the materials anew",
        )
    })?;
    let color = |rgb: Option<[f32; 3]>| rgb.map(Vec3::from_array);
    let convert = |m: tobj::Material| ObjMaterial {
        ambient: color(m.ambient),
        diffuse: color(m.diffuse),
        specular: color(m.specular),
        exponent: m.shininess,
        dissolve: m.dissolve,
        refractive_index: m.optical_density,
        illumination_model: m.illumination_model,
        name: m.name,
    };
    Ok(materials.into_iter().map(convert).collect())
}

/// Checks MTL text line by line and writes plainly what it says: tobj reports no lines and panics on colours with fewer
/// than three numbers.
fn scan(bytes: &[u8], file: &str, warnings: &mut Warnings) -> Result<String, ObjError> {
    let text = text::decode(bytes, file)?;
    let mut scanner =
        Scanner { file, warnings, plain: String::with_capacity(text.len()), in_material: false };
    for line in text::lines(text) {
        scanner.statement(&line)?;
    }
    Ok(scanner.plain)
}

struct Scanner<'a> {
    file: &'a str,
    warnings: &'a mut Warnings,
    plain: String,
    in_material: bool,
}

impl Scanner<'_> {
    fn statement(&mut self, line: &Line<'_>) -> Result<(), ObjError> {
        let code = line.text.split('#').next().unwrap_or_default();
        let words: Vec<&str> = code.split_whitespace().collect();
        let Some((&keyword, values)) = words.split_first() else {
            return Ok(());
        };
        if keyword == "newmtl" {
            return self.new_material(line);
        }
        let is_known = matches!(keyword, "Ka" | "Kd" | "Ks" | "Ns" | "d" | "Tr" | "Ni" | "illum");
        if is_known && !self.in_material {
            return Err(self.error(
                line,
                format!("{keyword} before any material"),
                "begin with: newmtl NAME",
            ));
        }
        match keyword {
            "Ka" | "Kd" | "Ks" => self.color(line, keyword, values),
            "Ns" => self.scalar(line, keyword, values, (0.0, f32::MAX.into())),
            "d" | "Tr" => self.scalar(line, keyword, values, (0.0, 1.0)),
            "Ni" => self.scalar(line, keyword, values, (f32::MIN_POSITIVE.into(), f32::MAX.into())),
            "illum" => self.scalar(line, keyword, values, (0.0, 10.0)),
            other => {
                self.warn(line, format!("{} is left out", quoted(other)));
                Ok(())
            }
        }
    }

    fn new_material(&mut self, line: &Line<'_>) -> Result<(), ObjError> {
        let name = line.text.trim_start().strip_prefix("newmtl").unwrap_or_default().trim();
        if name.is_empty() {
            return Err(self.error(line, "newmtl without a name", "write a name, as in: newmtl clay"));
        }
        self.in_material = true;
        self.write(format_args!("newmtl {name}\n"));
        Ok(())
    }

    /// One number is a grey; three are red, green and blue.
    fn color(&mut self, line: &Line<'_>, keyword: &str, values: &[&str]) -> Result<(), ObjError> {
        if let [form @ ("spectral" | "xyz"), ..] = values {
            self.warn(line, format!("{keyword} {form} is left out: only RGB is read"));
            return Ok(());
        }
        let numbers =
            values.iter().map(|word| number(word, self.file, line.number)).collect::<Result<Vec<_>, _>>()?;
        let [r, g, b] = match numbers[..] {
            [grey] => [grey; 3],
            [r, g, b] => [r, g, b],
            _ => {
                let problem = format!("{keyword} with {} numbers", numbers.len());
                return Err(self.error(line, problem, "write 3, red green blue, or 1 for a grey"));
            }
        };
        if r < 0.0 || g < 0.0 || b < 0.0 {
            self.warn(line, format!("{keyword} with a negative number is left out"));
        } else {
            if r > 1.0 || g > 1.0 || b > 1.0 {
                self.warn(
                    line,
                    format!("{keyword} above 1 gives back more light than arrives; it is taken as it stands"),
                );
            }
            self.write(format_args!("{keyword} {r} {g} {b}\n"));
        }
        Ok(())
    }

    fn scalar(
        &mut self,
        line: &Line<'_>,
        keyword: &str,
        values: &[&str],
        (least, greatest): (f64, f64),
    ) -> Result<(), ObjError> {
        let value = match values {
            ["-halo", value] | [value] => number(value, self.file, line.number)?,
            _ => {
                let problem = format!("{keyword} with {} values", values.len());
                return Err(self.error(line, problem, "write 1 number"));
            }
        };
        if !(least <= value && value <= greatest) {
            self.warn(line, format!("{keyword} out of its range is left out"));
            return Ok(());
        }
        match keyword {
            // Transparency is the opposite of dissolve.
            "Tr" => self.write(format_args!("d {}\n", 1.0 - value)),
            "illum" => self.write(format_args!("illum {}\n", value as u8)),
            _ => self.write(format_args!("{keyword} {value}\n")),
        }
        Ok(())
    }

    fn warn(&mut self, line: &Line<'_>, message: String) {
        self.warnings.add(self.file, Some(line.number), message);
    }

    fn error(&self, line: &Line<'_>, problem: impl Into<String>, remedy: &str) -> ObjError {
        ObjError::new(self.file, Some(line.number), problem, remedy)
    }

    fn write(&mut self, words: std::fmt::Arguments<'_>) {
        self.plain.write_fmt(words).expect("a String takes all that is written");
    }
}
