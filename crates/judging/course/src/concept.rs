//! Which part of the lecture is an exercise about?

/// A concept of the lecture; a folder in `exercises/`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Concept {
    /// How does a point of the world find its pixel?
    Transforms,
    /// Which polygon does a pixel show?
    Zbuffer,
    /// How bright is a point of a surface?
    Lighting,
    /// How do a few normals make a smooth surface?
    Shading,
    /// What does a ray meet?
    Raytrace,
}

impl Concept {
    /// All of them, in the lecture's order.
    pub const ALL: [Self; 5] =
        [Self::Transforms, Self::Zbuffer, Self::Lighting, Self::Shading, Self::Raytrace];

    /// The folder's name, and what is typed on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Transforms => "transforms",
            Self::Zbuffer => "zbuffer",
            Self::Lighting => "lighting",
            Self::Shading => "shading",
            Self::Raytrace => "raytrace",
        }
    }
}
