//! Does everything arrive as it was sent, and nothing that was never sent?

use glam::{Mat3, vec2, vec3};
use std::time::Duration;
use vocabulary::{Ray, Triangle2};

use worker::wire::{self, Answer, Answered, Panic, Question};
use worker::{Plain, Value};

/// Through the wire and back.
fn travelled(value: Value) -> Value {
    let mut bytes = Vec::new();
    let question = Question { function: 3, arguments: vec![value] };
    wire::send(&mut bytes, &question).expect("sent");
    let back: Question = wire::receive(&mut bytes.as_slice()).expect("read").expect("a question");
    assert_eq!(back.function, 3);
    back.arguments.into_iter().next().expect("an argument")
}

#[test]
fn every_kind_of_value_travels_and_comes_back_as_its_type() {
    let ray = Ray { origin: vec3(1.0, 2.0, 3.0), direction: vec3(-4.0, 0.5, 0.0) };
    assert_eq!(Ray::from_value(travelled(ray.into_value())), Some(ray));
    let matrix = Mat3::from_cols_array(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]);
    assert_eq!(Mat3::from_value(travelled(matrix.into_value())), Some(matrix));
    let mixed = (7_u32, vec![Some(vec2(1.0, 2.0)), None], [true, false]);
    assert_eq!(Plain::from_value(travelled(mixed.clone().into_value())), Some(mixed));
    <()>::from_value(travelled(().into_value())).expect("nothing");
}

#[test]
fn nan_infinities_and_negative_zero_survive_to_the_bit() {
    for number in [f32::NAN, -f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -0.0, f32::MIN_POSITIVE / 4.0] {
        let back = f32::from_value(travelled(number.into_value())).expect("a number");
        assert_eq!(back.to_bits(), number.to_bits(), "{number}");
    }
}

#[test]
fn a_value_of_another_type_is_refused() {
    assert_eq!(f32::from_value(vec2(1.0, 2.0).into_value()), None);
    assert_eq!(u32::from_value((-1_i32).into_value()), None);
    assert_eq!(<[f32; 3]>::from_value(vec![1.0_f32; 2].into_value()), None);
    let triangle = Triangle2 { a: vec2(0.0, 1.0), b: vec2(2.0, 3.0), c: vec2(4.0, 5.0) };
    assert_eq!(Ray::from_value(triangle.into_value()), None);
    assert_eq!(<(f32, f32)>::from_value(vec![1.0_f32; 3].into_value()), None);
}

#[test]
fn distance_is_the_greatest_difference_and_shapes_must_be_alike() {
    let distance = |a: Vec<f32>, b: Vec<f32>| a.into_value().distance(&b.into_value());
    assert_eq!(distance(vec![1.0, 0.25], vec![1.0, 0.0]), Some(0.25));
    assert_eq!(distance(vec![100.0], vec![200.0]), Some(0.5), "relative above 1");
    assert_eq!(distance(vec![1.0], vec![1.0, 2.0]), None);
    assert_eq!(distance(vec![f32::NAN], vec![f32::NAN]), Some(0.0));
    assert_eq!(distance(vec![f32::NAN], vec![0.0]), Some(f32::INFINITY));
    assert_eq!(distance(vec![f32::INFINITY], vec![f32::INFINITY]), Some(0.0));
    assert_eq!(distance(vec![f32::INFINITY], vec![1.0]), Some(f32::INFINITY));
    assert_eq!(true.into_value().distance(&false.into_value()), None);
    assert_eq!(Some(1.0_f32).into_value().distance(&Value::Nothing), None);
}

#[test]
fn values_read_as_a_person_would_write_them() {
    assert_eq!(vec3(1.0, -0.0, 2.5).into_value().to_string(), "(1, 0, 2.5)");
    assert_eq!(vec![1.0_f32, f32::NAN].into_value().to_string(), "[1, NaN]");
    let matrix = Mat3::from_cols_array(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]);
    assert_eq!(matrix.into_value().to_string(), "[1, 4, 7; 2, 5, 8; 3, 6, 9]");
    let ray = Ray { origin: vec3(1.0, 2.0, 3.0), direction: vec3(0.1, 0.0, -1e-8) };
    let text = "Ray { origin: (1, 2, 3), direction: (0.1, 0, -1.0e-8) }";
    assert_eq!(ray.into_value().to_string(), text);
    assert_eq!(None::<f32>.into_value().to_string(), "None");
}

#[test]
fn bytes_that_are_no_message_are_an_error_and_no_crash() {
    let mut sent = Vec::new();
    let panic = Panic { message: "m".to_owned(), file: "f".to_owned(), line: 3, elsewhere: false };
    wire::send(&mut sent, &Answer::Panicked(panic)).expect("sent");
    for end in 1..sent.len() {
        assert!(wire::receive::<Answer>(&mut &sent[..end]).is_err(), "{end} bytes");
    }
    assert_eq!(wire::receive::<Answer>(&mut &[][..]).expect("an end"), None);
    assert!(wire::receive::<Answer>(&mut &[255_u8; 64][..]).is_err(), "too long");
    assert!(wire::receive::<Answer>(&mut &[2, 0, 0, 0, 99, 99][..]).is_err(), "no such kind");
}

#[test]
fn lists_within_lists_without_end_are_refused_before_the_stack_is_full() {
    // A list of one list of one list…: tag and count a level.
    let mut deep = vec![0_u8];
    deep.extend([6, 1].repeat(1 << 20));
    let mut bytes = (deep.len() as u32).to_le_bytes().to_vec();
    bytes.extend(&deep);
    assert!(wire::receive::<Answer>(&mut bytes.as_slice()).is_err());
    // What an exercise gives is far less deep, and arrives.
    let value = (0..8).fold(1.0_f32.into_value(), |inner, _| Value::List(vec![inner]));
    assert_eq!(travelled(value.clone()), value);
}

#[test]
fn a_message_that_is_too_long_is_not_sent() {
    let much = Value::List(vec![Value::Number(1.5); 2 << 20]);
    assert!(wire::send(&mut Vec::new(), &much).is_err());
    let mut bytes = Vec::new();
    let computed = Duration::from_millis(7);
    wire::send_answer(&mut bytes, &Answered { answer: Answer::Value(much), computed }).expect("sent");
    let told: Answered = wire::receive(&mut bytes.as_slice()).expect("read").expect("an answer");
    assert_eq!(told.computed, computed);
    assert!(matches!(told.answer, Answer::TooLong(length) if length > wire::LONGEST), "{told:?}");
}
