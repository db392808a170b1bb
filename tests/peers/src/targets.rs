//! What is to be reached? How many times as fast as each peer, by a table of times measured once, on one machine with
//! two processors, the peers compiled for it (`-C target-cpu=native`): what a peer took there, over what we set out to
//! take there.

/// Milliseconds a frame: scene, shading, euc 0.5, retrofire 0.4, to reach.
const FRAMES: [(&str, &str, f64, f64, f64); 6] = [
    ("1M", "Gouraud", 78.5, 213.0, 39.0),
    ("69k", "Gouraud", 30.7, 17.7, 8.8),
    ("fill", "Gouraud", 238.0, 54.8, 19.0),
    ("1M", "Phong", 96.6, 243.0, 48.0),
    ("69k", "Phong", 57.1, 38.2, 13.0),
    ("fill", "Phong", 510.0, 485.0, 30.0),
];

/// Million rays a second: scene, kind, obvhs 0.4, parry3d 0.31, to reach.
const RAYS: [(&str, &str, f64, f64, f64); 6] = [
    ("69k", "primary", 4.7, 3.6, 12.0),
    ("69k", "random", 1.45, 1.3, 4.3),
    ("69k", "shadow", 4.2, 3.3, 10.0),
    ("1M", "primary", 3.0, 2.4, 8.0),
    ("1M", "random", 0.6, 0.5, 1.7),
    ("1M", "shadow", 2.65, 2.2, 6.0),
];

/// How many times as fast as `peer` a frame should be.
pub(crate) fn frame(scene: &str, shading: &str, peer: &str) -> Option<f64> {
    let (_, _, euc, retrofire, ours) = FRAMES.into_iter().find(|row| (row.0, row.1) == (scene, shading))?;
    [("euc", euc / ours), ("retrofire", retrofire / ours)]
        .into_iter()
        .find_map(|(name, r)| (name == peer).then_some(r))
}

/// How many times as fast as `peer` rays should be.
pub(crate) fn rays(scene: &str, kind: &str, peer: &str) -> Option<f64> {
    let (_, _, obvhs, parry, ours) = RAYS.into_iter().find(|row| (row.0, row.1) == (scene, kind))?;
    [("obvhs", ours / obvhs), ("parry3d", ours / parry)]
        .into_iter()
        .find_map(|(name, r)| (name == peer).then_some(r))
}

/// How many times as fast two threads should be as one, for a picture that takes one of them more than [`LONG`]
/// milliseconds.
pub(crate) const TWO_THREADS: f64 = 1.9;
/// Below this a picture is too short to be shared out well.
pub(crate) const LONG: f64 = 50.0;
/// Most milliseconds for a frame of a live view: a quarter of what 60 a second leave.
pub(crate) const LIVE: f64 = 4.0;
/// Most megabytes for mesh and hierarchy of a million triangles, and for a picture beside its buffers.
pub(crate) const MEGABYTES_OF_A_MILLION: f64 = 100.0;
pub(crate) const MEGABYTES_BESIDE_BUFFERS: f64 = 64.0;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_target_is_the_peers_time_over_ours() {
        assert_eq!(frame("1M", "Gouraud", "euc"), Some(78.5 / 39.0));
        assert_eq!(frame("fill", "Phong", "retrofire"), Some(485.0 / 30.0));
        assert_eq!(rays("69k", "shadow", "obvhs"), Some(10.0 / 4.2));
        assert_eq!(rays("1M", "random", "parry3d"), Some(1.7 / 0.5));
        assert_eq!((frame("1M", "Flat", "euc"), rays("1M", "random", "euc")), (None, None));
    }
}
