//! One ray a pixel, or several: the picture (L55), what is seen in each pixel, and what is under the mouse (L44).

use std::sync::atomic::{AtomicUsize, Ordering};

use canvas::{Image, Rgb, row_from_j};
use geometry::Ray;
use rayon::prelude::*;
use transforms::Pipeline;

use crate::query::{Hit, Search, nearest, nearest_brute};
use crate::viewing::{viewing_ray, visible_interval};
use crate::{World, fast, ray_color};

/// How a picture is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Settings {
    /// n: each pixel is the mean of n × n rays, through the centres of an n × n split of the pixel. At least 1.
    pub samples: u32,
    /// Whether shadow rays are sent (L56).
    pub shadows: bool,
    /// How many mirrors and surfaces that light passes may follow one another (L58).
    pub max_depth: u32,
    /// How hits are searched.
    pub search: Search,
}

impl Default for Settings {
    /// One ray a pixel, with shadows, six mirrors deep.
    fn default() -> Self {
        Self { samples: 1, shadows: true, max_depth: 6, search: Search::Hierarchy }
    }
}

/// The picture: a ray for each pixel, and its colour (L55, L57, L58).
///
/// Rows are shared among rayon's threads; the picture is the same, bit by bit, for any number of them.
///
/// - `progress`: is told how many rows are done, after each row, from any thread and not necessarily in order.
///
/// # Panics
/// If `settings.samples` is 0.
///
/// ```
/// use canvas::Rgb;
/// use glam::{Vec3, vec3};
/// use raytrace::{Settings, World, render};
/// use transforms::{Camera, Pipeline, ViewVolume};
///
/// let camera = Camera::look_at(vec3(0.0, 0.0, 4.0), Vec3::ZERO, Vec3::Y)?;
/// let volume = ViewVolume { left: -1.0, right: 1.0, bottom: -1.0, top: 1.0, near: -1.0, far: -9.0 };
/// let mut empty = World::new(Vec::new(), Vec::new());
/// empty.background = Rgb::new(0.1, 0.2, 0.4);
/// let image = render(&empty, &Pipeline::new(camera, volume, 20, 10)?, &Settings::default(), &|_| ());
/// assert_eq!(image.get(3, 7), empty.background);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn render(
    world: &World,
    pipeline: &Pipeline,
    settings: &Settings,
    progress: &(dyn Fn(usize) + Sync),
) -> Image {
    assert!(settings.samples > 0, "a pixel needs at least one sample");
    let (width, height) = (pipeline.width(), pipeline.height());
    let mut image = Image::new(width, height, Rgb::ZERO);
    let rows_done = AtomicUsize::new(0);
    let row_is_done = || progress(rows_done.fetch_add(1, Ordering::Relaxed) + 1);
    match settings.search {
        Search::Hierarchy => fast::render(world, pipeline, settings, 0, image.pixels_mut(), &row_is_done),
        Search::BruteForce => {
            image.pixels_mut().par_chunks_mut(width as usize).enumerate().for_each(|(row, pixels)| {
                let j = row_from_j(row as u32, height);
                for (i, pixel) in pixels.iter_mut().enumerate() {
                    *pixel = pixel_color(world, pipeline, settings, i as u32, j);
                }
                row_is_done();
            });
        }
    }
    image
}

/// Some rows of the picture that [`render`] makes, by the fast search: for pictures that appear bit by bit.
///
/// - `rows`: as in an image, from the top down.
///
/// # Panics
/// If `settings.samples` is 0, or the rows are not those of the picture.
#[must_use]
pub fn render_rows(
    world: &World,
    pipeline: &Pipeline,
    settings: &Settings,
    rows: std::ops::Range<u32>,
) -> Vec<Rgb> {
    assert!(settings.samples > 0, "a pixel needs at least one sample");
    assert!(rows.start <= rows.end && rows.end <= pipeline.height(), "rows {rows:?}");
    let mut pixels = vec![Rgb::ZERO; rows.len() * pipeline.width() as usize];
    fast::render(world, pipeline, settings, rows.start, &mut pixels, &|| ());
    pixels
}

/// Where in a pixel a sample lies: the centre of the k-th of n parts of it, where it reaches from −½ to ½.
pub(crate) fn part(k: u32, n: u32) -> f32 {
    (k as f32 + 0.5) / n as f32 - 0.5
}

/// The colour of pixel (i, j): the mean over its samples.
fn pixel_color(world: &World, pipeline: &Pipeline, settings: &Settings, i: u32, j: u32) -> Rgb {
    let (t0, t1) = visible_interval(&pipeline.volume());
    let n = settings.samples;
    let mut sum = Rgb::ZERO;
    for dj in 0..n {
        for di in 0..n {
            let ray = viewing_ray(pipeline, i as f32 + part(di, n), j as f32 + part(dj, n));
            sum += ray_color(world, &ray, t0, t1, settings);
        }
    }
    sum / (n * n) as f32
}

/// What each pixel's centre shows, rows from the top down as in an image; `None` where it shows the background.
#[must_use]
pub fn visible(world: &World, pipeline: &Pipeline) -> Vec<Option<Hit>> {
    visible_by(world, pipeline, nearest)
}

/// The same by the slide's loop over everything (L43).
#[must_use]
pub fn visible_brute(world: &World, pipeline: &Pipeline) -> Vec<Option<Hit>> {
    visible_by(world, pipeline, nearest_brute)
}

/// How the nearest hit of a ray is found between t0 and t1.
type Find = fn(&World, &Ray, f32, f32) -> Option<Hit>;

fn visible_by(world: &World, pipeline: &Pipeline, find: Find) -> Vec<Option<Hit>> {
    let (t0, t1) = visible_interval(&pipeline.volume());
    let (width, height) = (pipeline.width(), pipeline.height());
    let mut hits = vec![None; width as usize * height as usize];
    hits.par_chunks_mut(width as usize).enumerate().for_each(|(row, hits)| {
        let j = row_from_j(row as u32, height);
        for (i, hit) in hits.iter_mut().enumerate() {
            *hit = find(world, &viewing_ray(pipeline, i as f32, j as f32), t0, t1);
        }
    });
    hits
}

/// Whether any ray of the picture that [`render`] makes hits anything: if not, it is all background.
///
/// - `samples`: n × n rays a pixel, as in [`Settings::samples`].
#[must_use]
pub fn covers_anything(world: &World, pipeline: &Pipeline, samples: u32) -> bool {
    let (t0, t1) = visible_interval(&pipeline.volume());
    let parts = || (0..samples).map(|k| part(k, samples));
    let is_hit = |i: f32, j: f32| nearest(world, &viewing_ray(pipeline, i, j), t0, t1).is_some();
    (0..pipeline.height()).into_par_iter().any(|j| {
        (0..pipeline.width())
            .any(|i| parts().any(|dj| parts().any(|di| is_hit(i as f32 + di, j as f32 + dj))))
    })
}

/// What lies under the point (i, j) of the screen, the mouse pointer say (L44): the nearest hit in the viewing volume.
///
/// - `i`, `j`: as for [`viewing_ray`], j upwards.
#[must_use]
pub fn pick(world: &World, pipeline: &Pipeline, i: f32, j: f32) -> Option<Hit> {
    let (t0, t1) = visible_interval(&pipeline.volume());
    nearest(world, &viewing_ray(pipeline, i, j), t0, t1)
}
