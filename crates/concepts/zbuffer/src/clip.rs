//! Which part of a triangle can be on the screen? The rest is cut off before the division by w.
//!
//! Behind the eye w changes its sign, and at the height of the eye it is 0: dividing first would fold what lies behind the
//! viewer onto the picture. So a triangle is cut in clip space, where it is still flat and its edges straight.
//!
//! Visible points have clip **w < 0** here (E2): near, z ≤ +1 after the division, reads z ≥ w before it, and far reads z ≤ −w.

use geometry::{Barycentric, Triangle};
use glam::{DVec2, DVec3, DVec4, Mat4};

use crate::screen::{ScreenTriangle, ScreenVertex};

/// The longest side, in pixels, of a screen that [`project`] accepts.
pub const GREATEST_SIDE: u32 = 1 << 15;

/// How far from the screen's origin a projected vertex may lie, in pixels: twice as far as the largest screen reaches.
///
/// Well within [`GREATEST_PIXEL`](crate::screen::GREATEST_PIXEL): up to here an `f32` still tells 1/256 pixels apart, so
/// that cutting moves no edge by more than snapping does.
pub const GUARD_BAND: f64 = (1 << 16) as f64;

/// A triangle has 3 corners, and each of the 6 planes can add one.
const MOST_VERTICES: usize = 9;

/// What of `triangle` lies between the near and the far plane, on a screen of `width` × `height` pixels (L5).
///
/// - `clip_from_world`: S · C · P · R · T, [`transforms::Pipeline::clip_from_world`]; visible points get w < 0 (E2). A
///   parallel projection has w = 1 everywhere: negate its matrix, which changes no point after the division.
/// - `triangle`: in world space, either side, any size.
///
/// The result is empty if nothing is left, or if a corner is not finite in clip space. Parts to the left or right, above
/// or below the screen are not cut unless they lie beyond [`GUARD_BAND`]. An edge that two triangles share is cut
/// at the same points, bit for bit, in both: no crack opens.
///
/// ```
/// use geometry::Triangle;
/// use glam::{Vec3, vec3};
/// use transforms::{Camera, Pipeline, ViewVolume};
/// use zbuffer::project;
///
/// let camera = Camera::look_at(vec3(0.0, 0.0, 0.0), vec3(0.0, 0.0, -1.0), Vec3::Y)?;
/// let volume = ViewVolume { left: -1.0, right: 1.0, bottom: -1.0, top: 1.0, near: -1.0, far: -9.0 };
/// let clip_from_world = Pipeline::new(camera, volume, 200, 100)?.clip_from_world();
/// // One corner lies behind the eye: a quadrilateral is left, two triangles.
/// let triangle = Triangle::new(vec3(-2.0, -1.0, -4.0), vec3(2.0, -1.0, -5.0), vec3(0.0, 1.0, 3.0));
/// assert_eq!(project(&clip_from_world, 200, 100, &triangle).triangles().count(), 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Panics
/// If `width` or `height` is 0 or more than [`GREATEST_SIDE`].
#[must_use]
pub fn project(clip_from_world: &Mat4, width: u32, height: u32, triangle: &Triangle) -> ScreenPolygon {
    // From the world to clip space.
    // In 64 bits: rounding z and w to 32 would cost as much as a step of a 24-bit depth buffer.
    let clip_from_world = clip_from_world.as_dmat4();
    let corners = triangle.corners().map(|p_world| clip_from_world * p_world.as_dvec3().extend(1.0));
    project_clip(corners, width, height)
}

/// As [`project`], from corners that are in clip space already: a mesh transforms a shared vertex only once.
///
/// # Panics
/// If `width` or `height` is 0 or more than [`GREATEST_SIDE`].
#[must_use]
pub fn project_clip(corners: [DVec4; 3], width: u32, height: u32) -> ScreenPolygon {
    let viewport = Viewport::new(width, height);
    if !corners.iter().all(|corner| corner.is_finite()) {
        return ScreenPolygon::EMPTY;
    }
    let mut polygon = ClipPolygon::triangle(corners);
    // Cut, in clip space, while edges are still straight.
    for plane in viewport.planes() {
        polygon.cut(plane);
    }
    // Divide by w, and go to pixels.
    viewport.screen_polygon(&polygon)
}

