//! Is the pixel's story that of the pictures? The same triangle, the same depth, the same colour, bit by bit.

use glam::{Vec3, vec3};
use play::story::story;
use play::{Look, Stage};
use raytrace::{nearest, ray_color, viewing_ray, visible_interval};
use scene::Renderer;
use serde_json::Value as Json;
use shading::Visibility;
use zbuffer::DepthFormat;

const WIDTH: u32 = 72;
const HEIGHT: u32 = 54;

fn look(scene: &str, shading: &str, highlight: &str) -> Look {
    Look {
        scene: scene.to_owned(),
        shading: shading.to_owned(),
        highlight: highlight.to_owned(),
        width: WIDTH,
        height: HEIGHT,
        ..Look::default()
    }
}

/// Scenes with flat, curved, exact, clear and mirroring surfaces, in all shadings and with both highlights.
fn looks() -> Vec<Look> {
    vec![
        look("teapot", "phong", "blinn"),
        look("teapot", "gouraud", "phong"),
        look("two-spheres", "flat", "blinn"),
        look("cycle", "phong", "phong"),
        look("floating-bin", "gouraud", "blinn"),
        look("glass-and-mirror", "phong", "blinn"),
        // From within the box's walls: much is clipped.
        Look { distance: 0.4, azimuth: 30.0, ..look("cornell-box", "flat", "phong") },
    ]
}

/// Pixels all over the picture, in no pattern that a scene could share.
fn pixels() -> impl Iterator<Item = (u32, u32)> {
    (0..9).map(|k| ((11 + 29 * k) % WIDTH, (7 + 23 * k) % HEIGHT))
}

fn number(json: &Json) -> f32 {
    json.as_f64().unwrap_or_else(|| panic!("{json} is no number")) as f32
}

fn vector(json: &Json) -> Vec3 {
    vec3(number(&json[0]), number(&json[1]), number(&json[2]))
}

fn list(json: &Json) -> &[Json] {
    json.as_array().unwrap_or_else(|| panic!("{json} is no list"))
}

/// The terms of the lighting equation, added up, give the colour.
fn check_terms(shading: &Json, color: Vec3, what: &str) {
    let sum = list(&shading["terms"]).iter().fold(Vec3::ZERO, |sum, term| sum + vector(&term["value"]));
    // No term is negative, so that no sum is larger than the last: each of some thirty roundings, here and in the renderer,
    // costs half an epsilon of it at most.
    let bound = 32.0 * f32::EPSILON * color.max_element();
    assert!((sum - color).abs().max_element() <= bound, "{what}: terms {sum}, colour {color}");
    assert!((vector(&shading["sum"]) - color).abs().max_element() <= bound, "{what}");
}

#[test]
fn the_z_buffers_story_ends_with_what_the_picture_shows() {
    let stage = Stage::default();
    let mut shown = 0;
    for look in looks() {
        let settings = look.settings(Renderer::ZBuffer).unwrap();
        let prepared = stage.prepared(&look).unwrap();
        let pipeline = prepared.pipeline(WIDTH, HEIGHT).unwrap();
        let frame = prepared.in_world(&settings, |world| {
            shading::render(world, &pipeline, settings.shading, Visibility::ZBuffer(DepthFormat::F32))
        });
        for (i, j) in pixels() {
            let what = format!("{} {} ({i}, {j})", look.scene, look.shading);
            let told = &story(&stage, &look, (i, j)).unwrap()["zbuffer"];
            assert_eq!(vector(&told["linear"]), frame.image.get(i, j), "{what}");
            let last = list(&told["tests"]).iter().rfind(|test| test["nearer"] == true);
            let Some(visible) = frame.visible_at(i, j) else {
                assert!(last.is_none() && told["shading"].is_null(), "{what}");
                continue;
            };
            shown += 1;
            let last = last.unwrap_or_else(|| panic!("{what}: nothing drawn"));
            assert_eq!(
                (&last["object"], &last["triangle"]),
                (&visible.object.into(), &visible.triangle.into())
            );
            assert_eq!(number(&last["z"]).to_bits(), visible.z.to_bits(), "{what}");
            assert_eq!(vector(&last["weights"]), visible.weights.to_vec3(), "{what}");
            assert_eq!(vector(&told["shading"]["normal"]), visible.n_world, "{what}");
            check_terms(&told["shading"], frame.image.get(i, j), &what);
        }
    }
    assert!(shown > 30, "only {shown} pixels show anything");
}

