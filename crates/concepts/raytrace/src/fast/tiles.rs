//! In which order is a picture drawn? Eight by eight pixels at a time: their viewing rays go together, and so do the shadow
//! rays of what they hit.

use canvas::{Rgb, row_from_j};
use geometry::Ray;
use glam::{Vec3, vec2};
use rayon::prelude::*;
use transforms::{Pipeline, viewport};

use super::{any_hit_each, nearest_each};
use crate::color::{Cast, LightingPoints, shows_light, with_optics};
use crate::picture::{Settings, part};
use crate::query::Hit;
use crate::shadow::{light_share, shadow_ray};
use crate::viewing::visible_interval;
use crate::world::World;

/// Pixels along each side of a tile.
const SIDE: u32 = 8;
const PIXELS: usize = (SIDE * SIDE) as usize;

/// Writes the picture from its row `first` on, rows from the top down. `row_is_done` is called once for each row, from any thread.
pub(crate) fn render(
    world: &World,
    pipeline: &Pipeline,
    settings: &Settings,
    first: u32,
    pixels: &mut [Rgb],
    row_is_done: &(dyn Fn() + Sync),
) {
    let width = pipeline.width();
    pixels.par_chunks_mut((SIDE * width) as usize).enumerate().for_each(|(band, pixels)| {
        let first_row = first + band as u32 * SIDE;
        let rows = pixels.len() as u32 / width;
        for first_i in (0..width).step_by(SIDE as usize) {
            let colors = tile_colors(world, pipeline, settings, (first_i, first_row));
            for (k, color) in colors.iter().enumerate() {
                let (i, row) = place(k);
                if first_i + i < width && row < rows {
                    pixels[(row * width + first_i + i) as usize] = *color;
                }
            }
        }
        (0..rows).for_each(|_| row_is_done());
    });
}

/// Which pixel of a tile is the k-th: blocks of four by two, so that each eight lie close together.
fn place(k: usize) -> (u32, u32) {
    let (block, k) = (k as u32 / 8, k as u32 % 8);
    (block % 2 * 4 + k % 4, block / 2 * 2 + k / 4)
}

/// The colours of a tile's pixels, the mean of their samples each; those beyond the picture's border are made up.
fn tile_colors(
    world: &World,
    pipeline: &Pipeline,
    settings: &Settings,
    (first_i, first_row): (u32, u32),
) -> [Rgb; PIXELS] {
    let interval = visible_interval(&pipeline.volume());
    let n = settings.samples;
    let mut sums = [Rgb::ZERO; PIXELS];
    for dj in 0..n {
        for di in 0..n {
            let rays = viewing_rays(pipeline, (first_i, first_row), (part(di, n), part(dj, n)));
            let colors = ray_colors(world, &rays, interval, settings);
            sums.iter_mut().zip(colors).for_each(|(sum, color)| *sum += color);
        }
    }
    sums.map(|sum| sum / (n * n) as f32)
}

/// What [`crate::viewing_ray`] gives for each pixel of a tile, `di` and `dj` beside its centre: the same sum, but what
/// columns and rows have in common is computed once for each.
fn viewing_rays(
    pipeline: &Pipeline,
    (first_i, first_row): (u32, u32),
    (di, dj): (f32, f32),
) -> [Ray; PIXELS] {
    let (camera, volume) = (pipeline.camera(), pipeline.volume());
    let (width, height) = (pipeline.width(), pipeline.height());
    let (eye, basis) = (camera.eye(), camera.basis());
    let window = |i: f32, j: f32| viewport::window_point(&volume, width, height, vec2(i, j));
    let along_u: [Vec3; SIDE as usize] =
        std::array::from_fn(|k| window((first_i + k as u32) as f32 + di, 0.0).x * basis.u);
    let along_v: [Vec3; SIDE as usize] = std::array::from_fn(|k| {
        let j = row_from_j((first_row + k as u32).min(height - 1), height);
        window(0.0, j as f32 + dj).y * basis.v
    });
    let along_w = volume.near * basis.w;
    std::array::from_fn(|k| {
        let (i, row) = place(k);
        Ray::new(eye, along_u[i as usize] + along_v[row as usize] + along_w)
    })
}

/// What [`crate::ray_color`] gives for each ray.
fn ray_colors(
    world: &World,
    rays: &[Ray; PIXELS],
    (t0, t1): (f32, f32),
    settings: &Settings,
) -> [Rgb; PIXELS] {
    let mut colors = [world.background; PIXELS];
    let mut met = [None; PIXELS];
    nearest_each(world, rays, t0, t1, &mut met);
    let mut seen: Vec<Seen> = Vec::with_capacity(PIXELS);
    for (k, met) in met.iter().enumerate() {
        if let Some(met) = met {
            seen.push(Seen { k, hit: world.hit(&rays[k], met), light: Rgb::ZERO });
        }
    }
    add_light(world, rays, settings, &mut seen);
    for Seen { k, hit, light } in &seen {
        let cast = Cast { world, ray: &rays[*k], settings, share: 1.0 };
        colors[*k] = with_optics(&cast, hit, *light);
    }
    colors
}

/// What a ray hit.
struct Seen {
    /// Which ray.
    k: usize,
    hit: Hit,
    /// The light on it.
    light: Rgb,
}

/// Adds up the light on all hits, light by light.
fn add_light(world: &World, rays: &[Ray], settings: &Settings, seen: &mut [Seen]) {
    let lit = seen.iter().enumerate().filter(|(_, seen)| shows_light(world, &rays[seen.k], &seen.hit));
    let points: Vec<(usize, LightingPoints)> =
        lit.map(|(which, seen)| (which, LightingPoints::new(world, &rays[seen.k], &seen.hit))).collect();
    let mut shadows = Shadows::default();
    for light in &world.lights {
        for (which, points) in &points {
            let Seen { k, hit, light: sum } = &mut seen[*which];
            let unhindered = points.unhindered(&world.surface(hit).material, light, world.highlight);
            match light.illumination(hit.point) {
                Some(arriving) if settings.shadows && unhindered != Rgb::ZERO => {
                    if world.has_glass() {
                        *sum += unhindered * light_share(world, &rays[*k], hit, &arriving, settings.search);
                    } else {
                        let ray = shadow_ray(world, &rays[*k], hit, &arriving);
                        shadows.push(*which, unhindered, ray, arriving.distance);
                    }
                }
                _ => *sum += unhindered,
            }
        }
        shadows.settle(world, seen);
    }
}

/// Shadow rays towards one light that wait to be sent together.
#[derive(Default)]
struct Shadows {
    /// Which hit each starts from, and what it is lit with if nothing is on the way.
    waiting: Vec<(usize, Rgb)>,
    rays: Vec<Ray>,
    distances: Vec<f32>,
    stopped: Vec<bool>,
}

impl Shadows {
    fn push(&mut self, which: usize, unhindered: Rgb, ray: Ray, distance: f32) {
        self.waiting.push((which, unhindered));
        self.rays.push(ray);
        self.distances.push(distance);
    }

    /// Sends them all, and adds the light where it arrives.
    fn settle(&mut self, world: &World, seen: &mut [Seen]) {
        self.stopped.clear();
        self.stopped.resize(self.rays.len(), false);
        any_hit_each(world, &self.rays, 0.0, &self.distances, &mut self.stopped);
        for ((which, unhindered), stopped) in self.waiting.drain(..).zip(&self.stopped) {
            seen[which].light += unhindered * if *stopped { Rgb::ZERO } else { Rgb::ONE };
        }
        self.rays.clear();
        self.distances.clear();
    }
}
