//! Is a figure drawn with the student's function, and does the page live on whatever that function does?

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use course::Exercise;
use figures::{Figure, Values};
use grader::{Build, Judge, Libraries};
use play::StudentPictures;
use serde_json::Value as Json;

/// The workspace.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(3).expect("crates/programs/play").to_owned()
}

/// Built once for all tests of this program.
fn libraries() -> Libraries {
    static LIBRARIES: OnceLock<Libraries> = OnceLock::new();
    LIBRARIES
        .get_or_init(|| {
            Libraries::build(&root(), Build::of_the_workspace()).expect("the libraries are built")
        })
        .clone()
}

/// A folder of exercises as it is handed out, and who draws with what is in it.
struct Desk {
    folder: tempfile::TempDir,
    mine: StudentPictures,
}

impl Desk {
    fn new() -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let exercises = folder.path().join("exercises");
        for exercise in course::all() {
            let file = exercises.join(exercise.path());
            fs::create_dir_all(file.parent().expect("a folder")).expect("a folder");
            fs::write(file, exercise.stub).expect("a file");
        }
        let work = folder.path().join("work");
        let make_judge = move || Ok(Judge::in_folder(libraries(), &work));
        Self { mine: StudentPictures::new(exercises, Box::new(make_judge)), folder }
    }

    fn file(&self, exercise: &Exercise) -> PathBuf {
        self.folder.path().join("exercises").join(exercise.path())
    }

    fn write(&self, exercise: &Exercise, text: &str) {
        fs::write(self.file(exercise), text).expect("a file");
    }

    /// A file with `lambert` of this body.
    fn write_lambert(&self, body: &str) {
        let text = format!(
            "use glam::Vec3;\n\npub fn lambert(c_r: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {{\n    {body}\n}}\n"
        );
        self.write(exercise("lambert"), &text);
    }

    fn draw(&self, exercise: &'static Exercise) -> Json {
        let figure = figure_of(exercise);
        self.mine.draw(figure, &Values::of(figure), exercise)
    }

    fn draw_lambert(&self) -> Json {
        self.draw(exercise("lambert"))
    }

    /// How many programs are kept.
    fn programs(&self) -> usize {
        fs::read_dir(self.folder.path().join("work/scratch")).map_or(0, Iterator::count)
    }
}

const RIGHT: &str = "c_r * c_l * n.dot(to_light).max(0.0)";

fn exercise(name: &str) -> &'static Exercise {
    course::find(name).expect("an exercise")
}

/// The first figure that an exercise draws.
fn figure_of(exercise: &Exercise) -> &'static Figure {
    let draws = |figure: &&Figure| {
        StudentPictures::exercises_of(figure).iter().any(|other| other.name == exercise.name)
    };
    figures::all().into_iter().find(draws).expect("a figure")
}

/// The names of an answer's drawings.
fn names(answer: &Json) -> Vec<&str> {
    answer["drawings"].as_array().expect("drawings").iter().filter_map(|it| it["name"].as_str()).collect()
}

#[test]
fn a_right_function_draws_every_exercise_without_a_difference() {
    let desk = Desk::new();
    // By day every fourth exercise: each program is compiled for itself.
    for exercise in course::all().iter().step_by(testkit::effort(4, 1)) {
        desk.write(exercise, &exercise.submission(&exercise.reference).expect("its text"));
        let answer = desk.draw(exercise);
        assert_eq!(answer["state"], "drawn", "{}: {answer}", exercise.name);
        assert_eq!(answer["differing"], 0, "{}: {}", exercise.name, answer["differs"]["en"]);
        assert!(!names(&answer).is_empty(), "{}", exercise.name);
    }
    assert!(desk.programs() <= 8, "{} programs are kept", desk.programs());
    desk.mine.clear();
    assert_eq!(desk.programs(), 0);
}

