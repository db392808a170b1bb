//! `cargo lab scenes`: the built-in scenes, listed and printed.

use crate::desk::Desk;

/// The name at the start of each line of the list.
fn names(desk: &Desk) -> Vec<String> {
    let list = desk.lab("scenes").done().out;
    list.lines().map(|line| line.split_whitespace().next().unwrap().to_owned()).collect()
}

#[test]
fn each_scene_has_a_line_and_the_first_is_the_default() {
    let desk = Desk::new();
    let list = desk.lab("scenes").done().out;
    assert!(list.lines().next().unwrap().starts_with("teapot "));
    assert_eq!(list.matches("(the default)").count(), 1);
    for line in list.lines() {
        assert!(line.split_whitespace().count() > 2, "{line} says what it shows");
    }
    for name in ["cornell-box", "two-spheres", "floating-bin", "glass-and-mirror"] {
        assert!(names(&desk).contains(&name.to_owned()), "{name} in {list}");
    }
}

#[test]
fn a_printed_scene_is_the_scene() {
    let desk = Desk::new();
    for name in names(&desk).into_iter().step_by(testkit::effort(3, 1)) {
        desk.put("mine.toml", desk.lab(&format!("scenes {name}")).done().out);
        for scene in ["mine.toml", &name] {
            desk.lab(&format!("render {scene} --size 24x18 -o {scene}.png")).done();
        }
        assert_eq!(desk.bytes("mine.toml.png"), desk.bytes(&format!("{name}.png")), "{name}");
    }
}

#[test]
fn an_unknown_scene_is_refused_with_the_names_there_are() {
    Desk::new().lab("scenes teepot").refused(&["teepot", "cornell-box", "similar value exists: 'teapot'"]);
}

#[test]
fn a_reader_who_has_left_is_no_error() {
    let desk = Desk::new();
    for words in [&["scenes"][..], &["scenes", "teapot"], &["--help"]] {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let run = desk.command(words).stdout(writer).output().unwrap();
        assert_eq!((run.status.code(), run.stderr.as_slice()), (Some(0), &b""[..]), "{words:?}");
    }
    let said = desk.shell("$LAB scenes | head -1").done();
    assert!(said.out.starts_with("teapot"));
}

#[test]
#[cfg(target_os = "linux")]
fn a_full_disk_under_standard_output_is_an_error() {
    Desk::new().shell("$LAB scenes > /dev/full").refused(&["standard output", "No space left"]);
}