#[test]
fn the_loop_counts_every_triangle_once() {
    let stage = Stage::default();
    for look in looks() {
        let triangles = stage.prepared(&look).unwrap().triangle_count() as u64;
        let told = story(&stage, &look, (WIDTH / 2, HEIGHT / 3)).unwrap();
        let counts: Vec<u64> =
            list(&told["zbuffer"]["counts"]).iter().map(|count| count["count"].as_u64().unwrap()).collect();
        let [scene, clipped, beside, tested, inside, drawn] = counts[..] else { panic!("{counts:?}") };
        assert_eq!(scene, triangles);
        // Clipping can leave several parts of a triangle.
        assert!(clipped + beside + tested >= scene, "{counts:?}");
        assert!(tested >= inside && inside >= drawn, "{counts:?}");
    }
}

#[test]
fn the_rays_story_ends_with_what_the_ray_tracer_shows() {
    let stage = Stage::default();
    let (mut hits, mut mirrored) = (0, 0);
    for look in looks() {
        let settings = look.settings(Renderer::Raytrace).unwrap();
        let prepared = stage.prepared(&look).unwrap();
        let pipeline = prepared.pipeline(WIDTH, HEIGHT).unwrap();
        let world = prepared.traced_world(&settings).unwrap();
        let (t0, t1) = visible_interval(&pipeline.volume());
        let rays = raytrace::Settings { max_depth: settings.max_depth, ..raytrace::Settings::default() };
        for (i, j) in pixels() {
            let what = format!("{} {} ({i}, {j})", look.scene, look.shading);
            let told = &story(&stage, &look, (i, j)).unwrap()["raytrace"];
            let ray = viewing_ray(&pipeline, i as f32, j as f32);
            let color = ray_color(&world, &ray, t0, t1, &rays);
            assert_eq!(vector(&told["linear"]), color, "{what}");
            let last = list(&told["tests"]).iter().rfind(|test| test["nearer"] == true);
            let Some(hit) = nearest(&world, &ray, t0, t1) else {
                assert!(last.is_none() && told["shading"].is_null(), "{what}");
                continue;
            };
            hits += 1;
            let last = last.unwrap_or_else(|| panic!("{what}: nothing hit"));
            assert_eq!(last["object"], hit.object, "{what}");
            assert_eq!(number(&last["t"]).to_bits(), hit.t.to_bits(), "{what}");
            let is_mesh = matches!(world.objects()[hit.object].shape(), raytrace::Shape::Mesh(_));
            assert_eq!(last["triangle"].as_u64(), is_mesh.then_some(hit.triangle as u64), "{what}");
            assert_eq!(told["system"].is_null(), !is_mesh, "{what}");
            let optics = world.surface(&hit).optics;
            mirrored += usize::from(optics != raytrace::Optics::Opaque);
            check_terms(&told["shading"], color, &what);
        }
    }
    assert!(hits > 30 && mirrored > 0, "{hits} hits, {mirrored} on mirrors and glass");
}

#[test]
fn the_system_is_that_of_the_visible_triangle_and_its_solution_lies_inside() {
    let stage = Stage::default();
    let look = look("teapot", "phong", "blinn");
    let told = &story(&stage, &look, (WIDTH / 2, HEIGHT / 2)).unwrap()["raytrace"];
    let system = &told["system"];
    let x = vec3(number(&system["beta"]), number(&system["gamma"]), number(&system["t"]));
    for row in 0..3 {
        let (left, right) = (vector(&system["matrix"][row]).dot(x), number(&system["rhs"][row]));
        // Determinants of numbers up to 12, and their quotients: some dozens of roundings.
        assert!((left - right).abs() < 64.0 * f32::EPSILON * 12.0, "row {row}: {left} ≠ {right}");
    }
    assert!(list(&system["inside"]).iter().all(|test| test["holds"] == true), "{system}");
}

