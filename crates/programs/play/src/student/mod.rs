//! Figures drawn by the student's own functions.
//!
//! [`StudentPictures`] compiles the file of an exercise once, asks its function in a process of its own, and gives three pictures: yours, right, and the
//! difference. If the file cannot be drawn, a message takes their place.
//!
//! - [`which`]: which exercises draw which figure.
//! - [`light`], [`smooth`], [`screen`], [`rays`]: what each exercise is asked for a picture of pixels; [`calls`]: one call, drawn with lines.
//! - [`panel`] and [`drawing`]: from answers to pictures.
//! - [`compiled`]: compiled functions, reused from one movement of a slider to the next.
//! - [`messages`]: messages for functions that cannot be drawn.

mod calls;
mod compiled;
mod drawing;
mod knobs;
mod light;
mod messages;
mod panel;
mod rays;
mod screen;
#[cfg(test)]
mod seen;
mod smooth;
mod which;

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};
use std::time::{Duration, UNIX_EPOCH};

use course::Exercise;
use figures::{Figure, Values};
use grader::{CompiledFunction, Judge};
use serde_json::{Value as Json, json};

use crate::api::{title, words};
use compiled::{Shelf, locked};
use drawing::Drawn;
use knobs::Knobs;
use messages::Trouble;

/// All questions of a picture together may take so long. A right function takes a hundredth of it.
const PATIENCE: Duration = Duration::from_secs(3);

/// Makes the one who compiles.
type MakeJudge = dyn Fn() -> Result<Judge, String> + Send + Sync;

/// Draws figures with the student's functions.
pub struct StudentPictures {
    exercises: PathBuf,
    make_judge: Box<MakeJudge>,
    judge: Mutex<Option<Arc<Judge>>>,
    shelf: Shelf,
}

impl std::fmt::Debug for StudentPictures {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("StudentPictures").field("exercises", &self.exercises).finish_non_exhaustive()
    }
}

impl StudentPictures {
    /// For the files in this folder. `make_judge` is asked when the first of them is to be compiled, and again only after it failed: it may build
    /// the libraries for that, which takes a minute.
    pub fn new(exercises: PathBuf, make_judge: Box<MakeJudge>) -> Self {
        Self { exercises, make_judge, judge: Mutex::default(), shelf: Shelf::default() }
    }

    /// The exercises whose functions can draw a figure, the most fitting first.
    pub fn exercises_of(figure: &Figure) -> Vec<&'static Exercise> {
        which::exercises_of(figure)
    }

    /// Changes when the student's file does, also when it is replaced or vanishes. The file is not read for it.
    pub fn stamp(&self, exercise: &Exercise) -> String {
        match std::fs::metadata(self.file(exercise)) {
            Ok(metadata) => {
                let since = metadata.modified().ok().and_then(|at| at.duration_since(UNIX_EPOCH).ok());
                format!("{}-{}", since.unwrap_or_default().as_nanos(), metadata.len())
            }
            Err(error) => format!("{:?}", error.kind()),
        }
    }

    /// A figure, drawn with the function of an exercise: the page's answer, whatever becomes of the file. The first time it may take a minute.
    ///
    /// One exercise is drawn by one thread at a time, different ones at once: whoever calls does so where waiting stops nobody else.
    pub fn draw(&self, figure: &Figure, values: &Values, exercise: &'static Exercise) -> Json {
        let knobs = Knobs::new(figure, values);
        let drawn = self.drawn(&knobs, exercise);
        let mut answer = self.answer(exercise, drawn);
        answer["moved_by"] = knobs.read().into();
        answer
    }

    /// Forgets what was compiled, and removes it. For the end of a server that does not live to drop this value.
    pub fn clear(&self) {
        self.shelf.clear();
    }

    fn drawn(&self, knobs: &Knobs<'_>, exercise: &'static Exercise) -> Drawn {
        let file = self.file(exercise);
        let bytes = grader::bytes_of(&file);
        // Then nothing has to be made ready to compile it.
        if bytes.as_ref().is_some_and(|bytes| exercise.is_untouched(bytes)) {
            return Drawn::nothing(Trouble::of_file(grader::Outcome::NotStarted));
        }
        let judge = match self.judge() {
            Ok(judge) => judge,
            Err(why) => return Drawn::nothing(Trouble::fault(&why)),
        };
        let slot = self.shelf.slot(exercise);
        let mut slot = locked(&slot);
        match slot.open(&judge, exercise, &file, bytes.map(course::fingerprint)) {
            Ok(opened) => by(opened, knobs, exercise),
            Err(outcome) => Drawn::nothing(Trouble::of_file(outcome)),
        }
    }

    /// The one who compiles, made at the first use.
    fn judge(&self) -> Result<Arc<Judge>, String> {
        let mut judge = locked(&self.judge);
        if let Some(judge) = &*judge {
            return Ok(Arc::clone(judge));
        }
        let made = Arc::new((self.make_judge)()?);
        *judge = Some(Arc::clone(&made));
        Ok(made)
    }

    fn file(&self, exercise: &Exercise) -> PathBuf {
        self.exercises.join(exercise.path())
    }

    fn answer(&self, exercise: &Exercise, drawn: Drawn) -> Json {
        let Drawn { trouble, drawings, differs } = drawn;
        let (state, message, detail) = match trouble {
            Some(Trouble { state, message, detail }) => (state, Some(words(&message)), detail),
            None => ("drawn", None, None),
        };
        json!({
            "state": state,
            "exercise": exercise.name,
            "title": title(exercise),
            "message": message,
            "detail": detail,
            "file": shown(&self.exercises, exercise),
            "drawings": drawings,
            "differs": differs.as_ref().map(|(said, _, _)| words(said)),
            "differing": differs.as_ref().map(|(_, differing, _)| differing),
            "of": differs.as_ref().map(|(_, _, of)| of),
        })
    }
}

/// A picture by a compiled function, in a process of its own that has its own time.
fn by(opened: &CompiledFunction, knobs: &Knobs<'_>, exercise: &Exercise) -> Drawn {
    let mut yours = opened.ask_for(PATIENCE);
    let panels = which::panels(exercise, knobs);
    if panels.is_empty() {
        calls::of_a_call(exercise, knobs, &mut yours)
    } else {
        drawing::of_panels(exercise, &panels, &mut yours)
    }
}

/// The file's path as the student knows it, from the folder of exercises on.
fn shown(exercises: &Path, exercise: &Exercise) -> String {
    let folder = exercises.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    format!("{folder}/{}", exercise.path())
}
