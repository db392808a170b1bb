//! What does a folder of figures hold already? A small file in it says so, and the drawings' files are held against it.

use std::collections::BTreeMap;
use std::collections::hash_map::DefaultHasher;
use std::fs;
use std::hash::{Hash, Hasher};
use std::path::{Path, PathBuf};

use ::album::{Medium, Shown};
use figures::{Content, Drawing, Words};
use serde_json::{Map, Value, json};

use crate::failure::Failure;
use crate::speech::warn;
use crate::unfinished::Unfinished;

/// The file that says what the others are.
const FILE: &str = ".lab-figures.json";

/// A folder of figures.
pub(crate) struct Album {
    folder: PathBuf,
    /// What was drawn, by stem.
    kept: BTreeMap<String, Kept>,
}

/// What was drawn of one figure or claim.
#[derive(Clone)]
struct Kept {
    /// What it was drawn from; if that is another now, it has to be drawn again.
    from: String,
    /// The values, in a line.
    values: String,
    /// What else came out: a claim's verdict and evidence.
    result: Value,
    drawings: Vec<KeptDrawing>,
}

#[derive(Clone)]
struct KeptDrawing {
    name: String,
    file: String,
    alt: Words,
    fingerprint: String,
}

/// Drawings with the values that they were made with, and what else came out.
pub(crate) struct Taken {
    pub(crate) values: String,
    pub(crate) result: Value,
    pub(crate) drawings: Vec<Shown>,
}

impl Album {
    /// The album in `folder`, which is made if it is not there.
    ///
    /// # Errors
    /// [`Failure`] if there can be no such folder, if it takes no files, or if it has somebody else's page.
    pub(crate) fn open(folder: &Path) -> Result<Self, Failure> {
        let refused = |error: std::io::Error| {
            Failure::io("write to", folder, &error, "choose another folder with --out")
        };
        if folder.exists() && !folder.is_dir() {
            return Err(Failure::new(
                format!("{} is a file, not a folder", folder.display()),
                "choose another folder with --out",
            ));
        }
        fs::create_dir_all(folder).map_err(refused)?;
        Unfinished::beside(&folder.join(FILE)).map_err(refused)?;
        let list = folder.join(FILE);
        if !list.exists() && folder.join(super::PAGE).exists() {
            return Err(Failure::new(
                format!("{} holds an {} that is not from here", folder.display(), super::PAGE),
                "choose another folder with --out, so that nothing of yours is replaced",
            ));
        }
        let text = fs::read_to_string(&list).unwrap_or_default();
        let kept = serde_json::from_str(&text).ok().and_then(|value| all_from_json(&value));
        if kept.is_none() && list.exists() {
            warn(&format!(
                "{} is damaged, so it is not known what was drawn before: `cargo lab figures --out {}` draws all of it anew",
                list.display(),
                folder.display()
            ));
        }
        Ok(Self { folder: folder.to_owned(), kept: kept.unwrap_or_default() })
    }

    /// Whether there are drawings of `stem`, of whatever values.
    pub(crate) fn has(&self, stem: &str) -> bool {
        self.kept.contains_key(stem)
    }

    /// The drawings of `stem`, if their files are as they were written; and only if they were drawn from `from`, if that
    /// is given.
    pub(crate) fn take(&self, stem: &str, from: Option<&str>) -> Option<Taken> {
        let kept = self.kept.get(stem).filter(|kept| from.is_none_or(|from| from == kept.from))?;
        let drawings = kept.drawings.iter().map(|drawing| self.read(drawing)).collect::<Option<_>>()?;
        Some(Taken { values: kept.values.clone(), result: kept.result.clone(), drawings })
    }

    fn read(&self, drawing: &KeptDrawing) -> Option<Shown> {
        let bytes = fs::read(self.folder.join(&drawing.file)).ok()?;
        if fingerprint(&bytes) != drawing.fingerprint {
            return None;
        }
        let medium = if drawing.file.ends_with(".svg") {
            Medium::Svg(String::from_utf8(bytes).ok()?)
        } else {
            Medium::Png(bytes)
        };
        Some(Shown { name: drawing.name.clone(), alt: drawing.alt.clone(), medium })
    }

