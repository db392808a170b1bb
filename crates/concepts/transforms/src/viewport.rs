//! Which pixel is it? The canonical square meets the pixels (L4), and the pixels meet the window (L8, L9).
//!
//! Pixel (i, j) covers [i−½, i+½] × [j−½, j+½], so the screen is [−½, n_x−½] × [−½, n_y−½]; j runs upwards.

use glam::{Mat3, Mat4, Vec2, vec2, vec3};

use crate::{ViewVolume, affine2};

/// V (L4): from the canonical cube to the screen; z stays as it is.
///
/// Scale by (n_x/2, n_y/2, 1), then translate by ((n_x−1)/2, (n_y−1)/2, 0).
///
/// # Panics
/// If `width` or `height` is 0.
///
/// ```
/// use glam::vec3;
/// use transforms::viewport::screen_from_canonical;
///
/// let v = screen_from_canonical(640, 480);
/// assert_eq!(v.transform_point3(vec3(-1.0, -1.0, 0.25)), vec3(-0.5, -0.5, 0.25));
/// assert_eq!(v.transform_point3(vec3(1.0, 1.0, 0.25)), vec3(639.5, 479.5, 0.25));
/// ```
#[must_use]
pub fn screen_from_canonical(width: u32, height: u32) -> Mat4 {
    assert!(width > 0 && height > 0, "a screen of {width} × {height} pixels has no pixels");
    let (n_x, n_y) = (width as f32, height as f32);
    let scale = Mat4::from_scale(vec3(0.5 * n_x, 0.5 * n_y, 1.0));
    Mat4::from_translation(vec3(0.5 * (n_x - 1.0), 0.5 * (n_y - 1.0), 0.0)) * scale
}

/// The window transform (L8), 3×3: from pixels (i, j, 1) to the window [l, r] × [b, t] on the view plane.
///
/// translate(l, b) · scale((r−l)/n_x, (t−b)/n_y) · translate(½, ½). The slide's last factor has a 0 in the corner where
/// a 1 belongs (E14): with it, no pixel would ever be moved by (l, b). The volume is not checked
/// ([`ViewVolume::validate`]).
///
/// # Panics
/// If `width` or `height` is 0.
#[must_use]
pub fn window_from_pixel(volume: &ViewVolume, width: u32, height: u32) -> Mat3 {
    assert!(width > 0 && height > 0, "a screen of {width} × {height} pixels has no pixels");
    let pixel_size =
        vec2((volume.right - volume.left) / width as f32, (volume.top - volume.bottom) / height as f32);
    affine2::translate(vec2(volume.left, volume.bottom))
        * affine2::scale(pixel_size)
        * affine2::translate(Vec2::splat(0.5))
}

/// (u_s, v_s): where the ray through a point of the screen crosses the window (L9).
///
/// u_s = l + (r−l)(i+½)/n_x, v_s = b + (t−b)(j+½)/n_y. `pixel` is (i, j), whole numbers for the centres of pixels.
///
/// # Panics
/// If `width` or `height` is 0.
///
/// ```
/// use glam::vec2;
/// use transforms::{ViewVolume, viewport::window_point};
///
/// let volume = ViewVolume { left: -2.0, right: 2.0, bottom: -1.0, top: 3.0, near: -1.0, far: -9.0 };
/// assert_eq!(window_point(&volume, 8, 4, vec2(7.0, 0.0)), vec2(1.75, -0.5));
/// ```
#[must_use]
pub fn window_point(volume: &ViewVolume, width: u32, height: u32, pixel: Vec2) -> Vec2 {
    assert!(width > 0 && height > 0, "a screen of {width} × {height} pixels has no pixels");
    vec2(
        volume.left + (volume.right - volume.left) * (pixel.x + 0.5) / width as f32,
        volume.bottom + (volume.top - volume.bottom) * (pixel.y + 0.5) / height as f32,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_slides_window_matrix_loses_the_corner_of_the_window() {
        // E14: the printed translation by (½, ½) has 0 in its corner.
        let slide_half = Mat3::from_cols(vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), vec3(0.5, 0.5, 0.0));
        let volume = ViewVolume { left: -2.0, right: 4.0, bottom: -1.0, top: 3.0, near: -1.0, far: -9.0 };
        let slide =
            affine2::translate(vec2(-2.0, -1.0)) * affine2::scale(vec2(6.0 / 12.0, 4.0 / 8.0)) * slide_half;
        let pixel = vec3(3.0, 5.0, 1.0);
        assert_eq!(slide * pixel, vec3(1.75, 2.75, 0.0)); // shifted by nothing, and at infinity
        assert_eq!(window_from_pixel(&volume, 12, 8) * pixel, vec3(-0.25, 1.75, 1.0));
    }
}
