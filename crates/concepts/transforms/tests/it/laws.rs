//! What must hold for every camera, basis and volume.
//!
//! Bounds are multiples of ε = `f32::EPSILON`, the rounding of one operation relative to its result; each says which
//! operations add up.

use glam::{Mat3, Mat4, Vec2, Vec3, vec2, vec3};
use proptest::prelude::*;
use testkit::{Law, ensure, ensure_close, strategy};
use transforms::affine2::{rotate, rotate_about, translate};
use transforms::projection::{orthographic, perspective};
use transforms::viewport::{screen_from_canonical, window_from_pixel, window_point};
use transforms::{Basis, Camera, Pipeline, ViewVolume, change_of_basis, change_of_basis_inverse};

const EPS: f32 = f32::EPSILON;

fn point2(extent: f32) -> impl Strategy<Value = Vec2> + Clone {
    (strategy::coordinate(extent), strategy::coordinate(extent)).prop_map(Vec2::from)
}

/// A point inside the viewing volume: window coordinates as shares, depth as a share of the way from near to far.
fn point_in(volume: ViewVolume) -> impl Strategy<Value = Vec3> + Clone {
    (0.0_f32..1.0, 0.0_f32..1.0, 0.0_f32..1.0).prop_map(move |(x, y, depth)| {
        let z = volume.near + depth * (volume.far - volume.near);
        let on_window = vec2(
            volume.left + x * (volume.right - volume.left),
            volume.bottom + y * (volume.top - volume.bottom),
        );
        (on_window * (z / volume.near)).extend(z)
    })
}

fn volume_and_point() -> impl Strategy<Value = (ViewVolume, Vec3)> {
    strategy::view_volume().prop_flat_map(|volume| (Just(volume), point_in(volume)))
}

#[test]
fn camera_matrix_keeps_lengths_and_handedness() {
    Law::new("the camera matrix is rigid (L1)").demand("turned and moved", 0.5).holds_for(
        (strategy::camera(), strategy::point(20.0), strategy::point(20.0)),
        |(camera, p, q), seen| {
            seen.class("turned and moved", is_turned(&camera) && camera.eye().length() > 1.0);
            let m = camera.camera_from_world();
            let moved = m.transform_point3(p).distance(m.transform_point3(q));
            // Each camera coordinate is a sum of four terms up to 30: 5 roundings of 5·30ε, in two points.
            ensure_close("distance", moved, p.distance(q), 2.0 * 5.0 * 60.0 * EPS)?;
            // The rows are unit to 2ε each, and a determinant has six products.
            ensure_close("determinant", Mat3::from_mat4(m).determinant(), 1.0, 16.0 * EPS)
        },
    );
}

/// Whether no axis of the camera lies near one of the world's, so that no exchange of two axes goes unnoticed.
fn is_turned(camera: &Camera) -> bool {
    let Basis { u, v, w } = camera.basis();
    [u, v, w].iter().all(|axis| axis.abs().max_element() < 0.98)
}

#[test]
fn camera_matrix_and_its_inverse_undo_each_other() {
    Law::new("world_from_camera undoes camera_from_world").demand("turned and moved", 0.5).holds_for(
        (strategy::camera(), strategy::point(20.0)),
        |(camera, p), seen| {
            seen.class("turned and moved", is_turned(&camera) && camera.eye().length() > 1.0);
            let there = camera.camera_from_world().transform_point3(p);
            ensure_close("p", camera.world_from_camera().transform_point3(there), p, 20.0 * 60.0 * EPS)
        },
    );
}

#[test]
fn camera_frame_is_the_one_of_figure_4_8() {
    let law = Law::new("w is against the gaze, v leans to up, u is level (L6)");
    law.demand("up is far from square to the gaze", 0.3).demand("nearly along the gaze", 0.01).holds_for(
        (strategy::point(5.0), strategy::point(5.0)),
        |(gaze, up), seen| {
            let sine = gaze.normalize_or_zero().cross(up.normalize_or_zero()).length();
            prop_assume!(sine > 0.01);
            seen.class("up is far from square to the gaze", sine < 0.8);
            seen.class("nearly along the gaze", sine < 0.25);
            let Basis { u, v, w } = Basis::from_gaze_and_up(gaze, up).unwrap();
            ensure_close("w", w, -gaze.normalize(), 4.0 * EPS)?;
            ensure(v.dot(up) > 0.0, || format!("v·up = {}", v.dot(up)))?;
            ensure_close("u·up", u.dot(up) / up.length(), 0.0, 8.0 * EPS)?;
            ensure_close("u × v", u.cross(v), w, 8.0 * EPS)
        },
    );
}

