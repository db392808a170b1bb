//! Who answers what?

use std::sync::Arc;
use std::time::Duration;

use http_body_util::{BodyExt, Limited};
use hyper::body::Incoming;
use hyper::header::{CONTENT_TYPE, HeaderValue, LOCATION, SET_COOKIE};
use hyper::{Method, Request, StatusCode};
use serde::de::DeserializeOwned;
use serde_json::Value as Json;

use super::answer::{self, Answer};
use super::{Busy, Shared, files};
use crate::api::{self, Measured};
use crate::{Refusal, steps, story};

/// No request of the page is longer, in bytes.
const LONGEST_BODY: usize = 64 << 10;
/// A body that has not arrived by then will not.
const PATIENCE: Duration = Duration::from_secs(10);

/// The answer to any request.
pub(crate) async fn answer(shared: Arc<Shared>, request: Request<Incoming>) -> Answer {
    let is_page = request.method() == Method::GET && request.uri().path() == "/";
    if !shared.guard.admits(request.headers(), is_page) {
        return answer::refused(
            StatusCode::FORBIDDEN,
            &Refusal::new(
                "this server answers its own page only: open the address that the program printed",
                "deze server antwoordt alleen zijn eigen pagina: open het adres dat het programma heeft afgedrukt",
            ),
        );
    }
    let method = request.method().clone();
    let path = request.uri().path().to_owned();
    let found = match (&method, path.as_str()) {
        (&Method::GET, "/") => Ok(page(&shared, &request)),
        (&Method::GET, path) if path.starts_with("/page/") => Ok(file(&shared, &path["/page/".len()..])),
        (&Method::GET, "/api/lecture") => {
            Ok(answer::json(&api::lecture::lecture(shared.guard.trusts(request.headers()))))
        }
        (&Method::GET, "/api/mine/stamp") => stamp(&shared, &request),
        (&Method::POST, path) => post(&shared, path.to_owned(), request).await,
        (_, path) if path.starts_with("/api/") || path.starts_with("/page/") || path == "/" => {
            Err(Problem::Status(StatusCode::METHOD_NOT_ALLOWED))
        }
        _ => Err(Problem::Status(StatusCode::NOT_FOUND)),
    };
    found.unwrap_or_else(Problem::into_answer)
}

/// Why there is no answer.
enum Problem {
    Status(StatusCode),
    /// What was asked for makes no sense here: the page would not ask so.
    Malformed(Refusal),
    /// What was asked for cannot be done: an answer like any other, which the page shows in its place.
    Refused(Refusal),
    Busy(Busy),
}

impl From<Refusal> for Problem {
    fn from(refusal: Refusal) -> Self {
        Self::Refused(refusal)
    }
}

impl Problem {
    fn into_answer(self) -> Answer {
        match self {
            Self::Malformed(refusal) => answer::refused(StatusCode::BAD_REQUEST, &refusal),
            // Of any other status a browser's console would speak as of an error of the page.
            Self::Refused(refusal) => answer::refused(StatusCode::OK, &refusal),
            Self::Busy(Busy::Full) => answer::refused(
                StatusCode::SERVICE_UNAVAILABLE,
                &Refusal::new(
                    "too many requests wait: close some tabs",
                    "er wachten te veel verzoeken: sluit wat tabbladen",
                ),
            ),
            Self::Busy(Busy::Panicked) => answer::refused(
                StatusCode::INTERNAL_SERVER_ERROR,
                &Refusal::new(
                    "the program failed at this; its terminal says where",
                    "hierop liep het programma vast; zijn terminal zegt waar",
                ),
            ),
            Self::Status(status) => {
                let reason = status.canonical_reason().unwrap_or("?");
                answer::refused(status, &Refusal(reason.into()))
            }
        }
    }
}

/// The page; with the key in its address the browser is given it to keep, and the address loses it.
fn page(shared: &Shared, request: &Request<Incoming>) -> Answer {
    if asked(request, "key") == Some(&shared.guard.key.to_string()) {
        let mut moved = answer::bytes(StatusCode::SEE_OTHER, "text/plain; charset=utf-8", "");
        // What follows a # stays: browsers carry it over.
        moved.headers_mut().insert(LOCATION, HeaderValue::from_static("/"));
        if let Ok(cookie) = HeaderValue::from_str(&shared.guard.set_cookie()) {
            moved.headers_mut().insert(SET_COOKIE, cookie);
        }
        return moved;
    }
    file(shared, "index.html")
}

fn file(shared: &Shared, name: &str) -> Answer {
    match files::find(name, shared.folder.as_deref()) {
        Some(file) => answer::bytes(StatusCode::OK, file.kind, file.bytes.into_owned()),
        None => Problem::Status(StatusCode::NOT_FOUND).into_answer(),
    }
}

