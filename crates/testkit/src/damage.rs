//! What may have happened to a file before it is read? Anything. And the reader must neither panic nor hang.
//!
//! - [`Random`]: the same damage in every run and on every machine.
//! - [`text`] and [`bytes`]: a good file in, a damaged one out.
//! - [`none_hangs`]: does something with a thousand of them, and names the one that panics or never ends.
//!
//! ```
//! use testkit::damage::{self, Random};
//!
//! let lengths = damage::none_hangs(1000, |case| {
//!     let mut random = Random::new(case.into());
//!     let file = damage::text(b"size = 3.5\ncolor = red\n", &["[", "size"], &mut random);
//!     String::from_utf8_lossy(&file).lines().count()
//! });
//! assert_eq!(lengths.len(), 1000);
//! ```

use std::any::Any;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

/// Numbers that follow from a seed alone: SplitMix64 of Steele, Lea and Flood, *Fast Splittable Pseudorandom Number
/// Generators* (OOPSLA 2014).
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// Equal seeds give equal numbers; neighbouring seeds give numbers that have nothing to do with each other.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        // The generator goes from number to number by adding a constant; mixed, seeds lie far apart on that way.
        Self(mixed(seed))
    }

    /// Any of the 2⁶⁴ numbers.
    pub fn number(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        mixed(self.0)
    }

    /// A number of 0 ≤ x < `end`.
    ///
    /// # Panics
    /// If `end` is 0.
    pub fn below(&mut self, end: usize) -> usize {
        (self.number() % end as u64) as usize
    }

    /// One of `choices`.
    ///
    /// # Panics
    /// If there are none.
    pub fn pick<'a, T: ?Sized>(&mut self, choices: &[&'a T]) -> &'a T {
        choices[self.below(choices.len())]
    }
}

fn mixed(z: u64) -> u64 {
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// What stands in a file of which somebody wants to see what happens: numbers that are none, numbers beyond `f32`, `i32`,
/// `u32`, `i64` and `u64`, numbers of other notations; and harmless ones, which only are not what was meant.
pub const HOSTILE_NUMBERS: &[&str] = &[
    "0.25",
    "0.5",
    "1.0",
    "2",
    "3",
    "12",
    "-2.5",
    "100.0",
    "nan",
    "inf",
    "-inf",
    "1e39",
    "-1e38",
    "3.4e38",
    "-3.4e38",
    "1e-45",
    "1e400",
    "-1e999",
    "0",
    "-0.0",
    "-1",
    "-7",
    "3.5",
    "1e9",
    "-1e9",
    "1e-9",
    "256",
    "16384",
    "65535",
    "4294967296",
    "-4294967297",
    "9223372036854775807",
    "9223372036854775808",
    "-9223372036854775808",
    "18446744073709551615",
    "99999999999999999999",
    "0x7fffffff",
    "1_000",
    "1e",
    "+",
    ".",
    "-",
    "𝟙",
    "1,5",
];

/// A text with one injury, or in a third of all cases two or three: cut off, a bit flipped, a number (most often) or word
/// replaced, a word put in, a piece repeated elsewhere, two lines exchanged. Few, so that some damaged files can be read
/// and the damage gets to what is behind the reader. `words` are those of its format that are worth finding in a wrong place.
///
/// # Panics
/// If `words` is empty.
#[must_use]
pub fn text(good: &[u8], words: &[&str], random: &mut Random) -> Vec<u8> {
    let mut bytes = good.to_vec();
    let more = if random.below(3) == 0 { 1 + random.below(2) } else { 0 };
    for _ in 0..=more {
        if !bytes.is_empty() {
            injure_text(&mut bytes, words, random);
        }
    }
    bytes
}

fn injure_text(bytes: &mut Vec<u8>, words: &[&str], random: &mut Random) {
    let at = random.below(bytes.len());
    match random.below(12) {
        0 => bytes.truncate(at),
        1 => bytes[at] ^= 1 << random.below(8),
        2..=6 => replace_a_number(bytes, random),
        7 => replace_a_word(bytes, at, random.pick(words)),
        8 => drop(bytes.splice(at..at, random.pick(words).bytes())),
        9 => {
            let to = (at + random.below(30)).min(bytes.len());
            let (piece, place) = (bytes[at..to].to_vec(), random.below(bytes.len()));
            bytes.splice(place..place, piece);
        }
        _ => {
            let mut lines: Vec<_> = bytes.split(|byte| *byte == b'\n').map(<[u8]>::to_vec).collect();
            let (a, b) = (random.below(lines.len()), random.below(lines.len()));
            lines.swap(a, b);
            *bytes = lines.join(&b'\n');
        }
    }
}

fn replace_a_number(bytes: &mut Vec<u8>, random: &mut Random) {
    let is_part = |byte: &u8| byte.is_ascii_digit() || matches!(byte, b'.' | b'-');
    let starts: Vec<usize> =
        (1..bytes.len()).filter(|k| is_part(&bytes[*k]) && !is_part(&bytes[*k - 1])).collect();
    if !starts.is_empty() {
        let start = starts[random.below(starts.len())];
        let end = (start..bytes.len()).find(|k| !is_part(&bytes[*k])).unwrap_or(bytes.len());
        bytes.splice(start..end, random.pick(HOSTILE_NUMBERS).bytes());
    }
}

fn replace_a_word(bytes: &mut Vec<u8>, at: usize, by: &str) {
    let is_space = |byte: &u8| byte.is_ascii_whitespace();
    let start = bytes[..at].iter().rposition(is_space).map_or(0, |k| k + 1);
    let end = bytes[at..].iter().position(is_space).map_or(bytes.len(), |k| at + k);
    bytes.splice(start..end, by.bytes());
}

/// A binary file with one to four injuries: cut off, or a byte flipped in one bit, extreme, or anything. Half of them hit
/// the first `header` bytes, where the file says what follows.
///
/// # Panics
/// If `good` is empty or `header` is 0.
#[must_use]
pub fn bytes(good: &[u8], header: usize, random: &mut Random) -> Vec<u8> {
    let mut bytes = good.to_vec();
    for _ in 0..=random.below(4) {
        let reach = if random.below(2) == 0 { bytes.len() } else { bytes.len().min(header) };
        let at = random.below(reach);
        match random.below(8) {
            0 => bytes.truncate(at + 1),
            1 => bytes[at] = 0x00,
            2 => bytes[at] = 0x7f,
            3 => bytes[at] = 0xff,
            4 => bytes[at] = random.below(256) as u8,
            _ => bytes[at] ^= 1 << random.below(8),
        }
    }
    bytes
}

/// How long one case may run before it counts as hanging. The slowest cases of our tests take a tenth of a second; this
/// is far beyond what a busy machine makes of that, and far below forever.
const LONGEST: Duration = Duration::from_secs(300);

/// What `check` gives for the cases 0, 1, … `count` − 1, which run one after the other on a thread of their own.
///
/// # Panics
/// If a case panics, or still runs after five minutes: with its number.
#[track_caller]
pub fn none_hangs<T: Send + 'static>(count: u32, check: impl FnMut(u32) -> T + Send + 'static) -> Vec<T> {
    none_longer_than(LONGEST, count, check)
}