    /// Writes drawings in place of earlier ones of `stem`.
    ///
    /// # Errors
    /// [`Failure`] if the disk does not take them.
    pub(crate) fn put(
        &mut self,
        stem: &str,
        from: String,
        values: String,
        result: Value,
        drawings: &[Drawing],
    ) -> Result<(), Failure> {
        let mut kept = Vec::new();
        for drawing in drawings {
            let file = drawing.file_name(stem);
            let bytes = match &drawing.content {
                Content::Picture(image) => canvas::codec::encode(image, canvas::Format::Png8)
                    .map_err(|error| Failure::new(error.to_string(), "choose another --size"))?,
                Content::Diagram(svg) => svg.clone().into_bytes(),
            };
            self.write(&file, &bytes)?;
            let fingerprint = fingerprint(&bytes);
            kept.push(KeptDrawing {
                name: drawing.name.clone(),
                file,
                alt: drawing.alt.clone(),
                fingerprint,
            });
        }
        let older = self.kept.insert(stem.to_owned(), Kept { from, values, result, drawings: kept.clone() });
        self.write(FILE, format!("{:#}\n", all_to_json(&self.kept)).as_bytes())?;
        for drawing in older.into_iter().flat_map(|older| older.drawings) {
            if kept.iter().all(|new| new.file != drawing.file) {
                // It shows other values; if it cannot go it is only untidy.
                let _ = fs::remove_file(self.folder.join(drawing.file));
            }
        }
        Ok(())
    }

    /// Writes a file of this folder whole, or leaves the older one.
    ///
    /// # Errors
    /// [`Failure`] if the disk does not take it.
    pub(crate) fn write(&self, file: &str, bytes: &[u8]) -> Result<(), Failure> {
        let path = self.folder.join(file);
        let remedy = "free some space, or choose another folder with --out";
        Unfinished::beside(&path)
            .and_then(|unfinished| unfinished.finish(bytes, None, &path))
            .map_err(|error| Failure::io("write", &path, &error, remedy))
    }
}

/// A number that changes when the bytes do.
pub(crate) fn fingerprint(bytes: &[u8]) -> String {
    let mut hasher = DefaultHasher::new();
    bytes.hash(&mut hasher);
    format!("{:016x}", hasher.finish())
}

fn all_to_json(kept: &BTreeMap<String, Kept>) -> Value {
    let drawing = |drawing: &KeptDrawing| {
        json!({
            "name": drawing.name,
            "file": drawing.file,
            "alt": { "en": drawing.alt.en, "nl": drawing.alt.nl },
            "fingerprint": drawing.fingerprint,
        })
    };
    let one = |kept: &Kept| {
        json!({
            "from": kept.from,
            "values": kept.values,
            "result": kept.result,
            "drawings": kept.drawings.iter().map(drawing).collect::<Vec<_>>(),
        })
    };
    Value::Object(kept.iter().map(|(stem, kept)| (stem.clone(), one(kept))).collect::<Map<_, _>>())
}

fn all_from_json(value: &Value) -> Option<BTreeMap<String, Kept>> {
    let text = |value: &Value, key: &str| value.get(key)?.as_str().map(ToOwned::to_owned);
    let drawing = |value: &Value| {
        let alt = value.get("alt")?;
        let file = text(value, "file")?;
        // Files of this folder only, whatever somebody wrote here.
        let is_own = !file.contains(['/', '\\']) && (file.ends_with(".png") || file.ends_with(".svg"));
        is_own.then_some(())?;
        Some(KeptDrawing {
            name: text(value, "name")?,
            file,
            alt: Words::new(text(alt, "en")?, text(alt, "nl")?),
            fingerprint: text(value, "fingerprint")?,
        })
    };
    let one = |value: &Value| {
        Some(Kept {
            from: text(value, "from")?,
            values: text(value, "values")?,
            result: value.get("result")?.clone(),
            drawings: value.get("drawings")?.as_array()?.iter().map(drawing).collect::<Option<_>>()?,
        })
    };
    value.as_object()?.iter().map(|(stem, value)| Some((stem.clone(), one(value)?))).collect()
}
