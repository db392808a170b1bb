//! What is close to the eye is drawn, or the picture comes with a word about what was cut off.

use scene::{Loaded, Named, Prepared, Rendered, Renderer, Settings, prepare, render, render_slide};

/// The scene's head: a view from (0, 1, 0) along −z, all lengths times `scale`.
fn seen_from(scale: f32, camera: &str) -> String {
    format!(
        "[render]\nsize = [60, 40]\n[camera]\neye = [0, {scale}, 0]\ntarget = [0, {scale}, {}]\nfov = 60\n{camera}\n\
         [[light]]\nkind = \"ambient\"\ncolor = 1\n\
         [material.red]\ndiffuse = [1, 0, 0]\nspecular = 0\n[material.green]\ndiffuse = [0, 1, 0]\nspecular = 0\n",
        -scale
    )
}

/// A green floor at y = 0 that reaches 1000 away on all sides, that is behind the eye too.
fn floor(scale: f32) -> String {
    let far = 1000.0 * scale;
    format!(
        "[[object]]\npolygons = [[[-{far}, 0, {far}], [{far}, 0, {far}], [{far}, 0, -{far}], [-{far}, 0, -{far}]]]\n\
         material = \"green\"\n"
    )
}

/// A red ball, its center `distance` before the eye and `aside` to the right.
fn ball(shape: &str, scale: f32, (aside, distance): (f32, f32), radius: f32) -> String {
    let (x, z, radius) = (aside * scale, -distance * scale, radius * scale);
    format!(
        "[[object]]\nshape = \"{shape}\"\nradius = {radius}\nlevel = 3\nmaterial = \"red\"\n\
         transforms = [{{ translate = [{x}, {scale}, {z}] }}]\n"
    )
}

fn prepared(text: &str) -> Prepared {
    prepare(&Loaded::from_toml(text, "planes.toml", "".as_ref()).unwrap()).unwrap()
}

/// The picture by every renderer, and by the slides' loops.
fn pictures(prepared: &Prepared) -> Vec<(String, Rendered)> {
    let mut all = Vec::new();
    for renderer in [Renderer::ZBuffer, Renderer::Painter, Renderer::Raytrace] {
        let settings = Settings { renderer, size: (60, 40), shadows: false, ..Settings::default() };
        all.push((renderer.name().to_owned(), render(prepared, &settings, &|_| ()).unwrap()));
        all.push((format!("{renderer}, slide"), render_slide(prepared, &settings, &|_| ()).unwrap()));
    }
    all
}

fn red_pixels(rendered: &Rendered) -> usize {
    rendered.image.pixels().iter().filter(|color| color.x > 2.0 * color.y).count()
}

#[test]
fn a_ball_half_a_unit_before_the_eye_is_drawn_over_a_floor_of_a_thousand() {
    // Scenes of every size: a millimetre to a unit, and a kilometre.
    for (scale, shape) in [(1.0, "icosphere"), (1e-3, "sphere"), (1e3, "icosphere")] {
        let text = seen_from(scale, "") + &floor(scale) + &ball(shape, scale, (0.0, 0.5), 0.1);
        for (name, rendered) in pictures(&prepared(&text)) {
            // A disc of 20 · 0.1 / √(0.5² − 0.1²) / tan 30° = 7.07 pixels in radius: 157 pixels; its rim may go either way.
            let red = red_pixels(&rendered);
            assert!((135..=180).contains(&red), "{name}, {shape} at scale {scale}: {red} pixels of the ball");
            assert!(rendered.notes.is_empty(), "{name}: {:?}", rendered.notes);
        }
    }
}

#[test]
fn what_is_behind_the_eye_or_beside_the_picture_moves_no_plane() {
    let near = |extra: &str| {
        prepared(&(seen_from(1.0, "") + &floor(1.0) + extra)).pipeline(60, 40).unwrap().volume().near
    };
    // The floor comes into the picture 1/tan 30° = 1.73 away: the thousandth of 1010 will do.
    let alone = near("");
    assert!((alone + 1.01).abs() < 1e-5, "{alone}");
    // A ball behind the eye, one around it that is seen from inside, and one to its right.
    assert_eq!(near(&ball("icosphere", 1.0, (0.0, -0.5), 0.1)), alone);
    assert_eq!(near(&ball("icosphere", 1.0, (0.0, 0.0), 3.0)), alone);
    assert_eq!(near(&ball("icosphere", 1.0, (0.5, 0.1), 0.1)), alone);
    // Before the eye it does: the nearest point is 0.4 away.
    let close = near(&ball("icosphere", 1.0, (0.0, 0.5), 0.1));
    assert!((close + 0.99 * 0.4).abs() < 1e-3, "{close}");
}

#[test]
fn a_mesh_that_crosses_the_plane_of_the_eye_is_seen_as_near_as_it_comes_into_the_picture() {
    // A wall along the gaze, 0.2 to the right: with a window 0.87 · w to the right it comes in at w = −0.2 / 0.866.
    let wall = "[[object]]\npolygons = [[[0.2, -5, 9], [0.2, -5, -900], [0.2, 5, -900], [0.2, 5, 9]]]\nmaterial = \"red\"\n";
    let prepared = prepared(&(seen_from(1.0, "") + &floor(1.0) + wall));
    let near = prepared.pipeline(60, 40).unwrap().volume().near;
    let expected = -0.99 * 0.2 / (1.5 * 30.0_f32.to_radians().tan());
    assert!((near - expected).abs() < 1e-5, "{near}, not {expected}");
    for (name, rendered) in pictures(&prepared) {
        let last_column =
            rendered.image.pixels().chunks(60).filter(|row| row[59].x > 2.0 * row[59].y).count();
        assert_eq!(last_column, 40, "{name}: the wall fills the last column");
    }
}

#[test]
fn what_is_too_close_to_keep_is_named() {
    // A ball a thousandth of a unit away, a floor of a thousand: a millionth.
    let text = |camera| seen_from(1.0, camera) + &floor(1.0) + &ball("icosphere", 1.0, (0.0, 0.002), 0.001);
    for (name, rendered) in pictures(&prepared(&text(""))) {
        let notes = &rendered.notes;
        assert!(
            notes.iter().any(|note| note.contains("within 1.0e-3") && note.contains("`near`")),
            "{name}: {notes:?}"
        );
    }
    // A near plane that somebody gave is what they want.
    for (name, rendered) in pictures(&prepared(&text("near = -1\nfar = -2000"))) {
        assert!(rendered.notes.is_empty(), "{name}: {:?}", rendered.notes);
    }
}
