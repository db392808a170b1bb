//! Do rays hit the same? Every answer is compared, and what differs is counted.

/// Two places on a ray are the same if they differ by no more than this share: a test of rays and triangles in 32-bit
/// numbers loses a few bits where a ray grazes.
const SAME_PLACE: f32 = 1e-4;

/// One ray of so many may be answered otherwise: where it passes an edge of the silhouette, or an edge between two
/// triangles, within rounding. A silhouette pixel of 1024 × 1024 is 2·10⁻³ wide and rounding moves an edge by 10⁻⁶ of
/// the ball, so of some thousand silhouette rays one or two in a million come out otherwise; tests that are not
/// watertight lose as many again between triangles. Ten times that.
const RAYS_TO_ONE_OTHERWISE: usize = 50_000;

/// What differs between two lists of answers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Differences {
    /// How many rays there are.
    pub(super) rays: usize,
    /// How many of them hit something, by ours.
    pub(super) hits: usize,
    /// Only ours hits.
    pub(super) only_ours: usize,
    /// Only the peer's hits.
    pub(super) only_theirs: usize,
    /// Both hit, at different places.
    pub(super) elsewhere: usize,
}

/// Compares t by t; infinite is a miss.
pub(super) fn compare(ours: &[f32], theirs: &[f32]) -> Differences {
    let mut found = Differences { rays: ours.len(), ..Differences::default() };
    for (ours, theirs) in ours.iter().zip(theirs) {
        found.hits += usize::from(ours.is_finite());
        match (ours.is_finite(), theirs.is_finite()) {
            (true, true) => found.elsewhere += usize::from((ours - theirs).abs() > SAME_PLACE * ours),
            (true, false) => found.only_ours += 1,
            (false, true) => found.only_theirs += 1,
            (false, false) => {}
        }
    }
    found
}

impl Differences {
    /// Whether they are explained by rounding.
    pub(super) fn check(&self) -> Result<(), String> {
        let found = self.only_ours + self.only_theirs + self.elsewhere;
        let most = 2 + self.rays / RAYS_TO_ONE_OTHERWISE;
        if found <= most {
            return Ok(());
        }
        Err(format!("{found} rays of {} see something else, where rounding explains {most}", self.rays))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MISS: f32 = f32::INFINITY;

    #[test]
    fn each_way_to_differ_is_counted_by_itself() {
        let found = compare(&[1.0, 2.0, MISS, 3.0, MISS, 4.0], &[1.000_01, MISS, 5.0, 3.1, MISS, 4.0]);
        let expected = Differences { rays: 6, hits: 4, only_ours: 1, only_theirs: 1, elsewhere: 1 };
        assert_eq!(found, expected);
        assert!(found.check().unwrap_err().contains("3 rays of 6"));
        assert_eq!(Differences { only_theirs: 0, ..found }.check(), Ok(()));
    }
}
