//! Where pictures may go, and that they arrive whole or not at all.

use std::fs;

use crate::desk::{Desk, is_there};

/// A quick picture.
const RENDER: &str = "render two-spheres --renderer zbuffer --size 20x15 -o";

#[test]
fn what_cannot_be_written_is_refused_before_rendering() {
    let desk = Desk::new();
    desk.put("file", "");
    fs::create_dir(desk.path("folder.png")).unwrap();
    let long = format!("{}.png", "a".repeat(300));
    let cases: [(&str, &[&str]); 12] = [
        (".", &["is a folder", "./picture.png"]),
        ("folder.png", &["is a folder", "folder.png/picture.png"]),
        ("new/", &["new/ is a folder"]),
        ("out.jpg", &["out.jpg", "unknown extension .jpg", ".exr"]),
        ("out", &["no extension", "picture.png"]),
        (".png", &["no extension"]),
        ("-", &["no extension"]),
        ("nowhere/out.png", &["there is no folder nowhere", "mkdir -p nowhere"]),
        ("no/where/out.png", &["there is no folder no/where"]),
        ("file/out.png", &["file/out.png", "Not a directory"]),
        (&long, &["name too long"]),
        ("=", &["value"]),
    ];
    for (name, parts) in cases {
        let option = if name == "=" { "--output=".to_owned() } else { format!("-o {name}") };
        // A picture so large that rendering first would be noticed.
        let said = desk.lab(&format!("render --renderer raytrace --size 8000x8000 --samples 16 {option}"));
        said.refused(parts);
    }
    assert_eq!(desk.files(), ["file", "folder.png"]);
}

#[test]
#[cfg(target_os = "linux")]
fn a_folder_that_takes_no_files_is_refused() {
    // Not even root makes files there, so that this test holds for root too.
    Desk::new().lab(&format!("{RENDER} /proc/out.png")).refused(&["cannot write /proc/out.png"]);
}

#[test]
#[cfg(unix)]
fn a_folder_without_write_permission_is_refused() {
    use std::os::unix::fs::PermissionsExt;
    let desk = Desk::new();
    fs::create_dir(desk.path("closed")).unwrap();
    fs::set_permissions(desk.path("closed"), fs::Permissions::from_mode(0o555)).unwrap();
    if fs::write(desk.path("closed/probe"), "").is_ok() {
        eprintln!("skipped: this user (root) may write everywhere");
        return;
    }
    desk.lab(&format!("{RENDER} closed/out.png")).refused(&["closed/out.png", "Permission denied"]);
}

#[test]
fn a_file_that_is_there_is_replaced_unless_it_is_read_only() {
    let desk = Desk::new();
    desk.put("out.png", "old");
    desk.lab(&format!("{RENDER} out.png")).done();
    assert_eq!(desk.picture("out.png").width(), 20);

    let mut permissions = fs::metadata(desk.path("out.png")).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(desk.path("out.png"), permissions).unwrap();
    let before = desk.bytes("out.png");
    desk.lab(&format!("{RENDER} out.png --size 30x20")).refused(&["out.png is read-only", "chmod"]);
    assert_eq!(desk.bytes("out.png"), before);
    assert_eq!(desk.files(), ["out.png"]);
}

#[test]
#[cfg(unix)]
fn permissions_follow_the_umask_and_those_of_a_replaced_file_stay() {
    use std::os::unix::fs::PermissionsExt;
    let desk = Desk::new();
    let mode = || fs::metadata(desk.path("out.png")).unwrap().permissions().mode() & 0o7777;
    desk.shell(&format!("umask 027; exec $LAB {RENDER} out.png")).done();
    assert_eq!(mode(), 0o640);
    fs::set_permissions(desk.path("out.png"), fs::Permissions::from_mode(0o606)).unwrap();
    desk.shell(&format!("umask 027; exec $LAB {RENDER} out.png")).done();
    assert_eq!(mode(), 0o606);
}

#[test]
#[cfg(unix)]
fn a_symbolic_link_is_followed_and_stays() {
    use std::os::unix::fs::symlink;
    let desk = Desk::new();
    fs::create_dir(desk.path("far")).unwrap();
    desk.put("far/real.png", "old");
    symlink("far/real.png", desk.path("link.png")).unwrap();
    symlink("nowhere.png", desk.path("dangling.png")).unwrap();
    symlink("circle.png", desk.path("circle.png")).unwrap();
    symlink("/dev/null", desk.path("null.png")).unwrap();

    desk.lab(&format!("{RENDER} link.png")).done();
    assert_eq!(desk.picture("far/real.png").width(), 20);
    assert!(desk.path("link.png").is_symlink());
    assert_eq!(fs::read_dir(desk.path("far")).unwrap().count(), 1, "nothing is left beside the file");

    desk.lab(&format!("{RENDER} dangling.png")).refused(&["dangling.png", "link to nothing"]);
    desk.lab(&format!("{RENDER} circle.png")).refused(&["circle.png", "symbolic link"]);
    desk.lab(&format!("{RENDER} null.png")).refused(&["null.png", "not an ordinary file"]);
    assert_eq!(desk.files(), ["circle.png", "dangling.png", "far", "link.png", "null.png"]);
}

#[test]
#[cfg(unix)]
fn a_picture_larger_than_files_may_be_leaves_the_old_one() {
    let desk = Desk::new();
    desk.put("out.exr", "old");
    // 8 blocks of 512 bytes; the picture has 40 × 30 × 12 bytes.
    let said = desk.shell("ulimit -f 8; exec $LAB render --renderer zbuffer --size 40x30 -o out.exr");
    said.refused(&["cannot write out.exr", "File too large", "ulimit -f"]);
    assert_eq!(desk.bytes("out.exr"), b"old");
    assert_eq!(desk.files(), ["out.exr"]);
}

#[test]
#[cfg(target_os = "linux")]
fn a_full_disk_leaves_the_old_picture() {
    let desk = Desk::new();
    fs::create_dir(desk.path("disk")).unwrap();
    let mount = "mount -t tmpfs -o size=16k lab disk";
    if desk.shell(&format!("unshare --map-root-user --mount sh -c '{mount}'")).code != Some(0) {
        eprintln!("skipped: this user may mount no file system of 16 kB");
        return;
    }
    let inside = format!(
        "{mount} && echo old > disk/out.exr && \
         $LAB render --renderer zbuffer --size 40x30 -o disk/out.exr; echo $?; cat disk/*; ls -A disk"
    );
    let said = desk.shell(&format!("unshare --map-root-user --mount sh -c '{inside}'"));
    assert!(said.out.ends_with("2\nold\nout.exr\n"), "{said:?}");
    assert!(said.err.contains("error: cannot write disk/out.exr: No space left on device"), "{}", said.err);
    assert!(said.err.contains("help: free some space"), "{}", said.err);
}

#[test]
#[cfg(target_os = "linux")]
fn a_picture_is_written_even_if_nobody_can_be_told() {
    let desk = Desk::new();
    desk.shell("$LAB render --size 20x15 > /dev/full").refused(&["standard output", "No space left"]);
    assert_eq!(desk.picture("teapot.png").height(), 15);
}

#[test]
fn names_may_hold_blanks_and_other_letters() {
    let desk = Desk::new();
    let name = "mijn theepot é.png";
    desk.words(&["render", "--renderer", "zbuffer", "--size", "20x15", "-o", name]).done();
    assert!(is_there(&desk.path(name)));
}
