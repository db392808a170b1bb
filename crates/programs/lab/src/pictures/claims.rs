//! `cargo lab claims`: is what the slides say true?

use ::claims::{Claim, Report, all, find};
use serde_json::{Value, json};

use super::args::ClaimsArgs;
use super::progress::Progress;
use crate::cli::Outcome;
use crate::failure::Failure;
use crate::speech::say;

/// Runs the claims and prints what came out.
///
/// # Errors
/// [`Failure`] if there is no such claim, or if standard output takes nothing.
pub(crate) fn run(asked: &ClaimsArgs) -> Result<Outcome, Failure> {
    let claims = chosen(&asked.claims)?;
    let progress = Progress::start("claims");
    let mut reports = Vec::new();
    for claim in &claims {
        reports.push((*claim).run());
        progress.reached(reports.len() as f32 / claims.len() as f32);
    }
    progress.finish();
    if asked.json {
        say(&format!("{:#}", json!({ "claims": reports.iter().map(record).collect::<Vec<_>>() })))?;
    } else {
        let with_evidence = !asked.claims.is_empty();
        for report in &reports {
            say(&row(report, with_evidence))?;
        }
        say(&summary(&reports))?;
    }
    let all_expected = reports.iter().all(Report::is_as_expected);
    Ok(if all_expected { Outcome::Done } else { Outcome::Differs })
}

/// The claims that are meant; all if none is named.
fn chosen(names: &[String]) -> Result<Vec<&'static Claim>, Failure> {
    if names.is_empty() {
        return Ok(all());
    }
    let mut chosen: Vec<&Claim> = Vec::new();
    for name in names {
        let found = find(name);
        if found.is_empty() {
            return Err(Failure::new(
                format!("there is no claim called {name}"),
                "`cargo lab claims` lists all of them: give a number such as E3 or L26",
            ));
        }
        // Two names may mean the same claim.
        chosen.extend(
            found
                .into_iter()
                .filter(|claim| chosen.iter().all(|known| known.stem() != claim.stem()))
                .collect::<Vec<_>>(),
        );
    }
    Ok(chosen)
}

/// A line for each claim; beneath it, if asked for or if something is amiss, all there is to say.
fn row(report: &Report, with_evidence: bool) -> String {
    let Report { claim, examination } = report;
    let verdict = examination.verdict.to_string();
    let short = verdict.split(" if ").next().unwrap_or_default();
    let short = if verdict.contains(" if ") { format!("{short} if …") } else { short.to_owned() };
    let mut text = format!("{:5}{short:13}„{}”", claim.number, claim.quote);
    if with_evidence || !report.is_as_expected() {
        let indented = |name: &str, line: &str| format!("\n     {name:13}{line}");
        text += &indented("", &format!("“{}”", claim.translation));
        text += &indented("verdict", &verdict);
        if !report.is_as_expected() {
            text += &indented("recorded", &claim.expected.to_string());
        }
        text += &indented("true is", claim.truth.en);
        for evidence in &examination.evidence {
            text += &indented("evidence", &evidence.to_string());
        }
        text += &indented("by", &claim.code.join(", "));
    }
    text
}

fn summary(reports: &[Report]) -> String {
    let unexpected: Vec<String> =
        reports.iter().filter(|report| !report.is_as_expected()).map(|report| report.claim.stem()).collect();
    let count = reports.len();
    let claims = if count == 1 { "1 claim".to_owned() } else { format!("{count} claims") };
    match unexpected.as_slice() {
        [] => format!("{claims}: every verdict came out as recorded"),
        names => format!("{claims}: not as recorded: {}", names.join(", ")),
    }
}

/// What a machine wants to know of a claim.
fn record(report: &Report) -> Value {
    let Report { claim, examination } = report;
    json!({
        "number": claim.number,
        "name": claim.name,
        "quote": claim.quote,
        "translation": claim.translation,
        "truth": { "en": claim.truth.en, "nl": claim.truth.nl },
        "verdict": examination.verdict.to_string(),
        "recorded": claim.expected.to_string(),
        "as_recorded": report.is_as_expected(),
        "evidence": examination.evidence.iter().map(ToString::to_string).collect::<Vec<_>>(),
        "code": claim.code,
    })
}