#[test]
fn a_wrong_function_shows_where_it_differs() {
    let desk = Desk::new();
    let lambert = exercise("lambert");
    for misconception in &lambert.misconceptions {
        desk.write(lambert, &lambert.submission(&misconception.program).expect("its text"));
        let answer = desk.draw_lambert();
        assert_eq!(answer["state"], "drawn", "{answer}");
        assert_eq!(names(&answer), ["yours", "right", "difference"]);
        let (differing, of) = (answer["differing"].as_u64().expect("a count"), answer["of"].as_u64());
        assert!(differing > 100 && Some(differing) <= of, "{}: {differing}", misconception.program.name);
        let words = answer["differs"]["nl"].as_str().expect("words");
        assert!(words.starts_with(&format!("{differing} van ")), "{words}");
        let [yours, right] = [0, 1].map(|k| answer["drawings"][k]["png"].as_str().expect("a picture"));
        assert!(yours.starts_with("data:image/png;base64,") && yours != right);
    }
}

#[test]
fn a_file_as_it_was_handed_out_is_not_started_and_nothing_is_made_ready() {
    static MADE: AtomicUsize = AtomicUsize::new(0);
    let desk = Desk::new();
    let make_judge = || {
        MADE.fetch_add(1, Ordering::Relaxed);
        Err("no compiler".to_owned())
    };
    let mine = StudentPictures::new(desk.folder.path().join("exercises"), Box::new(make_judge));
    let lambert = exercise("lambert");
    let figure = figure_of(lambert);
    let answer = mine.draw(figure, &Values::of(figure), lambert);
    assert_eq!((answer["state"].as_str(), MADE.load(Ordering::Relaxed)), (Some("not-started"), 0));
    assert_eq!(answer["file"], "exercises/lighting/lambert.rs");
    desk.write_lambert(RIGHT);
    let answer = mine.draw(figure, &Values::of(figure), lambert);
    assert_eq!((answer["state"].as_str(), MADE.load(Ordering::Relaxed)), (Some("fault"), 1));
    assert!(answer["message"]["nl"].as_str().is_some_and(|words| words.contains("no compiler")), "{answer}");
    // What failed is tried again.
    mine.draw(figure, &Values::of(figure), lambert);
    assert_eq!(MADE.load(Ordering::Relaxed), 2);
}

#[test]
fn todo_in_a_changed_file_is_not_started_either() {
    let desk = Desk::new();
    desk.write_lambert("// Later.\n    todo!()");
    assert_eq!(desk.draw_lambert()["state"], "not-started");
}

#[test]
fn what_does_not_compile_comes_with_the_compilers_words_and_is_mended_by_the_next_save() {
    let desk = Desk::new();
    desk.write_lambert("5");
    let answer = desk.draw_lambert();
    assert_eq!(answer["state"], "does-not-compile");
    let detail = answer["detail"].as_str().expect("the compiler's words");
    assert!(detail.contains("error[E0308]") && detail.contains("lambert.rs:4"), "{detail}");
    assert!(answer["drawings"].as_array().is_some_and(Vec::is_empty));
    desk.write_lambert(RIGHT);
    assert_eq!(desk.draw_lambert()["state"], "drawn");
}

#[test]
fn a_loop_without_end_is_timed_out_and_the_next_save_is_drawn() {
    let desk = Desk::new();
    desk.write_lambert("loop { std::hint::spin_loop() }");
    let answer = desk.draw_lambert();
    assert_eq!(answer["state"], "timed-out", "{answer}");
    assert_eq!(answer["message"]["en"], "No answer after 2 s of computing: is there a loop without end?");
    desk.write_lambert(RIGHT);
    assert_eq!(desk.draw_lambert()["state"], "drawn");
}

#[test]
fn a_loop_in_one_exercise_does_not_hold_up_another() {
    let desk = Desk::new();
    let begun = desk.folder.path().join("begun");
    desk.write_lambert(&format!("std::fs::write({begun:?}, []).unwrap(); loop {{ std::hint::spin_loop() }}"));
    let other = exercise("reflection");
    desk.write(other, &other.submission(&other.reference).expect("its text"));
    // Both are compiled by now.
    desk.draw(other);
    desk.draw_lambert();
    fs::remove_file(&begun).expect("the loop was called");
    std::thread::scope(|scope| {
        let hanging = scope.spawn(|| desk.draw_lambert());
        while !begun.exists() && !hanging.is_finished() {
            std::thread::sleep(Duration::from_millis(1));
        }
        assert_eq!(desk.draw(other)["state"], "drawn");
        assert!(!hanging.is_finished(), "it waited for the loop");
        assert_eq!(hanging.join().expect("an answer")["state"], "timed-out");
    });
}

