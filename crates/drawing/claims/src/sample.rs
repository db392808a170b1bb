//! On what is a sentence tried? On numbers that look random and are the same in every run.

use geometry::Triangle;
use glam::{Vec3, vec3};
use transforms::{Basis, Camera, Pipeline, ViewVolume};

use crate::Trial;

/// Numbers without a pattern, fixed by a seed (SplitMix64).
pub(super) struct Sequence(u64);

impl Sequence {
    pub(super) fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number from `low` to `high`.
    pub(super) fn between(&mut self, low: f32, high: f32) -> f32 {
        // 24 bits: as many as an f32 holds.
        low + (high - low) * ((self.next() >> 40) as f32 / (1 << 24) as f32)
    }

    /// A whole number below `end`.
    pub(super) fn below(&mut self, end: usize) -> usize {
        (self.next() % end as u64) as usize
    }

    /// A point of the box from −`reach` to `reach`.
    pub(super) fn point(&mut self, reach: f32) -> Vec3 {
        let mut coordinate = || self.between(-reach, reach);
        vec3(coordinate(), coordinate(), coordinate())
    }

    /// A unit vector: a point of the unit ball, brought to length 1.
    pub(super) fn direction(&mut self) -> Vec3 {
        loop {
            let p = self.point(1.0);
            if (0.01..1.0).contains(&p.length_squared()) {
                return p.normalize();
            }
        }
    }

    /// A unit vector on the side of `n`.
    pub(super) fn direction_around(&mut self, n: Vec3) -> Vec3 {
        let d = self.direction();
        if d.dot(n) < 0.0 { -d } else { d }
    }

    /// A colour with parts from 0 to 1.
    pub(super) fn color(&mut self) -> Vec3 {
        0.5 * (self.point(1.0) + 1.0)
    }

    /// A right-handed basis.
    pub(super) fn basis(&mut self) -> Basis {
        let gaze = self.direction();
        loop {
            let up = self.direction();
            // A tenth of a radian off the gaze keeps the cross product accurate.
            if up.cross(gaze).length() > 0.1
                && let Ok(basis) = Basis::from_gaze_and_up(gaze, up)
            {
                return basis;
            }
        }
    }

    /// A camera somewhere, looking somewhere.
    pub(super) fn camera(&mut self) -> Camera {
        loop {
            let (eye, up) = (self.point(9.0), self.direction());
            let gaze = self.direction();
            if up.cross(gaze).length() > 0.1
                && let Ok(camera) = Camera::look_at(eye, eye + 3.0 * gaze, up)
            {
                return camera;
            }
        }
    }

    /// A triangle of some size within `reach`.
    pub(super) fn triangle(&mut self, reach: f32) -> Triangle {
        loop {
            let triangle = Triangle::new(self.point(reach), self.point(reach), self.point(reach));
            if triangle.area() > 0.1 * reach * reach {
                return triangle;
            }
        }
    }

    /// The numbers 0 to `count` − 1 in some order.
    pub(super) fn order(&mut self, count: usize) -> Vec<usize> {
        let mut order: Vec<usize> = (0..count).collect();
        for k in (1..count).rev() {
            order.swap(k, self.below(k + 1));
        }
        order
    }
}

/// So many trials, each on the next numbers of one sequence.
pub(super) fn trials(count: usize, seed: u64, mut trial: impl FnMut(&mut Sequence) -> Trial) -> Vec<Trial> {
    let mut sequence = Sequence::new(seed);
    (0..count).map(|_| trial(&mut sequence)).collect()
}

/// A pipeline with a symmetric volume; `fov_y` in radians.
///
/// # Panics
/// If camera, volume or screen are degenerate: the claims' own are not.
pub(super) fn pipeline(
    (eye, target): (Vec3, Vec3),
    fov_y: f32,
    (near, far): (f32, f32),
    (width, height): (u32, u32),
) -> Pipeline {
    let camera = Camera::look_at(eye, target, Vec3::Y).expect("a camera");
    let volume = ViewVolume::from_fov_y(fov_y, width as f32 / height as f32, near, far).expect("a volume");
    Pipeline::new(camera, volume, width, height).expect("a pipeline")
}

/// A vector in a few digits.
pub(super) fn short(v: Vec3) -> String {
    format!("({:.3}, {:.3}, {:.3})", v.x, v.y, v.z)
}

/// All orders of so many things.
pub(super) fn permutations(count: usize) -> Vec<Vec<usize>> {
    let Some(last) = count.checked_sub(1) else { return vec![Vec::new()] };
    let mut all = Vec::new();
    for shorter in permutations(last) {
        for place in 0..=last {
            let mut order = shorter.clone();
            order.insert(place, last);
            all.push(order);
        }
    }
    all
}
