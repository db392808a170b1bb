//! `cargo lab watch`: a verdict on every save.

use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::{Duration, Instant};

use course::Exercise;
use grader::{Judge, Judgement, bytes_of};

use super::ink::{faint, strong, typed};
use super::workbench::Workbench;
use super::{board, changes, hint, keys, verdict, which};
use crate::cli::{Outcome, WatchArgs};
use crate::failure::Failure;
use crate::speech::say;

/// An editor may write a file in several steps; this long after one, the next belongs to it.
const ONE_SAVE: Duration = Duration::from_millis(12);

/// So many lines stand beneath a verdict.
const FOOTER: usize = 4;

/// What a watcher waits for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Happening {
    /// A file was changed.
    Saved(PathBuf),
    /// A key was pressed.
    Key(char),
}

/// Shows the verdict on the exercise, and again after every save, until somebody quits.
///
/// # Errors
/// [`Failure`] if there is no such exercise, nobody can judge here, or files cannot be watched.
pub(crate) fn run(asked: &WatchArgs) -> Result<Outcome, Failure> {
    let bench = Workbench::find()?;
    let exercise = first(&bench, asked.name.as_deref())?;
    let judge = bench.judge(None)?;
    let (to, happenings) = channel();
    let folder = bench.exercises.clone();
    let changes = changes::watch(&folder, asked.poll, &to).map_err(|e| {
        Failure::new(
            format!("{} cannot be watched: {e}", folder.display()),
            "use `cargo lab check` after each save instead",
        )
    })?;
    let keys = keys::listen(&to);
    let mut watch =
        Watch { bench, judge, exercise, json: asked.json, keys: keys.is_some(), last: None, picture: None };
    watch.judge()?;
    if changes.polls && !asked.json {
        watch.show(&faint("The system does not tell of changes; looking for them four times a second."))?;
    }
    let ended = watch.go_on(&happenings);
    drop(keys);
    ended?;
    Ok(Outcome::Done)
}

/// The exercise that is named, or the next one to do.
fn first(bench: &Workbench, name: Option<&str>) -> Result<&'static Exercise, Failure> {
    if let Some(name) = name {
        return which::one(bench, name);
    }
    let rows = board::rows(bench)?;
    let row = board::next(&rows).or(rows.first());
    row.map(|row| row.exercise).ok_or_else(|| {
        Failure::new("there are no exercises", "this is a mistake of the project's: report it")
    })
}

struct Watch {
    bench: Workbench,
    judge: Judge,
    exercise: &'static Exercise,
    json: bool,
    keys: bool,
    /// The bytes that were judged last.
    last: Option<Vec<u8>>,
    picture: Option<PathBuf>,
}

impl Watch {
    fn go_on(&mut self, happenings: &Receiver<Happening>) -> Result<(), Failure> {
        while let Ok(happening) = happenings.recv() {
            match happening {
                Happening::Saved(path) => self.saved(path, happenings)?,
                Happening::Key('q') => break,
                Happening::Key(key) => self.key(key)?,
            }
        }
        Ok(())
    }

    /// Judges what was saved. The other changes of the same save go with it.
    fn saved(&mut self, path: PathBuf, happenings: &Receiver<Happening>) -> Result<(), Failure> {
        let mut paths = vec![path];
        let mut until = Instant::now() + ONE_SAVE;
        loop {
            match happenings.recv_timeout(until.saturating_duration_since(Instant::now())) {
                Ok(Happening::Saved(path)) => {
                    paths.push(path);
                    until = Instant::now() + ONE_SAVE;
                }
                Ok(Happening::Key('q')) | Err(RecvTimeoutError::Disconnected) => return Ok(()),
                Ok(Happening::Key(_)) => {}
                Err(RecvTimeoutError::Timeout) => break,
            }
        }
        if let Some(exercise) = paths.iter().find_map(|path| self.exercise_of(path)) {
            let other = exercise.name != self.exercise.name;
            self.exercise = exercise;
            // A touch without a change needs no verdict.
            if other || bytes_of(&self.file()) != self.last {
                self.judge()?;
            }
        }
        Ok(())
    }