#[test]
fn change_of_basis_carries_u_v_w_to_a_b_c() {
    Law::new("M u = a, M v = b, M w = c (L11)").holds_for(
        (strategy::basis(), strategy::basis()),
        |(from, to), _| {
            let m = change_of_basis(&from, &to);
            // Two products of unit rows: 2 · 3 roundings, and the bases are orthonormal to 4ε.
            for (got, want) in [(m * from.u, to.u), (m * from.v, to.v), (m * from.w, to.w)] {
                ensure_close("M·axis", got, want, 24.0 * EPS)?;
            }
            ensure_close("det M", m.determinant(), 1.0, 32.0 * EPS)
        },
    );
}

#[test]
fn inverse_of_the_change_of_basis_is_the_product_of_the_slide() {
    Law::new("M⁻¹ = R_uvwᵀ R_abc and M⁻¹ M = I (L12)").holds_for(
        (strategy::basis(), strategy::basis()),
        |(from, to), _| {
            let (m, inverse) = (change_of_basis(&from, &to), change_of_basis_inverse(&from, &to));
            ensure_close("M⁻¹ M", inverse * m, Mat3::IDENTITY, 24.0 * EPS)?;
            ensure_close("M⁻¹", inverse, m.inverse(), 48.0 * EPS)
        },
    );
}

#[test]
fn rotation_about_a_point_fixes_it_and_keeps_distances() {
    Law::new("rotation about p fixes p and keeps distances (L10)").holds_for(
        (-7.0_f32..7.0, point2(10.0), point2(10.0), point2(10.0)),
        |(theta, p, a, b), _| {
            let m = rotate_about(theta, p);
            // Sums of about five terms up to 14, each rounded.
            let bound = 5.0 * 5.0 * 14.0 * EPS;
            ensure_close("p", m.transform_point2(p), p, bound)?;
            let moved = m.transform_point2(a).distance(m.transform_point2(b));
            ensure_close("distance", moved, a.distance(b), 2.0 * bound)
        },
    );
}

#[test]
fn rotation_about_a_point_is_the_product_of_three_matrices() {
    Law::new("multiplied out it is T(p) R(θ) T(−p) (L10)").holds_for(
        (-7.0_f32..7.0, point2(10.0)),
        |(theta, p), _| {
            let product = translate(p) * rotate(theta) * translate(-p);
            ensure_close("R_p", rotate_about(theta, p), product, 8.0 * 30.0 * EPS)
        },
    );
}

#[test]
fn perspective_fixes_its_planes() {
    Law::new("P leaves z = n and z = f where they are (L2)").demand("deep", 0.5).holds_for(
        (strategy::view_volume(), strategy::point(5.0)),
        |(volume, p), seen| {
            seen.class("deep", volume.far < 10.0 * volume.near);
            let m = perspective(volume.near, volume.far);
            for z in [volume.near, volume.far] {
                let moved = m.project_point3(p.with_z(z));
                // (n + f)z − fn, up to |f|², cancels to z² and is divided by z.
                let bound = 8.0 * EPS * volume.far * volume.far / z.abs();
                ensure_close("z", moved.z, z, bound)?;
            }
            ensure_close(
                "x, y on the window",
                m.project_point3(p.with_z(volume.near)).truncate(),
                p.truncate(),
                16.0 * EPS * 5.0,
            )
        },
    );
}

#[test]
fn perspective_keeps_depth_order() {
    Law::new("nearer stays nearer (L2)").demand("resolvable", 0.5).demand("close together", 0.05).holds_for(
        (strategy::view_volume(), 0.0_f32..1.0, 0.0_f32..1.0),
        |(volume, s, t), seen| {
            let depth = |share: f32| volume.near + share * (volume.far - volume.near);
            let (near, far) = (depth(s.min(t)), depth(s.max(t)));
            let m = perspective(volume.near, volume.far);
            let (z_near, z_far) =
                (m.project_point3(vec3(0.0, 0.0, near)).z, m.project_point3(vec3(0.0, 0.0, far)).z);
            // Canonical depth changes by fn/z² a unit; what is below the rounding of P may fall together.
            let slope = volume.far * volume.near / (far * far);
            let noise = 8.0 * EPS * volume.far * volume.far / near.abs();
            seen.class("close together", near - far < 0.05 * (volume.near - volume.far));
            let resolvable = slope * (near - far) > noise;
            seen.class("resolvable", resolvable);
            ensure(z_near >= z_far - noise, || format!("{z_near} < {z_far}"))?;
            ensure(!resolvable || z_near > z_far, || format!("{z_near} ≤ {z_far}, though far enough apart"))
        },
    );
}

