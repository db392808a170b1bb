//! Triangles straight on the screen, and who wins their pixels: what the claims about occlusion are tried on.

use std::collections::BTreeMap;

use zbuffer::{DepthBuffer, DepthFormat, Fragment, ScreenTriangle, rasterize};

use crate::sample::Sequence;
pub(super) use figures::on_screen::triangle;

/// Pixels of the trial screen in either direction.
pub(super) const SIDE: u32 = 24;

/// For each pixel of the screen, row by row upwards, which triangle it shows.
pub(super) type Winners = Vec<Option<usize>>;

/// So many triangles across the screen, each as deep as `depths` says: a range for each corner's z.
pub(super) fn random_triangles(
    random: &mut Sequence,
    count: usize,
    mut depths: impl FnMut(&mut Sequence, usize) -> (f32, f32),
) -> Vec<ScreenTriangle> {
    let side = SIDE as f32;
    let corner = |random: &mut Sequence, (low, high): (f32, f32)| {
        [random.between(-2.0, side), random.between(-2.0, side), random.between(low, high)]
    };
    (0..count)
        .map(|k| {
            let range = depths(random, k);
            triangle([corner(random, range), corner(random, range), corner(random, range)])
        })
        .collect()
}

/// The long triangles of Fig 8.9: each lies over the next and under the one before (L14), on a screen of 64 × 64.
pub(super) fn cycle() -> [ScreenTriangle; 3] {
    [
        triangle([[4.0, 6.0, -0.5], [58.0, 9.0, 0.5], [4.0, 16.0, -0.5]]),
        triangle([[46.0, 3.0, -0.5], [56.0, 4.0, -0.5], [26.0, 58.0, 0.5]]),
        triangle([[40.0, 52.0, -0.5], [32.0, 60.0, -0.5], [6.0, 2.0, 0.5]]),
    ]
}

/// Two triangles that pass through each other.
pub(super) fn piercing() -> [ScreenTriangle; 2] {
    [
        triangle([[3.0, 5.0, 0.5], [60.0, 8.0, -0.5], [30.0, 58.0, 0.0]]),
        triangle([[5.0, 40.0, -0.5], [58.0, 35.0, 0.5], [28.0, 3.0, 0.1]]),
    ]
}

/// Every fragment of every triangle on a screen of `side` × `side`, by pixel.
pub(super) fn fragments(
    triangles: &[ScreenTriangle],
    side: u32,
) -> BTreeMap<(u32, u32), Vec<(usize, Fragment)>> {
    let mut by_pixel: BTreeMap<_, Vec<_>> = BTreeMap::new();
    for (k, triangle) in triangles.iter().enumerate() {
        rasterize(triangle, side, side, |fragment| {
            by_pixel.entry((fragment.j, fragment.i)).or_default().push((k, fragment));
        });
    }
    by_pixel
}

/// Drawn in this order, each over what is there.
pub(super) fn painted(triangles: &[ScreenTriangle], order: &[usize], side: u32) -> Winners {
    let mut winners = vec![None; (side * side) as usize];
    for k in order {
        rasterize(&triangles[*k], side, side, |f| winners[(f.j * side + f.i) as usize] = Some(*k));
    }
    winners
}

/// Drawn in this order, each pixel to the nearest, with depths as the format keeps them.
pub(super) fn z_buffered(
    triangles: &[ScreenTriangle],
    order: &[usize],
    side: u32,
    format: DepthFormat,
) -> Winners {
    let mut winners = vec![None; (side * side) as usize];
    let mut depth = DepthBuffer::new(side, side, format);
    for k in order {
        rasterize(&triangles[*k], side, side, |f| {
            if depth.test_and_set(f.i, f.j, f.z) {
                winners[(f.j * side + f.i) as usize] = Some(*k);
            }
        });
    }
    winners
}

/// The nearest triangle of every pixel, by z-buffer in the order of the list.
pub(super) fn nearest(triangles: &[ScreenTriangle], side: u32) -> Winners {
    let order: Vec<usize> = (0..triangles.len()).collect();
    z_buffered(triangles, &order, side, DepthFormat::F32)
}

/// In how many pixels two pictures differ.
pub(super) fn different(a: &Winners, b: &Winners) -> usize {
    a.iter().zip(b).filter(|(a, b)| a != b).count()
}
