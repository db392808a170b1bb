//! Does the order of drawing matter? Two spheres of one size, without and with depth (L15, Fig 8.10).

use canvas::{Image, Rgb};
use glam::{Vec3, vec3};
use transforms::{Camera, Pipeline, ViewVolume};
use zbuffer::{DepthBuffer, DepthFormat, ScreenTriangle, project, rasterize};

const NEAR: Rgb = Rgb::new(0.9, 0.3, 0.2);
const FAR: Rgb = Rgb::new(0.2, 0.4, 0.9);

/// The triangles of the nearer sphere and then those of the farther one, on a screen of 64 × 64 pixels.
fn near_before_far() -> Vec<(ScreenTriangle, Rgb)> {
    let camera = Camera::look_at(vec3(0.0, 0.0, 6.0), Vec3::ZERO, Vec3::Y).expect("a camera");
    let volume = ViewVolume::from_fov_y(0.7, 1.0, -1.0, -20.0).expect("a volume");
    let clip_from_world = Pipeline::new(camera, volume, 64, 64).expect("a pipeline").clip_from_world();
    let ball = geometry::shapes::icosphere(3).expect("a sphere");
    let mut triangles = Vec::new();
    for (center, color) in [(vec3(-0.4, 0.0, 1.0), NEAR), (vec3(0.4, 0.0, -2.0), FAR)] {
        for k in 0..ball.len() {
            let [a, b, c] = ball.triangle(k).corners().map(|corner| corner + center);
            let polygon = project(&clip_from_world, 64, 64, &geometry::Triangle { a, b, c });
            triangles.extend(polygon.triangles().map(|triangle| (triangle, color)));
        }
    }
    triangles
}

fn count(image: &Image, color: Rgb) -> usize {
    image.pixels().iter().filter(|pixel| **pixel == color).count()
}

#[test]
fn without_depth_the_sphere_drawn_last_wins_wrongly() {
    let triangles = near_before_far();
    let mut without = Image::new(64, 64, Rgb::ZERO);
    for (triangle, color) in &triangles {
        rasterize(triangle, 64, 64, |fragment| without.set(fragment.i, fragment.j, *color));
    }
    let mut with = Image::new(64, 64, Rgb::ZERO);
    let mut depth = DepthBuffer::new(64, 64, DepthFormat::F32);
    zbuffer::draw::z_buffer(Rgb::ZERO, &triangles, &mut with, &mut depth);

    // Both spheres cover the middle of the screen, and the nearer one is to be seen there.
    assert_eq!((without.get(31, 31), with.get(31, 31)), (FAR, NEAR));
    // Of the farther one, drawn last, nothing is hidden; in truth most of it is.
    assert!(count(&without, FAR) > 2 * count(&with, FAR));
    assert!(count(&with, NEAR) > count(&without, NEAR));
}
