//! Whom does the server answer, and what does it survive? Asked byte by byte, as no browser would.

use std::io::{Read, Write};
use std::net::{Shutdown, TcpListener, TcpStream};
use std::sync::Arc;
use std::thread;
use std::time::Duration;

use play::{Server, StudentPictures};
use serde_json::{Value as Json, json};

/// A server that answers until the tests end.
fn served() -> Arc<Server> {
    let server = Arc::new(Server::start(0, mine(), None).unwrap());
    let running = server.clone();
    thread::spawn(move || running.run());
    server
}

/// Nothing is drawn with a student's functions here.
fn mine() -> StudentPictures {
    StudentPictures::new("no folder".into(), Box::new(|| Err("no judge".to_owned())))
}

/// What comes back on a request: status and the rest, up to the end of the connection.
fn raw(server: &Server, bytes: &[u8]) -> String {
    sent(server, bytes, false)
}

/// The same where nothing follows the bytes, whether or not they are a whole request.
fn torn(server: &Server, bytes: &[u8]) -> String {
    sent(server, bytes, true)
}

fn sent(server: &Server, bytes: &[u8], is_all: bool) -> String {
    let mut stream = TcpStream::connect(("127.0.0.1", server.port())).unwrap();
    stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
    // A server that has heard enough may close before all is sent.
    let _ = stream.write_all(bytes);
    if is_all {
        let _ = stream.shutdown(Shutdown::Write);
    }
    let mut answer = Vec::new();
    let _ = stream.read_to_end(&mut answer);
    String::from_utf8_lossy(&answer).into_owned()
}

fn get(server: &Server, path: &str, more: &str) -> String {
    let host = format!("127.0.0.1:{}", server.port());
    raw(server, format!("GET {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n{more}\r\n").as_bytes())
}

fn post(server: &Server, path: &str, body: &str, more: &str) -> String {
    let host = format!("127.0.0.1:{}", server.port());
    let length = body.len();
    let head = format!(
        "POST {path} HTTP/1.1\r\nHost: {host}\r\nContent-Type: application/json\r\nContent-Length: {length}\r\nConnection: close\r\n{more}\r\n"
    );
    raw(server, format!("{head}{body}").as_bytes())
}

fn status(answer: &str) -> u32 {
    answer.split(' ').nth(1).and_then(|status| status.parse().ok()).unwrap_or(0)
}

fn body(answer: &str) -> Json {
    serde_json::from_str(answer.split_once("\r\n\r\n").unwrap().1).unwrap()
}

/// What became of a question that was understood: done, or refused with words in both languages.
fn is_refused(answer: &str) -> bool {
    assert_eq!(status(answer), 200, "{answer}");
    // Pixels are no JSON.
    let Ok(json) = serde_json::from_str::<Json>(answer.split_once("\r\n\r\n").unwrap().1) else {
        return false;
    };
    let error = &json["error"];
    error.is_object()
        && ["en", "nl"].iter().all(|language| error[language].as_str().is_some_and(|words| !words.is_empty()))
}

/// The cookie that the printed address gives.
fn cookie(server: &Server) -> String {
    let address = server.address("");
    let answer = get(server, &address[address.find("/?").unwrap()..], "");
    assert_eq!(status(&answer), 303, "{answer}");
    let line = answer.lines().find(|line| line.starts_with("set-cookie: ")).unwrap().to_owned();
    assert!(line.contains("HttpOnly") && line.contains("SameSite=Strict"), "{line}");
    format!("Cookie: {}\r\n", line["set-cookie: ".len()..].split(';').next().unwrap())
}

#[test]
fn the_page_and_the_lecture_are_served() {
    let server = served();
    let page = get(&server, "/", "");
    assert!(status(&page) == 200 && page.contains("<!DOCTYPE html>"), "{page}");
    assert!(page.contains("content-security-policy: default-src 'none'"), "{page}");
    let lecture = body(&get(&server, "/api/lecture", ""));
    assert_eq!(lecture["figures"].as_array().unwrap().len(), figures::all().len());
    assert_eq!(lecture["claims"].as_array().unwrap().len(), claims::all().len());
    assert_eq!(lecture["token"], false);
    assert_eq!(body(&get(&server, "/api/lecture", &cookie(&server)))["token"], true);
}

