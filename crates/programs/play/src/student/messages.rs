//! Messages for functions that cannot be drawn, or only in part.

use course::{Late, Loss, Reply};
use grader::{Outcome, Unreadable};
use sheet::Words;

/// The reason why a picture is missing or incomplete.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Trouble {
    /// One word for the page's code.
    pub(super) state: &'static str,
    /// One sentence for the student.
    pub(super) message: Words,
    /// The compiler's message.
    pub(super) detail: Option<String>,
}

impl Trouble {
    fn new(state: &'static str, en: impl Into<String>, nl: impl Into<String>) -> Self {
        Self { state, message: Words::new(en, nl), detail: None }
    }

    /// A failure that the student did not cause.
    pub(super) fn fault(what: &str) -> Self {
        Self::new(
            "fault",
            format!("Something is wrong here, not with the file: {what}."),
            format!("Er is hier iets mis, niet met het bestand: {what}."),
        )
    }

    /// A file in which nothing has been done.
    fn not_started() -> Self {
        Self::new(
            "not-started",
            "`todo!()` still stands where the solution goes.",
            "Waar de oplossing komt staat nog `todo!()`.",
        )
    }

    /// Why a file cannot be asked.
    pub(super) fn of_file(outcome: Outcome) -> Self {
        match outcome {
            Outcome::NotStarted => Self::not_started(),
            Outcome::DoesNotCompile { message, note } => Self {
                detail: Some(match note {
                    Some(note) => format!("{message}\n{note}"),
                    None => message,
                }),
                ..Self::new(
                    "does-not-compile",
                    "Rust does not accept the file; the compiler says why.",
                    "Rust aanvaardt het bestand niet; de compiler zegt waarom.",
                )
            },
            Outcome::Unreadable(why) => unreadable(&why),
            Outcome::GraderError(what) => Self::fault(&what),
            other => Self::fault(&other.sentence().unwrap_or_default()),
        }
    }

    /// What a reply that is no value means.
    pub(super) fn of_reply(reply: &Reply) -> Option<Self> {
        Some(match reply {
            Reply::Value(_) => return None,
            Reply::Panicked(panic) if panic.message.starts_with("not yet implemented") => Self::not_started(),
            Reply::Panicked(panic) => {
                let place =
                    if panic.line == 0 { String::new() } else { format!(" ({}:{})", panic.file, panic.line) };
                let message = &panic.message;
                Self::new(
                    "panicked",
                    format!("The code panicked{place}: {message}"),
                    format!("De code raakte in paniek{place}: {message}"),
                )
            }
            Reply::Lost(loss) => lost(loss),
        })
    }
}

fn lost(loss: &Loss) -> Trouble {
    match loss {
        Loss::TimedOut(late) => timed_out(*late),
        Loss::TooManyThreads => Trouble::new(
            "ended",
            "The code started more threads than any exercise needs.",
            "De code startte meer threads dan welke oefening ook nodig heeft.",
        ),
        Loss::OutOfMemory => Trouble::new(
            "ended",
            "The code asked for more memory than any exercise needs.",
            "De code vroeg meer geheugen dan welke oefening ook nodig heeft.",
        ),
        Loss::StackOverflow => Trouble::new(
            "ended",
            "The code filled its stack: a function calls itself without end.",
            "De code vulde haar stack: een functie roept zichzelf zonder einde aan.",
        ),
        Loss::Exited(code) => Trouble::new(
            "ended",
            format!("The code ended the whole program with exit code {code}: an exercise returns a value."),
            format!(
                "De code beëindigde het hele programma met exitcode {code}: een oefening geeft een waarde terug."
            ),
        ),
        Loss::Crashed(how) => Trouble::new(
            "ended",
            format!("The code ended the program: {how}."),
            format!("De code beëindigde het programma: {how}."),
        ),
    }
}

fn timed_out(late: Late) -> Trouble {
    let (Late::Computing(limit) | Late::Waiting(limit) | Late::Together(limit)) = late;
    let seconds = limit as f64 / 1e3;
    match late {
        Late::Computing(_) => Trouble::new(
            "timed-out",
            format!("No answer after {seconds} s of computing: is there a loop without end?"),
            format!("Geen antwoord na {seconds} s rekenen: is er een lus zonder einde?"),
        ),
        Late::Waiting(_) => Trouble::new(
            "timed-out",
            format!("No answer after {seconds} s, most of which the code waited."),
            format!("Geen antwoord na {seconds} s, waarin de code vooral wachtte."),
        ),
        Late::Together(_) => Trouble::new(
            "timed-out",
            format!("All calls together took more than {seconds} s."),
            format!("Alle oproepen samen duurden langer dan {seconds} s."),
        ),
    }
}

fn unreadable(why: &Unreadable) -> Trouble {
    let (en, nl) = match why {
        Unreadable::Missing => (
            "There is no such file; `cargo lab reset` brings it back.".to_owned(),
            "Dat bestand is er niet; `cargo lab reset` brengt het terug.".to_owned(),
        ),
        Unreadable::NotAFile => ("That is not a file.".to_owned(), "Dat is geen bestand.".to_owned()),
        Unreadable::Empty => (
            "The file is empty; `cargo lab reset` brings the task back.".to_owned(),
            "Het bestand is leeg; `cargo lab reset` brengt de opdracht terug.".to_owned(),
        ),
        Unreadable::NotUtf8 { line } => (
            format!("Line {line} is not UTF-8 text: save the file with that encoding."),
            format!("Regel {line} is geen UTF-8-tekst: bewaar het bestand in die codering."),
        ),
        Unreadable::TooLong => (
            "The file is over one MiB long: that is no solution.".to_owned(),
            "Het bestand is langer dan een MiB: dat is geen oplossing.".to_owned(),
        ),
        Unreadable::Io(error) => {
            (format!("The file cannot be read: {error}."), format!("Het bestand is niet te lezen: {error}."))
        }
    };
    Trouble::new("unreadable", en, nl)
}
