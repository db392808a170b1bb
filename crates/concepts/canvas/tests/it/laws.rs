//! What holds for every colour and every picture.

use canvas::{DepthImage, Format, Image, Rgb, codec, difference, side_by_side, srgb};
use proptest::prelude::*;
use testkit::{Law, ensure, ensure_close};

/// Light from deep shadow to far above white, also negative: every exponent is about as likely.
fn light() -> impl Strategy<Value = f32> + Clone {
    prop_oneof![
        8 => (-14.0..1.0_f32).prop_map(f32::exp2),
        1 => 1.0..50.0_f32,
        1 => -2.0..0.0_f32,
    ]
}

/// Light, and what goes wrong with it.
fn any_number() -> impl Strategy<Value = f32> + Clone {
    prop_oneof![4 => light(), 1 => any::<f32>(), 1 => Just(f32::NAN), 1 => Just(f32::INFINITY)]
}

fn image_of(channel: impl Strategy<Value = f32> + Clone) -> impl Strategy<Value = Image> {
    (1..13_u32, 1..9_u32).prop_flat_map(move |size| image_of_size(size, channel.clone()))
}

fn image_of_size(
    (width, height): (u32, u32),
    channel: impl Strategy<Value = f32>,
) -> impl Strategy<Value = Image> {
    let channels = 3 * width as usize * height as usize;
    proptest::collection::vec(channel, channels).prop_map(move |channels| {
        let pixels = channels.chunks_exact(3).map(Rgb::from_slice).collect();
        Image::from_rows(width, height, pixels).expect("three channels a pixel")
    })
}

fn images_of_one_size(channel: impl Strategy<Value = f32> + Clone) -> impl Strategy<Value = [Image; 3]> {
    (1..13_u32, 1..9_u32).prop_flat_map(move |size| [(); 3].map(|()| image_of_size(size, channel.clone())))
}

fn bits(image: &Image) -> Vec<[u32; 3]> {
    image.pixels().iter().map(|pixel| pixel.to_array().map(f32::to_bits)).collect()
}

fn same_bits(a: &Image, b: &Image) -> bool {
    (a.width(), a.height(), bits(a)) == (b.width(), b.height(), bits(b))
}

fn clamped(light: f32) -> f32 {
    light.clamp(0.0, 1.0)
}

#[test]
fn decoding_undoes_encoding_up_to_clamping() {
    // Encoding rounds once, by at most 2^-25 below 1, and decoding stretches that by at most the slope 2.4/1.055 at
    // white. Decoding rounds once more, and the curves themselves are evaluated in f64. 2.3 + 1 < 4 halves of an
    // epsilon.
    Law::new("decode(encode(x)) is x, clamped")
        .cases(4000)
        .demand("straight piece", 0.1)
        .demand("power piece", 0.2)
        .demand("clamped", 0.1)
        .holds_for(light(), |x, seen| {
            seen.class("straight piece", (0.0..0.003).contains(&x));
            seen.class("power piece", (0.004..1.0).contains(&x));
            seen.class("clamped", !(0.0..=1.0).contains(&x));
            ensure_close("light", srgb::decode(srgb::encode(x)), clamped(x), 2.0 * f32::EPSILON)
        });
}

#[test]
fn more_light_is_never_encoded_lower() {
    Law::new("encode and decode rise")
        .cases(4000)
        .demand("neighbours", 0.3)
        .demand("within the file", 0.3)
        .holds_for((light(), light(), any::<bool>()), |(x, other, next), seen| {
            // Half of the pairs are neighbouring floats, where rounding could swap the order.
            let y = if next { x.next_up() } else { other };
            let (low, high) = (x.min(y), x.max(y));
            seen.class("neighbours", next);
            seen.class("within the file", 0.0 < low && high < 1.0);
            ensure(srgb::encode(low) <= srgb::encode(high), || "encode falls".to_owned())?;
            ensure(srgb::decode(low) <= srgb::decode(high), || "decode falls".to_owned())
        });
}

