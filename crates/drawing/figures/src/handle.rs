//! What in a drawing can be taken by hand, and which numbers follow?

use std::error::Error;

use glam::{Vec2, Vec3, vec2};
use sheet::{Sheet, Text, Words};
use transforms::Pipeline;

use crate::figure::{Drawing, Drawn};
use crate::parameter::Values;

/// A place in a drawing that depends on parameters, so that dragging it can set them.
#[derive(Clone, Debug, PartialEq)]
pub struct Handle {
    /// What is dragged: "the light".
    pub name: Words,
    /// The parameters that it changes, one or two.
    pub moves: Vec<&'static str>,
    /// Where it is, as shares of the drawing's width and height from its top left corner.
    pub at: Vec2,
}

/// The handles of one drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Handles {
    /// Width and height of the drawing, in pixels of its natural size.
    pub size: Vec2,
    /// What can be dragged.
    pub handles: Vec<Handle>,
}

/// The handles of a figure, a list for each of its drawings in their order; lists of none may be left out at the end.
/// An error says which values do not go together.
pub type Handled = Result<Vec<Handles>, Box<dyn Error + Send + Sync>>;

/// For a figure in whose drawings no parameter has a place.
pub(crate) fn without_handles(_: &Values) -> Handled {
    Ok(Vec::new())
}

/// The drawings with the handles that their figure gives them.
pub(crate) fn with_handles(drawings: Vec<Drawing>, handled: Handled) -> Drawn {
    let lists = handled?.into_iter().map(|list| list.handles).chain(std::iter::repeat_with(Vec::new));
    Ok(drawings.into_iter().zip(lists).map(|(drawing, handles)| drawing.with_handles(handles)).collect())
}

impl Handles {
    /// None yet, in a drawing of this size.
    pub(crate) fn none(size: Vec2) -> Self {
        Self { size, handles: Vec::new() }
    }

    /// One more, at this share of the width and height.
    pub(crate) fn and(mut self, name: Text, moves: &[&'static str], at: Vec2) -> Self {
        self.handles.push(Handle { name: name.into(), moves: moves.to_vec(), at });
        self
    }

    /// Handles at points of the plane that a sheet shows.
    pub(crate) fn on<const COUNT: usize>(
        sheet: &Sheet,
        list: [(Text, &[&'static str], Vec2); COUNT],
    ) -> Self {
        let start = Self::none(sheet.size());
        list.into_iter().fold(start, |handles, (name, moves, p)| handles.and(name, moves, sheet.share(p)))
    }
}

/// Where a point of the world lies in the picture that a pipeline gives, as shares of its width and height from its top
/// left corner; `None` behind the eye.
pub(crate) fn in_picture(pipeline: &Pipeline, p_world: Vec3) -> Option<Vec2> {
    let traced = pipeline.trace(p_world);
    // What is before the eye has a negative w (E2); what is behind it would land somewhere too.
    let screen = traced.screen.filter(|_| traced.clip.w < 0.0)?.truncate();
    let size = vec2(pipeline.width() as f32, pipeline.height() as f32);
    // The screen begins half a pixel before the centre of pixel (0, 0), and j runs upwards.
    let share = (screen + 0.5) / size;
    Some(vec2(share.x, 1.0 - share.y))
}

#[cfg(test)]
mod tests {
    use super::*;
    use canvas::row_from_j;
    use transforms::{Camera, ViewVolume};

    #[test]
    fn the_centre_of_a_pixel_lies_in_the_middle_of_its_place_in_the_file() {
        let camera = Camera::look_at(Vec3::ZERO, Vec3::NEG_Z, Vec3::Y).unwrap();
        let volume = ViewVolume::from_fov_y(1.0, 1.5, -1.0, -9.0).unwrap();
        let pipeline = Pipeline::new(camera, volume, 6, 4).unwrap();
        for (i, j) in [(0, 0), (5, 3), (2, 1)] {
            let p = raytrace::viewing_ray(&pipeline, i as f32, j as f32).at(1.7);
            let share = in_picture(&pipeline, p).unwrap();
            let middle = vec2((i as f32 + 0.5) / 6.0, (row_from_j(j, 4) as f32 + 0.5) / 4.0);
            // Six matrices, each a few roundings, on a screen of a few pixels.
            assert!(share.abs_diff_eq(middle, 1e-5), "({i}, {j}): {share} instead of {middle}");
        }
        assert_eq!(in_picture(&pipeline, Vec3::Z), None);
    }
}
