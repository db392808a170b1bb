//! Where may a picture go, and how does it get there?
//!
//! What can be known beforehand is checked in [`Target::check`], before the rendering, which may take long. [`Target::write`]
//! then puts the picture in place whole, or leaves everything as it was ([`crate::unfinished`] says how).
//!
//! - A symbolic link is followed: the file that it points to is replaced, the link stays.
//! - A file that is replaced keeps its permissions; a new one gets those that the user's umask leaves.
//! - A read-only file is not replaced, although the system would allow it: somebody wanted it to stay.

use std::fs::{self, Permissions};
use std::io;
use std::path::{Path, PathBuf};

use canvas::{Format, Image, codec};

use crate::failure::Failure;
use crate::unfinished::Unfinished;

/// A file that can be written, going by all that can be known beforehand.
#[derive(Debug)]
pub(crate) struct Target {
    /// As the user named it.
    named: PathBuf,
    /// The file itself, beyond symbolic links.
    file: PathBuf,
    format: Format,
    /// Those of the file that is there now.
    older: Option<Permissions>,
}

impl Target {
    /// Checks that the name is that of a picture, that what is there already may be replaced, and that its folder takes
    /// new files.
    ///
    /// # Errors
    /// [`Failure`] that says which of these is not so.
    pub(crate) fn check(named: &Path) -> Result<Self, Failure> {
        let format = format_of(named)?;
        let file = beyond_links(named)?;
        let older = replaceable(&file, named)?;
        // The surest way to know whether a folder takes a file is to make one. It goes again at once: one that stayed
        // while the picture is rendered would stay for good if the program were killed meanwhile.
        Unfinished::beside(&file).map_err(|error| no_new_file(named, &error))?;
        Ok(Self { named: named.to_owned(), file, format, older })
    }

    /// The file as the user named it.
    pub(crate) fn named(&self) -> &Path {
        &self.named
    }

    /// Whether writing would replace the file at `path`.
    pub(crate) fn replaces(&self, path: &Path) -> bool {
        match (fs::canonicalize(&self.file), fs::canonicalize(path)) {
            (Ok(file), Ok(path)) => file == path,
            _ => false,
        }
    }

    /// Writes the picture and gives the number of bytes.
    ///
    /// # Errors
    /// [`Failure`] if the format cannot hold the picture, or the disk does not take it.
    pub(crate) fn write(&self, image: &Image) -> Result<usize, Failure> {
        let bytes = codec::encode(image, self.format).map_err(|error| {
            Failure::new(
                format!("cannot write {}: {error}", self.named.display()),
                "choose another size or another format: .png, .16.png or .exr",
            )
        })?;
        Unfinished::beside(&self.file)
            .and_then(|unfinished| unfinished.finish(&bytes, self.older.as_ref(), &self.file))
            .map_err(|error| Failure::io("write", &self.named, &error, remedy(&error)))?;
        Ok(bytes.len())
    }
}

/// The format that the name asks for.
fn format_of(named: &Path) -> Result<Format, Failure> {
    if named.as_os_str().is_empty() {
        return Err(Failure::new(
            "the name of the output file is empty",
            "name a file, such as -o picture.png",
        ));
    }
    if named.is_dir() || named.as_os_str().as_encoded_bytes().ends_with(b"/") {
        return Err(Failure::new(
            format!("{} is a folder, not a file", named.display()),
            format!("name a file in it: -o {}", named.join("picture.png").display()),
        ));
    }
    Format::from_path(named).map_err(|error| {
        Failure::new(
            format!("cannot write {}: {error}", named.display()),
            format!(
                "the extension chooses the format: -o {}, say",
                named.with_file_name("picture.png").display()
            ),
        )
    })
}

/// The file itself, where `named` is a symbolic link; the same path elsewhere.
fn beyond_links(named: &Path) -> Result<PathBuf, Failure> {
    if !named.is_symlink() {
        return Ok(named.to_owned());
    }
    fs::canonicalize(named).map_err(|error| {
        let remedy = "remove the link, or choose another name with -o";
        match error.kind() {
            io::ErrorKind::NotFound => {
                Failure::new(format!("{} is a symbolic link to nothing", named.display()), remedy)
            }
            _ => Failure::io("follow the symbolic link", named, &error, remedy),
        }
    })
}

/// The permissions of the file that is there now, if it may be replaced; `None` if there is none.
fn replaceable(file: &Path, named: &Path) -> Result<Option<Permissions>, Failure> {
    let there = match fs::metadata(file) {
        Ok(there) => there,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(no_new_file(named, &error)),
    };
    if !there.is_file() {
        return Err(Failure::new(
            format!("{} is not an ordinary file", named.display()),
            "pictures go to ordinary files: choose another name with -o",
        ));
    }
    if there.permissions().readonly() {
        return Err(Failure::new(
            format!("{} is read-only", named.display()),
            format!("allow it with `chmod u+w {}`, or choose another name with -o", named.display()),
        ));
    }
    Ok(Some(there.permissions()))
}

/// Why no file can be made where `named` should be.
fn no_new_file(named: &Path, error: &io::Error) -> Failure {
    let folder = named.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let (file, folder_name) = (named.display(), folder.display());
    if !folder.exists() && error.kind() == io::ErrorKind::NotFound {
        return Failure::new(
            format!("cannot write {file}: there is no folder {folder_name}"),
            format!("make it with `mkdir -p {folder_name}`, or choose another one with -o"),
        );
    }
    Failure::io("write", named, error, "choose another name, in a folder where you may write, with -o")
}

/// What helps when the bytes do not get onto the disk.
fn remedy(error: &io::Error) -> &'static str {
    match error.kind() {
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => {
            "free some space, or choose a place on another disk with -o"
        }
        io::ErrorKind::FileTooLarge => "allow larger files (`ulimit -f`), or choose a smaller --size",
        _ => "choose another place with -o, and see whether this disk is in order",
    }
}