#[test]
fn every_number_is_encoded_within_the_file() {
    Law::new("encode and decode give [0, 1]")
        .cases(4000)
        .demand("NaN", 0.05)
        .demand("infinite", 0.05)
        .holds_for(any_number(), |x, seen| {
            seen.class("NaN", x.is_nan());
            seen.class("infinite", x.is_infinite());
            let inside = |y: f32| (0.0..=1.0).contains(&y);
            ensure(inside(srgb::encode(x)) && inside(srgb::decode(x)), || format!("{x} leaves [0, 1]"))
        });
}

#[test]
fn looking_up_a_step_gives_what_computing_it_gives() {
    let steps = srgb::EightBitSteps::new();
    Law::new("EightBitSteps is to_u8")
        .cases(4000)
        .demand("between the steps", 0.3)
        .demand("NaN", 0.05)
        .holds_for(any_number(), |x, seen| {
            seen.class("between the steps", 0.001 < x && x < 1.0);
            seen.class("NaN", x.is_nan());
            ensure(steps.nearest(x) == srgb::to_u8(x), || {
                format!("{x}: {} and {}", steps.nearest(x), srgb::to_u8(x))
            })
        });
}

#[test]
fn openexr_gives_every_bit_back() {
    Law::new("OpenEXR is lossless").demand("NaN", 0.5).holds_for(image_of(any_number()), |image, seen| {
        seen.class("NaN", image.pixels().iter().any(|pixel| pixel.is_nan()));
        let file = codec::encode(&image, Format::Exr)?;
        ensure(same_bits(&codec::decode(&file)?, &image), || "bits differ".to_owned())
    });
}

#[test]
fn png_gives_the_nearest_step_back() {
    // Half a step of the file; the curve and its inverse add a rounding each.
    Law::new("PNG is right to half a step").demand("beyond white", 0.5).holds_for(
        image_of(light()),
        |image, seen| {
            seen.class("beyond white", image.pixels().iter().any(|pixel| pixel.max_element() > 1.0));
            for (format, last_step) in [(Format::Png8, 255.0), (Format::Png16, 65535.0)] {
                let read = codec::decode(&codec::encode(&image, format)?)?;
                let greatest = difference(&image, &read, 0.0)?.greatest;
                ensure(greatest <= 0.5 / last_step + 2.0 * f32::EPSILON, || {
                    format!("{format:?}: {greatest}")
                })?;
            }
            Ok(())
        },
    );
}

#[test]
fn a_png_that_was_read_is_written_with_the_same_bytes() {
    Law::new("encode after decode after encode changes nothing").holds_for(
        image_of(any_number()),
        |image, _| {
            for format in [Format::Png8, Format::Png16, Format::Exr] {
                let file = codec::encode(&image, format)?;
                let again = codec::encode(&codec::decode(&file)?, format)?;
                ensure(file == again, || format!("{format:?} differs"))?;
            }
            Ok(())
        },
    );
}

#[test]
fn difference_is_a_distance() {
    // Both sums are of three values in [0, 1], each from one subtraction of rounded values.
    let rounding = 4.0 * f32::EPSILON;
    Law::new("symmetric, zero against itself, and no detour is shorter").demand("visible", 0.5).holds_for(
        images_of_one_size(light()),
        |[a, b, c], seen| {
            let (ab, ba) = (difference(&a, &b, 0.1)?, difference(&b, &a, 0.1)?);
            seen.class("visible", ab.over_threshold > 0);
            ensure(ab == ba, || "not symmetric".to_owned())?;
            ensure(difference(&a, &a, 0.0)?.greatest_at.is_none(), || "differs from itself".to_owned())?;
            let detour = difference(&a, &c, 0.0)?.greatest + difference(&c, &b, 0.0)?.greatest;
            ensure(ab.greatest <= detour + rounding, || format!("{} > {detour}", ab.greatest))
        },
    );
}

