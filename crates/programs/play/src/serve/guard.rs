//! Does this request come from the page, in the browser of the one who started the program?
//!
//! The loopback address keeps other machines out, but not other pages in the same browser: a page of somebody else may send requests here, and
//! by a name that it lets point to 127.0.0.1 it may even read the answers (DNS rebinding). So the request must say that it means this
//! host, and that it comes from nowhere else. What runs the student's code needs the key besides. It is printed, and handed to the browser that is opened; on systems where users see each other's command lines,
//! `--no-open` keeps it out of them.

use std::fmt;

use hyper::HeaderMap;
use hyper::header::{COOKIE, HOST, ORIGIN};

/// The names of this machine by which the page may be opened.
const HOSTS: [&str; 2] = ["127.0.0.1", "localhost"];

/// A word that is new at each start and that nobody guesses.
#[derive(Clone, PartialEq, Eq)]
pub(crate) struct Key(String);

impl Key {
    /// 128 bits from the system.
    pub(crate) fn new() -> Result<Self, getrandom::Error> {
        let mut bytes = [0; 16];
        getrandom::fill(&mut bytes)?;
        Ok(Self(bytes.iter().map(|byte| format!("{byte:02x}")).collect()))
    }
}

impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl fmt::Debug for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Key(…)")
    }
}

/// Knows what an honest request looks like.
#[derive(Debug)]
pub(crate) struct Guard {
    /// The port that the server listens on.
    pub(crate) port: u16,
    pub(crate) key: Key,
}

impl Guard {
    /// Whether the request means this server and comes from its page, or from an address typed by hand.
    ///
    /// - `is_page`: it asks for the page alone, which says nothing that is secret: then a link on any other page may lead here.
    pub(crate) fn admits(&self, headers: &HeaderMap, is_page: bool) -> bool {
        let hosts: Vec<&str> = texts(headers, HOST.as_str());
        let is_ours = |host: &str| {
            host.rsplit_once(':')
                .is_some_and(|(name, port)| HOSTS.contains(&name) && port == self.port.to_string())
        };
        let means_us = hosts.len() == 1 && is_ours(hosts[0]);
        let comes_from_us = texts(headers, ORIGIN.as_str())
            .iter()
            .all(|origin| origin.strip_prefix("http://").is_some_and(is_ours));
        // Browsers say where a request begins even where they send no origin; an address that was typed begins nowhere.
        let begins_here =
            texts(headers, "sec-fetch-site").iter().all(|site| matches!(*site, "same-origin" | "none"));
        let follows_a_link = is_page
            && texts(headers, "sec-fetch-mode") == ["navigate"]
            && texts(headers, "sec-fetch-dest") == ["document"];
        means_us && comes_from_us && (begins_here || follows_a_link)
    }

    /// Whether the browser has shown the key.
    pub(crate) fn trusts(&self, headers: &HeaderMap) -> bool {
        let wanted = format!("{}={}", self.cookie(), self.key);
        texts(headers, COOKIE.as_str())
            .iter()
            .flat_map(|line| line.split(';'))
            .any(|pair| pair.trim() == wanted)
    }

    /// What keeps the key in the browser: cookies know no ports, so that two servers need two names.
    pub(crate) fn cookie(&self) -> String {
        format!("lightlab-{}", self.port)
    }

    /// The line that gives the key to the browser: for this host only, never to a script, never with a request that begins on another page.
    pub(crate) fn set_cookie(&self) -> String {
        format!("{}={}; Path=/; HttpOnly; SameSite=Strict", self.cookie(), self.key)
    }
}

/// The values of a header; one that is no text is a value that nothing equals.
fn texts<'a>(headers: &'a HeaderMap, name: &str) -> Vec<&'a str> {
    headers.get_all(name).iter().map(|value| value.to_str().unwrap_or("?")).collect()
}

#[cfg(test)]
mod tests {
    use hyper::header::{HeaderName, HeaderValue};

    use super::*;

    fn guard() -> Guard {
        Guard { port: 4000, key: Key("k".to_owned()) }
    }

    fn headers(pairs: &[(&str, &str)]) -> HeaderMap {
        let pair = |(name, value): &(&str, &str)| {
            (HeaderName::from_bytes(name.as_bytes()).unwrap(), HeaderValue::from_str(value).unwrap())
        };
        pairs.iter().map(pair).collect()
    }

    #[test]
    fn the_page_itself_is_admitted_and_so_is_an_address_typed_by_hand() {
        for host in ["127.0.0.1:4000", "localhost:4000"] {
            assert!(guard().admits(&headers(&[("host", host)]), false));
            let origin = format!("http://{host}");
            assert!(guard().admits(
                &headers(&[("host", host), ("origin", &origin), ("sec-fetch-site", "same-origin")]),
                false
            ));
        }
    }

    #[test]
    fn other_names_for_this_machine_are_turned_away() {
        for host in [
            "evil.example:4000",
            "127.0.0.1",
            "127.0.0.1:4001",
            "127.0.0.1:4000.evil.example",
            "[::1]:4000",
            "",
        ] {
            assert!(!guard().admits(&headers(&[("host", host)]), false), "{host}");
        }
        assert!(!guard().admits(&HeaderMap::new(), true));
        let mut twice = headers(&[("host", "127.0.0.1:4000")]);
        twice.append(HOST, HeaderValue::from_static("127.0.0.1:4000"));
        assert!(!guard().admits(&twice, true));
    }

    #[test]
    fn requests_from_other_pages_are_turned_away() {
        for (name, value) in [
            ("origin", "http://evil.example"),
            ("origin", "null"),
            ("origin", "https://127.0.0.1:4000"),
            ("origin", "http://127.0.0.1:4001"),
            ("sec-fetch-site", "cross-site"),
            ("sec-fetch-site", "same-site"),
        ] {
            assert!(
                !guard().admits(&headers(&[("host", "127.0.0.1:4000"), (name, value)]), false),
                "{name}: {value}"
            );
        }
    }

    #[test]
    fn a_link_on_another_page_leads_to_the_page_and_to_nothing_else() {
        let link = [
            ("host", "127.0.0.1:4000"),
            ("sec-fetch-site", "cross-site"),
            ("sec-fetch-mode", "navigate"),
            ("sec-fetch-dest", "document"),
        ];
        assert!(guard().admits(&headers(&link), true));
        assert!(!guard().admits(&headers(&link), false));
        let framed = [link[0], link[1], link[2], ("sec-fetch-dest", "iframe")];
        assert!(!guard().admits(&headers(&framed), true));
    }

    #[test]
    fn only_the_key_of_this_start_is_trusted() {
        assert!(guard().trusts(&headers(&[("cookie", "a=b; lightlab-4000=k")])));
        for cookie in ["lightlab-4000=K", "lightlab-4000=", "lightlab-4001=k", "xlightlab-4000=k", "k"] {
            assert!(!guard().trusts(&headers(&[("cookie", cookie)])), "{cookie}");
        }
        assert_ne!(Key::new().unwrap(), Key::new().unwrap());
    }
}
