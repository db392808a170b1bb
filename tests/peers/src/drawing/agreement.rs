//! Do they draw the same? Every pixel is compared, and what differs is counted.

use super::Picture;

/// Two colours are the same if no channel differs by more: a byte tells 1/256, of which its middle is at most half
/// away, and interpolation by steps along a row of 1920 pixels adds up as many roundings of 2⁻²⁴. Twice that.
const SAME_COLOR: f32 = 2.0 * (0.5 / 255.0 + 1920.0 / 16_777_216.0);

/// Two distances are the same if they differ by no more than this share. Depth is stored as z near 1 by some, of which
/// the last bit is worth 10⁻⁶ of the distance, and computed from a matrix of differences whose terms cancel to some
/// digits where triangles are small.
const SAME_DISTANCE: f32 = 1e-3;

/// What differs between two pictures of one scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Differences {
    /// Pixels of ours that show something.
    pub(crate) covered: usize,
    /// Pixels of ours on an outline: neighbours of pixels that are nearer or farther than one surface would be, or that
    /// show nothing.
    pub(crate) on_outlines: usize,
    /// Pixels that one covers and the other does not.
    pub(crate) coverage: usize,
    /// Pixels in which both see something, at another distance.
    pub(crate) distance: usize,
    /// Pixels in which both see the same surface in another colour.
    pub(crate) color: usize,
}

/// Compares pixel by pixel.
///
/// # Panics
/// If the sizes differ.
pub(crate) fn compare(ours: &Picture, peer: &Picture) -> Differences {
    assert_eq!((ours.width, ours.pixels.len()), (peer.width, peer.pixels.len()), "two sizes");
    let mut differences = Differences { on_outlines: outline(ours), ..Differences::default() };
    for (ours, peer) in ours.pixels.iter().zip(&peer.pixels) {
        differences.covered += usize::from(ours.is_some());
        match (ours, peer) {
            (None, None) => {}
            (Some(a), Some(b)) if (a.distance - b.distance).abs() > SAME_DISTANCE * a.distance => {
                differences.distance += 1;
            }
            (Some(a), Some(b)) => differences.color += usize::from(!same_color(a.color, b.color)),
            _ => differences.coverage += 1,
        }
    }
    differences
}

fn same_color(a: [f32; 3], b: [f32; 3]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a.clamp(0.0, 1.0) - b).abs() <= SAME_COLOR)
}

/// How many pixels have a neighbour to the right or below that lies on something else.
fn outline(picture: &Picture) -> usize {
    let distance = |at: usize| picture.pixels.get(at).copied().flatten().map(|seen| seen.distance);
    let apart = |a: Option<f32>, b: Option<f32>| match (a, b) {
        (Some(a), Some(b)) => (a - b).abs() > 10.0 * SAME_DISTANCE * a,
        (None, None) => false,
        _ => true,
    };
    let is_outline = |at: &usize| {
        let below = at + picture.width;
        let last_column = (at + 1).is_multiple_of(picture.width);
        (!last_column && apart(distance(*at), distance(at + 1)))
            || (below < picture.pixels.len() && apart(distance(*at), distance(below)))
    };
    (0..picture.pixels.len()).filter(is_outline).count()
}

impl Differences {
    /// Whether they are explained by rounding: `Err` says which are not.
    ///
    /// Ours moves corners to the nearest 1/256 of a pixel, by up to 1/512 in either direction, so that an outline that
    /// crosses a pixel sweeps over its sample in at most one case of 256; peers round less. Three times that for
    /// chance, and a dozen pixels where an outline is short.
    pub(crate) fn check(&self) -> Result<(), String> {
        let moved = 12 + self.on_outlines * 3 / 256;
        for (what, found, most) in [
            ("covered by one only", self.coverage, moved),
            ("at another distance", self.distance, moved),
            ("in another colour", self.color, moved),
        ] {
            if found > most {
                return Err(format!("{found} pixels {what}, where rounding explains {most}"));
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::Seen;
    use super::*;

    /// A wall at distance 2, with a post before it in the columns of `post`.
    fn picture(post: std::ops::Range<usize>) -> Picture {
        let seen = |x| Seen { color: [0.25; 3], distance: if post.contains(&x) { 1.0 } else { 2.0 } };
        Picture { width: 40, pixels: (0..40 * 30).map(|k| Some(seen(k % 40))).collect() }
    }

    #[test]
    fn equal_pictures_do_not_differ_and_have_their_outlines() {
        let found = compare(&picture(10..20), &picture(10..20));
        let expected = Differences { covered: 1200, on_outlines: 60, ..Differences::default() };
        assert_eq!(found, expected);
        assert_eq!(found.check(), Ok(()));
    }

    #[test]
    fn an_outline_moved_by_a_pixel_is_an_error() {
        let found = compare(&picture(10..20), &picture(11..20));
        assert_eq!((found.distance, found.coverage), (30, 0));
        assert!(found.check().unwrap_err().contains("at another distance"));
    }

    #[test]
    fn a_hole_and_another_colour_are_counted() {
        let mut peer = picture(10..20);
        peer.pixels[5] = None;
        for seen in peer.pixels[100..300].iter_mut().flatten() {
            seen.color[1] += 0.01;
        }
        let found = compare(&picture(10..20), &peer);
        assert_eq!((found.coverage, found.color), (1, 200));
        assert!(found.check().unwrap_err().contains("in another colour"));
    }
}
