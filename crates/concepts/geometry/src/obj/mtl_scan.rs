//! What does each line of the MTL text say? A line that is wrong is an error with its number and a remedy.

use std::collections::HashSet;

use glam::DVec3;

use super::material::ObjMaterial;
use super::message::{ObjError, Warnings, quoted};
use super::text::{self, Line, number};

/// Reads the materials in MTL text, in its order.
///
/// - `names`: those of all materials that were read before; the new ones are added.
///
/// # Errors
/// [`ObjError`]: text that is not UTF-8, numbers that are none, values before the first material, a material without a name.
pub(super) fn scan(
    bytes: &[u8],
    file: &str,
    names: &mut HashSet<String>,
    warnings: &mut Warnings,
) -> Result<Vec<ObjMaterial>, ObjError> {
    let text = text::decode(bytes, file)?;
    let mut scanner = Scanner { file, names, warnings, materials: Vec::new(), material: None };
    for line in text::lines(text) {
        scanner.statement(&line)?;
    }
    scanner.end_material();
    Ok(scanner.materials)
}

/// Greatest difference between `d` and 1 − `Tr` that still says the same: exporters round either of them to two digits.
const ROUNDING: f64 = 0.01;

struct Scanner<'a> {
    file: &'a str,
    names: &'a mut HashSet<String>,
    warnings: &'a mut Warnings,
    /// Those that are complete.
    materials: Vec<ObjMaterial>,
    material: Option<Current>,
}

/// The material whose lines are being read.
#[derive(Default)]
struct Current {
    /// What it is so far, without `dissolve`.
    material: ObjMaterial,
    /// The keywords whose values were taken.
    keywords: HashSet<String>,
    /// `d`.
    dissolve: Option<f64>,
    /// `Tr`, and its line.
    transparency: Option<(f64, usize)>,
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
        if is_known && self.material.is_none() {
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
        self.end_material();
        if !self.names.insert(name.to_owned()) {
            let message = format!("material {} is defined again; its first definition is used", quoted(name));
            self.warn(line, message);
        }
        let material = ObjMaterial { name: name.to_owned(), ..ObjMaterial::default() };
        self.material = Some(Current { material, ..Current::default() });
        Ok(())
    }

    /// Completes the material that ends here. Where `d` and `Tr` contradict each other, `d` decides: some
    /// exporters write the same number for both.
    fn end_material(&mut self) {
        let Some(mut said) = self.material.take() else { return };
        let by_transparency = said.transparency.map(|(transparency, _)| 1.0 - transparency);
        if let (Some(d), Some((transparency, line))) = (said.dissolve, said.transparency)
            && (d - (1.0 - transparency)).abs() > ROUNDING
        {
            let message = format!("Tr {transparency} contradicts d {d}; d is used, since Tr should be 1 - d");
            self.warnings.add(self.file, Some(line), message);
        }
        said.material.dissolve = said.dissolve.or(by_transparency).map(|share| share as f32);
        self.materials.push(said.material);
    }

    /// Notes that a value of `keyword` is taken.
    fn take(&mut self, line: &Line<'_>, keyword: &str) -> &mut Current {
        let is_new = self.material.get_or_insert_default().keywords.insert(keyword.to_owned());
        if !is_new {
            self.warn(line, format!("{keyword} occurs again in one material; the last one is used"));
        }
        self.material.get_or_insert_default()
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
            let color = Some(DVec3::new(r, g, b).as_vec3());
            let material = &mut self.take(line, keyword).material;
            match keyword {
                "Ka" => material.ambient = color,
                "Kd" => material.diffuse = color,
                _ => material.specular = color,
            }
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
        let said = self.take(line, keyword);
        match keyword {
            "d" => said.dissolve = Some(value),
            "Tr" => said.transparency = Some((value, line.number)),
            "illum" => said.material.illumination_model = Some(value as u8),
            "Ns" => said.material.exponent = Some(value as f32),
            _ => said.material.refractive_index = Some(value as f32),
        }
        Ok(())
    }

    fn warn(&mut self, line: &Line<'_>, message: String) {
        self.warnings.add(self.file, Some(line.number), message);
    }

    fn error(&self, line: &Line<'_>, problem: impl Into<String>, remedy: &str) -> ObjError {
        ObjError::new(self.file, Some(line.number), problem, remedy)
    }
}
