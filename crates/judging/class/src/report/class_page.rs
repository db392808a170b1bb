//! What does a lecturer want to know of a class? Who has how many points, what was hard, and which mistakes many have made alike.

use maud::{Markup, html};

use crate::results::{Audience, Outcome, Results, Submission};

use super::charts::{histogram, percent, share};
use super::foreign::line;
use super::groups::{self, Cluster, Diagnosis};
use super::statistics::{self, Item};
use super::submissions::{self, head, link};
use super::{page, prose};

const SCRIPT: &str = include_str!("class.js");
/// The script's SHA-256: the page's policy admits no other script. A test says what it should be.
const FINGERPRINT: &str = "sha256-9Ku9ZB0s/mWkfFLQ1UGfMO20gYpr7Lr+iUlCvyvn1+w=";

/// The page of the class. It holds what is for the staff alone.
pub fn class_page(results: &Results) -> String {
    let items = statistics::items(results);
    let sections = [
        ("distribution", "Distribution of points", distribution(results)),
        ("exercises", "Exercises and laws", exercises(&items)),
        ("misconceptions", "Misconceptions", misconceptions(results)),
        ("clusters", "The same laws broken", clusters(results)),
        ("outcomes", "Outcomes", outcomes(&items)),
        ("notices", "Notices", notices(results)),
        ("submissions", "Submissions", submissions::table(results)),
    ];
    let body = html! {
        a.skip href="#submissions" { "Skip to the submissions" }
        header {
            h1 { "The class: " (results.submissions.len()) " submissions" }
            (warnings(results))
            (summary(results))
            nav aria-label="Sections" {
                ul { @for (id, title, _) in &sections { li { a href={ "#" (id) } { (title) } } } }
            }
        }
        main {
            @for (id, title, content) in &sections {
                section aria-labelledby=(id) { h2 id=(id) { (title) } (content) }
            }
        }
        footer { (judged_by(results)) }
    };
    page("The class", include_str!("class.css"), (SCRIPT, FINGERPRINT), &body)
}

/// What has to be known before any number is read; grader errors first, since nothing of them is the students' fault.
fn warnings(results: &Results) -> Markup {
    let errors: Vec<_> = results
        .submissions
        .iter()
        .flat_map(|submission| submission.verdicts.iter().map(move |verdict| (submission, verdict)))
        .filter(|(_, verdict)| verdict.outcome == Outcome::GraderError)
        .collect();
    html! {
        @if !errors.is_empty() {
            section.warning aria-label="Grader errors" {
                p { strong { "The grader failed on " (errors.len()) " exercises; no points were given for them. A person has to look:" } }
                ul {
                    @for (submission, verdict) in errors {
                        li {
                            (link(submission)) ", " code { (verdict.exercise) } ": "
                            (line(verdict.sentence.as_deref().unwrap_or("no reason was given")))
                        }
                    }
                }
            }
        }
        @if let Some(partition) = &results.partition {
            p.notice { "This is a part of the class, " code { (line(partition)) } ": " code { "cargo lab merge" } " puts the parts together." }
        }
        @for remark in &results.remarks {
            p.notice { "In the class's folder: " (line(remark)) }
        }
        @if !results.sandboxed {
            p.warning { "Not every submission was judged in the sandbox: what they did on this machine was not limited." }
        }
    }
}

fn summary(results: &Results) -> Markup {
    let shares = statistics::shares(results);
    let shown = |value: Option<f64>| value.map_or("–".to_owned(), percent);
    let full = shares.iter().filter(|share| **share >= 1.0).count();
    let none = shares.iter().filter(|share| **share <= 0.0).count();
    let facts = [
        ("mean", shown(statistics::mean(&shares))),
        ("median", shown(statistics::quantile(&shares, 0.5))),
        (
            "middle half",
            match (statistics::quantile(&shares, 0.25), statistics::quantile(&shares, 0.75)) {
                (Some(low), Some(high)) => {
                    format!("{} – {}", percent(low).trim_end_matches(" %"), percent(high))
                }
                _ => "–".to_owned(),
            },
        ),
        ("all points", full.to_string()),
        ("no points", none.to_string()),
    ];
    html! {
        dl.facts { @for (name, value) in facts { div { dt { (name) } dd { (value) } } } }
    }
}

