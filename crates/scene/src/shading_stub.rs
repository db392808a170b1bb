//! Stands in until `shading` has it.
/// Where the lighting model is evaluated (L37-L40).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Shading {
    /// One colour a triangle.
    Flat,
    /// One colour a vertex.
    Gouraud,
    /// One normal a pixel.
    #[default]
    Phong,
}
impl crate::Named for Shading {
    const WHAT: &'static str = "shading";
    const ALL: &'static [(&'static str, Self)] = &[
        ("flat", Self::Flat),
        ("gouraud", Self::Gouraud),
        ("phong", Self::Phong),
    ];
}
