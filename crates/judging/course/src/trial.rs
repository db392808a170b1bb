//! Does a function keep the laws of its exercise, and if not, what is the smallest input on which it fails?

use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use testkit::fingerprint;
use worker::Value;

use crate::answerer::{Answerer, Fault, Late, Loss, Reply};
use crate::exercise::{Example, Exercise};
use crate::law::{Asker, Broken, Case, Law, Stop};

/// So many steps towards a smaller input, at most.
const MOST_SHRINKING: u32 = 400;

/// So many calls that never came back, at most; the laws after them are not tried. Each may cost the whole time limit.
const MOST_LOSSES: u32 = 2;

/// The name under which the worked examples are reported.
pub const EXAMPLES: &str = "worked_examples";

/// What a trial brought to light.
#[derive(Clone, Debug, PartialEq)]
pub struct Examination {
    /// Of the worked examples first, then of each law in order.
    pub laws: Vec<Tried>,
    /// Calls that were answered, with the answers: what a diagnosis looks at.
    pub answered: Vec<(Vec<Value>, Value)>,
    /// Places in `answered` of the calls that smaller counterexamples were sought with: that search goes where answers are odd.
    pub sought: Vec<usize>,
    /// Whether the very first call said that nothing is there yet: `todo!()`.
    pub not_started: bool,
    /// The limit on all calls together, if they reached it. Then no law counts as tried: on which call that happens is chance.
    pub exhausted: Option<Late>,
}

/// A law and how it went.
#[derive(Clone, Debug, PartialEq)]
pub struct Tried {
    /// The law's name.
    pub name: &'static str,
    /// What it states.
    pub statement: &'static str,
    /// What keeping it is worth.
    pub points: u32,
    /// How it went.
    pub outcome: Outcome,
}

/// How a law went.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// It held for so many inputs.
    Kept(u32),
    /// It did not hold.
    Failed(Box<Counterexample>),
    /// It was not tried.
    NotRun,
}

/// The smallest input found on which a law does not hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Counterexample {
    /// Which worked example it is, if it is one.
    pub example: Option<&'static str>,
    /// The calls that show it, with what came of them.
    pub calls: Vec<(Vec<Value>, Reply)>,
    /// What was wrong: `None` if the last call gave no value.
    pub broken: Option<Broken>,
    /// What would help.
    pub help: &'static str,
}

impl Examination {
    /// The points of the laws that hold.
    pub fn points(&self) -> u32 {
        self.laws.iter().filter(|law| matches!(law.outcome, Outcome::Kept(_))).map(|law| law.points).sum()
    }

    /// Whether every law holds.
    pub fn passed(&self) -> bool {
        !self.not_started
            && self.exhausted.is_none()
            && self.laws.iter().all(|law| matches!(law.outcome, Outcome::Kept(_)))
    }

    /// The counterexample to show.
    pub fn counterexample(&self) -> Option<(&Tried, &Counterexample)> {
        counterexample(&self.laws)
    }
}

/// The counterexample to show: that of the first law that fails; a worked example's only if all laws hold, since it is not the smallest input.
pub fn counterexample(laws: &[Tried]) -> Option<(&Tried, &Counterexample)> {
    let (examples, laws) = laws.split_at(laws.len().min(1));
    laws.iter().chain(examples).find_map(|law| match &law.outcome {
        Outcome::Failed(counterexample) => Some((law, &**counterexample)),
        Outcome::Kept(_) | Outcome::NotRun => None,
    })
}

/// Tries all laws of an exercise. The inputs depend on the exercise and the seed alone.
///
/// # Errors
/// [`Fault`]: the one who judges cannot go on, or a law is at fault itself. Never the student's doing.
pub fn examine(exercise: &Exercise, seed: u64, answerer: &mut dyn Answerer) -> Result<Examination, Fault> {
    let mut trial = Trial { answerer, answered: Vec::new(), sought: Vec::new(), losses: 0, exhausted: None };
    let mut laws = vec![Tried {
        name: EXAMPLES,
        statement: "The worked examples come out as they should.",
        points: Exercise::EXAMPLE_POINTS,
        outcome: Outcome::NotRun,
    }];
    laws.extend(exercise.laws.iter().map(|law| Tried {
        name: law.name(),
        statement: law.statement(),
        points: law.points(),
        outcome: Outcome::NotRun,
    }));
    if trial.says_todo(&exercise.examples)? {
        return Ok(Examination {
            laws,
            answered: Vec::new(),
            sought: Vec::new(),
            not_started: true,
            exhausted: None,
        });
    }
    laws[0].outcome = trial.examples(&exercise.examples)?;
    for (law, tried) in exercise.laws.iter().zip(&mut laws[1..]) {
        if trial.losses < MOST_LOSSES && trial.exhausted.is_none() {
            let seed = seed_of(seed, &[exercise.name, law.name()]);
            tried.outcome = trial
                .law(law, &seed)
                .map_err(|fault| Fault(format!("law {} of {}: {fault}", law.name(), exercise.name)))?;
        }
    }
    if trial.exhausted.is_some() {
        for law in &mut laws {
            law.outcome = Outcome::NotRun;
        }
    }
    let Trial { answered, sought, exhausted, .. } = trial;
    Ok(Examination { laws, answered, sought, not_started: false, exhausted })
}

