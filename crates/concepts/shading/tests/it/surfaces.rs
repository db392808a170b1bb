//! Laws of one triangle: flat, Gouraud and Phong shading of a facet (L37, L38, L40, E7).

use geometry::{Barycentric, Indexed, Mesh, Triangle};
use glam::{Vec3, vec3};
use lighting::{Highlight, Light, Material};
use proptest::prelude::*;
use shading::mode::{gouraud_colors, phong_normal};
use shading::{Facet, Lighting, Object, Shading, Surface};
use testkit::{Law, ensure, ensure_close, strategy};

use crate::model;

/// A triangle with normals of its own at the corners, within some 50° of the front.
fn facet() -> impl Strategy<Value = Facet> + Clone {
    let normal = || strategy::unit_vector_beside(Vec3::Z, 0.6);
    (strategy::triangle(3.0), normal(), normal(), normal(), model::material()).prop_filter_map(
        "no area",
        |(corners, n0, n1, n2, material)| {
            let face_normal = corners.normal()?;
            let to_face = glam::Quat::from_rotation_arc(Vec3::Z, face_normal);
            Some(Facet { corners, face_normal, corner_normals: [n0, n1, n2].map(|n| to_face * n), material })
        },
    )
}

#[test]
fn gouraud_shading_is_affine_in_the_vertex_colors() {
    let inputs = (facet(), model::lights(), strategy::point(9.0), strategy::inside(0.0), -1.0_f32..2.0);
    let law = Law::new("Gouraud shading is affine in the vertex colours").demand("corners differ", 0.5);
    law.holds_for(inputs, |(facet, lights, eye, weights, factor), seen| {
        let color = |lights: &[Light]| {
            let lighting = Lighting { lights, highlight: Highlight::Blinn, eye };
            let surface = Surface::new(Shading::Gouraud, facet, lighting);
            (gouraud_colors(&facet, &lighting), surface.color(weights))
        };
        // Two lightings, and a third whose vertex colours are theirs mixed: factor · first + (1 − factor) · second.
        let (first, second) = (&lights[..2], &lights[1..]);
        let dimmed: Vec<_> = first
            .iter()
            .map(|l| scaled(l, factor))
            .chain(second.iter().map(|l| scaled(l, 1.0 - factor)))
            .collect();
        let ((c, at_c), (d, at_d), (mixed, at_mixed)) = (color(first), color(second), color(&dimmed));
        seen.class("corners differ", mixed[0].distance(mixed[1]) > 0.1);
        // At most 4 lights of up to 2 · 2 each: about 20 roundings of numbers up to 16.
        let bound = 20.0 * 16.0 * f32::EPSILON;
        for k in 0..3 {
            ensure_close("vertex colour", mixed[k], factor * c[k] + (1.0 - factor) * d[k], bound)?;
        }
        ensure_close("colour", at_mixed, factor * at_c + (1.0 - factor) * at_d, bound)
    });
}

fn scaled(light: &Light, factor: f32) -> Light {
    match *light {
        Light::Ambient { color } => Light::Ambient { color: factor * color },
        Light::Directional { to_light, color } => Light::Directional { to_light, color: factor * color },
        Light::Point { position, color } => Light::Point { position, color: factor * color },
    }
}

#[test]
fn gouraud_shading_reaches_the_vertex_colors_and_stays_between_them() {
    let inputs = (facet(), model::lights(), strategy::point(9.0), strategy::inside(0.0));
    Law::new("Gouraud shading stays between the vertex colours").demand("corners differ", 0.5).holds_for(
        inputs,
        |(facet, lights, eye, weights), seen| {
            let lighting = Lighting { lights: &lights, highlight: Highlight::Blinn, eye };
            let surface = Surface::new(Shading::Gouraud, facet, lighting);
            let [c0, c1, c2] = gouraud_colors(&facet, &lighting);
            for (corner, color) in [(Barycentric::A, c0), (Barycentric::B, c1), (Barycentric::C, c2)] {
                ensure_close("at a corner", surface.color(corner), color, 0.0)?;
            }
            seen.class("corners differ", c0.distance(c1).min(c1.distance(c2)) > 0.05);
            // Weights that add up to 1 but for three roundings, colours up to 5.
            let (least, greatest) = (c0.min(c1).min(c2), c0.max(c1).max(c2));
            let color = surface.color(weights);
            let beyond = (least - color).max(color - greatest).max_element();
            ensure(beyond <= 5.0 * 4.0 * f32::EPSILON, || format!("{beyond} beyond the vertex colours"))
        },
    );
}

#[test]
fn interpolated_normals_are_unit() {
    let inputs = (facet(), strategy::inside(0.0));
    let law = Law::new("interpolated normals are unit").demand("too short on the slide", 0.3);
    law.holds_for(inputs, |(facet, weights), seen| {
        let [n0, n1, n2] = facet.corner_normals;
        // The slide's version, L40 as printed (E7).
        let slide = weights.interpolate(n0, n1, n2);
        seen.class("too short on the slide", slide.length() < 0.95);
        let ours = phong_normal(facet.corner_normals, weights).unwrap();
        ensure_close("length", ours.length(), 1.0, 4.0 * f32::EPSILON)?;
        ensure_close("direction", ours * slide.length(), slide, 4.0 * f32::EPSILON)
    });
}

