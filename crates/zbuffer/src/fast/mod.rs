//! How does a million triangles come to the screen in a hundredth of a second?
mod band;
mod bins;
mod edges;
mod projected;
mod vertices;

pub use band::Band;
pub use bins::BAND_ROWS;
pub use projected::{Faces, NONE, Number, Part, Projected};