struct Trial<'a> {
    answerer: &'a mut dyn Answerer,
    answered: Vec<(Vec<Value>, Value)>,
    sought: Vec<usize>,
    losses: u32,
    exhausted: Option<Late>,
}

/// What is known of one input: the answers that its check has asked for.
type Known = Vec<(Vec<Value>, Reply)>;

/// A check's end: well, or not.
type Ended = Result<(), Ill>;

/// Why an input speaks against the function.
struct Ill {
    broken: Option<Broken>,
}

impl Trial<'_> {
    fn says_todo(&mut self, examples: &[Example]) -> Result<bool, Fault> {
        let Some(first) = examples.first() else { return Ok(false) };
        let replies = self.answerer.ask(std::slice::from_ref(&first.arguments))?;
        // What `todo!()` says, with or without a text of the student's own.
        Ok(
            matches!(replies.first(), Some(Reply::Panicked(panic)) if panic.message.starts_with("not yet implemented")),
        )
    }

    fn examples(&mut self, examples: &[Example]) -> Result<Outcome, Fault> {
        let mut cases: Vec<Box<dyn Case + '_>> =
            examples.iter().map(|example| Box::new(Fixed(example)) as Box<dyn Case>).collect();
        let failed = self.settle(&mut cases)?;
        Ok(match failed {
            None => Outcome::Kept(examples.len() as u32),
            Some((at, calls, ill)) => Outcome::Failed(Box::new(Counterexample {
                example: Some(examples[at].caption),
                calls,
                broken: ill.broken,
                help: "Work this example out by hand, step by step, and compare.",
            })),
        })
    }

    fn law(&mut self, law: &Law, seed: &[u8; 32]) -> Result<Outcome, Fault> {
        let rng = TestRng::from_seed(RngAlgorithm::ChaCha, seed);
        let mut runner =
            TestRunner::new_with_rng(Config { failure_persistence: None, ..Config::default() }, rng);
        let mut cases =
            law.grow(&mut runner).map_err(|reason| Fault(format!("no inputs: {}", reason.message())))?;
        let Some((at, calls, ill)) = self.settle(&mut cases)? else {
            return Ok(Outcome::Kept(cases.len() as u32));
        };
        let (calls, ill) = self.shrink(cases[at].as_mut(), calls, ill)?;
        let broken = ill.broken;
        Ok(Outcome::Failed(Box::new(Counterexample { example: None, calls, broken, help: law.help() })))
    }

    /// Checks all inputs, asking what they ask for in as few batches as possible; the first that fails, by its place.
    fn settle<'c>(&mut self, cases: &mut [Box<dyn Case + 'c>]) -> Result<Option<(usize, Known, Ill)>, Fault> {
        let mut known: Vec<Known> = vec![Vec::new(); cases.len()];
        let mut ends: Vec<Option<Ended>> = cases.iter().map(|_| None).collect();
        // Inputs from here on are left alone, since one before them fails.
        let mut end = cases.len();
        loop {
            let mut asked: Vec<(usize, Vec<Value>)> = Vec::new();
            let open: Vec<usize> = (0..end).filter(|at| ends[*at].is_none()).collect();
            for at in open {
                match look(cases[at].as_ref(), &known[at])? {
                    Look::Asks(question) => asked.push((at, question)),
                    Look::Ended(ended) => {
                        let failed = ended.is_err();
                        ends[at] = Some(ended);
                        if failed {
                            end = at + 1;
                            break;
                        }
                    }
                }
            }
            if asked.is_empty() {
                break;
            }
            let (places, questions): (Vec<usize>, Vec<Vec<Value>>) = asked.into_iter().unzip();
            let replies = self.ask(&questions)?;
            if let (Some(Reply::Lost(_)), Some(last)) = (replies.last(), places.get(replies.len() - 1)) {
                end = end.min(last + 1);
            }
            for ((at, question), reply) in places.into_iter().zip(questions).zip(replies) {
                known[at].push((question, reply));
            }
        }
        let failed = ends.into_iter().take(end).enumerate().find_map(|(at, ended)| match ended {
            Some(Err(ill)) => Some((at, ill)),
            _ => None,
        });
        Ok(failed.map(|(at, ill)| (at, std::mem::take(&mut known[at]), ill)))
    }

    /// Looks for a smaller input that fails in the same way: wrong stays wrong, a panic stays a panic.
    fn shrink(&mut self, case: &mut dyn Case, calls: Known, ill: Ill) -> Result<(Known, Ill), Fault> {
        let mut best = (calls, ill);
        if matches!(best.0.last(), Some((_, Reply::Lost(_)))) || !case.simplify() {
            return Ok(best);
        }
        for _ in 0..MOST_SHRINKING {
            let (calls, ended) = self.single(case)?;
            let alike = match &ended {
                Err(ill) => {
                    ill.broken.is_some() == best.1.broken.is_some()
                        && !matches!(calls.last(), Some((_, Reply::Lost(_))))
                }
                Ok(()) => false,
            };
            let further = match ended {
                Err(ill) if alike => {
                    best = (calls, ill);
                    case.simplify()
                }
                _ => case.complicate(),
            };
            if !further || self.losses >= MOST_LOSSES || self.exhausted.is_some() {
                break;
            }
        }
        Ok(best)
    }

    fn single(&mut self, case: &dyn Case) -> Result<(Known, Ended), Fault> {
        let mut known = Known::new();
        loop {
            match look(case, &known)? {
                Look::Ended(ended) => return Ok((known, ended)),
                Look::Asks(question) => {
                    let before = self.answered.len();
                    let mut replies = self.ask(std::slice::from_ref(&question))?;
                    self.sought.extend(before..self.answered.len());
                    let reply = replies.pop().ok_or_else(|| Fault("no reply to a question".to_owned()))?;
                    known.push((question, reply));
                }
            }
        }
    }

    fn ask(&mut self, questions: &[Vec<Value>]) -> Result<Vec<Reply>, Fault> {
        let replies = self.answerer.ask(questions)?;
        for (question, reply) in questions.iter().zip(&replies) {
            match reply {
                Reply::Value(value) => self.answered.push((question.clone(), value.clone())),
                Reply::Lost(loss) => self.lose(loss),
                Reply::Panicked(_) => {}
            }
        }
        if replies.is_empty() && !questions.is_empty() {
            return Err(Fault("no reply to any question".to_owned()));
        }
        Ok(replies)
    }

    fn lose(&mut self, loss: &Loss) {
        self.losses += 1;
        if let Loss::TimedOut(late @ Late::Together(_)) = loss {
            self.exhausted = Some(*late);
        }
    }
}

