//! What is object 3 called? By its shape and its material, as the scene file has them.

use scene::{Scene, Shape};
use sheet::Words;

/// The names of a scene's objects, copies counted one by one.
pub(crate) struct Names(Vec<Words>);

impl Names {
    /// The names in a scene.
    pub(crate) fn of(scene: &Scene) -> Self {
        let mut names = Vec::new();
        for object in &scene.objects {
            let name = named(&object.shape, object.material.as_deref());
            match object.instances.len() {
                0 => names.push(name),
                copies => names.extend((1..=copies).map(|k| {
                    Words::new(format!("{}, copy {k}", name.en), format!("{}, kopie {k}", name.nl))
                })),
            }
        }
        Self(names)
    }

    /// The name of an object.
    pub(crate) fn object(&self, object: usize) -> Words {
        let nameless = || Words::new(format!("object {object}"), format!("object {object}"));
        self.0.get(object).cloned().unwrap_or_else(nameless)
    }

    /// The name of one of its triangles.
    pub(crate) fn triangle(&self, object: usize, triangle: usize) -> Words {
        let name = self.object(object);
        Words::new(
            format!("triangle {triangle} of {}", name.en),
            format!("driehoek {triangle} van {}", name.nl),
        )
    }
}

fn named(shape: &Shape, material: Option<&str>) -> Words {
    let (en, nl) = match shape {
        Shape::Sphere { .. } | Shape::UvSphere { .. } | Shape::Icosphere { .. } => ("ball", "bol"),
        Shape::Cuboid { .. } => ("box", "doos"),
        Shape::Torus { .. } => ("ring", "ring"),
        Shape::Disc { .. } => ("disc", "schijf"),
        Shape::Teapot { .. } => ("teapot", "theepot"),
        Shape::Polygons { .. } => ("polygons", "veelhoeken"),
        Shape::Obj { .. } => ("mesh", "mesh"),
    };
    match material {
        Some(material) => Words::new(format!("{en} “{material}”"), format!("{nl} “{material}”")),
        None => Words::new(en, nl),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Look, Stage};

    #[test]
    fn each_copy_has_a_name_of_its_own() {
        let look = Look { scene: "floating-bin".to_owned(), ..Look::default() };
        let names = Names::of(&Stage::default().scene(&look).unwrap());
        assert_eq!(names.object(0).en, "polygons “floor”");
        assert_eq!(names.object(2).nl, "veelhoeken “bin”, kopie 2");
        assert_eq!(names.triangle(9, 4).en, "triangle 4 of object 9");
    }
}