#[test]
fn perspective_maps_lines_to_lines() {
    let inputs = strategy::view_volume()
        .prop_flat_map(|volume| (Just(volume), point_in(volume), point_in(volume), 0.1_f32..0.9));
    let law = Law::new("three points of a line stay on a line (L2)");
    law.demand("into the depth", 0.5).demand("off-centre", 0.5).holds_for(
        inputs,
        |(volume, p, q, s), seen| {
            let m = transforms::canonical_from_camera(&volume);
            let [a, b, c] = [p, q, p.lerp(q, s)].map(|point| m.project_point3(point));
            prop_assume!(a.distance(b) > 0.05);
            // Lines across the view keep w, so that they would stay lines without any division.
            seen.class("into the depth", p.z.max(q.z) / p.z.min(q.z) < 0.7);
            seen.class("off-centre", is_off_centre(&volume));
            let off_the_line = (c - a).cross(b - a).length() / (b - a).length();
            // A camera coordinate of size up to |f|(1 + reach) is rounded by ε of that, and at depth |n| a camera unit is 1/|n|
            // canonical units; about 32 such roundings lie on the way.
            let magnification = (volume.far / volume.near) * (1.0 + reach(&volume));
            ensure_close("distance from the line", off_the_line, 0.0, 32.0 * magnification * EPS)
        },
    );
}

/// How far off its axis a volume reaches, in window widths.
fn reach(volume: &ViewVolume) -> f32 {
    let x = volume.left.abs().max(volume.right.abs()) / (volume.right - volume.left);
    let y = volume.bottom.abs().max(volume.top.abs()) / (volume.top - volume.bottom);
    x.max(y)
}

/// Whether the window's middle lies off the axis by a tenth of its width and of its height.
fn is_off_centre(volume: &ViewVolume) -> bool {
    (volume.left + volume.right).abs() > 0.2 * (volume.right - volume.left)
        && (volume.bottom + volume.top).abs() > 0.2 * (volume.top - volume.bottom)
}

#[test]
fn orthographic_carries_the_corners_of_the_box_to_plus_and_minus_one() {
    let law = Law::new("the box becomes the cube, near at +1 (L3)").demand("off-centre", 0.5);
    law.holds_for(strategy::view_volume(), |volume, seen| {
        seen.class("off-centre", is_off_centre(&volume));
        let ViewVolume { left, right, bottom, top, near, far } = volume;
        let m = orthographic(&volume);
        // An off-centre box: the middle, up to `reach` widths away, is subtracted after scaling.
        let bound = 8.0 * (1.0 + 2.0 * reach(&volume) + 2.0 * far.abs() / (near - far)) * EPS;
        ensure_close("right top near", m.transform_point3(vec3(right, top, near)), Vec3::ONE, bound)?;
        ensure_close("left bottom far", m.transform_point3(vec3(left, bottom, far)), Vec3::NEG_ONE, bound)
    });
}

#[test]
fn visible_points_have_negative_clip_w_and_land_in_the_cube() {
    let law =
        Law::new("what the volume holds, the cube holds (E2)").demand("off-centre", 0.5).demand("deep", 0.5);
    law.holds_for(volume_and_point(), |(volume, p), seen| {
        seen.class("off-centre", is_off_centre(&volume));
        seen.class("deep", p.z < 3.0 * volume.near);
        let clip = transforms::canonical_from_camera(&volume) * p.extend(1.0);
        ensure_close("clip w", clip.w, p.z, EPS * p.z.abs())?;
        let canonical = clip.truncate() / clip.w;
        let bound = 32.0 * (1.0 + reach(&volume)) * (volume.far / volume.near) * EPS;
        ensure(canonical.abs().max_element() <= 1.0 + bound, || format!("{canonical} outside the cube"))
    });
}

#[test]
fn viewport_and_window_transform_are_inverse_up_to_the_range() {
    Law::new("canonical → pixel → window is canonical → window (L4, L8)").holds_for(
        (strategy::view_volume(), 1_u32..4000, 1_u32..4000, point2(1.0)),
        |(volume, width, height, p), _| {
            let pixel = screen_from_canonical(width, height).transform_point3(p.extend(0.0)).truncate();
            let window = window_from_pixel(&volume, width, height).transform_point2(pixel);
            let share = 0.5 * (p + 1.0);
            let want = vec2(
                volume.left + share.x * (volume.right - volume.left),
                volume.bottom + share.y * (volume.top - volume.bottom),
            );
            // The window is at most 6 wide; a pixel position is rounded relative to the whole screen.
            ensure_close("window", window, want, 8.0 * 6.0 * EPS)
        },
    );
}