    fn exercise_of(&self, path: &Path) -> Option<&'static Exercise> {
        let name = path.file_stem()?.to_str()?;
        let exercise = course::find(name)?;
        let own = self.bench.file(exercise);
        let same = own == path || std::fs::canonicalize(&own).ok()? == std::fs::canonicalize(path).ok()?;
        same.then_some(exercise)
    }

    fn file(&self) -> PathBuf {
        self.bench.file(self.exercise)
    }

    fn judge(&mut self) -> Result<(), Failure> {
        let file = self.file();
        self.last = bytes_of(&file);
        self.busy()?;
        let judgement = self.bench.judge_file(&self.judge, self.exercise, &file);
        self.picture = self.bench.draw(&judgement);
        self.verdict(&judgement)?;
        let mut memory = self.bench.memory();
        memory.note(self.exercise, &file, &judgement);
        memory.write();
        Ok(())
    }

    /// Says that the verdict on the screen is not the one of the file any more.
    fn busy(&self) -> Result<(), Failure> {
        if self.json || !self.keys { Ok(()) } else { self.show(&faint("judging …")) }
    }

    fn verdict(&self, judgement: &Judgement) -> Result<(), Failure> {
        if self.json {
            let mut json = judgement.json();
            json["picture"] = serde_json::json!(self.picture.as_ref().map(|path| path.display().to_string()));
            return say(&json.to_string());
        }
        let picture = self.picture.as_ref().map(|path| self.bench.shown(path));
        self.clear()?;
        let file = self.bench.shown(&self.file());
        let mut text = verdict::text(judgement, self.exercise, picture.as_deref(), &file);
        let rows = if self.keys {
            crossterm::terminal::size().map_or(24, |(_, rows)| usize::from(rows))
        } else {
            usize::MAX
        };
        let fits = |text: &str| text.lines().count() + FOOTER <= rows;
        if !fits(&text) {
            // The picture is in a file, too.
            let without = Judgement { picture: None, ..judgement.clone() };
            text = verdict::text(&without, self.exercise, picture.as_deref(), &file);
        }
        self.show(&text)?;
        if !fits(&text) {
            // It has scrolled away.
            self.show(&verdict::headline(judgement))?;
        }
        if judgement.passed() {
            self.show(&format!("  {}", strong("n goes on to the next exercise.")))?;
        }
        self.footer()
    }

    fn key(&mut self, key: char) -> Result<(), Failure> {
        match key {
            'h' => {
                let level = hint::next_level(&self.bench, self.exercise);
                self.clear()?;
                self.show(&hint::text(self.exercise, level))?;
                self.footer()
            }
            'n' => {
                let rows = board::rows(&self.bench)?;
                let other = rows.iter().position(|row| row.exercise.name == self.exercise.name).unwrap_or(0);
                // After this one, around the end: the next that has not passed.
                let next =
                    (1..rows.len()).map(|step| &rows[(other + step) % rows.len()]).find(|row| !row.passed());
                if let Some(row) = next {
                    self.exercise = row.exercise;
                }
                self.judge()
            }
            'l' => {
                let rows = board::rows(&self.bench)?;
                self.clear()?;
                self.show(&board::table(&rows))?;
                self.footer()
            }
            'r' => self.judge(),
            'o' => self.open(),
            _ => Ok(()),
        }
    }

    fn open(&self) -> Result<(), Failure> {
        let Some(picture) = &self.picture else {
            return self.show("There is no picture of this verdict.");
        };
        match open::that_detached(picture) {
            Ok(()) => self.show(&format!("Opened {}", self.bench.shown(picture))),
            Err(_) => self.show(&format!(
                "Nothing here opens pictures by itself: look at {}",
                self.bench.shown(picture)
            )),
        }
    }

    fn footer(&self) -> Result<(), Failure> {
        if self.json {
            return Ok(());
        }
        let keys = "h hint · n next · l list · r rerun · o open picture · q quit";
        let waiting = format!("watching {}", self.bench.shown(&self.file()));
        let keys = if self.keys { typed(keys) } else { faint("Ctrl-C quits") };
        self.show(&format!("\n{}\n{keys}", faint(&waiting)))
    }

    /// Clears a terminal; elsewhere what was said stays, with a line between.
    fn clear(&self) -> Result<(), Failure> {
        if std::io::stdout().is_terminal() && self.keys {
            // Whole screen, and up to the corner.
            return say("\x1b[2J\x1b[H\r");
        }
        Ok(())
    }

    fn show(&self, text: &str) -> Result<(), Failure> {
        if keys::raw() { say(&format!("{}\r", text.replace('\n', "\r\n"))) } else { say(text) }
    }
}