/// The value of a word in the address, as it stands there.
fn asked<'a>(request: &'a Request<Incoming>, name: &str) -> Option<&'a str> {
    let pairs = request.uri().query()?.split('&');
    pairs.filter_map(|pair| pair.split_once('=')).find(|(known, _)| *known == name).map(|(_, value)| value)
}

/// What changes when the student's file changes.
fn stamp(shared: &Shared, request: &Request<Incoming>) -> Result<Answer, Problem> {
    trusted(shared, request)?;
    let exercise = api::exercise(asked(request, "exercise").unwrap_or_default())?;
    Ok(answer::json(&serde_json::json!({ "stamp": shared.mine.stamp(exercise) })))
}

/// # Errors
/// [`Problem`] if the browser has not shown the key.
fn trusted(shared: &Shared, request: &Request<Incoming>) -> Result<(), Problem> {
    if shared.guard.trusts(request.headers()) { Ok(()) } else { Err(Problem::Status(StatusCode::FORBIDDEN)) }
}

/// What is computed.
async fn post(shared: &Arc<Shared>, path: String, request: Request<Incoming>) -> Result<Answer, Problem> {
    match path.as_str() {
        "/api/figure" => compute(shared, request, |_, asked| api::figure::draw(&asked)).await,
        "/api/drag" => compute(shared, request, |_, asked| api::figure::drag(&asked)).await,
        "/api/claim" => compute(shared, request, |_, asked| api::claim::run(&asked)).await,
        "/api/story" => {
            compute(shared, request, |shared, asked: api::StoryRequest| {
                let [i, j] = asked.pixel;
                story::story(&shared.stage, &asked.look, (i, j))
            })
            .await
        }
        "/api/steps" => compute(shared, request, |shared, asked| steps::steps(&shared.stage, &asked)).await,
        "/api/mine" => {
            trusted(shared, &request)?;
            let asked = body(request).await?;
            let drawn = shared.ask(move |shared| api::student::draw(&shared.mine, &asked)).await;
            Ok(answer::json(&drawn.map_err(Problem::Busy)??))
        }
        "/api/frame" => {
            let asked = body(request).await?;
            // On a thread that renders: entering its pool once takes less time than at each loop.
            let draw = move |shared: &Shared| rayon::scope(|_| api::frame::draw(&shared.stage, &asked));
            let frame = shared.compute(draw).await;
            Ok(frame.map_err(Problem::Busy)??.into_answer())
        }
        "/api/measured" => {
            trusted(shared, &request)?;
            let measured: Measured = body(request).await?;
            // What is printed comes from a list of ours.
            if scene::builtin::find(&measured.scene).is_none() {
                return Err(Problem::Status(StatusCode::BAD_REQUEST));
            }
            // Without anybody who waits for it, it is the page's own.
            let _ = shared.measured.try_send(measured);
            Ok(answer::json(&Json::Null))
        }
        _ => Err(Problem::Status(StatusCode::NOT_FOUND)),
    }
}

/// Reads what is asked, computes, and answers with JSON.
async fn compute<T: DeserializeOwned + Send + 'static>(
    shared: &Arc<Shared>,
    request: Request<Incoming>,
    work: impl FnOnce(&Shared, T) -> Result<Json, Refusal> + Send + 'static,
) -> Result<Answer, Problem> {
    let asked = body(request).await?;
    let value = shared.compute(move |shared| work(shared, asked)).await.map_err(Problem::Busy)??;
    Ok(answer::json(&value))
}

/// What stands in a request.
///
/// # Errors
/// [`Problem`] if it is no JSON, too long, too late, or not what is asked for here.
async fn body<T: DeserializeOwned>(request: Request<Incoming>) -> Result<T, Problem> {
    let kind = request.headers().get(CONTENT_TYPE).and_then(|kind| kind.to_str().ok());
    // A form of another page can send anything but this without being asked first.
    if kind.is_none_or(|kind| kind.split(';').next() != Some("application/json")) {
        return Err(Problem::Status(StatusCode::UNSUPPORTED_MEDIA_TYPE));
    }
    let limited = Limited::new(request.into_body(), LONGEST_BODY);
    let collected = tokio::time::timeout(PATIENCE, limited.collect()).await;
    let collected = collected.map_err(|_| Problem::Status(StatusCode::REQUEST_TIMEOUT))?;
    let bytes = collected.map_err(|_| Problem::Status(StatusCode::PAYLOAD_TOO_LARGE))?.to_bytes();
    serde_json::from_slice(&bytes).map_err(|error| {
        Problem::Malformed(Refusal::new(
            format!("the request is not understood: {error}"),
            format!("het verzoek is niet te begrijpen: {error}"),
        ))
    })
}