#[test]
fn window_matrix_is_the_formula_of_u_s_and_v_s() {
    Law::new("the window matrix gives u_s and v_s (L8, L9)").holds_for(
        (strategy::view_volume(), 1_u32..4000, 1_u32..4000, 0.0_f32..1.0, 0.0_f32..1.0),
        |(volume, width, height, x, y), _| {
            let pixel = vec2((x * width as f32).floor(), (y * height as f32).floor());
            let got = window_from_pixel(&volume, width, height).transform_point2(pixel);
            ensure_close("(u_s, v_s)", got, window_point(&volume, width, height, pixel), 8.0 * 6.0 * EPS)
        },
    );
}

#[test]
fn our_projection_is_opengls_frustum_with_the_signs_turned() {
    let law = Law::new("diag(−1, −1, 1, −1) · S·C·P is glam's OpenGL frustum (E2)");
    law.demand("off-centre", 0.5).holds_for(strategy::view_volume(), |volume, seen| {
        seen.class("off-centre", is_off_centre(&volume));
        let ours = transforms::opengl::opengl_clip_from_camera(&volume);
        let ViewVolume { left, right, bottom, top, near, far } = volume;
        let glams = glam::camera::rh::proj::opengl::frustum(left, right, bottom, top, -near, -far);
        // Entries up to 2fn/(f − n); ours come out of three products.
        let greatest = glams.to_cols_array().iter().fold(0.0_f32, |m, x| m.max(x.abs()));
        ensure_close("frustum", ours, glams, 8.0 * greatest * EPS)
    });
}

#[test]
fn our_camera_is_glams_right_handed_view() {
    Law::new("camera_from_world is glam's look_at").holds_for(
        (strategy::point(10.0), strategy::unit_vector(), strategy::unit_vector()),
        |(eye, gaze, up), _| {
            prop_assume!(gaze.cross(up).length() > 0.1);
            let ours = Camera::look_at(eye, eye + 3.0 * gaze, up).unwrap().camera_from_world();
            let glams = glam::camera::rh::view::look_at_mat4(eye, eye + 3.0 * gaze, up);
            // Ours is right to a rounding. glam's gaze g is unit to 2ε; g × up is then off by 2ε and its own 1.5ε, over a
            // length of at least 0.1: u by 35ε, and by 2ε more for bringing it to unit length. v = u × g by 37 + 2 + 1.5.
            let axes = 41.0 * EPS;
            ensure_close("axes", Mat3::from_mat4(ours), Mat3::from_mat4(glams), axes)?;
            // The shift is the eye, at most √3 · 10 = 17.4 from the origin, along them: three roundings on either side.
            let shift = 17.4 * (axes + 2.0 * 3.0 * 0.5 * EPS);
            ensure_close("shift", ours.w_axis, glams.w_axis, shift)
        },
    );
}

/// Numbers of all sizes and signs, special ones among them.
fn any_number() -> impl Strategy<Value = f32> + Clone {
    prop_oneof![4 => -10.0_f32..10.0, 2 => any::<f32>(), 1 => Just(0.0), 1 => Just(f32::NAN), 1 => Just(-1.0)]
}

#[test]
fn six_numbers_are_refused_or_give_a_cube() {
    let sensible = strategy::view_volume();
    let hostile = [(); 6]
        .map(|()| any_number())
        .prop_map(|[left, right, bottom, top, near, far]| ViewVolume { left, right, bottom, top, near, far });
    let ordered = hostile.clone().prop_map(|v| ViewVolume {
        left: v.left.min(v.right),
        right: v.left.max(v.right),
        bottom: v.bottom.min(v.top),
        top: v.bottom.max(v.top),
        near: (-v.near.abs()).max(-v.far.abs()),
        far: (-v.near.abs()).min(-v.far.abs()),
    });
    Law::new("a volume is an error, or its corners land on ±1")
        .cases(4000)
        .demand("accepted", 0.2)
        .demand("refused", 0.3)
        .holds_for(prop_oneof![sensible, hostile, ordered], |volume, seen| {
            let accepted = volume.validate().is_ok();
            seen.class("accepted", accepted);
            seen.class("refused", !accepted);
            if !accepted {
                return Ok(());
            }
            let m = transforms::canonical_from_camera(&volume);
            let near_corner = m.project_point3(vec3(volume.right, volume.top, volume.near));
            // A thousandth: what `validate` promises.
            ensure_close("near corner", near_corner, Vec3::ONE, 1e-3)?;
            let far_middle = m.project_point3(vec3(0.0, 0.0, volume.far));
            ensure_close("far depth", far_middle.z, -1.0, 1e-3)
        });
}

