//! What a material file says about a surface.

use glam::Vec3;

/// A material of an MTL file. What the file does not say is `None`.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct ObjMaterial {
    /// `newmtl`: its name; empty for the default material.
    pub name: String,
    /// `Ka`: the colour that reflects ambient light; linear RGB, each at least 0.
    pub ambient: Option<Vec3>,
    /// `Kd`: the diffuse colour; linear RGB, each at least 0.
    pub diffuse: Option<Vec3>,
    /// `Ks`: the colour of the highlight; linear RGB, each at least 0.
    pub specular: Option<Vec3>,
    /// `Ns`: the exponent of the highlight, at least 0 (MTL means the halfway form, L34).
    pub exponent: Option<f32>,
    /// `d`, or 1 − `Tr` where there is no `d`: from 0, invisible, to 1, opaque.
    pub dissolve: Option<f32>,
    /// `Ni`: the index of refraction, greater than 0.
    pub refractive_index: Option<f32>,
    /// `illum`: the lighting model, 0 to 10; 2 has highlights, from 3 on there are mirrors, 4, 6, 7 and 9 are glass.
    pub illumination_model: Option<u8>,
}
