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
/// If the image and the depth buffer are not of one size, and as [`rasterize()`].
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
/// If the image and the depth buffer are not of one size, and as [`rasterize()`].
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
/// If the image and the depth buffer are not of one size, and as [`rasterize()`].
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{DepthFormat, ScreenVertex};
    use geometry::Barycentric;
    use glam::vec3;

    const WIDTH: u32 = 6;
    const HEIGHT: u32 = 5;

    /// A triangle of one depth; (x, y) in pixels, y upwards.
    fn triangle(z: f32, corners: [(f32, f32); 3]) -> ScreenTriangle {
        let weights = [Barycentric::A, Barycentric::B, Barycentric::C];
        let vertex = |k: usize| ScreenVertex {
            position: vec3(corners[k].0, corners[k].1, z).as_dvec3(),
            inv_w: -1.0,
            weights: weights[k],
        };
        ScreenTriangle { vertices: [0, 1, 2].map(vertex) }
    }

    /// The rectangle from the screen's lower left corner to (x, y).
    fn rectangle(z: f32, x: f32, y: f32) -> [ScreenTriangle; 2] {
        let o = -0.5;
        [triangle(z, [(o, o), (x, o), (x, y)]), triangle(z, [(o, o), (x, y), (o, y)])]
    }

    /// The stored depths as the slide prints them: rows from the top down, 0 where nothing was drawn.
    fn grid(depth: &DepthBuffer) -> String {
        let row = |j| {
            let cells: Vec<_> = (0..WIDTH).map(|i| depth.get(i, j).unwrap_or(0.0).to_string()).collect();
            cells.join(" ") + "\n"
        };
        (0..HEIGHT).rev().map(row).collect()
    }

    #[test]
    fn the_four_grids_of_the_slide() {
        // L17: three polygons at depths 10, 5 and 15; larger is nearer, 0 is the farthest. The slide's first grid
        // lost one of its five rows (E18).
        let mut image = Image::new(WIDTH, HEIGHT, Rgb::ZERO);
        let mut depth = DepthBuffer::new(WIDTH, HEIGHT, DepthFormat::F32);
        let mut step = |polygon: &[ScreenTriangle]| {
            for triangle in polygon {
                draw(triangle, |f| Rgb::splat(f.z as f32), &mut image, &mut depth);
            }
            grid(&depth)
        };
        assert_eq!(step(&[]), "0 0 0 0 0 0\n".repeat(5));
        let second = ["0 0 0 0 0 0\n".repeat(2), "10 10 10 10 0 0\n".repeat(3)].concat();
        assert_eq!(step(&rectangle(10.0, 3.5, 2.5)), second);
        let third = ["5 5 5 5 5 5\n".repeat(2), "10 10 10 10 5 5\n".repeat(3)].concat();
        assert_eq!(step(&rectangle(5.0, 5.5, 4.5)), third);
        let fourth =
            "5 5 15 15 5 5\n5 5 15 15 15 5\n10 15 15 15 15 15\n10 15 15 15 15 15\n15 15 15 15 15 15\n";
        assert_eq!(step(&[triangle(15.0, [(2.5, 5.0), (-0.25, -0.5), (8.0, -0.5)])]), fourth);
        assert_eq!(image.get(0, 0), Rgb::splat(15.0));
        assert_eq!(image.get(0, 2), Rgb::splat(10.0));
    }

    #[test]
    fn the_algorithm_starts_from_background_and_farthest_depth() {
        let mut image = Image::new(WIDTH, HEIGHT, Rgb::ONE);
        let mut depth = DepthBuffer::new(WIDTH, HEIGHT, DepthFormat::Bits24);
        depth.test_and_set(0, 0, 1.0); // left over from another picture
        let polygons = rectangle(-0.5, 3.5, 2.5).map(|triangle| (triangle, Rgb::X));
        let work = z_buffer(Rgb::Y, &polygons, &mut image, &mut depth);
        assert_eq!(work, Work { fragments: 12, colored: 12 });
        assert_eq!((image.get(0, 0), image.get(5, 4)), (Rgb::X, Rgb::Y));
    }

    #[test]
    fn layers_from_front_to_back_are_coloured_once_and_from_back_to_front_each() {
        let mut image = Image::new(WIDTH, HEIGHT, Rgb::ZERO);
        let mut colored = |layers: [f32; 4]| {
            let polygons: Vec<_> = layers
                .iter()
                .flat_map(|z| rectangle(*z, 3.5, 2.5))
                .map(|triangle| (triangle, Rgb::X))
                .collect();
            let mut depth = DepthBuffer::new(WIDTH, HEIGHT, DepthFormat::F32);
            z_buffer(Rgb::ZERO, &polygons, &mut image, &mut depth).colored / 12
        };
        assert_eq!(colored([0.4, 0.1, -0.2, -0.7]), 1);
        assert_eq!(colored([-0.7, -0.2, 0.1, 0.4]), 4);
    }
}