fn distribution(results: &Results) -> Markup {
    let shares = statistics::shares(results);
    let of = results.submissions.iter().map(|it| it.of).max().unwrap_or(0);
    html! {
        p.soft { "How many submissions have which share of the " (of) " points." }
        div.scroll role="region" aria-labelledby="distribution" tabindex="0" { (histogram(&shares, statistics::mean(&shares))) }
    }
}

fn exercises(items: &[Item<'_>]) -> Markup {
    html! {
        p.soft {
            "Share: the mean of the points, of what they could be. It separates where those who have its points also have those of the other "
            "exercises: the correlation with the rest, in brackets. Against the rest means that the weak do better than the strong: look at the exercise."
        }
        div.scroll role="region" aria-labelledby="exercises" tabindex="0" {
            table.sortable {
                thead {
                    tr {
                        (head("Exercise", false)) (head("Concept", false)) (head("Share of points", true)) (head("Passed", true))
                        (head("Difficulty", false)) (head("Separation", true)) (head("Laws", true))
                    }
                }
                tbody { @for item in items { (exercise_row(item)) } }
            }
        }
    }
}

fn exercise_row(item: &Item<'_>) -> Markup {
    let r = item.discrimination;
    html! {
        tr {
            th scope="row" { (item.exercise.title) br; code.soft { (item.exercise.name) } }
            td { (item.exercise.concept) br; span.soft { (item.exercise.items) } }
            td data-key=[item.share] { (share(item.share)) }
            td.number data-key=(item.passed) { (item.passed) " of " (item.judged) }
            td { (item.share.map_or("–", statistics::difficulty_in_words)) }
            td data-key=[r] {
                (statistics::discrimination_in_words(r))
                @if let Some(r) = r { " " span.soft { "(" (format!("{r:.2}").replace('-', "−")) ")" } }
            }
            td data-key=(item.laws.iter().map(|law| law.failed).sum::<usize>()) { (laws(item)) }
        }
    }
}

fn laws(item: &Item<'_>) -> Markup {
    html! {
        details {
            summary { (item.laws.len()) " laws, broken " (item.laws.iter().map(|law| law.failed).sum::<usize>()) " times" }
            ul.laws {
                @for count in &item.laws {
                    @let tried = count.kept + count.failed;
                    li {
                        (share((tried > 0).then(|| count.kept as f64 / tried as f64)))
                        span { (prose(&count.law.statement)) " " span.soft { "(" (count.kept) " of " (tried) " keep it)" } }
                    }
                }
            }
        }
    }
}

fn misconceptions(results: &Results) -> Markup {
    let found = groups::misconceptions(results);
    let most = found.first().map_or(1, |it| it.members.len());
    let shared = |it: &Diagnosis<'_>| {
        html! {
            span.meter aria-hidden="true" { span style={ "width:" (100 * it.members.len() / most) "%" } {} }
            (prose(it.what)) " " code.soft { (it.exercise) " / " (it.name) }
        }
    };
    let listed = found.iter().map(|it| group(&it.members, &shared(it))).collect();
    html! {
        p.soft { "Whose answers are, input for input, those of a known wrong program. This looks like:" }
        (groups_list(listed, "No answers are those of a known misconception."))
    }
}

