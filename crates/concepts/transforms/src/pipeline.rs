//! Where is a point at each stage of its way to the screen? (L5)

use glam::{Mat4, Vec3, Vec4};

use crate::{Camera, DegenerateVolume, ViewVolume, projection, viewport};

/// The whole chain of stages: world → camera → clip → canonical → screen.
///
/// The slide prints the matrices as camera · perspective · scale · translate · viewport, from left to right in the order of
/// time (E1). With column vectors what acts first stands last: screen = V · S · C · P · R · T.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pipeline {
    camera: Camera,
    volume: ViewVolume,
    width: u32,
    height: u32,
}

/// Why there is no pipeline.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum DegeneratePipeline {
    /// The viewing volume is degenerate.
    #[error(transparent)]
    Volume(#[from] DegenerateVolume),
    /// The screen has no pixels.
    #[error("a screen of {width} × {height} pixels has no pixels")]
    NoPixels {
        /// n_x.
        width: u32,
        /// n_y.
        height: u32,
    },
}

/// One factor of the chain, in the order in which they act.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Factor {
    /// The letter on the slide: T, R, P, C, S or V.
    pub symbol: char,
    /// What it does, in a few words.
    pub meaning: &'static str,
    /// The matrix.
    pub matrix: Mat4,
}

/// One point at each stage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Traced {
    /// In world space, as it was given.
    pub world: Vec3,
    /// In camera space: x right, y up, z towards the viewer; visible points have negative z.
    pub camera: Vec3,
    /// In clip space, before the division; w = z_camera, negative for visible points (E2).
    pub clip: Vec4,
    /// In the canonical cube, after the division; `None` for a point in the plane of the eye, whose w is 0. A point behind
    /// the eye (w > 0) has one too, mirrored: that is why clipping comes before the division.
    pub canonical: Option<Vec3>,
    /// On the screen: x and y in pixels, y upwards, z as in the canonical cube.
    pub screen: Option<Vec3>,
}

impl Pipeline {
    /// The pipeline of a camera, what it sees, and a screen of `width` × `height` pixels.
    ///
    /// # Errors
    /// [`DegeneratePipeline`] if the volume is degenerate or the screen has no pixels.
    ///
    /// ```
    /// use glam::{Vec3, vec2, vec3};
    /// use transforms::{Camera, Pipeline, ViewVolume};
    ///
    /// let camera = Camera::look_at(vec3(0.0, 0.0, 4.0), Vec3::ZERO, Vec3::Y)?;
    /// let volume = ViewVolume { left: -1.0, right: 1.0, bottom: -1.0, top: 1.0, near: -1.0, far: -9.0 };
    /// let traced = Pipeline::new(camera, volume, 200, 100)?.trace(vec3(2.0, 1.0, 0.0));
    /// assert_eq!(traced.camera, vec3(2.0, 1.0, -4.0));
    /// assert_eq!(traced.canonical.unwrap().truncate(), vec2(0.5, 0.25));
    /// assert_eq!(traced.screen.unwrap().truncate(), vec2(149.5, 62.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(
        camera: Camera,
        volume: ViewVolume,
        width: u32,
        height: u32,
    ) -> Result<Self, DegeneratePipeline> {
        volume.validate()?;
        if width == 0 || height == 0 {
            return Err(DegeneratePipeline::NoPixels { width, height });
        }
        Ok(Self { camera, volume, width, height })
    }

    /// V · S · C · P · R · T: from the world to the screen; divide by w afterwards.
    #[must_use]
    pub fn screen_from_world(&self) -> Mat4 {
        self.screen_from_canonical() * self.canonical_from_camera() * self.camera_from_world()
    }

    /// S · C · P · R · T: from the world to clip space.
    #[must_use]
    pub fn clip_from_world(&self) -> Mat4 {
        self.canonical_from_camera() * self.camera_from_world()
    }

    /// R · T (L1).
    #[must_use]
    pub fn camera_from_world(&self) -> Mat4 {
        self.camera.camera_from_world()
    }

    /// S · C · P (L2, L3); divide by w afterwards.
    #[must_use]
    pub fn canonical_from_camera(&self) -> Mat4 {
        projection::canonical_from_camera(&self.volume)
    }

    /// V (L4).
    #[must_use]
    pub fn screen_from_canonical(&self) -> Mat4 {
        viewport::screen_from_canonical(self.width, self.height)
    }

    /// The six factors in the order in which they act: T, R, P, C, S, V. Their product, last to first, is
    /// [`Pipeline::screen_from_world`] (E1).
    #[must_use]
    pub fn factors(&self) -> [Factor; 6] {
        let factor = |symbol, meaning, matrix| Factor { symbol, meaning, matrix };
        [
            factor('T', "move the eye to the origin", self.camera.translation()),
            factor('R', "turn u, v, w to x, y, z", self.camera.rotation()),
            factor(
                'P',
                "bend the pyramid into a box",
                projection::perspective(self.volume.near, self.volume.far),
            ),
            factor('C', "move the middle of the box to the origin", projection::center(&self.volume)),
            factor('S', "scale the box to the cube", projection::scale(&self.volume)),
            factor('V', "spread the square over the pixels", self.screen_from_canonical()),
        ]
    }

    /// `p_world` at each stage.
    #[must_use]
    pub fn trace(&self, p_world: Vec3) -> Traced {
        let camera = self.camera_from_world().transform_point3(p_world);
        let clip = self.canonical_from_camera() * camera.extend(1.0);
        let canonical = Some(clip.truncate() / clip.w).filter(|p| p.is_finite());
        let screen = canonical.map(|p| self.screen_from_canonical().transform_point3(p));
        Traced { world: p_world, camera, clip, canonical, screen }
    }

    /// The camera.
    #[must_use]
    pub fn camera(&self) -> Camera {
        self.camera
    }

    /// What the camera sees.
    #[must_use]
    pub fn volume(&self) -> ViewVolume {
        self.volume
    }

    /// n_x, the screen's width in pixels.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// n_y, the screen's height in pixels.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.height
    }
}