/// Where a check stands, given what is known.
enum Look {
    Asks(Vec<Value>),
    Ended(Ended),
}

fn look(case: &dyn Case, known: &Known) -> Result<Look, Fault> {
    match case.check(&Asker { known }) {
        Ok(()) => Ok(Look::Ended(Ok(()))),
        Err(Stop::Pending(question)) => Ok(Look::Asks(question)),
        Err(Stop::Unanswered(_)) => Ok(Look::Ended(Err(Ill { broken: None }))),
        Err(Stop::Broken(broken)) => Ok(Look::Ended(Err(Ill { broken: Some(broken) }))),
        Err(Stop::Fault(fault)) => Err(fault),
    }
}

/// A worked example as a case: there is nothing smaller.
struct Fixed<'a>(&'a Example);

impl Case for Fixed<'_> {
    fn check(&self, asker: &Asker<'_>) -> Result<(), Stop> {
        self.0.check(&asker.ask(self.0.arguments.clone())?)
    }

    fn simplify(&mut self) -> bool {
        false
    }

    fn complicate(&mut self) -> bool {
        false
    }
}

/// From the seed and the names: a fingerprint with four different beginnings.
fn seed_of(seed: u64, names: &[&str]) -> [u8; 32] {
    let mut bytes = [0; 32];
    for (round, part) in bytes.chunks_exact_mut(8).enumerate() {
        let text = seed.to_le_bytes().into_iter().chain([round as u8]);
        let text = text.chain(names.iter().flat_map(|name| name.bytes().chain([0])));
        part.copy_from_slice(&fingerprint(text).to_le_bytes());
    }
    bytes
}
