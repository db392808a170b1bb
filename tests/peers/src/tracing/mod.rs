//! The same rays sent by everybody who goes ray by ray: ours, obvhs, parry3d.

mod agreement;
mod cases;
mod obvhs;
mod parry;
mod rays;

pub(crate) use cases::run;
use geometry::Mesh;
pub(crate) use rays::{Kind, Rays};

/// Somebody with a hierarchy built and rays prepared.
trait Traces {
    /// The name in the table.
    fn name(&self) -> &'static str;

    /// One query for each ray of this kind, into `t`: for primary and random rays the place of the nearest hit,
    /// infinite for none; for shadow rays 0 if anything is met before the light, else infinite. This is what is
    /// measured.
    fn trace(&self, kind: Kind, t: &mut [f32]);
}

/// All peers that trace, each with mesh and rays in its own form.
fn peers(mesh: &Mesh, rays: &Rays) -> Vec<Box<dyn Traces>> {
    vec![Box::new(obvhs::Prepared::new(mesh, rays)), Box::new(parry::Prepared::new(mesh, rays))]
}
