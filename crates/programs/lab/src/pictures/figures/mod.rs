//! `cargo lab figures`: how does each figure of the lecture look, here and now?

mod album;

use std::path::Path;
use std::time::Instant;

use ::album::{Entry, Trial};
use ::claims::{self, Claim, Verdict};
use ::figures::{Figure, ParameterError, Values};
use serde_json::{Value, json};

use crate::cli::Outcome;
use crate::failure::Failure;
use crate::pictures::args::FiguresArgs;
use crate::pictures::progress::Progress;
use crate::speech::say;
use album::{Album, Taken, fingerprint};

/// The page's file.
const PAGE: &str = "index.html";

/// Draws what has changed and writes the page.
///
/// # Errors
/// [`Failure`] if there is no such figure, if the values are not in order, or if the folder takes no files.
pub(crate) fn run(asked: &FiguresArgs) -> Result<Outcome, Failure> {
    let start = Instant::now();
    let figures = with_values(chosen(&asked.figures)?, asked)?;
    // The claims belong to the whole page; somebody who wants one figure does not wait for them.
    let trials = if asked.figures.is_empty() { claims::all() } else { Vec::new() };
    let mut album = Album::open(&asked.out)?;
    let program = program()?;

    let work = figures.len() + trials.len();
    let mut drawn = 0;
    let progress = Progress::start("figures");
    for (k, (figure, values)) in figures.iter().enumerate() {
        drawn += usize::from(draw(figure, values, &program, &mut album)?);
        progress.reached((k + 1) as f32 / work as f32);
    }
    for (k, claim) in trials.iter().copied().enumerate() {
        drawn += usize::from(put_on_trial(claim, &program, &mut album)?);
        progress.reached((figures.len() + k + 1) as f32 / work as f32);
    }
    progress.finish();

    let (entries, kept_trials) = on_the_page(&album);
    album.write(PAGE, ::album::html(&entries, &kept_trials).as_bytes())?;
    let page = asked.out.join(PAGE);
    let seconds = start.elapsed().as_secs_f64();
    say(&format!(
        "drew {drawn} of {work} in {seconds:.1} s, the others had not changed; see {}",
        page.display()
    ))?;
    unexpected(&kept_trials)
}

/// The figures that are meant; all if none is named.
fn chosen(names: &[String]) -> Result<Vec<&'static Figure>, Failure> {
    let all = ::figures::all();
    if names.is_empty() {
        return Ok(all);
    }
    for name in names {
        if ::figures::find(name).is_empty() {
            let mut known: Vec<&str> = all.iter().map(|figure| figure.number()).collect();
            known.dedup();
            return Err(Failure::new(
                format!("there is no figure called {name}"),
                format!("give a number such as {}, or the name of a figure", known.join(", ")),
            ));
        }
    }
    let is_meant = |figure: &&Figure| names.iter().any(|name| figure.is_called(name));
    Ok(all.into_iter().filter(is_meant).collect())
}

/// Each figure with its values: its own, except what was asked for.
fn with_values(
    figures: Vec<&'static Figure>,
    asked: &FiguresArgs,
) -> Result<Vec<(&'static Figure, Values)>, Failure> {
    let wrong = |error: ParameterError| Failure::new(error.to_string(), "change it with --set or --size");
    for (name, _) in &asked.set {
        let has = |figure: &&&Figure| figure.parameters.iter().any(|parameter| parameter.name == name);
        if !figures.iter().any(|figure| has(&figure)) {
            let mut known: Vec<&str> =
                figures.iter().flat_map(|figure| figure.parameters).map(|parameter| parameter.name).collect();
            known.sort_unstable();
            known.dedup();
            return Err(Failure::new(
                format!("none of the chosen figures has a parameter {name}"),
                if known.is_empty() {
                    "leave --set out".to_owned()
                } else {
                    format!("set one of {}", known.join(", "))
                },
            ));
        }
    }
    let mut all = Vec::new();
    for figure in figures {
        let mut values = Values::of(figure);
        if let Some((width, height)) = asked.size {
            values.set_size(width, height).map_err(wrong)?;
        }
        for (name, value) in &asked.set {
            match values.set(name, *value) {
                Err(ParameterError::Unknown { .. }) => {}
                other => other.map_err(wrong)?,
            }
        }
        all.push((figure, values));
    }
    Ok(all)
}

