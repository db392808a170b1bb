//! The lecture's sentences and the slides' errors, each tried by running code.
//!
//! A [`Claim`] examines itself: it tries the sentence on many inputs, or measures. [`judge`] reaches the [`Verdict`]; only the
//! expected verdict is written down, so that a change in the code that changes a verdict is noticed.

#![forbid(unsafe_code)]

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;

mod cost;
mod depth;
mod diffuse;
mod flat;
mod highlight;
mod highlight_errors;
mod judgement;
mod occlusion;
mod pros_and_cons;
mod ray_errors;
mod ray_pictures;
mod rays;
mod sample;
mod samples;
mod shaded;
mod stage;
mod transform_errors;
mod transform_laws;
mod versions;
mod window_errors;
mod words;

pub use judgement::{Evidence, Examination, Trial, Verdict, judge, measured};

use figures::{Drawing, Text, Words};

/// A sentence of the slides and what becomes of it.
#[derive(Debug)]
pub struct Claim {
    /// The item or error of the lecture: `E3`, `L26`.
    pub number: &'static str,
    /// A name of its own, in lower case with dashes: one item may hold several claims.
    pub name: &'static str,
    /// The slide's words, in Dutch, or its formula; short.
    pub quote: &'static str,
    /// The same in English.
    pub translation: &'static str,
    /// What is true, in a sentence; with the condition, if there is one.
    pub truth: Text,
    /// The verdict that the run must reach.
    pub expected: Verdict,
    /// The functions that produced the evidence: `lighting::blinn_highlight`.
    pub code: &'static [&'static str],
    /// Runs the slide's version beside the right one, or measures.
    pub examine: fn() -> Examination,
    /// The slide's version and the right one as pictures, where it can be seen.
    pub pictures: Option<fn() -> figures::Drawn>,
    /// The slide's version and the right one, run on one input: for an error of the slides that no pictures show.
    pub versions: Option<fn() -> [Version; 2]>,
}

/// What one side says, and what comes of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Version {
    /// The formula or the sentence.
    pub says: Words,
    /// What it gives on the input, computed here and now.
    pub gives: Words,
}

/// A claim after its run.
#[derive(Debug)]
pub struct Report {
    /// What was examined.
    pub claim: &'static Claim,
    /// What came out.
    pub examination: Examination,
}

impl Report {
    /// Whether the verdict is the expected one, and the right version passed wherever it was tried.
    #[must_use]
    pub fn is_as_expected(&self) -> bool {
        self.examination.verdict == self.claim.expected && self.examination.right_holds
    }
}

impl Claim {
    /// Runs it.
    #[must_use]
    pub fn run(&'static self) -> Report {
        Report { claim: self, examination: (self.examine)() }
    }

    /// What its files are called by: `E3-claim-h-n-always-positive`; a figure may have the name too.
    #[must_use]
    pub fn stem(&self) -> String {
        format!("{}-claim-{}", self.number, self.name)
    }

    /// Whether `asked` means this claim: its number, its name or its stem, in any case.
    #[must_use]
    pub fn is_called(&self, asked: &str) -> bool {
        [self.number, self.name].iter().any(|name| name.eq_ignore_ascii_case(asked))
            || self.stem().eq_ignore_ascii_case(asked)
    }
}

/// Every claim: those of the items in the order of the lecture, then the errors.
#[must_use]
pub fn all() -> Vec<&'static Claim> {
    let mut claims: Vec<&'static Claim> = ALL.to_vec();
    claims.sort_by_key(|claim| figures::lecture_order(claim.number));
    claims
}

/// The claims that a number or a name means.
#[must_use]
pub fn find(asked: &str) -> Vec<&'static Claim> {
    all().into_iter().filter(|claim| claim.is_called(asked)).collect()
}

