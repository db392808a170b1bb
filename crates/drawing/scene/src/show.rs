//! What does a picture of numbers look like? Depth, normals, barycentric coordinates and overdraw as colours.
//!
//! These pictures hold data, not light. [`canvas::srgb`] encodes light on its way into a PNG file; here the numbers are
//! *decoded* first, so that the file holds just them: a component of 0.5 becomes step 128 of 255. Depth and overdraw are
//! treated alike.

use canvas::{DepthImage, Image, Rgb, srgb};
use geometry::Barycentric;
use glam::Vec3;
use raytrace::{Hit, Shape};
use shading::Frame;
use transforms::Pipeline;

use crate::Show;

/// What one pixel shows, whichever renderer found it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Seen {
    /// Canonical z, near +1, far −1.
    z: f32,
    /// The unit normal on the side of the eye, world space.
    n_world: Vec3,
    /// Where in its triangle; none for an exact ball.
    weights: Option<Barycentric>,
    /// How many times a colour was computed for the pixel.
    shaded: u32,
}

/// What counts as work in vain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Loop {
    /// For each object, each of its pixels (L21): a colour is computed for all that is not hidden yet.
    Objects,
    /// For each pixel, its ray.
    Pixels,
}

impl Seen {
    /// What each pixel of a rasterizer's frame shows.
    pub(crate) fn all(frame: &Frame) -> Vec<Option<Self>> {
        let pixels = frame.visible.iter().zip(&frame.shaded);
        let seen = pixels.map(|(visible, shaded)| {
            visible.map(|visible| Self {
                z: visible.z,
                n_world: visible.n_world,
                weights: Some(visible.weights),
                shaded: *shaded,
            })
        });
        seen.collect()
    }

    /// What a ray from the eye met. It computes one colour, for it meets the nearest surface at once.
    pub(crate) fn hit(world: &raytrace::World, pipeline: &Pipeline, hit: &Hit) -> Self {
        let to_eye = pipeline.camera().eye() - hit.point;
        let side = if hit.normal.dot(to_eye) >= 0.0 { 1.0 } else { -1.0 };
        let is_mesh = matches!(world.objects()[hit.object].shape(), Shape::Mesh(_));
        Self {
            z: pipeline.clip_from_world().project_point3(hit.point).z,
            n_world: side * world.shading_normal(hit),
            weights: is_mesh.then_some(hit.weights),
            shaded: 1,
        }
    }
}

/// The picture of one property; `seen` has one entry a pixel, rows from the top down.
///
/// # Panics
/// If there is not one entry a pixel.
pub(crate) fn picture(
    show: Show,
    (width, height): (u32, u32),
    seen: &[Option<Seen>],
    order: Loop,
    notes: &mut Vec<String>,
) -> Image {
    let numbers = match show {
        Show::Depth => depth((width, height), seen),
        Show::Normals | Show::Color => pixels(seen, |seen| 0.5 * seen.n_world + 0.5),
        Show::Barycentric => pixels(seen, barycentric),
        Show::Overdraw => {
            notes.extend(overdraw_note(seen, order));
            pixels(seen, |seen| ramp(seen.shaded))
        }
    };
    let decoded = numbers.into_iter().map(|v| v.map(srgb::decode)).collect();
    Image::from_rows(width, height, decoded).expect("one entry for each pixel")
}

/// Numbers of the visible surface; black where there is none.
fn pixels(seen: &[Option<Seen>], number: impl Fn(&Seen) -> Vec3) -> Vec<Rgb> {
    seen.iter().map(|seen| seen.as_ref().map_or(Rgb::ZERO, &number)).collect()
}

/// Nearest white, farthest dark grey, nothing black.
fn depth((width, height): (u32, u32), seen: &[Option<Seen>]) -> Vec<Rgb> {
    let mut depths = DepthImage::new(width, height);
    for (k, seen) in seen.iter().enumerate() {
        if let Some(seen) = seen {
            let (i, row) = (k as u32 % width, k as u32 / width);
            depths.set(i, canvas::row_from_j(row, height), seen.z);
        }
    }
    depths.to_image().pixels().to_vec()
}