/// What clipping left of a triangle: a convex polygon of up to nine vertices on the screen, in the triangle's order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScreenPolygon {
    vertices: [ScreenVertex; MOST_VERTICES],
    count: usize,
}

impl ScreenPolygon {
    const EMPTY: Self = Self {
        vertices: [ScreenVertex { position: DVec3::ZERO, inv_w: 0.0, weights: Barycentric::A };
            MOST_VERTICES],
        count: 0,
    };

    /// The vertices: none, or at least three.
    #[must_use]
    pub fn vertices(&self) -> &[ScreenVertex] {
        &self.vertices[..self.count]
    }

    /// The polygon as triangles that fan out from its first vertex, all in its orientation.
    pub fn triangles(self) -> impl Iterator<Item = ScreenTriangle> {
        let [apex, ..] = self.vertices;
        (2..self.count)
            .map(move |k| ScreenTriangle { vertices: [apex, self.vertices[k - 1], self.vertices[k]] })
    }
}

/// The way from clip space to pixels, per axis: pixel = half_size · canonical + center (L4).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Viewport {
    pub(crate) half_size: DVec2,
    pub(crate) center: DVec2,
}

impl Viewport {
    pub(crate) fn new(width: u32, height: u32) -> Self {
        let sides = 1..=GREATEST_SIDE;
        assert!(
            sides.contains(&width) && sides.contains(&height),
            "no screen can have {width} × {height} pixels"
        );
        let size = DVec2::new(width.into(), height.into());
        Self { half_size: 0.5 * size, center: 0.5 * (size - 1.0) }
    }

    /// How far x/w and y/w may be from 0: half_size · x/w + center ≤ GUARD_BAND. The band is symmetric about the screen's
    /// middle.
    pub(crate) fn guard(&self) -> DVec2 {
        (GUARD_BAND - self.center) / self.half_size
    }

    /// The planes of the clipped volume: inside is where plane · (x, y, z, w) ≥ 0.
    fn planes(&self) -> [DVec4; 6] {
        // Times −w > 0.
        let guard = self.guard();
        [
            DVec4::new(0.0, 0.0, 1.0, -1.0),
            DVec4::new(0.0, 0.0, -1.0, -1.0),
            DVec4::new(1.0, 0.0, 0.0, -guard.x),
            DVec4::new(-1.0, 0.0, 0.0, -guard.x),
            DVec4::new(0.0, 1.0, 0.0, -guard.y),
            DVec4::new(0.0, -1.0, 0.0, -guard.y),
        ]
    }

    fn screen_polygon(&self, polygon: &ClipPolygon) -> ScreenPolygon {
        let mut screen = ScreenPolygon { count: polygon.count, ..ScreenPolygon::EMPTY };
        for (to, from) in screen.vertices.iter_mut().zip(polygon.vertices()) {
            let Some(vertex) = self.screen_vertex(from) else {
                return ScreenPolygon::EMPTY;
            };
            *to = vertex;
        }
        screen
    }

    /// `None` if the division fails: the volume has one such point, the eye itself, where all of x, y, z, w are 0.
    fn screen_vertex(&self, vertex: &ClipVertex) -> Option<ScreenVertex> {
        let inv_w = 1.0 / vertex.position.w;
        let canonical = vertex.position.truncate() * inv_w;
        let pixel = self.half_size * canonical.truncate() + self.center;
        // A vertex that was cut lies on its plane but for rounding.
        let pixel = pixel.clamp(DVec2::splat(-GUARD_BAND), DVec2::splat(GUARD_BAND));
        let position = on_grid(pixel.extend(canonical.z.clamp(-1.0, 1.0)));
        let DVec3 { x, y, z } = vertex.weights;
        let weights = Barycentric { alpha: x as f32, beta: y as f32, gamma: z as f32 };
        let vertex = ScreenVertex { position, inv_w: inv_w as f32, weights };
        (inv_w < 0.0 && vertex.inv_w.is_finite() && position.is_finite()).then_some(vertex)
    }
}

