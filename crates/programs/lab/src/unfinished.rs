//! What becomes of a file that is half written? Nobody sees it.
//!
//! The bytes go to a temporary file in the folder of the picture, `.lab-….tmp`. When all of them are on the disk, it takes
//! the name of the picture in one step; until then an older picture of that name stays as it is. If writing fails, the
//! temporary file goes.
//!
//! [`abandon`] is for the thread that waits for Ctrl-C. Whoever creates, renames or removes the file holds the lock of
//! [`CURRENT`] meanwhile; `abandon` takes it and never gives it back, so that no file can be made between the signal and
//! the end of the program.

use std::fs::Permissions;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use tempfile::{Builder, NamedTempFile};

/// The path of the one temporary file, while there is one.
static CURRENT: Mutex<Option<PathBuf>> = Mutex::new(None);

/// A temporary file; dropping it removes it.
#[derive(Debug)]
pub(crate) struct Unfinished {
    /// `None` once it has its final name.
    file: Option<NamedTempFile>,
}

impl Unfinished {
    /// An empty file in the folder of `target`, with the permissions that the umask leaves to any new file.
    ///
    /// # Errors
    /// That of the system: there is no such folder, it takes no files, …
    pub(crate) fn beside(target: &Path) -> io::Result<Self> {
        let folder = match target.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        let mut builder = Builder::new();
        builder.prefix(".lab-").suffix(".tmp");
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));

        let mut current = lock();
        let file = builder.tempfile_in(folder)?;
        *current = Some(file.path().to_owned());
        Ok(Self { file: Some(file) })
    }

    /// Fills it, sees it onto the disk, and gives it the name `target`.
    ///
    /// # Errors
    /// That of the system: the disk is full, … Nothing has changed then, and the temporary file is gone.
    pub(crate) fn finish(
        mut self,
        bytes: &[u8],
        permissions: Option<&Permissions>,
        target: &Path,
    ) -> io::Result<()> {
        let Some(mut file) = self.file.take() else {
            return Ok(());
        };
        // Some disks say only at the synchronization that they are full.
        let filled = file
            .write_all(bytes)
            .and_then(|()| permissions.map_or(Ok(()), |these| file.as_file().set_permissions(these.clone())))
            .and_then(|()| file.as_file().sync_all());

        let mut current = lock();
        let named = filled.and_then(|()| Ok(file.persist(target).map(drop)?));
        // It has its name, or the error has taken the file along and removed it.
        *current = None;
        named
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        if let Some(file) = self.file.take() {
            let mut current = lock();
            drop(file);
            *current = None;
        }
    }
}

/// Removes the temporary file, if there is one. The program ends before what this gives is dropped, so that nobody makes
/// another one.
#[cfg(any(unix, test))]
#[must_use = "a new file can be made as soon as this is dropped"]
pub(crate) fn abandon() -> impl Sized {
    let current = lock();
    if let Some(path) = current.as_deref() {
        // Nothing more can be done if this fails.
        let _ = std::fs::remove_file(path);
    }
    current
}

fn lock() -> MutexGuard<'static, Option<PathBuf>> {
    // A panic elsewhere leaves the path as true as it was.
    CURRENT.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::sync::mpsc;
    use std::time::Duration;

    use super::*;

    /// There is one temporary file at a time, so these tests take turns.
    static TURN: Mutex<()> = Mutex::new(());

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).unwrap();
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
    }

    #[test]
    fn a_finished_file_replaces_the_older_one() {
        let _turn = TURN.lock();
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("a.png");
        fs::write(&target, "old").unwrap();
        let unfinished = Unfinished::beside(&target).unwrap();
        assert_eq!(names(folder.path()).len(), 2);
        unfinished.finish(b"new", None, &target).unwrap();
        assert_eq!(names(folder.path()), ["a.png"]);
        assert_eq!(fs::read(&target).unwrap(), b"new");
        assert_eq!(*lock(), None);
    }

    #[test]
    fn a_file_that_cannot_be_finished_or_is_not_goes() {
        let _turn = TURN.lock();
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("folder");
        fs::create_dir(&target).unwrap();
        let unfinished = Unfinished::beside(&target).unwrap();
        assert!(unfinished.finish(b"new", None, &target).is_err(), "a folder is in the way");
        drop(Unfinished::beside(&target).unwrap());
        assert_eq!(names(folder.path()), ["folder"]);
        assert_eq!(*lock(), None);
    }

    #[test]
    fn after_the_signal_the_file_is_gone_and_no_other_is_made() {
        let _turn = TURN.lock();
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("a.png");
        let unfinished = Unfinished::beside(&target).unwrap();
        let no_new_file = abandon();
        assert!(names(folder.path()).is_empty());

        let (made, wait) = mpsc::channel();
        let other = target.clone();
        let making = std::thread::spawn(move || made.send(Unfinished::beside(&other).is_ok()));
        assert!(wait.recv_timeout(Duration::from_millis(50)).is_err(), "made a file after the signal");
        assert!(names(folder.path()).is_empty());

        // The program would have ended here; the test goes on, so that nobody waits for ever.
        drop(no_new_file);
        assert_eq!(wait.recv(), Ok(true));
        making.join().unwrap().unwrap();
        drop(unfinished);
        assert!(names(folder.path()).is_empty());
    }
}
