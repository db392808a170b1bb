//! `cargo lab compare`: same, different or unreadable.

use canvas::{Format, Image, Rgb, codec, srgb};

use crate::desk::{Desk, Said};

/// A desk with `a.png`; `b.png`, one step of 255 off in a pixel; `c.png`, half of it black; and `wide.png`.
fn desk() -> Desk {
    let desk = Desk::new();
    let a = Image::from_fn(6, 5, |i, j| {
        Rgb::new(srgb::from_u8(40 * i as u8), srgb::from_u8(17 + 30 * j as u8), 0.5)
    });
    let mut b = a.clone();
    b.set(4, 1, Rgb::new(srgb::from_u8(161), a.get(4, 1).y, a.get(4, 1).z));
    let c = Image::from_fn(6, 5, |i, j| if i < 3 { Rgb::ZERO } else { a.get(i, j) });
    let wide = Image::new(7, 5, Rgb::X);
    for (name, image) in [("a", &a), ("b", &b), ("c", &c), ("wide", &wide)] {
        desk.put(&format!("{name}.png"), codec::encode(image, Format::Png8).unwrap());
    }
    desk.put("a.exr", codec::encode(&a, Format::Exr).unwrap());
    desk
}

#[track_caller]
fn says(said: &Said, code: i32, parts: &[&str]) {
    assert_eq!((said.code, said.err.as_str()), (Some(code), ""), "{}", said.out);
    for part in parts {
        assert!(said.out.contains(part), "no {part:?} in: {}", said.out);
    }
}

#[test]
fn a_picture_is_the_same_as_itself() {
    says(&desk().lab("compare a.png a.png"), 0, &["same: none of 30 pixels differs", "a.png"]);
}

#[test]
fn one_step_is_a_difference_unless_tolerated() {
    let desk = desk();
    let parts = ["different: 1 of 30 pixels", "0.003922", "1.0 steps of 255", "(4, 1)", "mean 0.000131"];
    says(&desk.lab("compare a.png b.png"), 1, &parts);
    says(
        &desk.lab("compare a.png b.png --tolerance 1/255"),
        0,
        &["same: none of 30 pixels differs by more than"],
    );
    says(&desk.lab("compare a.png b.png --tolerance 0.0039"), 1, &["different: 1 of 30"]);
    says(&desk.lab("compare a.png b.png --tolerance 0.004"), 0, &["same"]);
}

#[test]
fn formats_can_be_compared_with_each_other() {
    // An 8-bit file is at most half a step off.
    says(&desk().lab("compare a.png a.exr --tolerance 0.5/255"), 0, &["same"]);
}

#[test]
fn different_sizes_are_different_pictures() {
    let desk = desk();
    says(&desk.lab("compare a.png wide.png"), 1, &["differ in size", "6 × 5", "7 × 5"]);
    let said = desk.lab("compare a.png wide.png -o d.png");
    assert_eq!(said.code, Some(1));
    assert!(said.err.contains("warning: d.png was not written"), "{}", said.err);
    assert!(!desk.files().contains(&"d.png".to_owned()));
}

#[test]
fn the_difference_is_drawn_beside_both() {
    let desk = desk();
    says(&desk.lab("compare a.png c.png -o d.png"), 1, &["different: 15 of 30", "wrote d.png"]);
    let (a, c, d) = (desk.picture("a.png"), desk.picture("c.png"), desk.picture("d.png"));
    assert_eq!((d.width(), d.height()), (6 + 8 + 6 + 8 + 6, 5));
    for (i, j) in [(0, 0), (2, 4), (3, 0), (5, 1)] {
        assert_eq!(d.get(i, j), a.get(i, j));
        assert_eq!(d.get(14 + i, j), c.get(i, j));
        assert_eq!(d.get(28 + i, j) == Rgb::ZERO, i >= 3, "heat where they differ, at ({i}, {j})");
    }
}

