//! What does a value look like all over a ball? Each pixel's ray meets a unit sphere, or passes beside it.

use std::error::Error;

use canvas::{Image, Rgb};
use geometry::Sphere;
use glam::{Vec2, Vec3, vec3};
use raytrace::{sphere, viewing_ray};
use transforms::{Camera, Pipeline, ViewVolume};

use crate::handle::{Handles, in_picture};

type Fault = Box<dyn Error + Send + Sync>;

/// The colour beside the ball.
const BESIDE: Rgb = Rgb::splat(0.08);
/// Rays along each side of a pixel.
const FINER: u32 = 2;

/// The ball of radius 1 around the origin, seen along −z, y up.
fn pipeline((width, height): (u32, u32)) -> Result<Pipeline, Fault> {
    let camera = Camera::look_at(vec3(0.0, 0.0, 6.0), Vec3::ZERO, Vec3::Y)?;
    // Up and down a little more than the ball; also sideways if the picture is narrow.
    let aspect = width as f32 / height as f32;
    let fov = 2.0 * (0.2 / aspect.min(1.0)).atan();
    Ok(Pipeline::new(camera, ViewVolume::from_fov_y(fov, aspect, -1.0, -9.0)?, width, height)?)
}

/// Pictures of the ball that differ in the colours which each normal and direction to the eye has; the rays are the same.
pub(crate) fn pictures<const COUNT: usize>(
    (width, height): (u32, u32),
    mut colors: impl FnMut(Vec3, Vec3) -> [Rgb; COUNT],
) -> Result<[Image; COUNT], Fault> {
    let (width, height) = (FINER * width, FINER * height);
    let pipeline = pipeline((width, height))?;
    let unit = Sphere::new(Vec3::ZERO, 1.0);
    let mut images = [(); COUNT].map(|()| Image::new(width, height, BESIDE));
    for (i, j) in (0..height).flat_map(|j| (0..width).map(move |i| (i, j))) {
        let ray = viewing_ray(&pipeline, i as f32, j as f32);
        if let Some(t) = sphere::intersect(&ray, &unit, 0.0, f32::INFINITY) {
            let colors = colors(ray.at(t).normalize(), -ray.direction.normalize());
            for (image, color) in images.iter_mut().zip(colors) {
                image.set(i, j, color);
            }
        }
    }
    Ok(images.map(|image| image.box_downsampled(FINER)))
}

/// Where the point of the ball that faces a direction lies in the picture.
pub(crate) fn place(size: (u32, u32), direction: Vec3) -> Result<Vec2, Fault> {
    Ok(in_picture(&pipeline(size)?, direction).ok_or("a direction behind the eye")?)
}

/// No handles yet, in a picture of the ball.
pub(crate) fn handles((width, height): (u32, u32)) -> Handles {
    Handles::none(Vec2::new(width as f32, height as f32))
}