fn pipeline_and_point() -> impl Strategy<Value = (Pipeline, Vec3)> {
    (strategy::camera(), volume_and_point(), 1_u32..2000, 1_u32..2000).prop_map(
        |(camera, (volume, p), w, h)| {
            let p_world = camera.world_from_camera().transform_point3(p);
            (Pipeline::new(camera, volume, w, h).expect("a valid volume"), p_world)
        },
    )
}

/// How far the rounding of one pixel position can carry, in pixels: camera coordinates are rounded at the size of the
/// scene, and the window is as far from it as near is from far.
fn pixel_bound(pipeline: &Pipeline) -> f32 {
    let volume = pipeline.volume();
    let size = pipeline.width().max(pipeline.height()) as f32;
    let magnification = (volume.far / volume.near) * (1.0 + reach(&volume));
    // 30: the greatest world coordinate over the smallest window, each matrix product rounding four times.
    64.0 * 30.0 * size * magnification * EPS
}

#[test]
fn factors_in_order_of_action_multiply_to_the_whole() {
    Law::new("screen = V·S·C·P·R·T (E1)").holds_for(pipeline_and_point(), |(pipeline, p), _| {
        let one_by_one = pipeline.factors().iter().fold(p.extend(1.0), |v, factor| factor.matrix * v);
        let at_once = pipeline.screen_from_world().project_point3(p);
        ensure_close(
            "screen",
            (one_by_one.truncate() / one_by_one.w).truncate(),
            at_once.truncate(),
            pixel_bound(&pipeline),
        )
    });
}

#[test]
fn a_traced_point_passes_through_the_matrices_of_the_stages() {
    Law::new("trace agrees with the matrices stage by stage (L5)").holds_for(
        pipeline_and_point(),
        |(pipeline, p), _| {
            let traced = pipeline.trace(p);
            ensure(traced.world == p, || "world".to_owned())?;
            ensure(traced.camera == pipeline.camera_from_world().transform_point3(p), || {
                "camera".to_owned()
            })?;
            let canonical = traced.canonical.expect("a visible point has w ≠ 0");
            let screen = traced.screen.expect("a visible point has w ≠ 0");
            ensure_close("z stays", screen.z, canonical.z, EPS)?;
            let at_once = pipeline.screen_from_world().project_point3(p);
            ensure_close("screen", screen.truncate(), at_once.truncate(), pixel_bound(&pipeline))
        },
    );
}

#[test]
fn a_pipeline_says_what_it_was_made_of() {
    let camera = Camera::look_at(vec3(3.0, 2.0, 5.0), vec3(0.5, 0.0, -1.0), Vec3::Y).unwrap();
    let volume = ViewVolume { left: -1.0, right: 1.5, bottom: -0.75, top: 1.0, near: -2.0, far: -20.0 };
    let pipeline = Pipeline::new(camera, volume, 640, 480).unwrap();
    assert_eq!((pipeline.width(), pipeline.height()), (640, 480));
    assert_eq!((pipeline.camera(), pipeline.volume()), (camera, volume));
}

#[test]
fn the_slides_order_of_matrices_misses_the_screen() {
    // E1: camera · perspective · scale · translate · viewport, as the slide prints them, read as one product.
    let camera = Camera::look_at(vec3(3.0, 2.0, 5.0), vec3(0.5, 0.0, -1.0), Vec3::Y).unwrap();
    let volume = ViewVolume { left: -1.0, right: 1.5, bottom: -0.75, top: 1.0, near: -2.0, far: -20.0 };
    let pipeline = Pipeline::new(camera, volume, 640, 480).unwrap();
    let [t, r, p, c, s, v] = pipeline.factors().map(|factor| factor.matrix);
    let target = vec3(0.5, 0.0, -1.0);
    let slide: Mat4 = r * t * p * s * c * v;
    let (wrong, right) = (slide.project_point3(target), pipeline.screen_from_world().project_point3(target));
    // What the camera looks at lies at camera (0, 0), so on the window at 0: share 1/2.5 across, 0.75/1.75 up.
    testkit::assert_close(
        "right",
        right.truncate(),
        vec2(0.4 * 640.0 - 0.5, 0.75 / 1.75 * 480.0 - 0.5),
        1e-3,
    );
    assert!(wrong.truncate().distance(right.truncate()) > 100.0, "the slide's order hits {wrong}");
    assert_ne!(2.0 / (1.5_f32 - 1.0), s.x_axis.x, "`r-1` on the slide is r − l");
}