#[test]
fn every_file_that_the_page_asks_for_is_there() {
    let server = served();
    let mut wanted = vec!["/page/app.js".to_owned()];
    let page = get(&server, "/", "");
    let quoted = |text: &str, begin: &str| -> Vec<String> {
        text.split(begin).skip(1).map(|rest| rest.split(['"', '\'']).next().unwrap().to_owned()).collect()
    };
    wanted.extend(quoted(&page, "href=\"/page/").iter().map(|name| format!("/page/{name}")));
    let mut at = 0;
    while at < wanted.len() {
        let file = get(&server, &wanted[at], "");
        assert_eq!(status(&file), 200, "{}", wanted[at]);
        for name in quoted(&file, "from './") {
            let path = format!("/page/{name}");
            if !wanted.contains(&path) {
                wanted.push(path);
            }
        }
        at += 1;
    }
    assert!(wanted.len() > 15, "{wanted:?}");
}

#[test]
fn other_hosts_and_other_origins_are_turned_away() {
    let server = served();
    let port = server.port();
    for head in [
        "Host: evil.example".to_owned(),
        format!("Host: evil.example:{port}"),
        "Host: 127.0.0.1".to_owned(),
        format!("Host: 127.0.0.1:{port}\r\nOrigin: http://evil.example"),
        format!("Host: 127.0.0.1:{port}\r\nOrigin: null"),
        format!("Host: 127.0.0.1:{port}\r\nSec-Fetch-Site: cross-site"),
        "X-No-Host: 1".to_owned(),
    ] {
        for path in ["/", "/api/lecture", "/page/app.js"] {
            let answer = raw(
                &server,
                format!("GET {path} HTTP/1.1\r\n{head}\r\nConnection: close\r\n\r\n").as_bytes(),
            );
            assert_eq!(status(&answer), 403, "{head} {path}: {answer}");
            assert!(!answer.contains(&server.address("")[8..]), "the key is told");
        }
    }
    // By its other name it is the same.
    let head = format!("Host: localhost:{port}\r\nOrigin: http://localhost:{port}");
    let answer = raw(&server, format!("GET / HTTP/1.1\r\n{head}\r\nConnection: close\r\n\r\n").as_bytes());
    assert_eq!(status(&answer), 200);
}

#[test]
fn code_is_run_for_who_has_the_key_only() {
    let server = served();
    let question = json!({ "figure": "L31-exponent-strip", "exercise": "phong_highlight" }).to_string();
    assert_eq!(status(&post(&server, "/api/mine", &question, "")), 403);
    assert_eq!(status(&get(&server, "/api/mine/stamp?exercise=lambert", "")), 403);
    let forged = format!("Cookie: lightlab-{}=0123456789abcdef0123456789abcdef\r\n", server.port());
    assert_eq!(status(&post(&server, "/api/mine", &question, &forged)), 403);
    assert_eq!(status(&get(&server, "/?key=0123456789abcdef0123456789abcdef", "")), 200);
    let answer = post(&server, "/api/mine", &question, &cookie(&server));
    assert_eq!(status(&answer), 200, "{answer}");
    assert_ne!(body(&answer)["state"], "drawn");
}