/// A number added to a position and subtracted again rounds it to multiples of 2⁻³² pixel, since f64 has no finer ones between 2²⁰ and
/// 2²¹: x and y up to [`GUARD_BAND`] stay below that.
pub(crate) const PIXEL_GRID: f64 = 1.5 * (1 << 20) as f64;

/// The same for depths, to multiples of 2⁻⁴⁸.
pub(crate) const DEPTH_GRID: f64 = 1.5 * (1 << 4) as f64;

/// Rounds a position to a grid so fine that no depth buffer shows it. Differences of positions are then exact, and what snapping
/// leaves over fits in 32 bits, where the fast version keeps it.
fn on_grid(position: DVec3) -> DVec3 {
    let grid = DVec3::new(PIXEL_GRID, PIXEL_GRID, DEPTH_GRID);
    position + grid - grid
}

/// A vertex in clip space. In 64 bits, so that where an edge is cut does not depend on how far away its ends are.
#[derive(Clone, Copy)]
struct ClipVertex {
    position: DVec4,
    /// α, β, γ in the source triangle: affine in clip space.
    weights: DVec3,
}

/// A convex polygon in clip space.
struct ClipPolygon {
    vertices: [ClipVertex; MOST_VERTICES],
    count: usize,
}

impl ClipPolygon {
    const EMPTY: Self = Self {
        vertices: [ClipVertex { position: DVec4::ZERO, weights: DVec3::ZERO }; MOST_VERTICES],
        count: 0,
    };

    fn triangle(corners: [DVec4; 3]) -> Self {
        let mut polygon = Self::EMPTY;
        for (corner, weights) in corners.into_iter().zip(DVec3::AXES) {
            polygon.push(ClipVertex { position: corner, weights });
        }
        polygon
    }

    fn vertices(&self) -> &[ClipVertex] {
        &self.vertices[..self.count]
    }

    /// A convex polygon crosses a plane at most twice. Where rounding makes it seem otherwise, the surplus vertices lie
    /// on the plane but for rounding, and can be left out.
    fn push(&mut self, vertex: ClipVertex) {
        if self.count < MOST_VERTICES {
            self.vertices[self.count] = vertex;
            self.count += 1;
        }
    }

    /// Keeps what lies inside the plane (Sutherland–Hodgman).
    fn cut(&mut self, plane: DVec4) {
        if self.vertices().iter().all(|v| plane.dot(v.position) >= 0.0) {
            return;
        }
        let mut kept = Self::EMPTY;
        for (k, &to) in self.vertices().iter().enumerate() {
            let from = self.vertices[(k + self.count - 1) % self.count];
            let (d_from, d_to) = (plane.dot(from.position), plane.dot(to.position));
            match (d_from >= 0.0, d_to >= 0.0) {
                (true, true) => kept.push(to),
                (true, false) => kept.push(crossing(from, d_from, to, d_to)),
                (false, true) => {
                    kept.push(crossing(to, d_to, from, d_from));
                    kept.push(to);
                }
                (false, false) => {}
            }
        }
        *self = kept;
    }
}

