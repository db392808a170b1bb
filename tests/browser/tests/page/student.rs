//! A figure is drawn by the student's own function: right, wrong, not compiling, without end.

use crate::visit::{Visit, visit};

/// The exercise that draws the highlights of L31.
const FILE: &str = "lighting/phong_highlight.rs";

/// Its file with this in the place of `todo!()`.
fn solved(body: &str) -> String {
    let stub = include_str!("../../../../exercises/lighting/phong_highlight.rs");
    let text = stub.replace("todo!()", body);
    assert_ne!(text, stub, "the exercise is handed out with todo!()");
    text
}

/// As the lecture has it.
const RIGHT: &str = "if n.dot(to_light) <= 0.0 { return Vec3::ZERO; }
    let r = 2.0 * n.dot(to_light) * n - to_light;
    c_l * to_eye.dot(r).max(0.0).powf(p)";

/// Without the exponent.
const WRONG: &str = "let r = 2.0 * n.dot(to_light) * n - to_light;
    let _ = p;
    c_l * to_eye.dot(r).max(0.0)";

/// Waits for a state of the student's drawing.
async fn is(page: &Visit, state: &str) {
    page.until(state, &format!("return document.querySelector('section.mine')?.dataset.state === '{state}'"))
        .await;
    page.settled().await;
}

async fn differs(page: &Visit) -> String {
    page.text("[data-test='mine-differs']").await
}

#[test]
fn mine_is_right_then_wrong_and_redraws_on_save() {
    visit("L31-exponent-strip", async |page| {
        page.stage.save(FILE, &solved(RIGHT));
        page.click("[data-test='mine']").await;
        is(page, "drawn").await;
        let right = differs(page).await;
        assert!(right.starts_with('0'), "{right}");
        page.screenshot("mine-right").await;
        // A misconception, saved: the page draws it by itself.
        page.stage.save(FILE, &solved(WRONG));
        page.until(
            "the wrong picture",
            "return !document.querySelector('[data-test=mine-differs]')?.textContent.startsWith('0')",
        )
        .await;
        is(page, "drawn").await;
        page.screenshot("mine-wrong").await;
        let drawings = page
            .run(
                "return document.querySelectorAll('section.mine figure, section.mine .drawing').length",
                Vec::new(),
            )
            .await;
        assert!(drawings.as_u64().unwrap() >= 3, "yours, right, difference: {drawings}");
    });
}

#[test]
fn what_cannot_draw_says_so_and_the_page_lives_on() {
    visit("L31-exponent-strip", async |page| {
        page.click("[data-test='mine']").await;
        is(page, "not-started").await;
        page.stage.save(FILE, "pub fn phong_highlight( { nonsense");
        is(page, "does-not-compile").await;
        assert!(page.text("section.mine pre").await.contains("error"));
        page.screenshot("mine-does-not-compile").await;
        page.stage.save(FILE, &solved("panic!(\"not today\")"));
        is(page, "panicked").await;
        assert!(page.text("section.mine").await.contains("not today"));
        page.stage.save(FILE, &solved("loop {}"));
        is(page, "timed-out").await;
        page.screenshot("mine-without-end").await;
        // And the figure still moves.
        page.drag("input[data-parameter='p']", (-60.0, 0.0)).await;
        page.stage.save(FILE, &solved(RIGHT));
        is(page, "drawn").await;
    });
}

#[test]
fn without_the_key_nothing_of_the_students_runs() {
    visit("L31-exponent-strip", async |page| {
        page.browser.delete_all_cookies().await.unwrap();
        page.browser.refresh().await.unwrap();
        page.settled().await;
        page.click("[data-test='mine']").await;
        is(page, "no-permission").await;
    });
}