#[test]
fn what_is_malformed_is_refused_and_the_server_lives_on() {
    let server = served();
    let host = format!("127.0.0.1:{}", server.port());
    let long_head = format!("GET / HTTP/1.1\r\nHost: {host}\r\nX-Long: {}\r\n\r\n", "x".repeat(1 << 20));
    let torn_body = format!(
        "POST /api/figure HTTP/1.1\r\nHost: {host}\r\nContent-Type: application/json\r\nContent-Length: 100\r\n\r\n{{"
    );
    for bytes in [
        b"".to_vec(),
        b"\r\n\r\n".to_vec(),
        b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03".to_vec(),
        b"GET".to_vec(),
        b"GET / HTTP/9.9\r\n\r\n".to_vec(),
        (0..=255).collect(),
        long_head.into_bytes(),
        torn_body.into_bytes(),
        format!("GET /../../../etc/passwd HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n")
            .into_bytes(),
        format!("GET /page/../lib.rs HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n").into_bytes(),
    ] {
        let answer = torn(&server, &bytes);
        assert!(answer.is_empty() || (400..500).contains(&status(&answer)), "{answer}");
    }
    for body in ["", "{", "[]", "null", r#"{"figure":"L31-exponent-strip","more":1}"#, r#"{"figure":7}"#] {
        let answer = post(&server, "/api/figure", body, "");
        assert_eq!(status(&answer), 400, "{body}: {answer}");
    }
    for (body, refused) in [
        (r#"{"figure":"L99"}"#, true),
        (r#"{"figure":"L31-exponent-strip","set":{"p":1e30}}"#, true),
        (r#"{"figure":"L31-exponent-strip","set":{"q":1}}"#, true),
        (r#"{"figure":"L31-exponent-strip","size":[100000,100000]}"#, true),
        (r#"{"figure":"L26-lambert"}"#, false),
    ] {
        let answer = post(&server, "/api/figure", body, "");
        assert_eq!(is_refused(&answer), refused, "{body}: {answer}");
    }
    let too_long = format!("{{\"figure\":\"{}\"}}", "x".repeat(100 << 10));
    assert!(matches!(status(&post(&server, "/api/figure", &too_long, "")), 413 | 0));
    let form = format!(
        "POST /api/figure HTTP/1.1\r\nHost: {host}\r\nContent-Type: text/plain\r\nContent-Length: 2\r\nConnection: close\r\n\r\n{{}}"
    );
    assert_eq!(status(&raw(&server, form.as_bytes())), 415);
    assert_eq!(status(&get(&server, "/api/figure", "")), 405);
    assert_eq!(status(&get(&server, "/nowhere", "")), 404);
    assert_eq!(status(&get(&server, "/api/lecture", "")), 200);
}

#[test]
fn frames_that_cannot_be_are_refused() {
    let server = served();
    for (question, refused) in [
        (json!({ "look": {}, "renderer": "zbuffer" }), false),
        (json!({ "look": { "width": 64, "height": 48 }, "renderer": "raytrace", "rows": [8, 24] }), false),
        (json!({ "look": {}, "renderer": "crayon" }), true),
        (json!({ "look": { "width": 0 }, "renderer": "zbuffer" }), true),
        (json!({ "look": { "width": 1_000_000 }, "renderer": "zbuffer" }), true),
        (json!({ "look": { "scene": "../../etc/passwd" }, "renderer": "zbuffer" }), true),
        (json!({ "look": { "level": 31 }, "renderer": "zbuffer" }), true),
        (json!({ "look": { "azimuth": 1e30 }, "renderer": "zbuffer" }), true),
        (json!({ "look": { "distance": 0 }, "renderer": "zbuffer" }), true),
        (json!({ "look": { "p": -1 }, "renderer": "zbuffer" }), true),
        (json!({ "look": {}, "renderer": "raytrace", "rows": [400, 481] }), true),
        (json!({ "look": {}, "renderer": "raytrace", "rows": [9, 3] }), true),
        (json!({ "look": {}, "renderer": "raytrace", "samples": 100 }), true),
        (json!({ "look": {}, "renderer": "raytrace", "scale": 0 }), true),
    ] {
        let answer = post(&server, "/api/frame", &question.to_string(), "");
        assert_eq!(is_refused(&answer), refused, "{question}");
    }
}

#[test]
fn closed_tabs_and_twenty_open_ones_do_no_harm() {
    let server = served();
    let host = format!("127.0.0.1:{}", server.port());
    // Tabs that were closed while a picture was being drawn for them.
    for _ in 0..20 {
        let question = json!({ "look": { "width": 320, "height": 240 }, "renderer": "raytrace" }).to_string();
        let length = question.len();
        let mut stream = TcpStream::connect(("127.0.0.1", server.port())).unwrap();
        let head = format!(
            "POST /api/frame HTTP/1.1\r\nHost: {host}\r\nContent-Type: application/json\r\nContent-Length: {length}\r\n\r\n"
        );
        stream.write_all(format!("{head}{question}").as_bytes()).unwrap();
    }
    // Twenty that are open at once, each with six connections as browsers have them, and all ask.
    let open: Vec<TcpStream> =
        (0..120).map(|_| TcpStream::connect(("127.0.0.1", server.port())).unwrap()).collect();
    thread::scope(|scope| {
        for _ in 0..20 {
            scope.spawn(|| {
                let question = json!({ "look": { "width": 160, "height": 120 }, "renderer": "zbuffer" });
                let answer = post(&server, "/api/frame", &question.to_string(), "");
                assert_eq!(status(&answer), 200, "{answer}");
            });
        }
    });
    drop(open);
}

#[test]
fn a_taken_port_means_the_next_free_one() {
    // A port with a free one after it, as far as the system tells.
    let taken = TcpListener::bind(("127.0.0.1", 0)).unwrap();
    let port = taken.local_addr().unwrap().port();
    let server = Server::start(port, mine(), None).unwrap();
    assert!(
        server.port() > port && server.port() <= port.saturating_add(100),
        "{} after {port}",
        server.port()
    );
    assert!(server.address("L31?p=64").ends_with("#L31?p=64"));
}

#[test]
fn two_starts_have_two_keys() {
    let [a, b] = [served(), served()];
    let key = |server: &Server| server.address("").split("key=").nth(1).unwrap().to_owned();
    assert_eq!(key(&a).len(), 32);
    assert_ne!(key(&a), key(&b));
    // And what one gives, the other does not take.
    assert_eq!(body(&get(&b, "/api/lecture", &cookie(&a)))["token"], false);
}
