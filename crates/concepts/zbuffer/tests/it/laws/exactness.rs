//! Depth is that of the surface under the pixel's center: snapping decides coverage and nothing else.

use geometry::{Barycentric, Mesh, Triangle};
use glam::{DMat3, DVec3, I64Vec2, Mat4, Vec3, dvec3, vec3};
use proptest::prelude::*;
use testkit::{Law, ensure};
use transforms::{Camera, Pipeline, ViewVolume};
use zbuffer::fast::{Band, Faces, MeshInstance, Projected};
use zbuffer::{DepthBuffer, DepthFormat, ScreenTriangle, ScreenVertex, project, rasterize};

use super::{HEIGHT, WIDTH, fragments};

/// The greatest height of triangles that may have a snapped corner beside them by more than their range of depths: √2/512.
const THINNEST: f64 = std::f64::consts::SQRT_2 / 512.0;

/// A vertex at a multiple of 2⁻¹⁶ pixel, seldom on the grid of 1/256, with a depth that is a multiple of 2⁻⁴⁰.
type Place = (I64Vec2, i64);

const PLACES: i64 = 1 << 16;
const DEPTHS: i64 = 1 << 40;

fn place() -> impl Strategy<Value = Place> + Clone {
    let coordinate = |side: u32| -10 * PLACES..(i64::from(side) + 10) * PLACES;
    (coordinate(WIDTH), coordinate(HEIGHT), -DEPTHS..=DEPTHS).prop_map(|(x, y, z)| (I64Vec2::new(x, y), z))
}

/// Triangles of any shape, and slivers: three corners near a line through a pixel's center, by less than `width` times 2⁻¹⁶ pixel.
fn corners() -> impl Strategy<Value = [Place; 3]> {
    let any = [place(), place(), place()];
    let sliver = |width: i64| {
        let aside = prop::array::uniform6(-width..=width);
        let depths = prop::array::uniform3(-DEPTHS..=DEPTHS);
        let pixel = (2..i64::from(WIDTH) - 2, 2..i64::from(HEIGHT) - 2);
        let direction = (-9 * PLACES..9 * PLACES, -9 * PLACES..9 * PLACES);
        (pixel, direction, -64..64_i64, aside, depths).prop_map(|((i, j), (x, y), share, aside, z)| {
            let (center, direction) = (I64Vec2::new(i, j) * PLACES, I64Vec2::new(x, y));
            let corner = |k: usize, share: i64| {
                (center + direction * share / 64 + I64Vec2::new(aside[2 * k], aside[2 * k + 1]), z[k])
            };
            [corner(0, -64), corner(1, 64), corner(2, share)]
        })
    };
    prop_oneof![2 => any, 2 => sliver(6000), 2 => sliver(400)]
}

fn on_screen(corners: [Place; 3]) -> ScreenTriangle {
    let weights = [Barycentric::A, Barycentric::B, Barycentric::C];
    let vertex = |k: usize| {
        let (p, z) = corners[k];
        let position = (p.as_dvec2() / PLACES as f64).extend(z as f64 / DEPTHS as f64);
        ScreenVertex { position, inv_w: -1.0, weights: weights[k] }
    };
    ScreenTriangle { vertices: [0, 1, 2].map(vertex) }
}

/// Twice the area of abc in whole numbers.
fn area(a: I64Vec2, b: I64Vec2, c: I64Vec2) -> i128 {
    let (u, v) = (b - a, c - a);
    i128::from(u.x) * i128::from(v.y) - i128::from(u.y) * i128::from(v.x)
}

/// The depth of the plane at a pixel's center: a fraction of whole numbers, rounded once.
fn exact_depth([a, b, c]: [Place; 3], (i, j): (u32, u32)) -> f64 {
    let p = I64Vec2::new(i.into(), j.into()) * PLACES;
    let weighted = |weight: i128, z: i64| weight * i128::from(z);
    let sum = weighted(area(b.0, c.0, p), a.1)
        + weighted(area(c.0, a.0, p), b.1)
        + weighted(area(a.0, b.0, p), c.1);
    // Both are below 2⁹⁷; rounding them to f64 costs 2⁻⁵³ each.
    sum as f64 / area(a.0, b.0, c.0) as f64 / DEPTHS as f64
}