#[test]
fn a_panic_on_some_pixels_leaves_the_others_and_says_where() {
    let desk = Desk::new();
    desk.write_lambert(&format!("if n.x > 0.5 {{ panic!(\"too far right\") }}\n    {RIGHT}"));
    let answer = desk.draw_lambert();
    assert_eq!(answer["state"], "panicked");
    let message = answer["message"]["en"].as_str().expect("words");
    assert!(message.contains("lambert.rs:4") && message.contains("too far right"), "{message}");
    assert_eq!(names(&answer), ["yours", "right", "difference"]);
    let (differing, of) =
        (answer["differing"].as_u64().expect("a count"), answer["of"].as_u64().expect("a count"));
    assert!(0 < differing && differing < of / 2, "{differing} of {of}");
    assert!(answer["differs"]["en"].as_str().is_some_and(|words| words.contains("hatched")), "{answer}");
}

#[test]
fn a_panic_everywhere_an_end_and_no_number_are_said() {
    let desk = Desk::new();
    for (body, state) in [
        ("panic!(\"nothing works\")", "panicked"),
        ("std::process::exit(3)", "ended"),
        (
            "fn deep(k: u64) -> u64 { if k == u64::MAX { 0 } else { 1 + deep(k + 1) } }\n    c_r * deep(0) as f32",
            "ended",
        ),
    ] {
        desk.write_lambert(body);
        let answer = desk.draw_lambert();
        assert_eq!(answer["state"], state, "{answer}");
        assert!(names(&answer).is_empty());
    }
    desk.write_lambert("Vec3::NAN * c_r * c_l * n * to_light");
    let answer = desk.draw_lambert();
    assert_eq!((answer["state"].as_str(), &answer["differing"]), (Some("drawn"), &answer["of"]));
}

#[test]
fn a_file_that_is_gone_or_no_text_says_so_and_changes_its_stamp() {
    let desk = Desk::new();
    let lambert = exercise("lambert");
    let mut stamps = vec![desk.mine.stamp(lambert)];
    assert_eq!(desk.mine.stamp(lambert), stamps[0], "nothing has changed");
    fs::write(desk.file(lambert), b"// \xff\n").expect("a file");
    stamps.push(desk.mine.stamp(lambert));
    assert_eq!(desk.draw_lambert()["state"], "unreadable");
    fs::remove_file(desk.file(lambert)).expect("removed");
    stamps.push(desk.mine.stamp(lambert));
    assert_eq!(desk.draw_lambert()["state"], "unreadable");
    fs::create_dir(desk.file(lambert)).expect("a folder");
    stamps.push(desk.mine.stamp(lambert));
    assert_eq!(desk.draw_lambert()["state"], "unreadable");
    stamps.sort();
    stamps.dedup();
    assert_eq!(stamps.len(), 4, "{stamps:?}");
}

#[test]
fn a_slider_moves_the_picture_and_compiles_nothing() {
    let desk = Desk::new();
    desk.write_lambert(RIGHT);
    let lambert = exercise("lambert");
    let figure = figures::all().into_iter().find(|figure| figure.name == "facing-away").expect("the figure");
    let at = |theta: f32| {
        let mut values = Values::of(figure);
        values.set("theta", theta).expect("in range");
        desk.mine.draw(figure, &values, lambert)["drawings"][0]["png"].to_string()
    };
    let first = at(100.0);
    let program = || {
        let folder = fs::read_dir(desk.folder.path().join("work/scratch")).expect("the folder");
        folder.map(|entry| entry.expect("an entry").file_name()).collect::<Vec<_>>()
    };
    let compiled = program();
    let begun = Instant::now();
    assert_ne!(at(140.0), first);
    println!("a slider's move with a compiled function: {:?}", begun.elapsed());
    assert_eq!(at(100.0), first);
    assert_eq!(program(), compiled);
}