#[test]
fn difference_tells_where_and_how_many() {
    Law::new("greatest, its place, mean and count belong together")
        .demand("some over, some not", 0.3)
        .holds_for((images_of_one_size(light()), 0.0..1.0_f32), |([a, b, _], threshold), seen| {
            let found = difference(&a, &b, threshold)?;
            let pixels = a.pixels().len();
            seen.class("some over, some not", 0 < found.over_threshold && found.over_threshold < pixels);
            ensure(found.mean <= found.greatest, || "mean above greatest".to_owned())?;
            ensure((found.over_threshold > 0) == (found.greatest > threshold), || "count".to_owned())?;
            let Some((i, j)) = found.greatest_at else {
                return ensure(found.greatest == 0.0, || "place".to_owned());
            };
            let there = difference(&Image::new(1, 1, a.get(i, j)), &Image::new(1, 1, b.get(i, j)), 0.0)?;
            ensure(there.greatest == found.greatest, || format!("({i}, {j}) differs by {}", there.greatest))
        });
}

#[test]
fn each_picture_is_found_again_in_the_row() {
    let gap_color = Rgb::new(-1.0, -2.0, -3.0);
    let inputs = (image_of(light()), image_of(light()), image_of(light()), 0..5_u32);
    Law::new("side by side keeps every pixel").demand("different heights", 0.5).holds_for(
        inputs,
        |(a, b, c, gap), seen| {
            seen.class("different heights", a.height() != b.height());
            let row = side_by_side(&[&a, &b, &c], gap, gap_color);
            let lefts = [0, a.width() + gap, a.width() + gap + b.width() + gap];
            let mut rest = row.pixels().len();
            for (image, left) in [&a, &b, &c].into_iter().zip(lefts) {
                let part = Image::from_fn(image.width(), image.height(), |i, j| row.get(left + i, j));
                ensure(part == *image, || format!("the picture at column {left} changed"))?;
                rest -= image.pixels().len();
            }
            let gaps = row.pixels().iter().filter(|pixel| **pixel == gap_color).count();
            ensure(gaps == rest, || format!("{gaps} pixels of the gap's colour, {rest} expected"))
        },
    );
}

#[test]
fn a_large_pixel_is_the_mean_of_its_small_ones() {
    let image = Image::from_fn(6, 4, |i, j| Rgb::new(i as f32, j as f32, (5 * i + 3 * j) as f32));
    let half = image.box_downsampled(2);
    assert_eq!((half.width(), half.height()), (3, 2));
    // Columns 4 and 5, rows 2 and 3 from below.
    assert_eq!(half.get(2, 1), Rgb::new(4.5, 2.5, 5.0 * 4.5 + 3.0 * 2.5));
    assert_eq!(image.box_downsampled(1), image);
}

#[test]
fn the_farthest_depth_is_told_from_nothing() {
    let mut depths = DepthImage::new(3, 2);
    for (i, j, depth) in [(0, 0, -0.75), (1, 1, 0.5), (2, 0, 0.0)] {
        depths.set(i, j, depth);
    }
    let grey = depths.to_image();
    assert_eq!((grey.get(1, 1), grey.get(1, 0)), (Rgb::ONE, Rgb::ZERO));
    assert!(grey.get(0, 0).min_element() > 0.02, "the farthest is {}", grey.get(0, 0));
    assert!(grey.get(0, 0).x < grey.get(2, 0).x && grey.get(2, 0).x < 1.0);
}

#[test]
fn of_equal_differences_the_first_in_reading_order_is_named() {
    let a = Image::new(4, 3, Rgb::new(0.2, 0.5, 0.3));
    let mut b = a.clone();
    for (i, j) in [(3, 0), (2, 1), (1, 2)] {
        b.set(i, j, Rgb::ZERO);
    }
    // j runs upwards: row 2 is the first.
    assert_eq!(difference(&a, &b, 0.1).unwrap().greatest_at, Some((1, 2)));
}
