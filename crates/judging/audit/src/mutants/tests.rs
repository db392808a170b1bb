//! Each slip on a small function: is it made, and nothing else?

use super::{difference, mutants};

/// What becomes of the one line of a function's body.
fn of(line: &str) -> Vec<String> {
    let text = format!("pub fn f() {{\n    {line}\n}}\n");
    let mutants = mutants(&text).expect("Rust");
    assert!(mutants.iter().all(|mutant| mutant.line == 2 && mutant.change.before == [line]), "{mutants:#?}");
    mutants.into_iter().map(|mutant| mutant.change.after.join("\n")).collect()
}

/// All that becomes of a line, in any order.
fn becomes(line: &str, wanted: &[&str]) {
    let (mut given, mut wanted) = (of(line), wanted.to_vec());
    given.sort_unstable();
    wanted.sort_unstable();
    assert_eq!(given, wanted, "{line}");
}

#[test]
fn an_operator_becomes_another_and_an_operand_is_left_out() {
    becomes("e - g", &["e", "g - e", "e + g", "g"]);
    becomes("e && g", &["e", "e || g", "g"]);
}

#[test]
fn a_border_moves_and_a_comparison_turns() {
    becomes("e < g", &["e <= g", "e > g", "e >= g"]);
    becomes("(e..g)", &["((e + 1)..g)", "(e..=g)", "(e..(g - 1))"]);
}

#[test]
fn constants_and_signs_change() {
    becomes("0.0", &["1.0", "-1.0"]);
    becomes("2.0", &["0.0", "1.0", "3.0", "4.0"]);
    becomes("3", &["0", "1", "2", "4", "6"]);
    becomes("-e", &["e"]);
    becomes("!e", &["e"]);
    assert!(of("f(e, g)").contains(&"f(e, -g)".to_owned()));
}

#[test]
fn arguments_change_places_and_calls_are_left_out() {
    becomes("sum(e, 0.0)", &["sum(0.0, e)", "sum(-e, 0.0)", "sum(e, 1.0)", "sum(e, -1.0)"]);
    becomes("e.max(g)", &["e", "e.min(g)", "e.max(-g)"]);
    becomes("e.cross(g)", &["e", "(g).cross(e)", "e.cross(-g)"]);
    becomes("e.normalize()", &["e", "e.normalize_or_zero()"]);
    becomes("e.sin()", &["e", "e.cos()"]);
}

#[test]
fn fields_rows_and_columns_are_taken_for_one_another() {
    becomes("p.x", &["p.y", "p.z"]);
    becomes("p[q][m]", &["p[m][q]"]);
    assert!(of("Mat3::from_cols(e, g, h)").contains(&"Mat3::from_cols(e, g, h).transpose()".to_owned()));
    becomes("Hit { e, g }", &["Hit { e: -e, g }", "Hit { e: g, g: e }", "Hit { e, g: -g }"]);
}

#[test]
fn branches_change_places_conditions_turn_and_steps_are_left_out() {
    becomes(
        "if e { g } else { h }",
        &["if false { g } else { h }", "if true { g } else { h }", "if e { h } else { g }"],
    );
    becomes("if e { return }", &["if !(e) { return }", "if false { return }"]);
    becomes("p = e;", &[""]);
}

#[test]
fn what_a_macro_is_given_changes_too_and_what_is_no_rust_is_said() {
    assert!(of("vec![0.0; n]").contains(&"vec![1.0; n]".to_owned()));
    assert!(mutants("fn f( {").is_err());
}

#[test]
fn no_two_mutants_are_the_same_and_none_is_the_original() {
    for exercise in course::all() {
        let text = exercise.submission(&exercise.reference).expect("its text");
        let mutants = mutants(&text).expect("Rust");
        let mut texts: Vec<&str> = mutants.iter().map(|mutant| mutant.text.as_str()).collect();
        assert!(texts.len() >= 10, "{}: only {} mutants", exercise.name, texts.len());
        assert!(!texts.contains(&text.as_str()));
        texts.sort_unstable();
        texts.dedup();
        assert_eq!(texts.len(), mutants.len(), "{}", exercise.name);
    }
}

#[test]
fn a_difference_is_the_lines_between_what_is_the_same() {
    let (at, before, after) = difference("a\n  b\nc\n", "a\n  d\n\nc\n");
    assert_eq!((at, before, after), (1, vec!["b".to_owned()], vec!["d".to_owned()]));
}

#[test]
fn a_repeated_line_is_counted_once() {
    let (at, before, after) = difference("a\na\na\n", "a\na\n");
    assert_eq!((at, before, after), (2, vec!["a".to_owned()], vec![]));
}
