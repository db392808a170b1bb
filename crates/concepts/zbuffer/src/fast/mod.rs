//! How do a million triangles come to the screen? Vertices once, triangles eight at a time, pixels in blocks, the nearest first.
//!
//! The slide's loop (L16) takes one triangle after the other and asks every pixel of its box; here the same questions are asked in
//! another order and many at once. The answers are the same, bit for bit: each pixel shows the same triangle at the same depth as
//! by [`crate::rasterize()`] and [`crate::DepthBuffer`]. `tests/it/laws/fast.rs` holds it to that.
//!
//! What is done. `cargo bench -p zbuffer -- frame` gives the ratio to the slide's loop; what a single step gains was measured by leaving it out, on
//! one thread at 1920 × 1080 pixels:
//!
//! 1. **Each vertex once**, eight at a time, in the slide's own roundings; of a closed mesh six triangles share each. What has to be
//!    clipped is marked and goes the slide's way ([`crate::project_clip`]). A vertex is kept in two rows of f32: where it was snapped to, and what
//!    that left over, from which each triangle's plane is known as exactly as on the slide.
//! 2. **Small triangles without a pixel centre are dropped** before anything else is done, eight at a time; what is left is sorted by bands
//!    of 16 rows, whose depths stay near the processor. Bands are also what threads share out.
//! 3. **Edge functions stay whole numbers.** In f64, or for triangles up to 8 pixels in f32, they are exact, so that the top-left
//!    rule (E10) decides as on the slide, without integers.
//! 4. **Small triangles are made ready eight at a time.** Of those of three pixels and less even the inside tests are done for
//!    eight triangles at once, pixel by pixel of their boxes. Without it a picture of a million triangles takes 1.3 times as long.
//! 5. **Larger ones go by blocks** of 4 × 2 pixels. Two rows lie interleaved in memory, so that a block is one piece of it.
//! 6. **Large ones nearest first, tile by tile** (64 × 16 pixels): where everything is nearer already, a tile is skipped. Eight layers that cover the
//!    screen, drawn from back to front, then take little more than one: without it the depth test takes 3.2 times as long. Ties go to the
//!    lower number, in whatever order triangles come.
//! 7. **No colour is computed here**, only which triangle is seen: overdraw (E16) costs depth tests and nothing else. [`Projected::weights`] finds
//!    afterwards where in its triangle a pixel lies.
//!
//! Eight numbers at a time are those of `fearless_simd`: its functions are compiled for several processors, and chosen when the program
//! runs. Nothing is fused or approximated, so every processor gives the same bits.
//!
//! Read `vertices`, `bins`, `small` and `blocks`, in this order.

/// The expression for k = 0, 1, 2 as an array. Closures would not do: the compiler does not always carry the permission to
/// use wide instructions into them.
macro_rules! three {
    ($k:ident => $value:expr) => {
        [
            {
                let $k = 0;
                $value
            },
            {
                let $k = 1;
                $value
            },
            {
                let $k = 2;
                $value
            },
        ]
    };
}

mod band;
mod bins;
mod blocks;
mod edges;
mod eight;
mod plane;
mod projected;
mod small;
mod vertices;
mod weights;

pub use band::{Band, Numbers};
pub use bins::BAND_ROWS;
pub use eight::{Corners, gather_columns, load_columns, store_columns};
pub use projected::{Faces, MeshInstance, NONE, Number, Projected};
pub use weights::{Singly, Weights};
