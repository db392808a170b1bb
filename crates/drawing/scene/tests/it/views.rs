//! What does a picture of another shape show, and where are the planes that nobody gave?

use scene::{Loaded, prepare};
use transforms::ViewVolume;

/// A ball of radius 1 at the origin, seen from z = 5 on 60 × 40 pixels, with `lens`; the volume of a picture of `size`.
fn volume(lens: &str, size: (u32, u32)) -> ViewVolume {
    let text = format!(
        "background = 0\n[render]\nsize = [60, 40]\n[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\nup = [0, 1, 0]\n{lens}\n\
         [[object]]\nshape = \"icosphere\"\nradius = 1.0\nlevel = 3\n"
    );
    let loaded = Loaded::from_toml(&text, "ball.toml", "".as_ref()).unwrap();
    prepare(&loaded).unwrap().pipeline(size.0, size.1).unwrap().volume()
}

#[test]
fn another_shape_shows_more_on_two_sides_and_never_less() {
    let lens = "window = { left = -0.5, right = 1.0, bottom = -0.25, top = 0.75 }\nnear = -1\nfar = -9";
    let sides = |size| {
        let ViewVolume { left, right, bottom, top, .. } = volume(lens, size);
        [left, right, bottom, top]
    };
    assert_eq!(sides((60, 40)), [-0.5, 1.0, -0.25, 0.75]);
    assert_eq!(sides((600, 400)), [-0.5, 1.0, -0.25, 0.75]);
    // Twice as wide: half a window more on either side of the middle, 0.25; then twice as high about 0.25.
    assert_eq!(sides((120, 40)), [-1.25, 1.75, -0.25, 0.75]);
    assert_eq!(sides((60, 80)), [-0.5, 1.0, -0.75, 1.25]);
}

#[test]
fn planes_that_nobody_gave_lie_around_what_is_there() {
    let planes = |lens: &str| {
        let ViewVolume { near, far, .. } = volume(lens, (60, 40));
        (near, far)
    };
    // The ball reaches from −4 to −6; a box around it does too, and a hundredth is added on both sides.
    let close = |got: (f32, f32), want: (f32, f32)| {
        // A mesh of level 3 reaches its radius at the corners on the axes, but for two roundings of 6.
        let apart = (got.0 - want.0).abs().max((got.1 - want.1).abs());
        assert!(apart <= 4.0 * 6.0 * f32::EPSILON, "{got:?}, not {want:?}");
    };
    close(planes("fov = 40"), (-0.99 * 4.0, -1.01 * 6.0));
    // A given plane stays. If all lies beyond the far plane, or before the near one, some depth is kept between them.
    close(planes("fov = 40\nnear = -2"), (-2.0, -1.01 * 6.0));
    close(planes("fov = 40\nfar = -5"), (-0.99 * 4.0, -5.0));
    close(planes("fov = 40\nfar = -2"), (-1.0, -2.0));
    close(planes("fov = 40\nnear = -50"), (-50.0, -100.0));
}