static ALL: &[&Claim] = &[
    &transform_laws::CAMERA_IS_RIGID,
    &transform_laws::DEPTH_ORDER,
    &transform_laws::LINES,
    &transform_laws::BOX_TO_CUBE,
    &transform_laws::CAMERA_FRAME,
    &transform_laws::ROTATION_ABOUT_A_POINT,
    &transform_laws::CHANGE_OF_BASIS,
    &transform_laws::INVERSE_CHANGE,
    &transform_errors::ORDER_OF_FACTORS,
    &transform_errors::R_MINUS_ONE,
    &transform_errors::CLIP_W_NEGATIVE,
    &transform_errors::OPENGL,
    &window_errors::WINDOW_POINT,
    &window_errors::CORNER,
    &transform_errors::HANDEDNESS,
    &occlusion::PAINTER,
    &occlusion::SORTED_BY_DEPTH,
    &occlusion::CYCLES,
    &occlusion::DRAWN_LAST,
    &occlusion::ORDER_OF_DRAWING,
    &occlusion::FOUR_GRIDS,
    &pros_and_cons::MEMORY,
    &pros_and_cons::HARDWARE,
    &pros_and_cons::ANY_NUMBER,
    &pros_and_cons::SIMPLE,
    &pros_and_cons::TRANSPARENCY,
    &pros_and_cons::FIGHTING,
    &depth::INTERPOLATED,
    &depth::NEAR_SIMILAR,
    &depth::TWO_LOOPS,
    &depth::CAMERA_DEPTH,
    &depth::SAVED_DEPTH,
    &depth::SHADED_AGAIN,
    &samples::INSIDE,
    &samples::STRICT,
    &samples::INCLUSIVE,
    &diffuse::THREE_PARTS,
    &diffuse::SUM,
    &diffuse::SAME_FROM_EVERYWHERE,
    &diffuse::COSINE,
    &diffuse::FACING_AWAY,
    &diffuse::BLACK_SHADOWS,
    &diffuse::ANGLE,
    &diffuse::NO_FALLOFF,
    &diffuse::BETWEEN_0_AND_1,
    &highlight::LIGHTS_COLOUR,
    &highlight::MAY_BE_NEGATIVE,
    &highlight::TOO_WIDE,
    &highlight::NARROWER,
    &highlight::HALFWAY,
    &highlight::EMPIRICAL,
    &highlight::LOCAL,
    &highlight_errors::ALWAYS_POSITIVE,
    &highlight_errors::A_NUMBER,
    &highlight_errors::REFLECTED_LEAKS,
    &highlight_errors::SAME_HIGHLIGHT,
    &cost::R_IS_EXPENSIVE,
    &shaded::GOURAUD_IS_AFFINE,
    &shaded::FINER_MESH,
    &shaded::PHONG_SHADING,
    &shaded::MISSED_HIGHLIGHT,
    &shaded::TWO_PHONGS,
    &shaded::NOT_UNIT,
    &rays::FIRST_HIT,
    &rays::PICKING,
    &rays::RAY_ENDS,
    &rays::NEARER_AND_BEHIND,
    &rays::THE_SYSTEM,
    &rays::THREE_SOLVERS,
    &rays::VIEW_VOLUME,
    &rays::EARLY_EXITS,
    &rays::WORKED_EXAMPLE,
    &ray_errors::PARALLEL,
    &ray_errors::RETURNS_NO_T,
    &ray_errors::SHADOW_FROM_ZERO,
    &ray_errors::BEYOND_THE_LAMP,
    &ray_errors::VIEWING_INTERVAL,
    &ray_pictures::RENDER_LOOP,
    &ray_pictures::SHADOW_RAYS,
    &ray_pictures::RAYCOLOR,
    &ray_pictures::RECURSION_ENDS,
    &ray_pictures::SNELL,
    &words::ONE_LETTER,
    &shaded::CAPTION,
    &words::MATT,
    &words::LOST_ROW,
    &words::ROWS,
];

/// The same words in English and Dutch.
const fn text(en: &'static str, nl: &'static str) -> Text {
    Text { en, nl }
}

/// The slide's version beside the right one.
pub(crate) fn pair(slide: Drawing, right: Drawing) -> figures::Drawn {
    Ok(vec![slide, right])
}
