//! Where inside a triangle is a point? Barycentric coordinates tell (L48).

use std::ops::{Add, Mul};

use glam::Vec3;

use crate::Aabb;

/// A triangle by its corners. Seen from its front they run anticlockwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    /// Corner a: α = 1.
    pub a: Vec3,
    /// Corner b: β = 1.
    pub b: Vec3,
    /// Corner c: γ = 1.
    pub c: Vec3,
}

impl Triangle {
    /// The triangle with corners `a`, `b`, `c`.
    #[must_use]
    pub fn new(a: Vec3, b: Vec3, c: Vec3) -> Self {
        Self { a, b, c }
    }

    /// The corners in order.
    #[must_use]
    pub fn corners(&self) -> [Vec3; 3] {
        [self.a, self.b, self.c]
    }

    /// (b − a) × (c − a): perpendicular to the triangle, towards its front, as long as twice the area.
    #[must_use]
    pub fn cross(&self) -> Vec3 {
        (self.b - self.a).cross(self.c - self.a)
    }

    /// The unit normal on the front, or `None` if the corners lie on one line (to within rounding).
    ///
    /// ```
    /// use geometry::Triangle;
    /// use glam::{Vec3, vec3};
    ///
    /// let floor = Triangle::new(vec3(0.0, 0.0, 0.0), vec3(2.0, 0.0, 0.0), vec3(0.0, 3.0, 0.0));
    /// assert_eq!(floor.normal(), Some(Vec3::Z)); // anticlockwise seen from +z
    /// ```
    #[must_use]
    pub fn normal(&self) -> Option<Vec3> {
        // In f64, so that neither a tiny nor a huge triangle under- or overflows on its way to a unit vector.
        let (a, b, c) = (self.a.as_dvec3(), self.b.as_dvec3(), self.c.as_dvec3());
        let cross = (b - a).cross(c - a);
        // A cross product below the rounding of its own factors says nothing about a direction.
        let noise = f64::from(f32::EPSILON) * (b - a).length() * (c - a).length();
        (cross.length() > noise && cross.is_finite()).then(|| cross.normalize().as_vec3())
    }

    /// The area, never negative.
    #[must_use]
    pub fn area(&self) -> f32 {
        0.5 * self.cross().length()
    }

    /// The point αa + βb + γc (L48).
    #[must_use]
    pub fn point(&self, weights: Barycentric) -> Vec3 {
        weights.interpolate(self.a, self.b, self.c)
    }

    /// The barycentric coordinates of `p`, or of its perpendicular projection if `p` lies off the plane.
    /// `None` for a triangle without area.
    ///
    /// Each coordinate is the signed area of the triangle that `p` makes with the opposite edge, over the whole (L48).
    ///
    /// ```
    /// use geometry::{Barycentric, Triangle};
    /// use glam::vec3;
    ///
    /// let t = Triangle::new(vec3(0.0, 0.0, 1.0), vec3(4.0, 0.0, 1.0), vec3(0.0, 8.0, 1.0));
    /// let weights = t.barycentric(vec3(1.0, 2.0, 1.0)).unwrap();
    /// assert_eq!(weights, Barycentric { alpha: 0.5, beta: 0.25, gamma: 0.25 });
    /// ```
    #[must_use]
    pub fn barycentric(&self, p: Vec3) -> Option<Barycentric> {
        let (a, b, c, p) = (self.a.as_dvec3(), self.b.as_dvec3(), self.c.as_dvec3(), p.as_dvec3());
        let n = (b - a).cross(c - a);
        let whole = n.length_squared();
        if whole == 0.0 || !whole.is_finite() {
            return None;
        }
        let beta = n.dot((c - p).cross(a - p)) / whole;
        let gamma = n.dot((a - p).cross(b - p)) / whole;
        Some(Barycentric::from_beta_gamma(beta as f32, gamma as f32))
    }

    /// The smallest box around the triangle.
    #[must_use]
    pub fn aabb(&self) -> Aabb {
        Aabb::from_points(self.corners())
    }
}

/// Barycentric coordinates α, β, γ of a point in the plane of a triangle, α + β + γ = 1 (L48).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Barycentric {
    /// α, the weight of corner a.
    pub alpha: f32,
    /// β, the weight of corner b.
    pub beta: f32,
    /// γ, the weight of corner c.
    pub gamma: f32,
}

impl Barycentric {
    /// Corner a.
    pub const A: Self = Self { alpha: 1.0, beta: 0.0, gamma: 0.0 };
    /// Corner b.
    pub const B: Self = Self { alpha: 0.0, beta: 1.0, gamma: 0.0 };
    /// Corner c.
    pub const C: Self = Self { alpha: 0.0, beta: 0.0, gamma: 1.0 };

    /// The coordinates with the given β and γ; α = 1 − β − γ (L48).
    #[must_use]
    pub fn from_beta_gamma(beta: f32, gamma: f32) -> Self {
        Self { alpha: 1.0 - beta - gamma, beta, gamma }
    }

    /// α·a + β·b + γ·c for anything that can be scaled and added: positions, normals, colours, numbers.
    #[must_use]
    pub fn interpolate<T>(&self, a: T, b: T, c: T) -> T
    where
        T: Mul<f32, Output = T> + Add<Output = T>,
    {
        a * self.alpha + b * self.beta + c * self.gamma
    }

    /// Whether the point lies strictly inside, as one slide has it: β > 0, γ > 0, β + γ < 1 (L49).
    ///
    /// `raytri` on a later slide includes the border (E10): the strict test misses a point on an edge that two
    /// triangles share, the inclusive one finds it twice.
    #[must_use]
    pub fn is_inside(&self) -> bool {
        self.beta > 0.0 && self.gamma > 0.0 && self.beta + self.gamma < 1.0
    }

    /// The coordinates as a vector (α, β, γ).
    #[must_use]
    pub fn to_vec3(self) -> Vec3 {
        Vec3::new(self.alpha, self.beta, self.gamma)
    }
}

impl Add for Barycentric {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            alpha: self.alpha + other.alpha,
            beta: self.beta + other.beta,
            gamma: self.gamma + other.gamma,
        }
    }
}

impl Mul<f32> for Barycentric {
    type Output = Self;
    fn mul(self, factor: f32) -> Self {
        Self { alpha: self.alpha * factor, beta: self.beta * factor, gamma: self.gamma * factor }
    }
}
