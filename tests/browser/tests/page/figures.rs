//! Figures are moved: in the drawing, beside it, by the address.

use crate::visit::visit;

/// The ball of L27, second drawing of its figure.
const BALL: &str = "[data-test='drawings'] figure:nth-child(2) img";

#[test]
fn the_light_of_l27_is_dragged_and_the_shading_changes() {
    visit("L27", async |page| {
        // At rest it is drawn as large as it is shown.
        page.keys("r").await;
        page.settled().await;
        let (theta, ball) = (page.parameter("theta").await, page.seen(BALL).await);
        page.screenshot("L27-at-rest").await;
        page.drag("[data-handle='0']", (-60.0, -60.0)).await;
        assert!((page.parameter("theta").await - theta).abs() > 5.0, "the light has not moved");
        assert_ne!(page.seen(BALL).await, ball, "the light moved, the shading did not");
        page.screenshot("L27-dragged").await;
        // One key puts it back.
        page.run("document.activeElement.blur()", Vec::new()).await;
        page.keys("r").await;
        page.settled().await;
        assert!((page.parameter("theta").await - theta).abs() < 1e-4);
        assert_eq!(page.seen(BALL).await, ball);
    });
}

#[test]
fn p_is_scrubbed_in_l31_and_the_address_keeps_it() {
    visit("L31-exponent-strip", async |page| {
        const PICTURE: &str = "[data-test='drawings'] figure img";
        let (p, balls) = (page.parameter("p").await, page.seen(PICTURE).await);
        page.drag("input[data-parameter='p']", (-60.0, 0.0)).await;
        let scrubbed = page.parameter("p").await;
        assert!(scrubbed < p, "{scrubbed} is not below {p}");
        assert_ne!(page.seen(PICTURE).await, balls);
        let place = page.place().await;
        assert!(place.starts_with("L31-exponent-strip?") && place.contains("p="), "{place}");
        // The same place in another tab shows the same.
        let shown = page.seen(PICTURE).await;
        page.browser.refresh().await.unwrap();
        page.settled().await;
        assert!((page.parameter("p").await - scrubbed).abs() <= 1e-5 * scrubbed);
        assert_eq!(page.seen(PICTURE).await, shown);
        page.click("[data-test='reset']").await;
        assert!((page.parameter("p").await - p).abs() < 1e-4);
        assert!(!page.place().await.contains("p="));
    });
}

#[test]
fn what_has_a_place_is_dragged_there() {
    // The middle of a handle arrives where it was dragged to.
    visit("L48-barycentric-plane", async |page| {
        const MIDDLE: &str = "const b = document.querySelector(\"[data-handle='0']\").getBoundingClientRect(); \
                              const d = document.querySelector('.picture svg').getBoundingClientRect(); \
                              return [b.x + b.width / 2 - d.x, b.y + b.height / 2 - d.y]";
        page.find("[data-handle='0']").await;
        let before = page.run(MIDDLE, Vec::new()).await;
        page.drag("[data-handle='0']", (70.0, -40.0)).await;
        let after = page.run(MIDDLE, Vec::new()).await;
        for (k, by) in [(0, 70.0), (1, -40.0)] {
            let moved = after[k].as_f64().unwrap() - before[k].as_f64().unwrap();
            assert!((moved - by).abs() < 3.0, "{moved} instead of {by} pixels");
        }
    });
}

#[test]
fn the_language_is_switched_and_remembered() {
    visit("L26", async |page| {
        let lecture = page.lecture().await;
        let all = lecture["figures"].as_array().unwrap();
        let figure = all.iter().find(|figure| figure["numbers"][0] == "L26").unwrap();
        let words = |of: &serde_json::Value, language: &str| of[language].as_str().unwrap().to_owned();
        assert_ne!(figure["title"]["en"], figure["title"]["nl"]);
        let title = "[data-test='figure-title']";
        assert!(page.text(title).await.contains(&words(&figure["title"], "en")));
        page.click("[data-test='language']").await;
        assert!(page.text(title).await.contains(&words(&figure["title"], "nl")));
        assert!(page.text("[data-test='caption']").await.contains(&words(&figure["caption"], "nl")));
        assert!(
            page.text(".parameter label").await.contains(&words(&figure["parameters"][0]["label"], "nl"))
        );
        assert_eq!(page.run("return document.documentElement.lang", Vec::new()).await, "nl");
        page.screenshot("L26-dutch").await;
        page.browser.refresh().await.unwrap();
        page.settled().await;
        assert!(page.text(title).await.contains(&words(&figure["title"], "nl")));
    });
}

#[test]
fn an_unknown_figure_is_said_and_all_are_offered() {
    visit("L99", async |page| {
        assert!(page.text("[data-test='unknown']").await.contains("L99"));
        let links =
            page.run("return document.querySelectorAll('[data-test=figure-link]').length", Vec::new()).await;
        assert_eq!(links, page.lecture().await["figures"].as_array().unwrap().len());
    });
}

#[test]
fn a_value_out_of_range_in_the_address_does_no_harm() {
    visit("L31-exponent-strip?p=1e9", async |page| {
        let p = page.parameter("p").await;
        assert!((0.0..=4096.0).contains(&p), "{p}");
        page.find("[data-test='drawings'] figure img").await;
    });
}