#[test]
fn depth_is_that_of_the_plane_that_was_projected_and_not_of_the_one_that_was_snapped() {
    Law::new(
        "a fragment's depth is that of the plane through the unsnapped vertices, but for a few roundings",
    )
    .cases(4000)
    .demand("slivers below a tenth of a pixel", 0.1)
    .demand("slivers below 1/362 pixel", 0.02)
    .demand("a center beside the triangle", 0.02)
    .demand("interpolating between the snapped corners is wrong by a step of 24 bits", 0.5)
    .holds_for(corners(), |corners, seen| {
        let triangle = on_screen(corners);
        let drawn = fragments(&triangle);
        let [a, b, c] = corners.map(|corner| corner.0);
        let doubled_area = area(a, b, c);
        let longest =
            [b - a, c - b, a - c].map(|side| side.as_dvec2().length()).into_iter().fold(0.0, f64::max);
        let (longest, height) =
            (longest / PLACES as f64, doubled_area.abs() as f64 / longest / PLACES as f64);
        let z = triangle.vertices.map(|v| v.position.z);
        let (least, greatest) = (z[0].min(z[1]).min(z[2]), z[0].max(z[1]).max(z[2]));
        let range = greatest - least;
        seen.class("slivers below a tenth of a pixel", height < 0.1 && !drawn.is_empty());
        seen.class("slivers below 1/362 pixel", height < THINNEST && !drawn.is_empty());
        // As `zbuffer::plane` derives it. 2⁻⁵¹: sums of three terms up to 3, and this test's own fraction.
        let moved = (THINNEST / height).min(1.0) * range;
        let bound = 2.0_f64.powi(-48) * (1.0 + longest / height) * moved + 3.0 * 2.0_f64.powi(-51);
        let snapped = ScreenTriangle {
            vertices: triangle.vertices.map(|v| ScreenVertex {
                position: (v.snapped().as_dvec2() / 256.0).extend(v.position.z),
                ..v
            }),
        };
        let by_snapped = fragments(&snapped);
        for (f, snapped) in drawn.iter().zip(&by_snapped) {
            let p = I64Vec2::new(f.i.into(), f.j.into()) * PLACES;
            let is_beside =
                [area(a, b, p), area(b, c, p), area(c, a, p)].iter().any(|side| side * doubled_area < 0);
            seen.class("a center beside the triangle", is_beside);
            ensure(least - moved <= f.z + bound && f.z - bound <= greatest + moved, || {
                format!("{f:?} leaves {least}..{greatest} by more than {moved}")
            })?;
            if height < THINNEST {
                continue;
            }
            let exact = exact_depth(corners, (f.i, f.j));
            seen.class(
                "interpolating between the snapped corners is wrong by a step of 24 bits",
                (snapped.z - exact).abs() > 2.0_f64.powi(-23),
            );
            ensure((f.z - exact).abs() <= bound, || format!("{f:?}, but {exact} ± {bound:e} is right"))?;
        }
        Ok(())
    });
}

/// The depths of a plane of the world under the pixels of a picture, without a screen position: where clip coordinates are
/// z = s · (x, y, w), canonical depth is s · (x/w, y/w, 1).
struct Surface {
    s: DVec3,
    width: f64,
    height: f64,
}

impl Surface {
    fn new(view: &Pipeline, triangle: &Triangle) -> Self {
        let clip_from_world = view.clip_from_world().as_dmat4();
        let clip = triangle.corners().map(|p| clip_from_world * p.as_dvec3().extend(1.0));
        let rows = DMat3::from_cols_array_2d(&clip.map(|c| [c.x, c.y, c.w])).transpose();
        let s = rows.inverse() * DVec3::from_array(clip.map(|c| c.z));
        Self { s, width: view.width().into(), height: view.height().into() }
    }

    fn depth(&self, i: u32, j: u32) -> f64 {
        let canonical = |pixel: u32, side: f64| (2.0 * f64::from(pixel) + 1.0) / side - 1.0;
        self.s.dot(dvec3(canonical(i, self.width), canonical(j, self.height), 1.0))
    }

