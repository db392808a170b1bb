//! Which share of a class is judged here, if several machines judge it together?

use std::str::FromStr;

use crate::digest::Digest;

/// One share of several, written as nextest writes it: `1/3`, `count:1/3`, `slice:1/3`, `hash:1/3`.
///
/// - `count` (what is meant without a word): the first, the fourth, the seventh … submission.
/// - `slice`: the first third of the submissions.
/// - `hash`: those whose id hashes to it. A submission stays in its share when others come or go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Partition {
    by: By,
    /// From 1.
    part: usize,
    of: usize,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum By {
    Count,
    Slice,
    Hash,
}

/// It is not a share.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "a share is K/N with 1 ≤ K ≤ N: 2/8 is the second of eight; count:2/8, slice:2/8 and hash:2/8 say how to share"
)]
pub struct NoPartition;

impl Partition {
    /// Whether the submission of this id, at this place among so many, is in this share.
    pub fn holds(&self, id: &str, place: usize, count: usize) -> bool {
        let share = match self.by {
            By::Count => place % self.of,
            By::Slice => {
                // The first shares are larger by one where it does not come out even.
                let (each, more) = (count / self.of, count % self.of);
                let large = more * (each + 1);
                if place < large { place / (each + 1) } else { more + (place - large) / each.max(1) }
            }
            By::Hash => (Digest::of([id.as_bytes()]).number() % self.of as u64) as usize,
        };
        share == self.part - 1
    }

    /// Which one it is, from 1.
    pub fn part(&self) -> usize {
        self.part
    }

    /// Of how many.
    pub fn of(&self) -> usize {
        self.of
    }

    /// Whether the other one is a share by the same rule, so that each submission is in one share.
    pub fn shares_like(&self, other: &Self) -> bool {
        (self.by, self.of) == (other.by, other.of)
    }
}

impl FromStr for Partition {
    type Err = NoPartition;

    fn from_str(text: &str) -> Result<Self, NoPartition> {
        let (by, share) = match text.split_once(':') {
            None => (By::Count, text),
            Some(("count", share)) => (By::Count, share),
            Some(("slice", share)) => (By::Slice, share),
            Some(("hash", share)) => (By::Hash, share),
            Some(_) => return Err(NoPartition),
        };
        let (part, of) = share.split_once('/').ok_or(NoPartition)?;
        let (part, of) = (part.parse().map_err(|_| NoPartition)?, of.parse().map_err(|_| NoPartition)?);
        if 1 <= part && part <= of { Ok(Self { by, part, of }) } else { Err(NoPartition) }
    }
}

impl std::fmt::Display for Partition {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let by = match self.by {
            By::Count => "count",
            By::Slice => "slice",
            By::Hash => "hash",
        };
        write!(f, "{by}:{}/{}", self.part, self.of)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_submission_is_in_one_share() {
        for by in ["count", "slice", "hash"] {
            for of in 1..=7 {
                let shares: Vec<Partition> =
                    (1..=of).map(|part| format!("{by}:{part}/{of}").parse().unwrap()).collect();
                for count in 0..20 {
                    for place in 0..count {
                        let id = format!("student-{place}");
                        let holding = shares.iter().filter(|share| share.holds(&id, place, count)).count();
                        assert_eq!(holding, 1, "{by}, {place} of {count} in {of} shares");
                    }
                }
            }
        }
    }

    #[test]
    fn count_goes_round_and_slice_goes_through() {
        let of = |text: &str| -> Vec<usize> {
            let share: Partition = text.parse().unwrap();
            (0..7).filter(|place| share.holds("", *place, 7)).collect()
        };
        assert_eq!(of("2/3"), [1, 4]);
        assert_eq!(of("count:1/3"), [0, 3, 6]);
        assert_eq!(of("slice:1/3"), [0, 1, 2]);
        assert_eq!(of("slice:3/3"), [5, 6]);
    }

    #[test]
    fn what_is_no_share_is_refused() {
        for text in ["0/3", "4/3", "1", "1/0", "-1/3", "half:1/2", "1/3/5", ""] {
            assert!(text.parse::<Partition>().is_err(), "{text}");
        }
    }
}
