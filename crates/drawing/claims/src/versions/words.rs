//! What do letters and words say, and what is so? (E17, E18)

use shading::Shading;

use super::version;
use crate::Version;
use crate::shaded::{mean_error, sphere};
use crate::words::{FIRST_GRID, LETTERS, cleared_rows, names, row_of, sent_back};
use figures::Words;

/// Eight letters, and the names that the code has for what they mean.
pub(crate) fn one_letter() -> [Version; 2] {
    let letters = LETTERS.map(|(letter, _)| letter).join(", ");
    let meanings: usize = LETTERS.iter().map(|(_, meanings)| meanings.len()).sum();
    let (count, names) = (LETTERS.len(), names());
    let many = names.len();
    [
        version(
            letters.as_str(),
            format!("{count} letters for {meanings} things"),
            format!("{count} letters voor {meanings} dingen"),
        ),
        version(
            names.join(", ").as_str(),
            format!("{many} names for {meanings} things"),
            format!("{many} namen voor {meanings} dingen"),
        ),
    ]
}

/// A white wall that is matt.
pub(crate) fn matt() -> [Version; 2] {
    let white = |says: Words, c_r: f32| {
        let back = sent_back(c_r);
        version(
            says,
            format!("c_r = {c_r}: {back:.2} of the light comes back"),
            format!("c_r = {c_r}: {back:.2} van het licht komt terug"),
        )
    };
    [
        white(Words::new("matt is absorbed: like c_r = 0", "mat is geabsorbeerd: als c_r = 0"), 0.0),
        white(Words::new("matt is scattered: a white wall", "mat is verstrooid: een witte muur"), 0.8),
    ]
}

/// The depth grid before the first polygon.
pub(crate) fn lost_row() -> [Version; 2] {
    let grid = |says: Words, rows: usize| {
        version(says, format!("{rows} rows of 6 zeros"), format!("{rows} rijen van 6 nullen"))
    };
    let slide = Words::new("the first grid as printed", "het eerste rooster zoals gedrukt");
    let ours = Words::new("a cleared buffer of 6 × 5 pixels", "een lege buffer van 6 × 5 pixels");
    [grid(slide, FIRST_GRID.len()), grid(ours, cleared_rows())]
}

/// The lowest pixels of a picture of four rows.
pub(crate) fn rows() -> [Version; 2] {
    const HEIGHT: u32 = 4;
    let lowest = |says: Words, row: u32| {
        version(
            says,
            format!("j = 0 of {HEIGHT} rows, the lowest: row {row} from the top"),
            format!("j = 0 van {HEIGHT} rijen, de onderste: rij {row} van boven"),
        )
    };
    let printed = Words::new("pixel (i, j) stands in row j", "pixel (i, j) staat in rij j");
    let j = 0;
    [lowest(printed, j), lowest("n_y − 1 − j".into(), row_of(j, HEIGHT))]
}

/// The error that the repeated caption describes, and that of the figure under which it stands.
pub(crate) fn caption() -> [Version; 2] {
    let error = |says: Words, shading: Shading, en: &str, nl: &str| {
        let mean = mean_error(&sphere(1), shading);
        version(
            says,
            format!("a ball of 80 triangles, {en}: mean error {mean:.4}"),
            format!("een bol van 80 driehoeken, {nl}: gemiddelde fout {mean:.4}"),
        )
    };
    [
        error(
            Words::new("interpolation artifacts are visible", "interpolatie-artefacten zijn zichtbaar"),
            Shading::Gouraud,
            "per vertex, which that describes",
            "per vertex, waar dat bij hoort",
        ),
        error(
            Words::new("per-fragment: the artifacts are gone", "per fragment: de artefacten zijn weg"),
            Shading::Phong,
            "per fragment",
            "per fragment",
        ),
    ]
}