    /// How much depth changes from pixel to pixel, along x and y together.
    fn slope(&self) -> f64 {
        2.0 * (self.s.x.abs() / self.width + self.s.y.abs() / self.height)
    }
}

#[test]
fn depth_is_that_of_the_surface_in_the_world() {
    // Near, far and tilted: from 1 to 400 units away, at the eye's feet and on the horizon.
    let corner = (-1.0_f32..1.0, -1.0_f32..1.0, 0.0_f32..6.0).prop_map(|(x, y, d)| {
        let d = d.exp();
        vec3(3.0 + x * d, -2.0 + y * d, 5.0 - d)
    });
    let camera =
        Camera::look_at(vec3(3.0, -2.0, 5.0), vec3(3.1, -2.2, -4.0), Vec3::Y).expect("a fixed camera");
    let volume = ViewVolume { left: -0.9, right: 0.8, bottom: -0.7, top: 0.6, near: -0.8, far: -500.0 };
    let view = Pipeline::new(camera, volume, WIDTH, HEIGHT).expect("a valid volume");
    Law::new("a fragment's depth is that of the surface that the ray through the pixel's center meets")
        .cases(2000)
        .demand("drawn", 0.4)
        .demand("steep", 0.2)
        .holds_for([corner.clone(), corner.clone(), corner], |[a, b, c], seen| {
            let triangle = Triangle::new(a, b, c);
            let surface = Surface::new(&view, &triangle);
            // Vertices lie on a grid of 2⁻³² pixel and 2⁻⁴⁸ in depth: half of that each, and as much again for roundings in 64 bits
            // of positions up to 2¹⁶. Slivers count it by 1 / height; those below a hundredth of a pixel are left to the law above.
            for piece in project(&view.clip_from_world(), WIDTH, HEIGHT, &triangle).triangles() {
                let [p, q, r] = piece.vertices.map(|v| v.position.truncate());
                let longest = (q - p).length().max((r - q).length()).max((p - r).length());
                let height = (q - p).perp_dot(r - p).abs() / longest;
                if height < 0.01 {
                    continue;
                }
                let drawn = fragments(&piece);
                seen.class("drawn", !drawn.is_empty());
                seen.class("steep", !drawn.is_empty() && surface.slope() > 0.05);
                let bound = 2.0_f64.powi(-30) * surface.slope() + 2.0_f64.powi(-44) * (1.0 + 1.0 / height);
                for f in drawn {
                    let exact = surface.depth(f.i, f.j);
                    ensure((f.z - exact).abs() <= bound, || format!("{f:?}, not {exact} ± {bound:e}"))?;
                }
            }
            Ok(())
        });
}

/// Two parallel quadrilaterals ten units away, tilted by some degrees; the second lies a little in front of the first.
struct Tilted {
    view: Pipeline,
    mesh: Mesh,
}

impl Tilted {
    fn new(degrees: f32, gap: f64, half: (f64, f64), turn: f64) -> Self {
        let camera = Camera::look_at(vec3(0.0, 0.0, 10.0), Vec3::ZERO, Vec3::Y).expect("a fixed camera");
        let volume = ViewVolume { left: -0.4, right: 0.4, bottom: -0.3, top: 0.3, near: -1.0, far: -100.0 };
        let view = Pipeline::new(camera, volume, 320, 240).expect("a valid volume");
        let axis = dvec3(turn.cos(), turn.sin(), 0.0);
        let tilt = DMat3::from_axis_angle(axis, f64::from(degrees).to_radians());
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        let quad = |z: f64| {
            corners.map(|(x, y)| (tilt * dvec3(x * half.0, y * half.1, 0.0) + z * DVec3::Z).as_vec3())
        };
        let positions = [quad(0.0), quad(gap)].concat();
        let mesh =
            Mesh::new(positions, vec![[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]]).expect("a valid mesh");
        Self { view, mesh }
    }

