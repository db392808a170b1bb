//! What do letters and words mean, and what did printing lose? (E17, E18)

use canvas::{Image, Rgb, row_from_j};
use glam::{Vec3, vec3};
use lighting::{Highlight, Light, Material, SurfacePoint, lit};
use zbuffer::{DepthBuffer, DepthFormat};

use crate::sample::Sequence;
use crate::{Claim, Examination, Trial, Verdict, judge, measured, text, versions};

/// What each letter stands for on the slides, and what the code calls it.
pub(super) const LETTERS: [(&str, &[(&str, &str)]); 8] = [
    ("e", &[("the eye's position (L1, L46)", "eye"), ("the direction to the eye (L31)", "to_eye")]),
    (
        "c",
        &[
            ("a colour (L26)", "color"),
            ("a triangle's third corner (L48)", "c"),
            ("a basis vector (L11)", "w"),
        ],
    ),
    (
        "b",
        &[
            ("the window's lower side (L3)", "bottom"),
            ("a triangle's second corner (L48)", "b"),
            ("the right-hand side of Ax = b (L50)", "rhs"),
            ("a basis vector (L11)", "v"),
        ],
    ),
    ("t", &[("the place on a ray (L46)", "t"), ("the window's upper side (L3)", "top")]),
    (
        "n",
        &[
            ("the near plane (L2)", "near"),
            ("a normal (L26)", "n"),
            ("the number of pixels n_x (L4)", "width"),
        ],
    ),
    (
        "r",
        &[
            ("the window's right side (L3)", "right"),
            ("the reflected direction (L31)", "reflect"),
            ("a ray (L53)", "ray"),
        ],
    ),
    ("l", &[("the window's left side (L3)", "left"), ("the direction to the light (L26)", "to_light")]),
    ("p", &[("a point (L46)", "point"), ("the Phong exponent (L31)", "exponent")]),
];

pub(super) static ONE_LETTER: Claim = Claim {
    number: "E17",
    name: "one-letter-many-meanings",
    quote: "e, c, b, t, n, r, l, p",
    translation: "e, c, b, t, n, r, l, p",
    truth: text(
        "Eight letters have twenty-one meanings between them: names in the code say which.",
        "Acht letters hebben samen eenentwintig betekenissen: namen in de code zeggen welke.",
    ),
    expected: Verdict::Refuted,
    code: &["transforms::ViewVolume", "lighting::SurfacePoint", "geometry::Triangle"],
    examine: || {
        let trials: Vec<Trial> = LETTERS
            .iter()
            .map(|(letter, meanings)| {
                let list: Vec<_> = meanings.iter().map(|(meaning, _)| *meaning).collect();
                Trial::new(meanings.len() == 1, format!("{letter} is {}", list.join(", ")))
            })
            .collect();
        let count = |(letter, meanings): &(&str, &[_])| format!("{letter} {}", meanings.len());
        let meanings: Vec<_> = LETTERS.iter().map(count).collect();
        let total: usize = LETTERS.iter().map(|(_, meanings)| meanings.len()).sum();
        let names = names();
        judge("each letter means one thing", None, &trials).compared(
            "how many things the letters mean",
            format!("{total} meanings of {} letters: {}", LETTERS.len(), meanings.join(", ")),
            format!("{} names: {}", names.len(), names.join(", ")),
        )
    },
    pictures: None,
    versions: Some(versions::one_letter),
};

/// What the code calls all those things.
pub(super) fn names() -> Vec<&'static str> {
    let mut names: Vec<&str> =
        LETTERS.iter().flat_map(|(_, list)| list.iter().map(|(_, name)| *name)).collect();
    names.sort_unstable();
    names.dedup();
    names
}

pub(super) static MATT: Claim = Claim {
    number: "E18",
    name: "matt-is-absorbed",
    quote: "deels geabsorbeerd (mat oppervlak)",
    translation: "in part absorbed (matt surface)",
    truth: text(
        "Matt means scattered, not absorbed: a matt white wall sends back most of its light, to all sides. What absorbs is dark.",
        "Mat betekent verstrooid, niet geabsorbeerd: een matte witte muur geeft het meeste licht terug, naar alle kanten. Wat absorbeert is donker.",
    ),
    expected: Verdict::Refuted,
    code: &["lighting::lit", "lighting::Material::matt"],
    examine: || {
        let trials: Vec<Trial> = [0.2, 0.5, 0.8]
            .into_iter()
            .map(|c_r| {
                let back = sent_back(c_r);
                // As the slide has it, matt is what absorbs: less than a tenth would come back.
                Trial::new(back < 0.1, format!("matt with c_r = {c_r}: {back:.2} of the light comes back"))
            })
            .collect();
        judge("a matt surface absorbs the light", None, &trials).compared(
            "a matt white wall, c_r = 0.8, light head-on",
            "all absorbed, 0 sent back",
            format!("{:.2} scattered, {:.2} absorbed", sent_back(0.8), 1.0 - sent_back(0.8)),
        )
    },
    pictures: None,
    versions: Some(versions::matt),
};