#[track_caller]
fn none_longer_than<T: Send + 'static>(
    longest: Duration,
    count: u32,
    check: impl FnMut(u32) -> T + Send + 'static,
) -> Vec<T> {
    let (sender, outcomes) = channel();
    // `try_for_each` ends when nobody listens any more.
    let worker = thread::spawn(move || (0..count).map(check).try_for_each(|outcome| sender.send(outcome)));
    let mut worker = Some(worker);
    let outcome = |case: u32| match outcomes.recv_timeout(longest) {
        Ok(outcome) => outcome,
        Err(RecvTimeoutError::Timeout) => panic!("case {case} still runs after {longest:?}"),
        Err(RecvTimeoutError::Disconnected) => {
            let cause = worker.take().and_then(|worker| worker.join().err());
            panic!("case {case} panicked: {}", cause.as_deref().map_or("", message))
        }
    };
    (0..count).map(outcome).collect()
}

fn message(cause: &(dyn Any + Send)) -> &str {
    let owned = cause.downcast_ref::<String>().map(String::as_str);
    owned.or_else(|| cause.downcast_ref::<&str>().copied()).unwrap_or("without a message")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_numbers_are_those_of_split_mix_64() {
        // The first numbers from state 0, as the reference implementation prints them.
        let mut random = Random(0);
        let numbers = [(); 3].map(|()| random.number());
        assert_eq!(numbers, [0xe220_a839_7b1d_cdaf, 0x6e78_9e6a_a1b9_65f4, 0x06c4_5d18_8009_454f]);
    }

    #[test]
    fn the_same_seed_does_the_same_damage_and_most_seeds_do_some() {
        let good = b"eye = [1, 2.5, -3]\nup = [0, 1, 0]\n";
        let all = |damage: fn(&[u8], &mut Random) -> Vec<u8>| -> Vec<_> {
            (0..100).map(|seed| damage(good, &mut Random::new(seed))).collect()
        };
        for damage in [
            |good: &[u8], random: &mut Random| text(good, &["eye", "["], random),
            |good: &[u8], random: &mut Random| bytes(good, 9, random),
        ] {
            let files = all(damage);
            assert_eq!(files, all(damage));
            assert!(files.iter().filter(|file| file[..] != good[..]).count() > 90);
        }
    }

    #[test]
    fn outcomes_come_in_the_order_of_the_cases() {
        assert_eq!(none_hangs(4, |case| 10 * case), [0, 10, 20, 30]);
    }

    #[test]
    #[should_panic(expected = "case 3 panicked: three is bad")]
    fn a_panic_names_its_case() {
        none_hangs(5, |case| assert!(case != 3, "{} is bad", "three"));
    }

    #[test]
    #[should_panic(expected = "case 2 still runs after 50ms")]
    fn a_case_that_hangs_is_named() {
        let forever = |case| {
            if case == 2 {
                thread::sleep(Duration::from_secs(3600));
            }
        };
        none_longer_than(Duration::from_millis(50), 5, forever);
    }
}
