//! JUnit XML: what its readers agree on, and the subset that is safe with CodeGrade's AutoTest V1.

use class::format::Format;
use roxmltree::{Document, Node};

use crate::formats::{laws, submissions, written};
use crate::made_up::hostile;

fn elements<'a, 'i>(node: Node<'a, 'i>) -> Vec<Node<'a, 'i>> {
    node.children().filter(Node::is_element).collect()
}

/// Exactly these attributes.
fn assert_attributes(node: Node<'_, '_>, wanted: &[&str]) {
    let names: Vec<&str> = node.attributes().map(|it| it.name()).collect();
    assert_eq!(names, wanted, "{}", node.tag_name().name());
}

fn number(node: Node<'_, '_>, name: &str) -> usize {
    node.attribute(name).unwrap_or_else(|| panic!("no {name}")).parse().expect("a whole number")
}

/// Only blanks stand between elements.
fn assert_no_text_beside_elements(node: Node<'_, '_>) {
    let blank = |it: Node<'_, '_>| it.text().is_none_or(|text| text.trim().is_empty());
    assert!(node.children().filter(Node::is_text).all(blank));
}

fn count(cases: &[Node<'_, '_>], name: &str) -> usize {
    cases.iter().filter(|case| elements(**case).iter().any(|it| it.has_tag_name(name))).count()
}

/// What tells how a case went, and the attribute that counts it.
const COUNTED: [(&str, &str); 3] = [("failures", "failure"), ("errors", "error"), ("skipped", "skipped")];

#[test]
fn junit_counts_are_exact_and_elements_are_known() {
    for submission in submissions() {
        let text = written(Format::Junit, &submission);
        assert!(text.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites "));
        let document = Document::parse(&text).expect("well-formed XML");
        let root = document.root_element();
        assert_attributes(root, &["name", "tests", "failures", "errors", "skipped", "time"]);
        assert_no_text_beside_elements(root);
        let all: Vec<Node<'_, '_>> = elements(root).into_iter().flat_map(cases_of_a_sound_suite).collect();
        for (attribute, element) in COUNTED {
            assert_eq!(number(root, attribute), count(&all, element));
        }
        assert_eq!(number(root, "tests"), all.len());
        let passed = all.iter().filter(|case| elements(**case).is_empty()).count();
        assert_eq!((passed, all.len()), laws(&submission));
    }
}

fn cases_of_a_sound_suite<'a, 'i>(suite: Node<'a, 'i>) -> Vec<Node<'a, 'i>> {
    assert!(suite.has_tag_name("testsuite"));
    assert_attributes(suite, &["name", "tests", "failures", "errors", "skipped", "time"]);
    assert_no_text_beside_elements(suite);
    let (cases, rest): (Vec<_>, Vec<_>) =
        elements(suite).into_iter().partition(|it| it.has_tag_name("testcase"));
    let is_last_output =
        |it: &Node<'_, '_>| it.has_tag_name("system-out") && it.next_sibling_element().is_none();
    assert!(rest.len() <= 1 && rest.iter().all(is_last_output));
    assert_eq!(number(suite, "tests"), cases.len());
    for (attribute, element) in COUNTED {
        assert_eq!(number(suite, attribute), count(&cases, element));
    }
    for case in &cases {
        assert_attributes(*case, &["name", "classname", "time"]);
        assert!(elements(*case).len() <= 1);
        for child in elements(*case) {
            let wanted: &[&str] =
                if child.has_tag_name("skipped") { &["message"] } else { &["message", "type"] };
            assert_attributes(child, wanted);
        }
    }
    cases
}

#[test]
fn codegrade_v1_reads_nothing_but_cases_and_every_point_counts() {
    for submission in submissions() {
        let text = written(Format::CodegradeV1, &submission);
        let document = Document::parse(&text).expect("well-formed XML");
        let root = document.root_element();
        assert!(root.has_tag_name("testsuites"));
        assert_attributes(root, &[]);
        let (mut got, mut of) = (0, 0);
        for suite in elements(root) {
            assert_attributes(suite, &["name", "tests", "failures", "errors", "skipped", "weight"]);
            assert_no_text_beside_elements(suite);
            let cases = elements(suite);
            assert!(cases.iter().all(|it| it.has_tag_name("testcase")), "only cases are read in a suite");
            assert_eq!(number(suite, "tests"), cases.len());
            assert_eq!(number(suite, "failures"), count(&cases, "failure"));
            assert_eq!(number(suite, "errors"), count(&cases, "error"));
            // What is skipped might not count.
            assert_eq!((number(suite, "skipped"), count(&cases, "skipped")), (0, 0));
            assert_eq!(number(suite, "weight"), cases.iter().map(|it| number(*it, "weight")).sum::<usize>());
            for case in cases {
                assert_attributes(case, &["name", "classname", "time", "weight"]);
                let children = elements(case);
                of += number(case, "weight");
                if children.is_empty() {
                    assert!(case.children().next().is_none(), "a case that passes has no child at all");
                    got += number(case, "weight");
                } else {
                    assert_eq!(children.len(), 1);
                    assert_attributes(children[0], &["message"]);
                }
            }
        }
        assert_eq!((got as u32, of as u32), (submission.points, submission.of));
    }
}

#[test]
fn what_would_end_a_section_of_xml_is_text() {
    for format in [Format::Junit, Format::CodegradeV1] {
        let text = written(format, &hostile());
        let document = Document::parse(&text).expect("well-formed XML");
        let said: String = document.descendants().filter(Node::is_text).filter_map(|it| it.text()).collect();
        assert!(said.contains("]]>") && said.contains("<script>alert(1)</script>"), "{format}");
        assert!(document.descendants().all(|it| !it.is_comment() && !it.has_tag_name("script")), "{format}");
    }
}
