//! How much room does it take? The axis-aligned box around it.

use glam::Vec3;

/// An axis-aligned bounding box, borders included. [`Aabb::EMPTY`] holds no point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// The corner with the smallest coordinates.
    pub min: Vec3,
    /// The corner with the greatest coordinates.
    pub max: Vec3,
}

impl Aabb {
    /// The box without points: the union with it changes nothing.
    pub const EMPTY: Self = Self { min: Vec3::INFINITY, max: Vec3::NEG_INFINITY };

    /// The smallest box around `points`; [`Aabb::EMPTY`] if there are none.
    ///
    /// ```
    /// use geometry::Aabb;
    /// use glam::vec3;
    ///
    /// let b = Aabb::from_points([vec3(1.0, 5.0, -2.0), vec3(4.0, 3.0, 0.0)]);
    /// assert_eq!(b.size(), vec3(3.0, 2.0, 2.0));
    /// assert_eq!(b.center(), vec3(2.5, 4.0, -1.0));
    /// ```
    #[must_use]
    pub fn from_points(points: impl IntoIterator<Item = Vec3>) -> Self {
        points.into_iter().fold(Self::EMPTY, |b, p| Self { min: b.min.min(p), max: b.max.max(p) })
    }

    /// The smallest box around both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// Whether the box holds no point.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        !(self.min.cmple(self.max).all())
    }

    /// Whether `p` lies in the box or on its border.
    #[must_use]
    pub fn contains(&self, p: Vec3) -> bool {
        self.min.cmple(p).all() && p.cmple(self.max).all()
    }

    /// Width, height and depth; zero for the empty box.
    #[must_use]
    pub fn size(&self) -> Vec3 {
        if self.is_empty() { Vec3::ZERO } else { self.max - self.min }
    }

    /// The point in the middle; the origin for the empty box.
    #[must_use]
    pub fn center(&self) -> Vec3 {
        // Halved before they are added, so that even the largest coordinates do not overflow.
        if self.is_empty() { Vec3::ZERO } else { 0.5 * self.min + 0.5 * self.max }
    }

    /// The eight corners; those of the empty box mean nothing.
    #[must_use]
    pub fn corners(&self) -> [Vec3; 8] {
        std::array::from_fn(|k| {
            let pick = |bit: usize, lo: f32, hi: f32| if k & bit == 0 { lo } else { hi };
            Vec3::new(
                pick(1, self.min.x, self.max.x),
                pick(2, self.min.y, self.max.y),
                pick(4, self.min.z, self.max.z),
            )
        })
    }
}
