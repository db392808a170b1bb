//! Which rays? Those of a picture, those of its shadows, and some that have nothing to do with each other.

use geometry::Ray;
use glam::Vec3;
use raytrace::viewing_ray;

use crate::ours::Tracing;
use crate::scenes::{self, view};

/// What a ray is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// From the eye through a pixel: neighbours meet the same boxes.
    Primary,
    /// From anywhere to anywhere.
    Random,
    /// From what the eye sees to the light; any hit will do.
    Shadow,
}

impl Kind {
    pub(crate) const ALL: [Self; 3] = [Self::Primary, Self::Random, Self::Shadow];

    /// As the table has it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Primary => "primary",
            Self::Random => "random",
            Self::Shadow => "shadow",
        }
    }

    /// Up to which t a hit counts: the light is at 1.
    pub(crate) fn farthest(self) -> f32 {
        if self == Self::Shadow { 1.0 } else { f32::INFINITY }
    }
}

/// The rays of all three kinds.
pub(crate) struct Rays([Vec<Ray>; 3]);

/// Around the mesh and its bumps.
const RADIUS: f32 = 1.06;
/// Which random rays: the same in every run.
const SEED: u64 = 20_260_401;
/// How far before the surface shadow rays start, as a share of the way there: no ray meets the triangle it came from,
/// whoever's the rounding.
const BEFORE_THE_SURFACE: f32 = 1e-3;

impl Rays {
    /// One primary ray for each of `side` × `side` pixels, in blocks of 4 × 2; a shadow ray for each that hits, in the
    /// same order; a quarter as many random ones.
    pub(crate) fn new(tracing: &Tracing, side: u32) -> Self {
        let view = view(side, side);
        let primary: Vec<Ray> =
            in_blocks(side).map(|(i, j)| viewing_ray(&view, i as f32, j as f32)).collect();
        let mut random = Random(SEED);
        let chord = |_| Ray::through(RADIUS * random.direction(), RADIUS * random.direction());
        let count = primary.len() / 4;
        let shadow = shadow(tracing, &primary);
        Self([primary, (0..count).map(chord).collect(), shadow])
    }

    /// Those of one kind.
    pub(crate) fn of(&self, kind: Kind) -> &[Ray] {
        &self.0[kind as usize]
    }
}

/// The pixels, neighbours together: whoever takes several rays at once finds them side by side.
///
/// # Panics
/// If `side` is not a multiple of 4.
fn in_blocks(side: u32) -> impl Iterator<Item = (u32, u32)> {
    assert!(side.is_multiple_of(4), "blocks of 4 × 2");
    let blocks = (0..side).step_by(2).flat_map(move |j| (0..side).step_by(4).map(move |i| (i, j)));
    blocks.flat_map(|(i, j)| (0..8).map(move |k| (i + k % 4, j + k / 4)))
}

/// From what the rays hit to the light, which is at t = 1.
fn shadow(tracing: &Tracing, primary: &[Ray]) -> Vec<Ray> {
    let mut t = vec![0.0; primary.len()];
    tracing.nearest(primary, &mut t);
    let hits = primary.iter().zip(t).filter(|(_, t)| t.is_finite());
    hits.map(|(ray, t)| Ray::through(ray.at(t * (1.0 - BEFORE_THE_SURFACE)), scenes::LIGHT)).collect()
}

/// Numbers without a pattern, by SplitMix64 (Steele, Lea and Flood, 2014).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Between −1 and 1.
    fn signed(&mut self) -> f32 {
        (self.next() >> 40) as f32 / 8_388_608.0 - 1.0
    }

    /// A direction, all of them equally likely: a point of the ball, by trying points of the cube.
    fn direction(&mut self) -> Vec3 {
        loop {
            let p = Vec3::from_array(std::array::from_fn(|_| self.signed()));
            if (0.01..1.0).contains(&p.length_squared()) {
                return p.normalize();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes::sphere::bumpy;

    #[test]
    fn rays_are_as_many_as_they_should_be_and_start_where_they_should() {
        let rays = Rays::new(&Tracing::build(bumpy(10)), 64);
        assert_eq!(rays.of(Kind::Primary).len(), 64 * 64);
        assert_eq!(rays.of(Kind::Random).len(), 64 * 16);
        let shadow = rays.of(Kind::Shadow);
        assert!((1000..3500).contains(&shadow.len()), "{} pixels show the ball", shadow.len());
        assert!(shadow.iter().all(|ray| ray.at(1.0).abs_diff_eq(scenes::LIGHT, 1e-5)));
        assert!(shadow.iter().all(|ray| ray.origin.length() < 1.1));
        assert!(rays.of(Kind::Random).iter().all(|ray| (ray.origin.length() - RADIUS).abs() < 1e-6));
    }

    #[test]
    fn every_pixel_is_in_one_block() {
        let mut pixels: Vec<_> = in_blocks(16).collect();
        assert_eq!(pixels[..9], [(0, 0), (1, 0), (2, 0), (3, 0), (0, 1), (1, 1), (2, 1), (3, 1), (4, 0)]);
        pixels.sort_unstable();
        pixels.dedup();
        assert_eq!(pixels.len(), 16 * 16);
    }

    #[test]
    fn directions_lean_to_no_side() {
        let mut random = Random(7);
        let mean = (0..10_000).map(|_| random.direction()).sum::<Vec3>() / 10_000.0;
        // Each coordinate of a mean has σ = √(1/3 / 10,000) = 0.006: five of them.
        assert!(mean.abs().max_element() < 0.03, "{mean}");
    }
}
