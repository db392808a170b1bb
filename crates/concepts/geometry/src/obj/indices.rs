//! Where does an index of a face point? Forwards from the first, or backwards from the latest.

use super::message::{ObjError, quoted};

/// A line that is being read.
#[derive(Clone, Copy)]
pub(super) struct Place<'a> {
    pub(super) file: &'a str,
    pub(super) line: usize,
}

impl Place<'_> {
    /// What is wrong on this line.
    pub(super) fn error(self, problem: impl Into<String>, remedy: impl Into<String>) -> ObjError {
        ObjError::new(self.file, Some(self.line), problem, remedy)
    }
}

/// What an index points to; the order is that of the indices of a corner.
#[derive(Clone, Copy)]
pub(super) enum Kind {
    Vertex,
    Texture,
    Normal,
}

const KINDS: [Kind; 3] = [Kind::Vertex, Kind::Texture, Kind::Normal];

impl Kind {
    fn keyword(self) -> &'static str {
        ["v", "vt", "vn"][self as usize]
    }

    fn name(self) -> &'static str {
        ["vertex", "texture coordinate", "normal"][self as usize]
    }
}

/// How many of each kind there are so far, and which indices pointed farther than that.
#[derive(Default)]
pub(super) struct Indices {
    counts: [u64; 3],
    ahead: Vec<(usize, Kind, u64)>,
}

const FORM: &str = "write a corner as v, v/vt, v//vn or v/vt/vn with whole numbers";

impl Indices {
    pub(super) fn add(&mut self, kind: Kind) {
        self.counts[kind as usize] += 1;
    }

    pub(super) fn count(&self, kind: Kind) -> u64 {
        self.counts[kind as usize]
    }

    /// The indices v, vt, vn of a corner, counted from 1.
    pub(super) fn corner(&mut self, word: &str, place: Place<'_>) -> Result<[Option<u64>; 3], ObjError> {
        let mut corner = [None; 3];
        for (slot, part) in word.split('/').enumerate() {
            let Some(kind) = KINDS.get(slot) else {
                let problem = format!("corner {} has more than three indices", quoted(word));
                return Err(place.error(problem, FORM));
            };
            if !part.is_empty() {
                corner[slot] = Some(self.index(*kind, part, place)?);
            }
        }
        match corner {
            [Some(_), ..] => Ok(corner),
            _ => Err(place.error(format!("corner {} has no vertex", quoted(word)), FORM)),
        }
    }

    fn index(&mut self, kind: Kind, part: &str, place: Place<'_>) -> Result<u64, ObjError> {
        let (name, count) = (kind.name(), self.count(kind));
        let Ok(index) = part.parse::<i64>() else {
            return Err(place.error(format!("index {} is not a whole number", quoted(part)), FORM));
        };
        let steps = index.unsigned_abs();
        match index {
            0 => Err(place.error(format!("{name} 0"), "indices count from 1, or from -1 for the latest")),
            1.. => {
                if steps > count {
                    self.ahead.push((place.line, kind, steps));
                }
                Ok(steps)
            }
            _ if steps <= count => Ok(count - steps + 1),
            _ => {
                let problem = format!("{name} {index}, but only {count} came before this line");
                let none = format!("put '{}' lines before the face", kind.keyword());
                let some = format!("-1 is the latest, -{count} the first");
                Err(place.error(problem, if count == 0 { none } else { some }))
            }
        }
    }

    /// Looks at the indices that pointed ahead, when all is counted.
    pub(super) fn check_ahead(&self, file: &str) -> Result<(), ObjError> {
        let is_beyond = |(_, kind, index): &&(usize, Kind, u64)| *index > self.count(*kind);
        let Some(&(line, kind, index)) = self.ahead.iter().find(is_beyond) else {
            return Ok(());
        };
        let (count, keyword) = (self.count(kind), kind.keyword());
        let problem = format!("{} {index}, but the file has only {count}", kind.name());
        let none = format!("add '{keyword}' lines");
        let some = format!("use 1 to {count}, or add the missing '{keyword}' lines");
        Err(Place { file, line }.error(problem, if count == 0 { none } else { some }))
    }
}
