//! Is every submission taken in as its author meant it, whatever a platform made of its name, and whatever its author put in beside it?

use std::fs;
use std::io::Write;
use std::path::Path;

use class::intake::{Class, ClassError, Taken};
use class::results::Audience;
use tempfile::TempDir;
use zip::write::SimpleFileOptions;

pub(crate) const TEXT: &str = "pub fn lambert() {}\n";

/// A class's folder with these files; the text of each is its own path unless it is given.
pub(crate) fn folder(files: &[&str]) -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for file in files {
        write(&folder.path().join(file), file.as_bytes());
    }
    folder
}

fn write(path: &Path, bytes: &[u8]) {
    fs::create_dir_all(path.parent().expect("a folder")).expect("made");
    fs::write(path, bytes).expect("written");
}

fn zip(path: &Path, files: &[(&str, &[u8])]) {
    let mut archive = zip::ZipWriter::new(fs::File::create(path).expect("made"));
    for (name, bytes) in files {
        archive.start_file(*name, SimpleFileOptions::default()).expect("begun");
        archive.write_all(bytes).expect("written");
    }
    archive.finish().expect("finished");
}

pub(crate) fn read(folder: &TempDir) -> Class {
    Class::read(folder.path()).expect("a class")
}

pub(crate) fn only(class: &Class) -> Taken {
    assert_eq!(class.entries.len(), 1, "{:?}", class.entries);
    class.entries[0].take().expect("taken")
}

pub(crate) fn lambert(taken: &Taken) -> Option<&str> {
    taken.files.get("lambert").map(|bytes| std::str::from_utf8(bytes).expect("text"))
}

pub(crate) fn words(taken: &Taken) -> String {
    taken.notices.iter().map(|notice| notice.text.as_str()).collect::<Vec<_>>().join("\n")
}

#[test]
fn only_the_exercises_files_are_taken_and_the_rest_is_said() {
    let folder = folder(&[
        "ada/lighting/lambert.rs",
        "ada/Cargo.toml",
        "ada/build.rs",
        "ada/.cargo/config.toml",
        "ada/src/helper.rs",
        "ada/target/debug/lambert.rs",
        "ada/__MACOSX/lighting/._lambert.rs",
    ]);
    let taken = only(&read(&folder));
    assert_eq!(taken.files.len(), 1);
    assert_eq!(lambert(&taken), Some("ada/lighting/lambert.rs"));
    assert_eq!(
        words(&taken),
        "Only the exercises' files are judged; ignored: Cargo.toml, build.rs, src/helper.rs."
    );
}

#[test]
fn nested_folders_and_archives_are_seen_through() {
    for place in ["ada/lambert.rs", "ada/lab-1/exercises/lighting/lambert.rs", "ada/a/b/c/lambert.rs"] {
        assert_eq!(lambert(&only(&read(&folder(&[place])))), Some(place));
    }
    let inside: &[(&str, &[u8])] =
        &[("lab/lighting/lambert.rs", TEXT.as_bytes()), ("__MACOSX/._lambert.rs", b"x")];
    let class = tempfile::tempdir().expect("a folder");
    zip(&class.path().join("ada.zip"), inside);
    assert_eq!(lambert(&only(&read(&class))), Some(TEXT));
    let class = tempfile::tempdir().expect("a folder");
    fs::create_dir(class.path().join("Ada_1_assignsubmission_file_")).expect("made");
    zip(&class.path().join("Ada_1_assignsubmission_file_/lab.ZIP"), inside);
    assert_eq!(lambert(&only(&read(&class))), Some(TEXT));
    assert_eq!(read(&class).entries[0].student, "Ada");
}

#[test]
fn the_latest_attempt_counts_and_the_staff_is_told() {
    let folder = folder(&["ada/lambert.rs", "ada (2)/lambert.rs", "ada-late/lambert.rs", "bob/lambert.rs"]);
    let class = read(&folder);
    let ids: Vec<&str> = class.entries.iter().map(|entry| entry.id.as_str()).collect();
    assert_eq!(ids, ["ada", "bob"]);
    let ada = &class.entries[0];
    assert_eq!(lambert(&ada.take().expect("taken")), Some("ada-late/lambert.rs"));
    let told: Vec<&str> = ada.notices.iter().map(|notice| notice.text.as_str()).collect();
    assert_eq!(
        told,
        ["Its name says that it came late.", "The latest attempt was judged, not ada, ada (2)."]
    );
    assert!(ada.notices.iter().all(|notice| notice.audience == Audience::Staff));
}

#[test]
fn loose_files_are_put_together_by_student() {
    let folder = folder(&[
        "lovelaceada_1_10_lambert.rs",
        "lovelaceada_1_11_halfway.rs",
        "lovelaceada_1_12_lambert.rs",
        "hopper_LATE_2_13_lambert-1.rs",
        "grades.csv",
    ]);
    let class = read(&folder);
    let students: Vec<&str> = class.entries.iter().map(|entry| entry.student.as_str()).collect();
    assert_eq!(students, ["hopper", "lovelaceada"]);
    let ada = class.entries[1].take().expect("taken");
    assert_eq!(lambert(&ada), Some("lovelaceada_1_12_lambert.rs"), "the newer one");
    assert!(ada.files.contains_key("halfway"));
    assert!(class.entries[0].take().expect("taken").files.contains_key("lambert"));
    assert_eq!(class.remarks, ["nobody's submission, and ignored: grades.csv"]);
}

