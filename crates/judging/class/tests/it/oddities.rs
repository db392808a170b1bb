//! Is a word said about everything odd that a class's folder or a submission holds, and does it hinder nothing else?

use std::fs;
use std::io::Write;
use std::path::Path;

use class::intake::{Class, Taken};
use zip::write::SimpleFileOptions;

use crate::intake::{TEXT, folder, lambert, only, read, words};

/// A zip of entries with names that have nothing to do with one another, as hostile programs write it.
fn zip(path: &Path, names: &[&str]) {
    let mut archive = zip::ZipWriter::new(fs::File::create(path).expect("made"));
    for name in names {
        archive.start_file(*name, SimpleFileOptions::default()).expect("begun");
        archive.write_all(format!("{TEXT}// {name}\n").as_bytes()).expect("written");
    }
    archive.finish().expect("finished");
}

fn of_a_zip(names: &[&str]) -> Taken {
    let class = tempfile::tempdir().expect("a folder");
    zip(&class.path().join("eve.zip"), names);
    only(&read(&class))
}

/// Replaces bytes wherever they stand in a file, both in an entry and in the directory of an archive.
fn replace(path: &Path, old: &[u8], new: &[u8]) {
    assert_eq!(old.len(), new.len());
    let mut bytes = fs::read(path).expect("read");
    let places: Vec<usize> =
        (0..bytes.len() - old.len()).filter(|at| bytes[*at..].starts_with(old)).collect();
    assert!(!places.is_empty());
    for at in places {
        bytes[at..at + old.len()].copy_from_slice(new);
    }
    fs::write(path, bytes).expect("written");
}

#[test]
fn every_path_that_leads_out_of_an_archive_is_said() {
    for name in
        ["../lambert.rs", "a/../../lambert.rs", "..\\lambert.rs", "/tmp/lambert.rs", "C:\\lambert.rs", "a/.."]
    {
        let taken = of_a_zip(&[name, "halfway.rs"]);
        assert_eq!(taken.files.keys().collect::<Vec<_>>(), [&"halfway"], "{name}");
        let said = format!("lead out of it are ignored: {}.", name.replace('\\', "/"));
        assert!(words(&taken).contains(&said), "{name}: {}", words(&taken));
    }
}

#[test]
fn a_name_that_is_twice_in_an_archive_is_said() {
    let class = tempfile::tempdir().expect("a folder");
    let path = class.path().join("eve.zip");
    zip(&path, &["lambert.rs", "lambeRT.rs", "halfway.rs"]);
    replace(&path, b"lambeRT.rs", b"lambert.rs");
    let taken = only(&read(&class));
    assert!(
        words(&taken).contains("holds a name more than once; the last of them counts: lambert.rs."),
        "{}",
        words(&taken)
    );
    assert_eq!(taken.files.len(), 2, "the other file is judged all the same");
    // The same place in two spellings is two files, of which one is judged.
    assert!(
        words(&of_a_zip(&["a/lambert.rs", "a\\lambert.rs"]))
            .contains("For lambert, a/lambert.rs was judged, not")
    );
}

#[test]
fn an_archive_that_begins_with_something_else_is_read_to_the_same_end() {
    let class = tempfile::tempdir().expect("a folder");
    let path = class.path().join("eve.zip");
    zip(&path, &["lambert.rs", "lambeRT.rs"]);
    replace(&path, b"lambeRT.rs", b"lambert.rs");
    let mut bytes = b"#!/bin/sh\nexec unzip \"$0\"\n".to_vec();
    bytes.extend(fs::read(&path).expect("read"));
    fs::write(&path, bytes).expect("written");
    assert!(words(&only(&read(&class))).contains("the last of them counts: lambert.rs."));
}

#[test]
fn what_is_hidden_is_said_if_it_is_an_exercise() {
    let class = folder(&[
        "eve/.work/lambert.rs",
        "eve/a/.b/halfway.rs",
        "eve/.cargo/config.toml",
        "eve/.git/lambert.rs",
        "eve/._lambert.rs",
    ]);
    let zipped =
        [".work/lambert.rs", "a/.b/halfway.rs", ".cargo/config.toml", ".git/lambert.rs", "._lambert.rs"];
    for taken in [only(&read(&class)), of_a_zip(&zipped)] {
        assert!(taken.files.is_empty());
        assert_eq!(words(&taken), "Hidden files are not judged: .work/lambert.rs, a/.b/halfway.rs.");
    }
}

#[test]
fn hidden_files_crowd_out_nothing() {
    let class = folder(&["eve/work/lambert.rs"]);
    let hidden = class.path().join("eve/.cache");
    fs::create_dir(&hidden).expect("made");
    for number in 0..20_001 {
        fs::File::create(hidden.join(number.to_string())).expect("made");
    }
    assert_eq!(lambert(&only(&read(&class))), Some("eve/work/lambert.rs"));
}

#[test]
fn whatever_is_nobodys_is_said_with_its_reason() {
    let class = folder(&["ada/lambert.rs", ".bob/lambert.rs", "target/lambert.rs", "notes.txt", ".DS_Store"]);
    let remarks = read(&class).remarks;
    assert_eq!(remarks.len(), 3, "{remarks:?}");
    assert!(remarks[0].starts_with("hidden, ") && remarks[0].ends_with(": .bob"), "{remarks:?}");
    assert!(remarks[1].starts_with("made by tools, ") && remarks[1].ends_with(": target"), "{remarks:?}");
    assert_eq!(remarks[2], "nobody's submission, and ignored: notes.txt");
}

/// On a path that is too long for the system, which nobody can read, not even a superuser.
#[cfg(unix)]
#[test]
fn a_folder_that_cannot_be_read_hinders_no_other() {
    let place = folder(&["class/ada/lambert.rs"]);
    let long = "x".repeat(250);
    let mut deep = place.path().join("class/ada/more");
    (0..9).for_each(|_| deep.push(&long));
    fs::create_dir_all(&deep).expect("made");
    fs::write(deep.join("halfway.rs"), TEXT).expect("written");
    // 2.3 KB of path become 4.3.
    let mut far = place.path().to_owned();
    (0..8).for_each(|_| far.push(&long));
    fs::create_dir_all(&far).expect("made");
    fs::rename(place.path().join("class"), far.join("class")).expect("moved");
    let class = Class::read(&far.join("class")).expect("a class");
    let taken = only(&class);
    assert_eq!(taken.files.keys().collect::<Vec<_>>(), [&"lambert"]);
    let words = words(&taken);
    assert!(
        words.starts_with("Folders that cannot be read, so that nothing in them was judged: more/"),
        "{words}"
    );
    assert!(!words.contains("os error"), "{words}");
}