/// The share of the light that a matt surface sends back: the mean of what is seen, over directions weighted by their cosine.
pub(super) fn sent_back(c_r: f32) -> f32 {
    let lights = [Light::Directional { to_light: Vec3::Z, color: Rgb::ONE }];
    let mut random = Sequence::new(131);
    let samples = (0..500).map(|_| {
        // A point of the unit disc, lifted to the hemisphere: its density is that of the cosine.
        let (angle, square) = (random.between(0.0, std::f32::consts::TAU), random.between(0.0, 1.0));
        let to_eye = vec3(square.sqrt() * angle.cos(), square.sqrt() * angle.sin(), (1.0 - square).sqrt());
        let at = SurfacePoint { p_world: Vec3::ZERO, n: Vec3::Z, to_eye };
        lit(&Material::matt(Rgb::splat(c_r)), &lights, Highlight::Phong, &at, |_| true).x
    });
    samples.sum::<f32>() / 500.0
}

/// The first grid as printed.
pub(super) const FIRST_GRID: [[u8; 6]; 4] = [[0; 6]; 4];

pub(super) static LOST_ROW: Claim = Claim {
    number: "E18",
    name: "grid-lost-a-row",
    quote: "1: 0 0 0 0 0 0 / 0 0 0 0 0 0 / 0 0 0 0 0 0 / 0 0 0 0 0 0",
    translation: "the first of the four depth grids, with four rows",
    truth: text(
        "The cleared buffer has five rows of six zeros, like the grids that follow.",
        "De lege buffer heeft vijf rijen van zes nullen, net als de roosters erna.",
    ),
    expected: Verdict::Refuted,
    code: &["zbuffer::DepthBuffer::new"],
    examine: || {
        let empty_rows = cleared_rows();
        let same = FIRST_GRID.len() == empty_rows;
        measured(same, format!("{} rows printed, {empty_rows} in the buffer", FIRST_GRID.len())).compared(
            "the depth grid before the first polygon",
            format!("{} rows of zeros", FIRST_GRID.len()),
            format!("{empty_rows} rows of nothing"),
        )
    },
    pictures: None,
    versions: Some(versions::lost_row),
};

/// The rows without any depth of a cleared buffer.
pub(super) fn cleared_rows() -> usize {
    let cleared = DepthBuffer::new(6, 5, DepthFormat::F32);
    (0..cleared.height()).filter(|j| (0..cleared.width()).all(|i| cleared.get(i, *j).is_none())).count()
}

pub(super) static ROWS: Claim = Claim {
    number: "E18",
    name: "rows-run-down",
    quote: "Elke pixel (i, j) op scherm tussen [−0.5, n_x − 0.5] × [−0.5, n_y − 0.5]",
    translation: "each pixel (i, j) on the screen, with j upwards; the depth grids are printed from the top down",
    truth: text(
        "j counts upwards, rows of grids and files count down: row = n_y − 1 − j, in one place.",
        "j telt omhoog, rijen van roosters en bestanden tellen omlaag: rij = n_y − 1 − j, op één plek.",
    ),
    expected: Verdict::Refuted,
    code: &["canvas::row_from_j", "canvas::Image"],
    examine: rows,
    pictures: None,
    versions: Some(versions::rows),
};

/// The row, from the top, in which a picture of this height stores pixel (1, j).
pub(super) fn row_of(j: u32, height: u32) -> u32 {
    let mut image = Image::new(3, height, Rgb::ZERO);
    image.set(1, j, Rgb::ONE);
    image.pixels().iter().position(|pixel| *pixel == Rgb::ONE).map_or(0, |k| k as u32 / 3)
}

fn rows() -> Examination {
    let height = 4;
    let row_of = |j: u32| row_of(j, height);
    let trials: Vec<Trial> = (0..height)
        .map(|j| {
            Trial::new(
                row_of(j) == j,
                format!("pixel (1, {j}) is in row {} of {height} from the top", row_of(j)),
            )
        })
        .collect();
    judge("pixel (i, j) stands in row j of the printed grid", None, &trials).compared(
        "the lowest pixels, j = 0, of a picture of 4 rows",
        "row 0",
        format!("row {} from the top, {} by row_from_j", row_of(0), row_from_j(0, height)),
    )
}
