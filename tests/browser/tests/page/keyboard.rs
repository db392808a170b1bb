//! The keyboard alone goes through all figures, moves them, and fills the screen.

use std::collections::BTreeSet;

use serde_json::json;

use crate::visit::visit;

/// WebDriver's names of keys.
const TAB: &str = "\u{e004}";
const RIGHT: &str = "\u{e014}";
const UP: &str = "\u{e013}";
const ENTER: &str = "\u{e007}";
const ESCAPE: &str = "\u{e00c}";

#[test]
#[ignore = "visits every page: for .ci/nightly"]
fn the_keyboard_alone_goes_through_all_figures() {
    visit("", async |page| {
        // From the top of the page to the first figure of the list.
        let mut steps = 0;
        loop {
            page.keys(TAB).await;
            let on = page.run("return document.activeElement.dataset.figure ?? null", Vec::new()).await;
            if on.is_string() {
                break;
            }
            steps += 1;
            assert!(steps < 40, "the list of figures is not reached");
        }
        page.keys(ENTER).await;
        page.settled().await;
        let mut seen = BTreeSet::new();
        let lecture = page.lecture().await;
        let figures = lecture["figures"].as_array().unwrap();
        for figure in figures {
            let stem = figure["stem"].as_str().unwrap();
            page.until(
                stem,
                &format!(
                    "return document.querySelector('[data-figure=\"{stem}\"] .picture :is(svg, img)') !== null"
                ),
            )
            .await;
            assert!(!page.text("[data-test='figure-title']").await.is_empty());
            let trouble = page.run("return [...document.querySelectorAll('.trouble')].filter((e) => e.checkVisibility()).map((e) => e.textContent).join()", Vec::new()).await;
            assert_eq!(trouble, "", "{stem}");
            seen.insert(stem);
            page.keys(RIGHT).await;
            page.settled().await;
        }
        assert_eq!(seen.len(), figures.len());
    });
}

#[test]
fn every_control_of_a_figure_is_reached_and_has_a_name() {
    visit("L31-phong-geometry", async |page| {
        let wanted = page
            .run(
                "return [...document.querySelectorAll('article button:not([disabled]), article input, article [tabindex=\"0\"], article a, article summary, article select')] \
                 .filter((e) => e.checkVisibility()).map((e, k) => { e.dataset.count = k; return k; })",
                Vec::new(),
            )
            .await;
        let mut missing: BTreeSet<i64> =
            wanted.as_array().unwrap().iter().map(|k| k.as_i64().unwrap()).collect();
        assert!(missing.len() > 8, "{missing:?}");
        for _ in 0..60 {
            page.keys(TAB).await;
            let now = page
                .run(
                    "const e = document.activeElement; const name = e.ariaLabel || e.labels?.[0]?.textContent || e.textContent || e.title; \
                     return [e.dataset.count ?? null, name.trim()]",
                    Vec::new(),
                )
                .await;
            if let Some(count) = now[0].as_str() {
                assert_ne!(now[1], json!(""), "control {count} has no name");
                missing.remove(&count.parse().unwrap());
            }
        }
        assert!(missing.is_empty(), "not reached: {missing:?}");
    });
}

#[test]
fn arrow_keys_move_a_handle() {
    visit("L31-phong-geometry", async |page| {
        let before = page.parameter("eye").await;
        page.run("document.querySelector(\"[data-moves='eye']\").focus()", Vec::new()).await;
        for _ in 0..5 {
            page.keys(RIGHT).await;
        }
        page.settled().await;
        assert!((page.parameter("eye").await - before).abs() > 1.0);
        let said = page.run("return document.activeElement.getAttribute('aria-valuetext')", Vec::new()).await;
        assert!(said.as_str().unwrap().chars().any(|c| c.is_ascii_digit()), "{said}");
    });
}

#[test]
fn f_fills_the_screen_arrows_step_and_escape_leaves() {
    visit("L26", async |page| {
        let is_full = "return document.documentElement.classList.contains('show')";
        page.keys("f").await;
        page.until("the full screen", is_full).await;
        page.screenshot("L26-full-screen").await;
        page.keys(RIGHT).await;
        page.settled().await;
        assert_eq!(page.run(is_full, Vec::new()).await, true);
        assert!(page.text("[data-test='figure-title']").await.contains("L27"));
        page.keys(ESCAPE).await;
        page.until("the page", "return !document.documentElement.classList.contains('show')").await;
    });
}

#[test]
fn a_number_is_moved_by_arrow_keys() {
    visit("L26", async |page| {
        let theta = page.parameter("theta").await;
        page.run("document.querySelector(\"input[data-parameter='theta']\").focus()", Vec::new()).await;
        page.keys(UP).await;
        page.settled().await;
        assert!(page.parameter("theta").await > theta);
    });
}