#[test]
fn on_a_flat_matt_triangle_under_the_sun_all_shadings_agree() {
    let inputs = (
        strategy::triangle(3.0),
        strategy::affine(3.0),
        model::color(),
        model::lights(),
        strategy::point(9.0),
    );
    let law = Law::new("flat = Gouraud = Phong where nothing varies").demand("lit", 0.2).demand("unlit", 0.2);
    law.demand("seen from behind", 0.2).holds_for(
        (inputs, strategy::inside(0.0)),
        |((triangle, affine, color, lights, eye), weights), seen| {
            // The normal is the same at the corners, the sun's direction is the same everywhere, and without a highlight
            // the direction to the eye does not matter.
            let mesh = Mesh::new(triangle.corners().to_vec(), vec![[0, 1, 2]]).unwrap();
            let normals = Indexed { values: vec![triangle.normal().unwrap()], triangles: vec![[0; 3]] };
            let mesh = mesh.with_normals(normals).unwrap();
            let material = [Material::matt(color)];
            let object = Object { mesh: &mesh, world_from_object: affine, materials: &material };
            let facet = Facet::new(&object, 0, eye);
            seen.class("seen from behind", facet.corners.cross().dot(facet.face_normal) < 0.0);
            let sun = &lights[..2];
            let lighting = Lighting { lights: sun, highlight: Highlight::Blinn, eye };
            let [flat, gouraud, phong] = [Shading::Flat, Shading::Gouraud, Shading::Phong]
                .map(|shading| Surface::new(shading, facet, lighting).color(weights));
            let is_lit = matches!(sun[1], Light::Directional { to_light, .. } if to_light.dot(facet.face_normal) > 0.0);
            seen.class("lit", is_lit);
            seen.class("unlit", !is_lit);
            // Weights add up to 1 but for three roundings; renormalizing adds three; colours up to 2.
            let bound = 2.0 * 8.0 * f32::EPSILON;
            ensure_close("Gouraud and flat", gouraud, flat, bound)?;
            ensure_close("Phong and flat", phong, flat, bound)
        },
    );
}

#[test]
fn normals_lie_on_the_side_of_the_eye_also_in_a_mirror() {
    let mirror = (strategy::affine(3.0), any::<bool>()).prop_map(|(m, mirrored)| {
        if mirrored { m * glam::Mat4::from_scale(vec3(-1.0, 1.0, 1.0)) } else { m }
    });
    let inputs = (strategy::triangle(3.0), mirror, strategy::point(9.0));
    let law = Law::new("the face normal points to the eye").demand("front", 0.2).demand("back", 0.2);
    law.holds_for(inputs, |(triangle, affine, eye), seen| {
        let mesh = Mesh::new(triangle.corners().to_vec(), vec![[0, 1, 2]]).unwrap();
        // Corner normals along the front: they stay on the face normal's side.
        let normals = Indexed { values: vec![triangle.normal().unwrap()], triangles: vec![[0; 3]] };
        let mesh = mesh.with_normals(normals).unwrap();
        let moved = mesh.transformed(&affine).unwrap().triangle(0);
        let facet = Facet::new(&Object { mesh: &mesh, world_from_object: affine, materials: &[] }, 0, eye);
        let distance = facet.face_normal.dot(eye - facet.corners.a);
        let front = moved.normal().unwrap();
        seen.class("front", front.dot(facet.face_normal) > 0.0);
        seen.class("back", front.dot(facet.face_normal) < 0.0);
        // A height over the triangle of up to 30, from a normal that is off by some roundings of a sliver (sine 0.05/4).
        ensure(distance >= -30.0 * 400.0 * f32::EPSILON, || format!("the eye lies {distance} behind"))?;
        // The mesh brought its normal to unit length once more, which moves it by a rounding or two.
        ensure_close("corner normal", facet.corner_normals[1], facet.face_normal, 4.0 * f32::EPSILON)?;
        ensure_close("perpendicular", front.cross(facet.face_normal).length(), 0.0, 400.0 * f32::EPSILON)
    });
}

#[test]
fn a_highlight_between_the_corners_is_lost_by_gouraud_and_shown_by_phong() {
    // L41: a wall of 8 × 8, lamp and eye 2 before its middle, exponent 60. At the corners 2/√36 = cos 70°: nothing.
    let corners = Triangle::new(vec3(-4.0, -4.0, 0.0), vec3(4.0, -4.0, 0.0), vec3(0.0, 8.0, 0.0));
    let material = Material::new(vec3(0.3, 0.2, 0.1), 60.0);
    let facet = Facet { corners, face_normal: Vec3::Z, corner_normals: [Vec3::Z; 3], material };
    let lights = [Light::Point { position: vec3(0.0, 0.0, 2.0), color: Vec3::ONE }];
    let lighting = Lighting { lights: &lights, highlight: Highlight::Blinn, eye: vec3(0.0, 0.0, 2.0) };
    let middle = corners.barycentric(Vec3::ZERO).unwrap();
    let at_middle = |shading| Surface::new(shading, facet, lighting).color(middle);
    // Head on: c_r + 1. Between the corners: c_r · cos 70° and no highlight.
    assert!(at_middle(Shading::Phong).abs_diff_eq(vec3(1.3, 1.2, 1.1), 1e-5));
    assert!(at_middle(Shading::Gouraud).max_element() < 0.3 * 0.34);
}
