//! One scene, three loops: orbited, refined, and asked about a pixel. Steps, forward and back.

use serde_json::json;

use crate::visit::visit;

const ZBUFFER: &str = "canvas[data-loop='zbuffer']";
const RAYTRACE: &str = "canvas[data-loop='raytrace']";

#[test]
fn the_camera_is_dragged_and_all_three_follow() {
    visit("loops?scene=two-spheres&size=320x240", async |page| {
        let loops = ["painter", "zbuffer", "raytrace"].map(|name| format!("canvas[data-loop='{name}']"));
        let mut before = Vec::new();
        for css in &loops {
            before.push(page.seen(css).await);
        }
        page.screenshot("loops").await;
        page.drag(ZBUFFER, (80.0, 20.0)).await;
        for (css, before) in loops.iter().zip(before) {
            assert_ne!(page.seen(css).await, before, "{css} has not followed");
        }
        let place = page.place().await;
        assert!(place.contains("azimuth="), "{place}");
    });
}

#[test]
fn the_ray_tracer_refines_and_a_change_interrupts_it() {
    visit("loops?scene=glass-and-mirror&size=320x240", async |page| {
        // Changed again before it has come to its end: it begins anew.
        page.run("document.querySelector(\"[data-look='shadows']\").click()", Vec::new()).await;
        page.drag(ZBUFFER, (40.0, 0.0)).await;
        page.until(
            "the finished picture",
            "const p = document.querySelector('[data-screen=raytrace] progress'); return p.value === p.max",
        )
        .await;
        let fine = page.seen(RAYTRACE).await;
        tokio::time::sleep(std::time::Duration::from_millis(300)).await;
        assert_eq!(page.seen(RAYTRACE).await, fine);
    });
}

#[test]
fn a_pixel_tells_both_stories_and_is_solved_step_by_step() {
    visit("loops?scene=teapot&size=320x240", async |page| {
        page.click(ZBUFFER).await;
        for name in ["zbuffer", "raytrace"] {
            let story = page.text(&format!("[data-story='{name}']")).await;
            assert!(story.chars().filter(char::is_ascii_digit).count() > 30, "{name}: {story}");
        }
        // The depths compared, and the system with its three unknowns.
        let depths = page.text("[data-story='zbuffer']").await;
        assert!(depths.contains('z'), "{depths}");
        let system = page.text("[data-story='raytrace']").await;
        for unknown in ["β", "γ", "t"] {
            assert!(system.contains(unknown), "no {unknown} in {system}");
        }
        page.find(".outside svg, .outside img").await;
        page.screenshot("story").await;
        let place = page.place().await;
        assert!(place.contains("i=") && place.contains("j="), "{place}");
        page.click("[data-test='solve']").await;
        assert!(page.place().await.starts_with("steps?"));
        page.find("[data-test='step-forward']").await;
    });
}

#[test]
fn l17_is_stepped_through_forward_back_and_scrubbed() {
    visit("steps?kind=depth", async |page| {
        const SAID: &str = "return document.querySelector('[data-test=step-words]').textContent";
        let first = page.run(SAID, Vec::new()).await;
        let drawn = page.seen("[data-test='step-stage']").await;
        page.click("[data-test='step-forward']").await;
        let second = page.run(SAID, Vec::new()).await;
        assert_ne!(first, second);
        assert_ne!(page.seen("[data-test='step-stage']").await, drawn);
        page.screenshot("L17-step").await;
        page.click("[data-test='step-back']").await;
        assert_eq!(page.run(SAID, Vec::new()).await, first);
        assert_eq!(page.seen("[data-test='step-stage']").await, drawn);
        // Scrubbed to the end, where no step follows.
        page.run(
            "const s = document.querySelector('[data-test=step-slider]'); s.value = s.max; s.dispatchEvent(new Event('input', { bubbles: true }))",
            Vec::new(),
        )
        .await;
        page.settled().await;
        assert_ne!(page.run(SAID, Vec::new()).await, second);
        assert_eq!(
            page.run("return document.querySelector('[data-test=step-forward]').ariaDisabled", Vec::new())
                .await,
            "true"
        );
    });
}

#[test]
fn the_three_solvers_end_with_the_lectures_answer() {
    for how in ["cramer", "inverse", "elimination"] {
        visit(&format!("steps?kind=solve&how={how}"), async |page| {
            page.click("[data-test='step-last']").await;
            let said =
                page.text("[data-test='step-words']").await + &page.text("[data-test='step-stage']").await;
            // L54: β = γ = 1/3, t = 2/3.
            assert!(said.contains("0.333") && said.contains("0.66"), "{how}: {said}");
        });
    }
}

#[test]
fn a_measurement_is_made_and_shown() {
    visit("measure", async |page| {
        let measured = page
            .until("a measurement", "return document.querySelector('[data-measured]')?.dataset.measured")
            .await;
        let measured: serde_json::Value = serde_json::from_str(measured.as_str().unwrap()).unwrap();
        assert_eq!(measured["size"], json!([640, 480]));
        assert!(measured["frames"].as_u64().unwrap() > 0, "{measured}");
        assert!(measured["latency_ms"]["median"].as_f64().unwrap() > 0.0, "{measured}");
    });
}