/// What stands for this program: it draws otherwise if it is another.
fn program() -> Result<String, Failure> {
    let path = std::env::current_exe();
    let bytes = path.and_then(std::fs::read);
    let remedy = "start the program by its full path";
    Ok(fingerprint(
        &bytes.map_err(|error| Failure::io("read", Path::new("the program itself"), &error, remedy))?,
    ))
}

/// Draws the figure unless the album has it; whether it was drawn.
fn draw(figure: &'static Figure, values: &Values, program: &str, album: &mut Album) -> Result<bool, Failure> {
    let (stem, from) = (figure.stem(), format!("{program} {}", values.summary()));
    if album.take(&stem, Some(&from)).is_some() {
        return Ok(false);
    }
    let drawings = (figure.draw)(values).map_err(|error| {
        Failure::new(format!("{stem} ({}): {error}", values.summary()), "choose other values with --set")
    })?;
    album.put(&stem, from, values.summary(), Value::Null, &drawings)?;
    Ok(true)
}

/// Runs the claim unless the album has its outcome; whether it was run.
fn put_on_trial(claim: &'static Claim, program: &str, album: &mut Album) -> Result<bool, Failure> {
    let stem = claim.stem();
    if album.take(&stem, Some(program)).is_some() {
        return Ok(false);
    }
    let report = claim.run();
    let drawings = match claim.pictures {
        None => Vec::new(),
        Some(draw) => draw().map_err(|error| {
            Failure::new(format!("{stem}: {error}"), "this is a fault of the program; please report it")
        })?,
    };
    let result = json!({
        "verdict": report.examination.verdict.to_string(),
        "as_recorded": report.is_as_expected(),
        "evidence": report.examination.evidence.iter().map(ToString::to_string).collect::<Vec<_>>(),
    });
    album.put(&stem, program.to_owned(), String::new(), result, &drawings)?;
    Ok(true)
}

/// All that the album holds, in the order of the lecture.
fn on_the_page(album: &Album) -> (Vec<Entry>, Vec<Trial>) {
    let figures = ::figures::all().into_iter().filter(|figure| album.has(&figure.stem()));
    let entry = |figure: &'static Figure| {
        let Taken { values, drawings, .. } = album.take(&figure.stem(), None)?;
        Some(Entry::new(figure, values, drawings))
    };
    let claims = claims::all().into_iter().filter(|claim| album.has(&claim.stem()));
    let trial = |claim: &'static Claim| {
        let Taken { result, drawings, .. } = album.take(&claim.stem(), None)?;
        let evidence = result.get("evidence")?.as_array()?.iter();
        let evidence = evidence.map(|line| line.as_str().map(ToOwned::to_owned)).collect::<Option<_>>()?;
        let verdict = verdict(result.get("verdict")?.as_str()?, claim)?;
        let is_as_expected = result.get("as_recorded")?.as_bool()?;
        Some(Trial::new(claim, (verdict, is_as_expected), evidence, drawings))
    };
    (figures.filter_map(entry).collect(), claims.filter_map(trial).collect())
}

/// The verdict that reads so.
fn verdict(words: &str, claim: &Claim) -> Option<Verdict> {
    [Verdict::Holds, Verdict::Refuted, claim.expected]
        .into_iter()
        .find(|verdict| verdict.to_string() == words)
}

/// Says which verdicts did not come out as recorded.
fn unexpected(trials: &[Trial]) -> Result<Outcome, Failure> {
    let names: Vec<&str> =
        trials.iter().filter(|trial| !trial.is_as_expected).map(|trial| trial.stem.as_str()).collect();
    if names.is_empty() {
        return Ok(Outcome::Done);
    }
    say(&format!("not as recorded: {}", names.join(", ")))?;
    Ok(Outcome::Differs)
}
