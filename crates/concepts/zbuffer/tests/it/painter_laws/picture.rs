//! What the painter leaves in each pixel, and what the depth buffer does.

use std::cell::Cell;

use testkit::{Outcome, ensure};
use zbuffer::painter::{self, DEPTH_TOLERANCE};
use zbuffer::{Fragment, ScreenTriangle, rasterize};

pub(crate) const WIDTH: u32 = 64;
pub(crate) const HEIGHT: u32 = 48;

/// What each pixel shows: the triangle and its depth there.
pub(crate) type Picture = Vec<Option<(usize, f64)>>;

pub(crate) fn empty_picture() -> Picture {
    vec![None; (WIDTH * HEIGHT) as usize]
}

pub(crate) fn place(fragment: &Fragment) -> usize {
    (fragment.j * WIDTH + fragment.i) as usize
}

/// The nearest triangle of each pixel, by comparison of all (L16).
pub(crate) fn nearest(triangles: &[ScreenTriangle]) -> Picture {
    let mut picture = empty_picture();
    for (k, triangle) in triangles.iter().enumerate() {
        rasterize(triangle, WIDTH, HEIGHT, |fragment| {
            let pixel = &mut picture[place(&fragment)];
            if pixel.is_none_or(|(_, z)| z < fragment.z) {
                *pixel = Some((k, fragment.z));
            }
        });
    }
    picture
}

/// What remains when triangles are drawn over each other.
pub(crate) fn painted(order: &[usize], triangles: &[ScreenTriangle]) -> Picture {
    let mut picture = empty_picture();
    for k in order {
        rasterize(&triangles[*k], WIDTH, HEIGHT, |fragment| {
            picture[place(&fragment)] = Some((*k, fragment.z));
        });
    }
    picture
}

pub(crate) fn painted_by_plan(plan: &painter::Plan, triangles: &[ScreenTriangle]) -> Picture {
    let mut picture = empty_picture();
    painter::for_each_fragment(plan, triangles, WIDTH, HEIGHT, |k, fragment| {
        picture[place(&fragment)] = Some((k, fragment.z));
    });
    picture
}

/// How far two depths may lie apart where the painter shows another triangle than the depth buffer: the tolerance, and
/// some roundings of the two fragments' depths, far below 2^−40.
pub(crate) const DEPTH_BOUND: f64 = DEPTH_TOLERANCE + 1e-12;

/// Pixels with a triangle in them, and those of them where painter and depth buffer show different triangles.
#[derive(Default)]
pub(crate) struct Pixels {
    covered: Cell<u32>,
    undecided: Cell<u32>,
}

impl Pixels {
    pub(crate) fn ensure_same(&self, painted: &Picture, nearest: &Picture) -> Outcome {
        for (p, (painted, nearest)) in painted.iter().zip(nearest).enumerate() {
            let (Some((k, z)), Some((best, z_best))) = (painted, nearest) else {
                ensure(painted == nearest, || {
                    format!("pixel {p}: painted {painted:?}, nearest {nearest:?}")
                })?;
                continue;
            };
            let behind = *z_best - *z;
            ensure(behind <= DEPTH_BOUND, || {
                format!("pixel {p} shows {k} at {z}, but {best} is nearer: {z_best}")
            })?;
            self.covered.set(self.covered.get() + 1);
            self.undecided.set(self.undecided.get() + u32::from(k != best));
        }
        Ok(())
    }

    /// The tolerance is a part in four million of the depths' range: a law that needs it often hides something.
    pub(crate) fn assert_nearly_all_decided(&self) {
        let (covered, undecided) = (self.covered.get(), self.undecided.get());
        assert!(1000 * undecided <= covered, "{undecided} of {covered} pixels differ within the tolerance");
    }
}
