//! What does an answer look like? Each says what the page may do: nothing but what comes from here.

use http_body_util::Full;
use hyper::body::Bytes;
use hyper::header::{
    CACHE_CONTROL, CONTENT_SECURITY_POLICY, CONTENT_TYPE, HeaderValue, REFERRER_POLICY,
    X_CONTENT_TYPE_OPTIONS,
};
use hyper::{Response, StatusCode};
use serde_json::{Value as Json, json};

use crate::Refusal;

/// What the server sends.
pub(crate) type Answer = Response<Full<Bytes>>;

/// Scripts, styles, pictures and requests from this server alone. Drawings carry styles of their own, and pictures come as data.
const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; \
                      connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// An answer of some kind, with what every answer says.
pub(crate) fn bytes(status: StatusCode, kind: &'static str, bytes: impl Into<Bytes>) -> Answer {
    let mut answer = Response::new(Full::new(bytes.into()));
    *answer.status_mut() = status;
    let headers = answer.headers_mut();
    for (name, value) in [
        (CONTENT_TYPE, kind),
        // Another start may have another page.
        (CACHE_CONTROL, "no-store"),
        (CONTENT_SECURITY_POLICY, POLICY),
        (X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (REFERRER_POLICY, "no-referrer"),
    ] {
        headers.insert(name, HeaderValue::from_static(value));
    }
    headers.insert("cross-origin-resource-policy", HeaderValue::from_static("same-origin"));
    answer
}

/// JSON.
pub(crate) fn json(value: &Json) -> Answer {
    bytes(StatusCode::OK, "application/json", value.to_string())
}

/// What cannot be done, in words.
pub(crate) fn refused(status: StatusCode, refusal: &Refusal) -> Answer {
    let words = json!({ "error": { "en": refusal.0.en, "nl": refusal.0.nl } });
    bytes(status, "application/json", words.to_string())
}
