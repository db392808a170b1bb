//! The lecturer's page.

use class::report::class_page;
use class::results::{LawResult, Outcome, Results};

use crate::made_up::{JUDGED, class, everyone, submission, without_answer};

#[test]
fn every_student_is_found_in_the_table_with_points_and_feedback() {
    let results = everyone();
    let page = class_page(&results);
    let table = page.split_once("<table class=\"sortable\" id=\"class\">").expect("the table").1;
    let rows: Vec<&str> = table.split("<tr data-words=").skip(1).collect();
    assert_eq!(rows.len(), results.submissions.len());
    for (row, submission) in rows.iter().zip(&results.submissions) {
        assert!(row.contains(&format!("href=\"feedback/{}.html\"", submission.id)), "{}", submission.id);
        assert!(
            row.contains(&format!("<td class=\"number\">{}</td>", submission.points)),
            "{}",
            submission.id
        );
    }
    assert_eq!(
        table.matches("<th scope=\"col\"").count() + table.matches("<th class=\"heat\"").count(),
        6 + 35
    );
}

#[test]
fn a_grader_error_stands_on_top() {
    let page = class_page(&everyone());
    let (warning, numbers) = (page.find("The grader failed on 2 exercises"), page.find("class=\"facts\""));
    assert!(warning.is_some() && warning < numbers);
    assert!(!class_page(&class(3)).contains("The grader failed"));
    let unguarded = Results { sandboxed: false, ..class(1) };
    assert!(class_page(&unguarded).contains("Not every submission was judged in the sandbox"));
}

#[test]
fn a_part_of_a_class_says_that_it_is_one() {
    let part = Results { partition: Some("count:1/3".to_owned()), ..class(2) };
    assert!(class_page(&part).contains("This is a part of the class, <code>count:1/3</code>"));
    assert!(!class_page(&class(2)).contains("part of the class"));
}

#[test]
fn what_is_nobodys_submission_stands_on_top() {
    let remarks = vec!["hidden, so nobody's submission: .ada, <b>".to_owned()];
    let page = class_page(&Results { remarks, ..class(2) });
    let (remark, numbers) =
        (page.find("hidden, so nobody's submission: .ada, &lt;b&gt;"), page.find("class=\"facts\""));
    assert!(remark.is_some() && remark < numbers);
    assert!(!class_page(&class(2)).contains("In the class's folder"));
}

#[test]
fn misconceptions_are_counted_and_lead_to_the_students() {
    let page = class_page(&same_mistake());
    let listed = section(&page, "misconceptions");
    let looks_like = JUDGED[0][1].looks_like.as_ref().expect("a diagnosis");
    let groups: Vec<&str> = listed.split("<li><details>").skip(1).collect();
    let group = groups.iter().find(|it| it.contains(&looks_like.misconception)).expect("the group");
    assert!(group.contains("<span class=\"size\">3</span>") && group.contains(&looks_like.what), "{group}");
    for id in ["a", "b", "c"] {
        assert!(group.contains(&format!("feedback/{id}.html")), "{id} is missing");
    }
    assert!(!group.contains("feedback/d.html") && !listed.contains("feedback/e.html"));
}

#[test]
fn those_who_break_the_same_laws_are_one_cluster_and_others_are_not_in_it() {
    let page = class_page(&same_mistake());
    let listed = section(&page, "clusters");
    // Once over the whole course, once in the exercise.
    assert_eq!(listed.matches("<span class=\"size\">3</span>").count(), 2, "{listed}");
    assert_eq!(listed.matches("<span class=\"size\">").count(), 2, "{listed}");
    assert!(!listed.contains("feedback/d.html") && !listed.contains("feedback/e.html"));
}

/// Three with the same misconception in the first exercise, one with another, one without fault.
fn same_mistake() -> Results {
    let judged = &JUDGED[0];
    let failed = |at: usize| -> Vec<bool> {
        judged[at].laws.iter().map(|law| matches!(law.result, LawResult::Failed(_))).collect()
    };
    let other =
        (2..judged.len()).find(|at| failed(*at) != failed(1)).expect("another one that breaks other laws");
    let student = |(id, at): (&str, usize)| submission(id, id, Vec::new(), vec![judged[at].clone()]);
    let submissions = [("a", 1), ("b", 1), ("c", 1), ("d", other), ("e", 0)].map(student).to_vec();
    let mut results = class(0);
    results.course.exercises.truncate(1);
    Results { submissions, ..results }
}

fn section<'a>(page: &'a str, id: &str) -> &'a str {
    let start = page.find(&format!("<section aria-labelledby=\"{id}\"")).expect("the section");
    let end = page[start..].find("</section>").expect("its end");
    &page[start..start + end]
}

#[test]
fn where_the_grader_failed_nothing_is_known_of_the_student() {
    let results = everyone();
    let failed = |name: &str| {
        let verdicts =
            results.submissions.iter().flat_map(|it| &it.verdicts).filter(|it| it.exercise == name);
        verdicts.filter(|it| it.outcome == Outcome::GraderError).count()
    };
    let page = class_page(&results);
    let rows = section(&page, "exercises");
    for exercise in &results.course.exercises {
        let row = rows
            .split("<tr>")
            .find(|row| row.contains(&format!(">{}</code>", exercise.name)))
            .expect("a row");
        let judged = results.submissions.len() - failed(&exercise.name);
        assert!(row.contains(&format!(" of {judged}</td>")), "{}: {row}", exercise.name);
    }
    assert!(results.course.exercises.iter().any(|exercise| failed(&exercise.name) > 0));
}

#[test]
fn an_exercise_that_the_weak_solve_and_the_strong_do_not_is_against_the_rest() {
    let right = |at: usize| JUDGED[at][0].clone();
    let none = |at: usize| without_answer(&course::all()[at], Outcome::Missing, "");
    let strong = submission("a", "a", Vec::new(), vec![none(0), right(1), right(2)]);
    let weak = submission("b", "b", Vec::new(), vec![right(0), none(1), none(2)]);
    let mut results = class(0);
    results.course.exercises.truncate(3);
    let page = class_page(&Results { submissions: vec![strong, weak], ..results });
    let rows: Vec<&str> = section(&page, "exercises").split("<tr>").skip(2).collect();
    assert!(rows[0].contains("against the rest") && rows[0].contains("(−1.00)"), "{}", rows[0]);
    assert!(rows[0].contains("50 %") && rows[0].contains("middling"), "{}", rows[0]);
}

#[test]
fn a_class_of_nobody_has_a_page_too() {
    let page = class_page(&class(0));
    assert!(page.contains("The class: 0 submissions") && !page.contains("NaN %"));
}