/// α, β, γ as red, green, blue: each corner of a triangle has one of the three.
fn barycentric(seen: &Seen) -> Vec3 {
    let third = Barycentric::from_beta_gamma(1.0 / 3.0, 1.0 / 3.0);
    let Barycentric { alpha, beta, gamma } = seen.weights.unwrap_or(third);
    Vec3::new(alpha, beta, gamma)
}

/// Colours for 1, 2, 3… computed colours: from blue (none in vain) over green and yellow to red, white for 8 and more.
const RAMP: [Vec3; 8] = [
    Vec3::new(0.13, 0.25, 0.60),
    Vec3::new(0.10, 0.50, 0.65),
    Vec3::new(0.15, 0.65, 0.35),
    Vec3::new(0.60, 0.75, 0.15),
    Vec3::new(0.95, 0.75, 0.10),
    Vec3::new(0.95, 0.45, 0.10),
    Vec3::new(0.80, 0.12, 0.10),
    Vec3::new(1.00, 1.00, 1.00),
];

fn ramp(shaded: u32) -> Vec3 {
    match shaded {
        0 => Vec3::ZERO,
        count => RAMP[(count as usize - 1).min(RAMP.len() - 1)],
    }
}

fn overdraw_note(seen: &[Option<Seen>], order: Loop) -> Option<String> {
    let counts: Vec<u64> = seen.iter().flatten().map(|seen| u64::from(seen.shaded)).collect();
    let most = counts.iter().max()?;
    let mean = counts.iter().sum::<u64>() as f64 / counts.len() as f64;
    let who = match order {
        Loop::Objects => "by the slide's loop over objects",
        Loop::Pixels => {
            "by the loop over pixels: a ray finds the nearest surface before any colour is computed"
        }
    };
    Some(format!(
        "overdraw: {mean:.2} colours per covered pixel, {most} at most (blue 1, … white 8 and more), {who}"
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seen(n_world: Vec3, shaded: u32) -> Option<Seen> {
        Some(Seen { z: 0.5, n_world, weights: None, shaded })
    }

    #[test]
    fn a_png_file_holds_the_numbers_themselves() {
        // n = (0.6, 0, 0.8): 0.5 n + 0.5 = (0.8, 0.5, 0.9), which are steps 204, 127.5 and 229.5 of 255.
        let pixels = vec![seen(Vec3::new(0.6, 0.0, 0.8), 1), None];
        let image = picture(Show::Normals, (2, 1), &pixels, Loop::Objects, &mut Vec::new());
        let [r, g, b] = image.get(0, 0).to_array().map(srgb::to_u8);
        assert_eq!((r, b), (204, 230));
        assert!(g == 127 || g == 128);
        assert_eq!(image.get(1, 0), Rgb::ZERO);
    }

    #[test]
    fn overdraw_counts_what_was_computed_in_vain() {
        let pixels = vec![seen(Vec3::Z, 1), seen(Vec3::Z, 4), None, seen(Vec3::Z, 1)];
        let mut notes = Vec::new();
        picture(Show::Overdraw, (4, 1), &pixels, Loop::Objects, &mut notes);
        assert!(notes[0].contains("2.00 colours") && notes[0].contains("4 at most"), "{}", notes[0]);
    }

    #[test]
    fn rows_come_out_the_right_way_up() {
        let near = Some(Seen { z: 0.9, n_world: Vec3::Z, weights: None, shaded: 1 });
        let far = Some(Seen { z: -0.9, n_world: Vec3::Z, weights: None, shaded: 1 });
        let image = picture(Show::Depth, (1, 2), &[near, far], Loop::Objects, &mut Vec::new());
        assert!(image.get(0, 1).x > image.get(0, 0).x);
    }
}
