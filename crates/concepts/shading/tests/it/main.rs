//! What must hold for every input: of normals, of single surfaces, of whole pictures.

mod fast;
mod model;
mod normals;
mod pictures;
mod surfaces;
