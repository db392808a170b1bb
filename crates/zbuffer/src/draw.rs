//! How does the z-buffer algorithm go? Two buffers, and the nearer wins (L16).

use canvas::{Image, Rgb};

use crate::{DepthBuffer, Fragment, ScreenTriangle, rasterize, rasterize_rows};

/// What drawing cost: how many fragments there were, and for how many of them a colour was computed.
///
/// Shading inside the loop is repeated for every fragment that is the nearest *so far* (E16). When n surfaces lie over a
/// pixel in random order, that is Hₙ = 1 + 1/2 + … + 1/n times on average: the k-th is the nearest of the first k with
/// probability 1/k.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// The fragments that the triangles left.
    pub fragments: u64,
    /// The fragments that were nearer than what was stored: the colours computed and written.
    pub colored: u64,
}

/// The z-buffer algorithm, as the slide has it (L16): draws triangles of one colour each, in any order.
///
/// 1. Set the background colour in the rgb-buffer and the **farthest** z in the z-buffer.
/// 2. For every polygon, rasterize; for every pixel, if z is nearer to the camera than the stored z, set the new colour and
///    the new z.
///
/// ```
/// use canvas::{Image, Rgb};
/// use zbuffer::{DepthBuffer, DepthFormat, draw::z_buffer};
///
/// let mut image = Image::new(640, 480, Rgb::ZERO);
/// let mut depth = DepthBuffer::new(640, 480, DepthFormat::F32);
/// let work = z_buffer(Rgb::new(0.2, 0.3, 0.5), &[], &mut image, &mut depth);
/// assert_eq!((work.fragments, image.get(7, 3)), (0, Rgb::new(0.2, 0.3, 0.5)));
/// ```
///
/// # Panics
/// If the image and the depth buffer are not of one size, and as [`rasterize`].
pub fn z_buffer(
    background: Rgb,
    polygons: &[(ScreenTriangle, Rgb)],
    image: &mut Image,
    depth: &mut DepthBuffer,
) -> Work {
    image.pixels_mut().fill(background);
    depth.clear();
    let mut work = Work::default();
    for (triangle, color) in polygons {
        work = work + draw(triangle, |_| *color, image, depth);
    }
    work
}

/// Step 2 for one polygon: what is nearer than all drawn before is coloured (L16).
///
/// - `color`: the colour of a fragment; asked only where the fragment is the nearest so far.
///
/// # Panics
/// If the image and the depth buffer are not of one size, and as [`rasterize`].
pub fn draw(
    triangle: &ScreenTriangle,
    mut color: impl FnMut(&Fragment) -> Rgb,
    image: &mut Image,
    depth: &mut DepthBuffer,
) -> Work {
    let (width, height) = common_size(image, depth);
    let mut work = Work::default();
    rasterize(triangle, width, height, |fragment| {
        work.fragments += 1;
        if depth.test_and_set(fragment.i, fragment.j, fragment.z) {
            work.colored += 1;
            image.set(fragment.i, fragment.j, color(&fragment));
        }
    });
    work
}

/// The same as [`draw`], through [`rasterize_rows`].
///
/// # Panics
/// If the image and the depth buffer are not of one size, and as [`rasterize`].
pub fn draw_fast(
    triangle: &ScreenTriangle,
    mut color: impl FnMut(&Fragment) -> Rgb,
    image: &mut Image,
    depth: &mut DepthBuffer,
) -> Work {
    let (width, height) = common_size(image, depth);
    let mut work = Work::default();
    rasterize_rows(triangle, width, 0..height, |fragment| {
        work.fragments += 1;
        if depth.test_and_set(fragment.i, fragment.j, fragment.z) {
            work.colored += 1;
            image.set(fragment.i, fragment.j, color(&fragment));
        }
    });
    work
}

fn common_size(image: &Image, depth: &DepthBuffer) -> (u32, u32) {
    let (size, depth_size) = ((image.width(), image.height()), (depth.width(), depth.height()));
    assert!(size == depth_size, "image {size:?} and depth buffer {depth_size:?} differ in size");
    size
}

impl std::ops::Add for Work {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { fragments: self.fragments + other.fragments, colored: self.colored + other.colored }
    }
}
