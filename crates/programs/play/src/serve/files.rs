//! Of which files does the page consist? They are compiled into the program, so that it needs no folder and no network.

use std::borrow::Cow;
use std::path::Path;

/// A file of the page and what kind it is.
pub(crate) struct File {
    pub(crate) kind: &'static str,
    pub(crate) bytes: Cow<'static, [u8]>,
}

macro_rules! files {
    ($($name:literal),* $(,)?) => {
        const FILES: &[(&str, &[u8])] = &[$(($name, include_bytes!(concat!("../../page/", $name)))),*];
    };
}

files!(
    "address.js",
    "app.js",
    "claims.js",
    "dom.js",
    "drawings.js",
    "figure.css",
    "figures.js",
    "frame.js",
    "handles.js",
    "index.html",
    "look.js",
    "loops.css",
    "loops.js",
    "measure.js",
    "mine.js",
    "names.js",
    "net.js",
    "orbit.js",
    "panel.js",
    "parameters.js",
    "picture.js",
    "refine.js",
    "show.css",
    "show.js",
    "sizes.js",
    "steps.js",
    "story.js",
    "style.css",
    "tables.js",
    "words.js",
);

/// The file of this name; read from `folder` if there is one.
pub(crate) fn find(name: &str, folder: Option<&Path>) -> Option<File> {
    let (known, bytes) = FILES.iter().find(|(known, _)| *known == name)?;
    let fresh = folder.and_then(|folder| std::fs::read(folder.join(known)).ok());
    let kind = match known.rsplit_once('.')?.1 {
        "html" => "text/html; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "js" => "text/javascript; charset=utf-8",
        _ => return None,
    };
    Some(File { kind, bytes: fresh.map_or(Cow::Borrowed(*bytes), Cow::Owned) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_of_the_page_is_in_the_program() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("page");
        for file in std::fs::read_dir(folder).unwrap() {
            let name = file.unwrap().file_name().into_string().unwrap();
            assert!(find(&name, None).is_some(), "{name} is not listed");
        }
    }
}