#[test]
fn names_with_anything_in_them_get_ids_that_fit_a_file_name() {
    let folder = folder(&[]);
    let names =
        ["<script>alert(1)<", "=cmd()|' ' !A0", "a\nb", "Å", "å", "con", "a..b", "o'\"k", &"x".repeat(200)];
    for name in names {
        fs::create_dir(folder.path().join(name.replace('/', "_"))).expect("made");
    }
    let class = read(&folder);
    assert_eq!(class.entries.len(), names.len());
    for entry in &class.entries {
        let fits =
            entry.id.chars().all(|c| c.is_ascii_alphanumeric() || "-_".contains(c)) && entry.id.len() < 64;
        assert!(fits, "{:?}", entry.id);
    }
    let mut lower: Vec<String> = class.entries.iter().map(|entry| entry.id.to_lowercase()).collect();
    lower.sort();
    lower.dedup();
    assert_eq!(lower.len(), names.len());
    assert!(class.entries.iter().any(|entry| entry.student == "a\nb"));
}

#[cfg(unix)]
#[test]
fn links_are_not_followed() {
    let secret = folder(&["lambert.rs"]);
    let class = folder(&["ada/halfway.rs"]);
    std::os::unix::fs::symlink(secret.path().join("lambert.rs"), class.path().join("ada/lambert.rs"))
        .expect("linked");
    std::os::unix::fs::symlink(secret.path(), class.path().join("ada/deeper")).expect("linked");
    std::os::unix::fs::symlink(secret.path(), class.path().join("eve")).expect("linked");
    let read = read(&class);
    let taken = only(&read);
    assert_eq!(taken.files.keys().collect::<Vec<_>>(), [&"halfway"]);
    assert_eq!(words(&taken), "Symbolic links are not followed: deeper, lambert.rs.");
    assert_eq!(
        read.remarks,
        ["symbolic links, so not followed (if one is a student's, copy what it points to): eve"]
    );
}

#[test]
fn an_archive_cannot_lead_out_of_itself() {
    let class = tempfile::tempdir().expect("a folder");
    let mut archive = zip::ZipWriter::new(fs::File::create(class.path().join("eve.zip")).expect("made"));
    let plain = SimpleFileOptions::default();
    for name in ["../lambert.rs", "/tmp/halfway.rs", "a/../../lambert.rs", "..\\halfway.rs"] {
        archive.start_file(name, plain).expect("begun");
        archive.write_all(TEXT.as_bytes()).expect("written");
    }
    archive.add_symlink("lambert_link/lambert.rs", "/etc/passwd", plain).expect("linked");
    archive.finish().expect("finished");
    let taken = only(&read(&class));
    assert!(taken.files.is_empty(), "{taken:?}");
    assert!(words(&taken).contains("lead out of it are ignored"), "{}", words(&taken));
    assert!(words(&taken).contains("Symbolic links are not followed"), "{}", words(&taken));
    assert_eq!(fs::read_dir(class.path()).expect("read").count(), 1);
}

#[test]
fn a_bomb_is_read_no_further_than_a_solution_is_long() {
    let class = tempfile::tempdir().expect("a folder");
    // A thousandth of the size on the disk.
    zip(&class.path().join("eve.zip"), &[("lambert.rs", &vec![b' '; 200 << 20]), ("bob.rs", &[0])]);
    assert!(fs::metadata(class.path().join("eve.zip")).expect("there").len() < 1 << 20);
    let taken = only(&read(&class));
    assert_eq!(taken.files["lambert"].len() as u64, grader::LONGEST_FILE + 1);
}

#[test]
fn a_torn_archive_is_an_empty_submission_and_said() {
    let class = folder(&["ada.zip", "bob/x.tar.gz", "eve/lambert.rs"]);
    let read = read(&class);
    let all: Vec<Taken> = read.entries.iter().map(|entry| entry.take().expect("taken")).collect();
    assert!(all[0].files.is_empty() && words(&all[0]).starts_with("The archive ada.zip cannot be read: "));
    assert!(
        all[1].files.is_empty() && words(&all[1]).contains("hand in the files themselves, or a zip archive")
    );
    assert_eq!(lambert(&all[2]), Some("eve/lambert.rs"));
}

#[test]
fn ten_thousand_files_and_a_hundred_megabytes_are_borne() {
    let class = folder(&["eve/lambert.rs", "ada/lambert.rs"]);
    for number in 0..10_000 {
        write(&class.path().join(format!("eve/more/{}/{number}.rs", number % 100)), b"");
    }
    let large = fs::File::create(class.path().join("eve/halfway.rs")).expect("made");
    large.set_len(100 << 20).expect("large");
    let read = read(&class);
    let eve = read.entries[1].take().expect("taken");
    assert_eq!(lambert(&eve), Some("eve/lambert.rs"));
    assert_eq!(eve.files["halfway"].len() as u64, grader::LONGEST_FILE + 1);
    assert!(words(&eve).ends_with("and 9992 more."), "{}", words(&eve));
    assert_eq!(words(&read.entries[0].take().expect("taken")), "");
}

#[test]
fn an_empty_folder_is_no_class_and_a_file_is_none() {
    assert!(matches!(Class::read(folder(&["notes.txt"]).path()), Err(ClassError::Empty(_))));
    assert!(matches!(Class::read(Path::new("nowhere")), Err(ClassError::Io { .. })));
}
