//! A thousand mutilated files: each ends in an error or in pictures, none in a panic or a hang.

use std::fs;
use std::path::Path;

use scene::{Loaded, Renderer, Settings, Shading, load, prepare, render};

const SCENE: &str = include_str!("hostile/scene.toml");
const MESH: &str = include_str!("hostile/mesh.obj");
const MATERIALS: &str = include_str!("hostile/mesh.mtl");

const CASES: u32 = 1000;

/// A mutilated level can ask for a million triangles, which is allowed but takes its time in a test.
const MOST_TRIANGLES: usize = 20_000;

/// What stands in files of which somebody wants to see what happens.
const HOSTILE_NUMBERS: [&str; 20] = [
    "nan",
    "inf",
    "-inf",
    "1e39",
    "-1e38",
    "1e-45",
    "0",
    "-0.0",
    "-1",
    "4294967296",
    "0x7fffffff",
    "1e9",
    "-1e9",
    "1e-9",
    "99999999999999999999",
    "3.5",
    "16384",
    "-7",
    "1e400",
    "65535",
];

/// Steele and Vigna's SplitMix64: a seed, and the same numbers on every machine.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, n: usize) -> usize {
        (self.next() % n.max(1) as u64) as usize
    }
}

#[test]
fn a_thousand_mutilated_files_end_in_an_error_or_a_picture() {
    let folder = tempfile::tempdir().unwrap();
    let mut random = Random(0x5ce7e);
    let (mut errors, mut pictures) = (0, 0);
    for case in 0..CASES {
        let mut files = [("scene.toml", SCENE), ("mesh.obj", MESH), ("mesh.mtl", MATERIALS)]
            .map(|(name, text)| (name, text.as_bytes().to_vec()));
        // Every other time the scene, else the mesh or its materials.
        let victim = [0, 1, 0, 2][case as usize % 4];
        for _ in 0..=random.below(3) {
            mutilate(&mut files[victim].1, &mut random);
        }
        for (name, bytes) in &files {
            fs::write(folder.path().join(name), bytes).unwrap();
        }
        for entry in ["scene.toml", "mesh.obj"] {
            match load(&folder.path().join(entry)) {
                Ok(loaded) => pictures += draw(&loaded),
                Err(error) => {
                    errors += 1;
                    assert!(!error.problem.is_empty() && !error.remedy.is_empty(), "case {case}: {error}");
                }
            }
        }
    }
    // Neither is the reader blind, nor does it refuse everything.
    assert!(errors > CASES / 5 && pictures > CASES, "{errors} errors, {pictures} pictures");
}

/// Draws tiny pictures with all renderers and shadings; how many came out.
fn draw(loaded: &Loaded) -> u32 {
    let Ok(prepared) = prepare(loaded) else { return 0 };
    if prepared.triangle_count() > MOST_TRIANGLES {
        return 0;
    }
    let mut pictures = 0;
    for (renderer, shading) in [
        (Renderer::ZBuffer, Shading::Gouraud),
        (Renderer::Painter, Shading::Flat),
        (Renderer::Raytrace, Shading::Phong),
    ] {
        let settings =
            Settings { renderer, shading, size: (16, 12), samples: 1, max_depth: 4, ..loaded.scene.settings };
        pictures += u32::from(render(&prepared, &settings, &|_| ()).is_ok());
    }
    pictures
}

fn mutilate(bytes: &mut Vec<u8>, random: &mut Random) {
    if bytes.is_empty() {
        return;
    }
    match random.below(6) {
        0 => bytes.truncate(random.below(bytes.len())),
        1 => {
            let place = random.below(bytes.len());
            bytes[place] ^= 1 << random.below(8);
        }
        2 | 3 => replace_a_number(bytes, random),
        4 => {
            let mut lines: Vec<Vec<u8>> = bytes.split(|byte| *byte == b'\n').map(<[u8]>::to_vec).collect();
            let (a, b) = (random.below(lines.len()), random.below(lines.len()));
            lines.swap(a, b);
            *bytes = lines.join(&b'\n');
        }
        _ => {
            let from = random.below(bytes.len());
            let to = (from + random.below(30)).min(bytes.len());
            let piece = bytes[from..to].to_vec();
            let place = random.below(bytes.len());
            bytes.splice(place..place, piece);
        }
    }
}

fn replace_a_number(bytes: &mut Vec<u8>, random: &mut Random) {
    let is_part = |byte: &u8| byte.is_ascii_digit() || matches!(byte, b'.' | b'-');
    let starts: Vec<usize> =
        (1..bytes.len()).filter(|k| is_part(&bytes[*k]) && !is_part(&bytes[*k - 1])).collect();
    if starts.is_empty() {
        return;
    }
    let start = starts[random.below(starts.len())];
    let end = (start..bytes.len()).find(|k| !is_part(&bytes[*k])).unwrap_or(bytes.len());
    bytes.splice(start..end, HOSTILE_NUMBERS[random.below(HOSTILE_NUMBERS.len())].bytes());
}

#[test]
fn the_files_are_good_before_they_are_mutilated() {
    let loaded = Loaded::from_toml(SCENE, "scene.toml", Path::new("tests/hostile")).unwrap();
    assert_eq!(loaded.warnings, Vec::<String>::new());
    assert_eq!(draw(&loaded), 3);
}