#[test]
fn what_is_no_picture_is_an_error() {
    let desk = desk();
    desk.put("text.png", "not a picture");
    std::fs::create_dir(desk.path("folder.png")).unwrap();
    desk.lab("compare a.png nowhere.png").refused(&["nowhere.png"]);
    desk.lab("compare text.png a.png").refused(&["text.png", "PNG", "OpenEXR"]);
    desk.lab("compare folder.png a.png").refused(&["folder.png"]);
    desk.lab("compare a.png").refused(&["<B>"]);
    for wrong in ["2", "-1", "NaN", "x", "1/0"] {
        desk.lab(&format!("compare a.png b.png --tolerance {wrong}"))
            .refused(&["--tolerance", "from 0 to 1"]);
    }
}

#[test]
fn the_output_is_checked_and_never_replaces_what_is_compared() {
    let desk = desk();
    let before = desk.bytes("a.png");
    desk.lab("compare a.png b.png -o a.png").refused(&["a.png", "replaced"]);
    desk.lab("compare b.png a.png -o ./a.png").refused(&["a.png", "replaced"]);
    desk.lab("compare a.png b.png -o d.gif").refused(&["d.gif", ".exr"]);
    assert_eq!(desk.bytes("a.png"), before);
    assert_eq!(desk.files(), ["a.exr", "a.png", "b.png", "c.png", "wide.png"]);
}

#[test]
fn damaged_pictures_end_in_an_error_or_a_verdict() {
    let desk = desk();
    for name in ["a.png", "a.exr"] {
        let whole = desk.bytes(name);
        for seed in 1_usize..=24 {
            let mut bytes = whole.clone();
            let place = seed * 104_729 % bytes.len();
            if seed % 4 == 0 {
                bytes.truncate(place);
            } else {
                bytes[place] ^= 1 << (seed % 8);
                bytes[seed] ^= 0x40;
            }
            desk.put("damaged", &bytes);
            let said = desk.lab(&format!("compare {name} damaged"));
            match said.code {
                Some(0 | 1) => assert_eq!(said.err, ""),
                _ => drop(said.refused(&["damaged"])),
            }
        }
    }
}

#[test]
fn nan_is_within_no_tolerance() {
    let desk = desk();
    let mut nan = Image::new(6, 5, Rgb::ZERO);
    nan.set(1, 2, Rgb::new(0.0, f32::NAN, 0.0));
    desk.put("nan.exr", codec::encode(&nan, Format::Exr).unwrap());
    desk.put("black.exr", codec::encode(&Image::new(6, 5, Rgb::ZERO), Format::Exr).unwrap());
    let parts = ["different: 1 of 30 pixels", "1 of 30 pixels are NaN", "(1, 2)"];
    says(&desk.lab("compare nan.exr black.exr --tolerance 1"), 1, &parts);
}

/// A black PNG of one pixel with alpha 0, as another program writes it.
const TRANSPARENT_PNG: &[u8] = b"\x89PNG\r\n\x1a\n\
    \x00\x00\x00\x0d\x49\x48\x44\x52\x00\x00\x00\x01\x00\x00\x00\x01\x08\x06\x00\x00\x00\x1f\x15\xc4\x89\
    \x00\x00\x00\x10\x49\x44\x41\x54\x78\x01\x01\x05\x00\xfa\xff\x00\x00\x00\x00\x00\x00\x05\x00\x01\x64\x78\x95\x38\
    \x00\x00\x00\x00\x49\x45\x4e\x44\xae\x42\x60\x82";

#[test]
fn transparent_black_against_opaque_black_is_the_same_with_a_word_about_alpha() {
    let desk = desk();
    desk.put("clear.png", TRANSPARENT_PNG);
    desk.put("black.png", codec::encode(&Image::new(1, 1, Rgb::ZERO), Format::Png8).unwrap());
    let parts = ["same: none of 1 pixels differs", "alpha differs in 1 of 1 pixels"];
    says(&desk.lab("compare clear.png black.png"), 0, &parts);
    assert!(!desk.lab("compare clear.png clear.png").out.contains("alpha"));
}