    /// For each pixel of both the nearer triangle by the slide's loop: how many there are, and in how many it is one of the farther two.
    fn slide(&self, format: DepthFormat) -> (usize, usize) {
        let mut depth = DepthBuffer::new(320, 240, format);
        let (mut shown, mut covered) = (vec![0; 320 * 240], vec![[false; 2]; 320 * 240]);
        for k in 0..4 {
            for piece in project(&self.view.clip_from_world(), 320, 240, &self.mesh.triangle(k)).triangles() {
                rasterize(&piece, 320, 240, |f| {
                    let pixel = (f.j * 320 + f.i) as usize;
                    covered[pixel][k / 2] = true;
                    if depth.test_and_set(f.i, f.j, f.z) {
                        shown[pixel] = k;
                    }
                });
            }
        }
        let both = covered.iter().zip(&shown).filter(|(covered, _)| **covered == [true; 2]);
        (both.clone().count(), both.filter(|(_, shown)| **shown < 2).count())
    }

    /// The same by the fast loop, but for pixels of one alone.
    fn fast(&self) -> usize {
        let parts = [MeshInstance { mesh: &self.mesh, world_from_object: Mat4::IDENTITY }];
        let (mut projected, mut band) = (Projected::default(), Band::default());
        projected.project(&parts, &self.view, Faces::Both);
        let mut wrong = 0;
        for b in 0..projected.bands() {
            band.draw(b, &projected, &parts);
            let shown =
                band.rows().flat_map(|row| band.row(row).map(|(number, _)| number).collect::<Vec<_>>());
            wrong += shown.filter(|number| *number < 2).count();
        }
        wrong
    }

    /// Pixels of the farther one, and those whose depth in 24 bits is not the exact depth in 24 bits.
    fn off_in_24_bits(&self) -> (usize, usize) {
        let surface = Surface::new(&self.view, &self.mesh.triangle(0));
        let code = |z: f64| DepthFormat::Bits24.code(z);
        let (mut all, mut off) = (0, 0);
        for k in 0..2 {
            for piece in project(&self.view.clip_from_world(), 320, 240, &self.mesh.triangle(k)).triangles() {
                rasterize(&piece, 320, 240, |f| {
                    all += 1;
                    off += usize::from(code(f.z) != code(surface.depth(f.i, f.j)));
                });
            }
        }
        (all, off)
    }
}

#[test]
fn of_two_tilted_quadrilaterals_the_nearer_is_seen() {
    // A hundred-thousandth of a unit at 70° and a ten-thousandth at 85° are more than a step of 24 bits wherever they are.
    for (degrees, gap) in [(70.0, 1e-5), (85.0, 1e-4)] {
        for (half, turn) in [((3.0, 3.0), 0.0), ((4.5, 3.0), 0.3), ((4.0, 2.9), 1.1), ((2.7, 2.9), 1.57)] {
            let scene = Tilted::new(degrees, gap, half, turn);
            for format in [DepthFormat::F32, DepthFormat::Bits24] {
                let (both, wrong) = scene.slide(format);
                assert!(both > 3000, "only {both} pixels at {degrees}°");
                assert_eq!(wrong, 0, "of {both} pixels at {degrees}° about {turn}, {format:?}");
            }
        }
    }
}

#[test]
fn the_fast_version_sees_the_nearer_of_two_tilted_quadrilaterals_too() {
    // Both fill the picture: no pixel is covered by one alone.
    for (degrees, gap) in [(70.0, 1e-5), (85.0, 1e-4)] {
        let scene = Tilted::new(degrees, gap, (3.0, 3.0), 0.4);
        let (both, _) = scene.slide(DepthFormat::F32);
        let wrong = scene.fast();
        // Along the rim snapping gives a few pixels to the farther one alone.
        assert!(wrong <= both / 200, "{wrong} of {both} at {degrees}°");
    }
}

#[test]
fn depth_in_24_bits_is_the_exact_depth_in_24_bits() {
    for degrees in [30.0, 70.0, 85.0] {
        for turn in [0.0, 0.3, 1.1] {
            let (all, off) = Tilted::new(degrees, 0.0, (4.5, 3.0), turn).off_in_24_bits();
            // Mesa differs in 2474 of 63,948 pixels. Here vertices in 64 bits leave errors of 2⁻³² steps times the slope.
            assert!(all > 3000 && off * 63_948 <= all * 2474, "{off} of {all} at {degrees}° about {turn}");
            assert!(off * 1000 <= all, "{off} of {all} at {degrees}° about {turn}");
        }
    }
}
