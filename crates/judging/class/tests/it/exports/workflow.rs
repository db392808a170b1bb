//! GitHub Classroom's workflow: the names it must have, and what its step does.

use std::collections::BTreeMap;
use std::process::Output;

use class::export::github_classroom;

use crate::exports::place::Place;
use crate::exports::{GUARDED, file, project, put};

/// The workflow's steps with their names: each begins with "      - ".
fn steps(workflow: &str) -> BTreeMap<String, String> {
    let steps = workflow.split("\n      - ").skip(1);
    steps
        .filter_map(|step| Some((step.lines().next()?.strip_prefix("name: ")?.to_owned(), step.to_owned())))
        .collect()
}

#[test]
fn the_workflow_has_the_names_that_github_classroom_looks_for() {
    let files = github_classroom(project().path(), GUARDED).expect("an export");
    let workflow =
        String::from_utf8(file(&files, ".github/workflows/classroom.yml").bytes.clone()).expect("UTF-8");
    assert!(workflow.contains("\nname: Autograding Tests\n"));
    let jobs = workflow.split_once("\njobs:\n").expect("jobs").1;
    let names: Vec<&str> =
        jobs.lines().filter(|line| line.starts_with("  ") && !line.starts_with("   ")).collect();
    assert_eq!(names, ["  run-autograding-tests:"]);
    let steps = steps(&workflow);
    assert!(steps["Grade"].contains("id: lightlab\n"));
    assert!(steps["Report"].contains("LIGHTLAB_RESULTS: ${{ steps.lightlab.outputs.result }}"));
    assert!(steps["Report"].contains("runners: lightlab"));
    assert!(!workflow.contains('\t'));
}

/// Runs the step that grades, with a grader that gives this.
fn grade(gives: &str) -> (Place, Output) {
    let files = github_classroom(project().path(), GUARDED).expect("an export");
    let workflow =
        String::from_utf8(file(&files, ".github/workflows/classroom.yml").bytes.clone()).expect("UTF-8");
    let step = steps(&workflow)["Grade"].clone();
    let script = step.split_once("run: |\n").expect("a script").1;
    let script: Vec<&str> = script.lines().map_while(|line| line.strip_prefix("          ")).collect();
    let place = Place::new(&[], "empty");
    let (output, temporary) = (place.path("output"), place.path("temporary"));
    put(&output, "");
    let variables = [
        ("GITHUB_WORKSPACE", "/w"),
        ("GITHUB_OUTPUT", output.to_str().expect("UTF-8")),
        ("GITHUB_ENV", "/env"),
        ("RUNNER_TEMP", temporary.to_str().expect("UTF-8")),
        ("GIVES", gives),
        ("EXTENSION", "txt"),
    ];
    let ran = place.run(&script.join("\n"), &variables);
    (place, ran)
}

#[test]
fn the_workflows_step_sets_the_result_and_hides_where_it_goes() {
    let (place, ran) = grade("eyJ9");
    assert!(ran.status.success(), "{ran:?}");
    assert_eq!(place.read("output"), "result=eyJ9\n");
    let environment = place.read("environment");
    assert!(!environment.contains("GITHUB_OUTPUT") && !environment.contains("GITHUB_ENV"), "{environment}");
    assert!(place.read("calls").contains("lab grade /w/submission --single --out "));
}

#[test]
fn the_workflows_step_fails_if_the_grader_does() {
    for gives in ["nothing", "twice"] {
        let (place, ran) = grade(gives);
        assert!(!ran.status.success() && place.read("output").is_empty());
        assert!(
            String::from_utf8_lossy(&ran.stderr).contains("The grader itself failed, not your submission")
        );
    }
}