/// Where the edge from `inside` to `outside` meets the plane; `d_in` ≥ 0 > `d_out` are the plane's values there.
///
/// Always computed from the inside out, whichever way the triangle runs along the edge: two triangles that share it get
/// the same point.
fn crossing(inside: ClipVertex, d_in: f64, outside: ClipVertex, d_out: f64) -> ClipVertex {
    let (share_in, share_out) = (d_out / (d_out - d_in), d_in / (d_in - d_out));
    ClipVertex {
        position: share_in * inside.position + share_out * outside.position,
        weights: share_in * inside.weights + share_out * outside.weights,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{Vec3, vec3};
    use transforms::{Camera, Pipeline, ViewVolume, projection, viewport::screen_from_canonical};

    const VOLUME: ViewVolume =
        ViewVolume { left: -1.0, right: 1.0, bottom: -1.0, top: 1.0, near: -2.0, far: -10.0 };

    fn clip_from_world() -> Mat4 {
        let camera = Camera::look_at(Vec3::ZERO, vec3(0.0, 0.0, -1.0), Vec3::Y).unwrap();
        Pipeline::new(camera, VOLUME, 200, 100).unwrap().clip_from_world()
    }

    #[test]
    fn the_viewport_is_that_of_the_lecture() {
        let v = screen_from_canonical(200, 100);
        let clip = [vec3(0.25, -0.5, 0.5), vec3(1.0, 0.0, -0.5), vec3(0.0, 0.75, 0.25)];
        let polygon = project_clip(clip.map(|p| p.as_dvec3().extend(1.0) * -1.0), 200, 100);
        let positions: Vec<Vec3> =
            polygon.vertices().iter().map(|vertex| vertex.position.as_vec3()).collect();
        assert_eq!(positions, clip.map(|p| v.transform_point3(p)));
    }

    #[test]
    fn the_part_before_the_near_plane_is_cut_off() {
        // From (0, 0, −6), inside, to (0, 4, 2), behind the eye: half-way, at z = −2, is the near plane.
        let t = Triangle::new(vec3(0.0, 0.0, -6.0), vec3(3.0, 0.0, -6.0), vec3(0.0, 4.0, 2.0));
        let polygon = project(&clip_from_world(), 200, 100, &t);
        let weights: Vec<_> = polygon.vertices().iter().map(|v| v.weights.to_vec3()).collect();
        let expected = [vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), vec3(0.0, 0.5, 0.5), vec3(0.5, 0.0, 0.5)];
        // The order starts with the last corner's edge; as a cycle it is that of the triangle.
        let start = weights.iter().position(|w| *w == Vec3::X).unwrap();
        let cycle: Vec<_> = (0..4).map(|k| weights[(start + k) % 4]).collect();
        for (got, want) in cycle.iter().zip(expected) {
            assert!((*got - want).length() < 1e-6, "{cycle:?}");
        }
        let nearest = polygon.vertices().iter().filter(|v| v.weights.gamma > 0.4);
        for v in nearest {
            assert_eq!(v.position.z, 1.0);
            assert!((v.inv_w + 0.5).abs() < 1e-6, "{v:?}");
        }
    }

    #[test]
    fn dividing_first_folds_what_lies_behind_the_eye_onto_the_picture() {
        // Two units behind the eye, up to the left; it would show below to the right, in the middle of the depths.
        let behind = vec3(-0.3, 0.4, 2.0);
        let folded = clip_from_world().project_point3(behind);
        assert!(folded.x > 0.0 && folded.y < 0.0 && folded.truncate().abs().max_element() < 1.0, "{folded}");
        let t = Triangle::new(behind, behind + 0.1 * Vec3::X, behind + 0.1 * Vec3::Y);
        assert!(project(&clip_from_world(), 200, 100, &t).vertices().is_empty());
    }

    #[test]
    fn a_parallel_projection_is_drawn_with_its_matrix_negated() {
        let parallel = projection::orthographic(&VOLUME);
        let t = Triangle::new(vec3(0.0, 0.0, -4.0), vec3(0.5, 0.0, -4.0), vec3(0.0, 0.5, -8.0));
        assert!(project(&parallel, 200, 100, &t).vertices().is_empty());
        let polygon = project(&(parallel * -1.0), 200, 100, &t);
        assert_eq!(polygon.vertices()[1].position.as_vec3(), vec3(149.5, 49.5, 0.5));
    }

    #[test]
    fn corners_that_are_not_finite_leave_nothing() {
        let t = Triangle::new(vec3(0.0, f32::NAN, -4.0), vec3(1.0, 0.0, -4.0), vec3(0.0, 1.0, -4.0));
        assert!(project(&clip_from_world(), 200, 100, &t).triangles().next().is_none());
    }
}