fn clusters(results: &Results) -> Markup {
    let listed = |clusters: Vec<Cluster<'_>>| {
        clusters.iter().map(|it| group(&it.members, &failures(&it.failures))).collect()
    };
    html! {
        p.soft { "Submissions that break exactly the same laws: one explanation helps all of them." }
        h3 { "In the whole course" }
        (groups_list(listed(groups::clusters_of_the_course(results)), "No two submissions with a fault have all faults in common."))
        h3 { "In one exercise" }
        (groups_list(listed(groups::clusters_by_exercise(results)), "No two submissions break the same laws of an exercise."))
    }
}

/// What the members of a cluster have in common: "lambert: is_linear, facing_away; halfway: not started".
fn failures(failures: &[(&str, &str)]) -> Markup {
    /// More would not be read.
    const SHOWN: usize = 8;
    let shown = &failures[..failures.len().min(SHOWN)];
    html! {
        @for (at, of_exercise) in shown.chunk_by(|a, b| a.0 == b.0).enumerate() {
            @if at > 0 { "; " }
            code { (of_exercise[0].0) } ": "
            (of_exercise.iter().map(|(_, law)| law.replace('_', " ")).collect::<Vec<_>>().join(", "))
        }
        @if failures.len() > SHOWN { "; and " (failures.len() - SHOWN) " more" }
    }
}

/// The first groups, the others where they are asked for.
fn groups_list(groups: Vec<Markup>, none: &str) -> Markup {
    const SHOWN: usize = 12;
    let list = |groups: &[Markup]| html! { ol.groups { @for group in groups { li { (group) } } } };
    html! {
        @if groups.is_empty() { p { (none) } }
        @else if groups.len() <= SHOWN + 1 { (list(&groups)) }
        @else {
            (list(&groups[..SHOWN]))
            details { summary { "The other " (groups.len() - SHOWN) } (list(&groups[SHOWN..])) }
        }
    }
}

/// A group by its size and what its members share; who they are is shown when asked for.
fn group(members: &[&Submission], shared: &Markup) -> Markup {
    html! {
        details {
            summary { span.size { (members.len()) } span { (shared) } }
            ul.members { @for member in members { li { (link(member)) } } }
        }
    }
}

fn outcomes(items: &[Item<'_>]) -> Markup {
    let seen: Vec<Outcome> = Outcome::ALL
        .into_iter()
        .filter(|outcome| items.iter().any(|it| it.outcomes.contains_key(outcome)))
        .collect();
    html! {
        div.scroll role="region" aria-labelledby="outcomes" tabindex="0" {
            table.sortable.counts {
                thead { tr { (head("Exercise", false)) @for outcome in &seen { (head(outcome.word(), true)) } } }
                tbody {
                    @for item in items {
                        tr {
                            th scope="row" { code { (item.exercise.name) } }
                            @for outcome in &seen {
                                td.number { @if let Some(count) = item.outcomes.get(outcome) { (count) } }
                            }
                        }
                    }
                }
            }
        }
    }
}

fn notices(results: &Results) -> Markup {
    let with: Vec<&Submission> = results.submissions.iter().filter(|it| !it.notices.is_empty()).collect();
    html! {
        @if with.is_empty() { p { "There is nothing to say beside the verdicts." } } @else {
            p.soft { "What was ignored, and what was seen. “Staff” is said here alone; students read the rest in their feedback." }
            ul.notices {
                @for submission in with {
                    li {
                        (link(submission)) " " code.soft { (line(&submission.source)) }
                        ul {
                            @for notice in &submission.notices {
                                li {
                                    @if notice.audience == Audience::Staff { strong.badge { "staff" } " " }
                                    (line(&notice.text))
                                }
                            }
                        }
                    }
                }
            }
        }
    }
}

fn judged_by(results: &Results) -> Markup {
    let seeds = if results.seeds.per_student {
        "each student has inputs of their own"
    } else {
        "the same inputs for everyone"
    };
    html! {
        p.soft {
            "Judged by course version " code { (line(&results.course.version)) } ", seed " code { (results.seeds.seed) } " (" (seeds) "). "
            "The points stand in grades.csv, everything in results.json."
        }
    }
}