#[test]
fn a_point_in_shadow_is_lit_by_the_z_buffer_alone_and_the_story_says_so() {
    let stage = Stage::default();
    let look = look("floating-bin", "phong", "blinn");
    let settings = look.settings(Renderer::Raytrace).unwrap();
    let prepared = stage.prepared(&look).unwrap();
    let pipeline = prepared.pipeline(WIDTH, HEIGHT).unwrap();
    let world = prepared.traced_world(&settings).unwrap();
    let sun =
        world.lights.iter().position(|light| matches!(light, lighting::Light::Directional { .. })).unwrap();
    // A pixel of the floor that the sun does not reach.
    let in_shadow = |&(i, j): &(u32, u32)| {
        let ray = viewing_ray(&pipeline, i as f32, j as f32);
        let (t0, t1) = visible_interval(&pipeline.volume());
        nearest(&world, &ray, t0, t1).is_some_and(|hit| {
            let light = world.lights[sun].illumination(hit.point).unwrap();
            hit.object == 0 && !raytrace::shadow::is_lit(&world, &ray, &hit, &light)
        })
    };
    let pixel = (0..HEIGHT).flat_map(|j| (0..WIDTH).map(move |i| (i, j))).find(in_shadow).unwrap();
    let told = story(&stage, &look, pixel).unwrap();
    assert_eq!(told["agree"], false);
    let why: String = list(&told["why"]).iter().map(|why| why["en"].as_str().unwrap()).collect();
    assert!(why.contains("Shadow: light 2") && !why.contains("edge"), "{why}");
    assert_eq!(told["raytrace"]["shadows"][0]["lit"], false);
    assert!(told["raytrace"]["shadows"][0]["met"]["en"].as_str().unwrap().contains("polygons “bin”"));
    // Without shadows both agree.
    let told = story(&stage, &Look { shadows: false, ..look }, pixel).unwrap();
    assert_eq!((&told["agree"], list(&told["why"]).len()), (&true.into(), 0), "{}", told["why"]);
    assert_eq!(list(&told["raytrace"]["shadows"]).len(), 0);
}

#[test]
fn where_the_loops_differ_there_is_a_reason_and_elsewhere_none() {
    let stage = Stage::default();
    let mut reasons = 0;
    for look in looks() {
        for pixel in pixels() {
            let told = story(&stage, &look, pixel).unwrap();
            assert_eq!(told["agree"] == true, list(&told["why"]).is_empty(), "{} {pixel:?}", look.scene);
            reasons += list(&told["why"]).len();
        }
    }
    assert!(reasons > 0);
}

#[test]
fn the_view_from_outside_is_a_drawing_with_the_ray_in_it() {
    let stage = Stage::default();
    for look in looks() {
        let told = story(&stage, &look, (WIDTH / 2, HEIGHT / 3)).unwrap();
        let svg = told["outside"]["svg"].as_str().unwrap();
        let drawing = roxmltree::Document::parse(svg).unwrap();
        let count = |tag| drawing.descendants().filter(|node| node.has_tag_name(tag)).count();
        // The picture; eye, window's point, hits; names.
        assert!(count("image") == 1 && count("circle") >= 2 && count("text") >= 2, "{}", look.scene);
        // The picture's own address may hold any letters.
        let lines = drawing.descendants().filter(|node| !node.has_tag_name("image"));
        let mut values = lines.flat_map(|node| node.attributes()).map(|attribute| attribute.value());
        assert!(!values.any(|value| value.contains("NaN") || value.contains("inf")), "{}", look.scene);
    }
}

#[test]
fn a_pixel_outside_the_picture_is_refused() {
    let refused = story(&Stage::default(), &look("cycle", "flat", "phong"), (WIDTH, 0)).unwrap_err();
    assert!(refused.0.en.contains("outside") && refused.0.nl.contains("buiten"), "{refused}");
}
