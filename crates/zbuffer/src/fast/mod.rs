//! How does a million triangles come to the screen in a hundredth of a second?
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
mod projected;
mod small;
mod vertices;
mod weights;

pub use band::Band;
pub use bins::BAND_ROWS;
pub use eight::{Indices, gather_columns};
pub use projected::{Faces, NONE, Number, Part, Projected};
pub use weights::Weights;
