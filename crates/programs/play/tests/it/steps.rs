//! Do the steps end where the algorithms end?

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use canvas::srgb;
use geometry::{Ray, Triangle};
use glam::Vec3;
use play::steps::{StepsRequest, steps};
use play::{Look, Stage};
use raytrace::triangle::{Solution, System, cramer, elimination, inverse, system};
use raytrace::{nearest, viewing_ray, visible_interval};
use scene::Renderer;
use serde_json::{Value as Json, json};
use shading::Visibility;

fn asked(json: Json) -> StepsRequest {
    serde_json::from_value(json).unwrap()
}

fn told(json: Json) -> Vec<Json> {
    list(&steps(&Stage::default(), &asked(json)).unwrap()["steps"]).to_vec()
}

fn list(json: &Json) -> &[Json] {
    json.as_array().unwrap_or_else(|| panic!("{json} is no list"))
}

fn text(json: &Json) -> &str {
    json.as_str().unwrap_or_else(|| panic!("{json} is no text"))
}

/// The numbers of a grid as the slide prints them: rows from the top down.
fn grid(step: &Json) -> Vec<String> {
    let svg = text(&step["svg"]);
    let drawing = roxmltree::Document::parse(svg).unwrap();
    let texts = drawing.descendants().filter(|node| node.has_tag_name("text"));
    let cells: Vec<String> = texts.map(|node| node.text().unwrap().to_owned()).collect();
    // Drawn from the lowest row upwards.
    cells.chunks(6).rev().map(|row| row.join(" ")).collect()
}

#[test]
fn the_grids_are_those_of_the_slide() {
    let steps = told(json!({ "kind": "depth", "first": 10, "second": 5, "third": 15 }));
    // Clearing, and two steps for each of 2 + 2 + 1 triangles.
    assert_eq!(steps.len(), 11);
    assert_eq!(grid(&steps[0]), ["0 0 0 0 0 0"; 5]);
    let second = ["0 0 0 0 0 0", "0 0 0 0 0 0", "10 10 10 10 0 0", "10 10 10 10 0 0", "10 10 10 10 0 0"];
    assert_eq!(grid(&steps[4]), second);
    let third = ["5 5 5 5 5 5", "5 5 5 5 5 5", "10 10 10 10 5 5", "10 10 10 10 5 5", "10 10 10 10 5 5"];
    assert_eq!(grid(&steps[8]), third);
    let fourth =
        ["5 5 15 15 5 5", "5 5 15 15 15 5", "10 15 15 15 15 15", "10 15 15 15 15 15", "15 15 15 15 15 15"];
    assert_eq!(grid(&steps[10]), fourth);
    // Asking changes nothing; only the comparison does.
    assert_eq!(grid(&steps[9]), third);
    // Both triangles of the second rectangle together: 30 pixels, 18 of them nearer than the 0 that was stored.
    let of = |k: usize| -> String { list(&steps[k]["lines"]).iter().map(|line| text(&line["en"])).collect() };
    let stays: u32 = [6, 8].iter().map(|k| count_before(&of(*k), "stays, ")).sum();
    let drawn: u32 = [6, 8].iter().map(|k| count_before(&of(*k), "drawn, ")).sum();
    assert_eq!((drawn, stays), (18, 12));
}

/// The number after a word.
fn count_before(line: &str, word: &str) -> u32 {
    let rest = line.split(word).nth(1).unwrap_or("0 ");
    rest.split(' ').next().unwrap().parse().unwrap()
}

#[test]
fn without_depths_the_slides_own_are_taken_and_others_may_not_be_out_of_range() {
    assert_eq!(
        asked(json!({ "kind": "depth" })),
        asked(json!({ "kind": "depth", "first": 10, "second": 5, "third": 15 }))
    );
    let refused = steps(&Stage::default(), &asked(json!({ "kind": "depth", "first": 0 }))).unwrap_err();
    assert!(refused.0.en.contains("out of range"), "{refused}");
}

#[test]
fn what_is_not_understood_is_refused() {
    for wrong in [
        json!({ "kind": "magic" }),
        json!({ "kind": "depth", "fourth": 3 }),
        json!({ "kind": "solve", "how": "guessing" }),
        json!({ "kind": "painter" }),
        json!({ "kind": "solve", "how": "cramer", "pixel": [1, -2] }),
    ] {
        assert!(serde_json::from_value::<StepsRequest>(wrong.clone()).is_err(), "{wrong}");
    }
}

fn small(scene: &str) -> Look {
    Look { scene: scene.to_owned(), width: 96, height: 72, ..Look::default() }
}

fn asked_of(look: &Look) -> Json {
    json!({ "scene": look.scene, "width": look.width, "height": look.height })
}

