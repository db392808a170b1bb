//! The unbounded flat surface, and on which side of it a point lies.

use glam::Vec3;

use crate::Triangle;

/// The points p with n·p = d.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// n: the unit normal, towards the front.
    pub normal: Vec3,
    /// d: the signed distance of the plane from the origin along n.
    pub offset: f32,
}

impl Plane {
    /// The plane through `point` with unit normal `normal`.
    #[must_use]
    pub fn new(point: Vec3, normal: Vec3) -> Self {
        Self { normal, offset: normal.dot(point) }
    }

    /// The plane of a triangle, or `None` if its corners lie on one line.
    #[must_use]
    pub fn of_triangle(triangle: &Triangle) -> Option<Self> {
        triangle.normal().map(|n| Self::new(triangle.a, n))
    }

    /// n·p − d: the distance of `p`, positive on the front, negative behind.
    ///
    /// ```
    /// use geometry::Plane;
    /// use glam::vec3;
    ///
    /// let table = Plane::new(vec3(7.0, 2.0, 1.0), vec3(0.0, 1.0, 0.0));
    /// assert_eq!(table.signed_distance(vec3(4.0, 5.0, 6.0)), 3.0);
    /// ```
    #[must_use]
    pub fn signed_distance(&self, p: Vec3) -> f32 {
        self.normal.dot(p) - self.offset
    }
}
