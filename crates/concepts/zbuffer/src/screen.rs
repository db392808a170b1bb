//! What is left of a triangle once it is on the screen? Three vertices with a pixel position, a depth and 1/w.

use geometry::Barycentric;
use glam::{DVec3, I64Vec2};

/// The fraction bits of a pixel position: vertices are snapped to 1/256 pixel, as graphics hardware does.
pub const SUBPIXEL_BITS: u32 = 8;

/// 2^[`SUBPIXEL_BITS`]: how many positions there are from one pixel centre to the next.
pub const SUBPIXELS: i64 = 1 << SUBPIXEL_BITS;

/// The greatest distance from the screen's origin, in pixels, that a vertex may have. Clipping sees to it.
///
/// A product of two differences of snapped positions then stays below 2^63: (2 · 2^20 · 2^8)² = 2^58.
pub const GREATEST_PIXEL: f64 = (1 << 20) as f64;

/// A vertex of a triangle on the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScreenVertex {
    /// x and y in pixels (y upwards), and canonical z, −1 to 1, larger is nearer.
    ///
    /// In 64 bits: on a steep surface the rounding of x and y to 32 bits would show in a 24-bit depth buffer.
    pub position: DVec3,
    /// 1 / w, w the depth in camera space (negative for visible points): affine on the screen, unlike w itself (E9).
    pub inv_w: f32,
    /// Where the vertex lies in the triangle that it comes from; after clipping that need not be a corner.
    pub weights: Barycentric,
}

impl ScreenVertex {
    /// The position in 1/256 pixels, rounded. A function of x and y alone, so a shared vertex stays shared.
    #[must_use]
    pub fn snapped(&self) -> I64Vec2 {
        let scaled = self.position.truncate() * SUBPIXELS as f64;
        I64Vec2::new(scaled.x.round() as i64, scaled.y.round() as i64)
    }
}

/// A triangle on the screen; either orientation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScreenTriangle {
    /// The vertices in the order of the triangle they come from: anticlockwise if its front is seen.
    pub vertices: [ScreenVertex; 3],
}

impl ScreenTriangle {
    /// Twice the signed area in snapped units: positive if the front is seen, 0 if the triangle covers no pixel.
    #[must_use]
    pub fn doubled_area(&self) -> i64 {
        let [a, b, c] = self.vertices.map(|v| v.snapped());
        (b - a).perp_dot(c - a)
    }
}

/// What a triangle leaves in one pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fragment {
    /// The pixel's column.
    pub i: u32,
    /// The pixel's row, counted upwards.
    pub j: u32,
    /// Canonical z at the pixel's center, interpolated affinely on the screen (E9).
    ///
    /// In 64 bits: between −1 and −½ a 32-bit number is only twice as fine as the steps of a 24-bit depth buffer.
    pub z: f64,
    /// Where the surface point lies in the triangle it comes from: perspective-correct, so that attributes interpolated
    /// with it are right (E9).
    pub weights: Barycentric,
}