#[test]
fn the_painters_last_picture_is_the_painters() {
    for scene in ["two-spheres", "cycle", "floating-bin"] {
        let look = small(scene);
        let steps = told(json!({ "kind": "painter", "look": asked_of(&look) }));
        assert!(steps.len() > 3 && steps.len() <= 42, "{scene}: {} steps", steps.len());
        let settings = look.settings(Renderer::Painter).unwrap();
        let prepared = Stage::default().prepared(&look).unwrap();
        let pipeline = prepared.pipeline(look.width, look.height).unwrap();
        let frame = prepared.in_world(&settings, |world| {
            shading::render(world, &pipeline, settings.shading, Visibility::Painter)
        });
        let png = text(&steps.last().unwrap()["png"]).strip_prefix("data:image/png;base64,").unwrap();
        let last = canvas::codec::decode(&BASE64_STANDARD.decode(png).unwrap()).unwrap();
        let steps_of = |image: &canvas::Image| -> Vec<[u8; 3]> {
            image.pixels().iter().map(|pixel| pixel.to_array().map(srgb::to_u8)).collect()
        };
        assert_eq!(steps_of(&last), steps_of(&frame.image), "{scene}");
    }
}

#[test]
fn the_cycle_is_named_and_cut() {
    let steps = told(json!({ "kind": "painter", "look": asked_of(&small("cycle")) }));
    assert!(text(&steps[0]["words"]["en"]).contains("no order is right"), "{}", steps[0]["words"]);
    assert!(text(&steps[0]["lines"][0]["nl"]).contains("Een cyclus"), "{}", steps[0]["lines"]);
    let is_part = |step: &&Json| text(&step["words"]["en"]).contains("the plane of triangle 0 of polygons");
    assert!(steps.iter().filter(is_part).count() >= 2);
    // Three triangles, and a piece more for each cut; each a step of its own.
    assert!(steps.len() > 4, "{} steps", steps.len());
}

/// One of the three ways to solve a system.
type Solve = fn(&System) -> Option<Solution>;

const WAYS: [(&str, Solve); 3] = [("cramer", cramer), ("inverse", inverse), ("elimination", elimination)];

fn solution(steps: &[Json]) -> [f32; 3] {
    let solution = list(&steps.last().unwrap()["solution"]);
    [0, 1, 2].map(|k| solution[k].as_f64().unwrap() as f32)
}

#[test]
fn the_worked_example_comes_out() {
    let system = system(&Ray::new(Vec3::ONE, Vec3::NEG_ONE), &Triangle::new(Vec3::X, Vec3::Y, Vec3::Z));
    for (how, solve) in WAYS {
        let steps = told(json!({ "kind": "solve", "how": how }));
        let Solution { beta, gamma, t } = solve(&system).unwrap();
        assert_eq!(solution(&steps), [beta, gamma, t], "{how}");
        assert!(text(&steps.last().unwrap()["words"]["en"]).contains("hits"), "{how}");
        assert!(steps.len() >= 6, "{how}: {} steps", steps.len());
    }
}

#[test]
fn the_steps_at_a_pixel_end_with_the_solution_for_its_triangle() {
    let look = small("teapot");
    let settings = look.settings(Renderer::Raytrace).unwrap();
    let prepared = Stage::default().prepared(&look).unwrap();
    let pipeline = prepared.pipeline(look.width, look.height).unwrap();
    let world = prepared.traced_world(&settings).unwrap();
    let ray = viewing_ray(&pipeline, 40.0, 30.0);
    let (t0, t1) = visible_interval(&pipeline.volume());
    let hit = nearest(&world, &ray, t0, t1).unwrap();
    let [a, b, c] = world.objects()[hit.object].corners(hit.triangle).unwrap();
    let system = system(&ray, &Triangle::new(a, b, c));
    for (how, solve) in WAYS {
        let steps = told(json!({ "kind": "solve", "how": how, "look": asked_of(&look), "pixel": [40, 30] }));
        let Solution { beta, gamma, t } = solve(&system).unwrap();
        assert_eq!(solution(&steps), [beta, gamma, t], "{how}");
        assert_eq!(list(&steps[0]["matrix"]).len(), 3);
        for step in &steps {
            for mark in list(step.get("marked").unwrap_or(&json!([]))) {
                assert!(mark[0].as_u64().unwrap() < 3 && mark[1].as_u64().unwrap() < 4, "{how}: {mark}");
            }
        }
    }
}

#[test]
fn elimination_leaves_zeros_below_the_diagonal() {
    let steps = told(json!({ "kind": "solve", "how": "elimination" }));
    let last = steps.iter().rfind(|step| step.get("matrix").is_some()).unwrap();
    for (row, column) in [(1, 0), (2, 0), (2, 1)] {
        assert_eq!(last["matrix"][row][column].as_f64(), Some(0.0), "{}", last["matrix"]);
    }
}

#[test]
fn balls_and_the_background_have_no_system() {
    for (scene, pixel, reason) in [("two-spheres", [35, 35], "ball"), ("two-spheres", [0, 0], "background")] {
        let asked = asked(
            json!({ "kind": "solve", "how": "cramer", "look": asked_of(&small(scene)), "pixel": pixel }),
        );
        let refused = steps(&Stage::default(), &asked).unwrap_err();
        assert!(refused.0.en.contains(reason), "{refused}");
    }
}
