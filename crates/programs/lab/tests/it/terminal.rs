//! What a pipe and a terminal get to see while the program works.

use std::io;

use crate::desk::Desk;

const RENDER: &str = "render glass-and-mirror --renderer raytrace --size 40x30";

#[test]
fn a_pipe_sees_no_progress_bar() {
    let said = Desk::new().shell(&format!("LIGHTLAB_PROGRESS=always \"$LAB\" {RENDER} 2>&1"));
    assert_eq!(said.code, Some(0), "{said:?}");
    assert!(said.out.contains("40 × 30 pixels in"), "{said:?}");
    assert!(!said.out.contains(['\r', '\u{1b}', '%']), "{said:?}");
}

#[test]
#[cfg(target_os = "linux")]
fn a_terminal_sees_a_progress_bar_that_goes_again() {
    let desk = Desk::new();
    // `script` gives the program a terminal; without a kind of terminal there is no bar.
    let said = desk.shell(&format!(
        "LIGHTLAB_PROGRESS=always TERM=xterm script --quiet --return --command \"$LAB {RENDER}\" /dev/null"
    ));
    if said.code == Some(127) {
        eprintln!("skipped: there is no program `script` to make a terminal");
        return;
    }
    assert_eq!(said.code, Some(0), "{said:?}");
    let bar = said.out.find("raytrace  [").expect("a bar");
    let result = said.out.rfind("40 × 30 pixels in").expect("a result");
    assert!(bar < result);
    assert!(said.out[bar..result].contains("\u{1b}[2K"), "the line of the bar is cleared: {:?}", said.out);
    assert!(!said.out[result..].contains(['[', '%']), "no bar after the result: {:?}", said.out);
}

#[test]
fn a_closed_pipe_does_not_keep_the_picture_from_being_written() {
    let desk = Desk::new();
    let (reader, writer) = io::pipe().unwrap();
    drop(reader);
    let mut run = desk.command(&["render", "--size", "24x18"]);
    assert_eq!(run.stdout(writer).output().unwrap().status.code(), Some(0));
    assert_eq!(desk.picture("teapot.png").height(), 18);
}

#[test]
fn a_closed_pipe_for_complaints_is_no_crash() {
    let desk = Desk::new();
    let (reader, writer) = io::pipe().unwrap();
    drop(reader);
    let mut run = desk.command(&["render", "nowhere.obj"]);
    assert_eq!(run.stderr(writer).output().unwrap().status.code(), Some(2));
}
