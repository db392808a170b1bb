//! How is a file compiled once, and not again for each move of a slider?

use std::path::Path;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use course::Exercise;
use grader::{CompiledFunction, Judge, Outcome};

/// So many exercises are kept compiled.
const MOST: usize = 8;

/// The function of one exercise's file, and of which bytes it was made.
#[derive(Debug, Default)]
pub(super) struct Slot(Option<(u64, CompiledFunction)>);

/// The functions that were asked last.
#[derive(Debug, Default)]
pub(super) struct Shelf(Mutex<Vec<Named>>);

/// What was compiled of the exercise of this name.
type Named = (&'static str, Arc<Mutex<Slot>>);

impl Shelf {
    /// The slot of an exercise. Whoever draws with it locks it: one exercise is drawn by one at a time, different ones at once.
    pub(super) fn slot(&self, exercise: &Exercise) -> Arc<Mutex<Slot>> {
        let mut slots = locked(&self.0);
        let known = slots.iter().position(|(name, _)| *name == exercise.name);
        let slot = known.map_or_else(|| (exercise.name, Arc::default()), |place| slots.remove(place));
        slots.push(slot.clone());
        if slots.len() > MOST {
            slots.remove(0);
        }
        slot.1
    }

    /// Forgets all, and removes the programs of those that nobody draws with just now.
    pub(super) fn clear(&self) {
        locked(&self.0).clear();
    }
}

impl Slot {
    /// The function in the file, compiled if it has changed.
    ///
    /// - `now`: the fingerprint of its bytes; none if it cannot be read, which the judge says better.
    pub(super) fn open(
        &mut self,
        judge: &Judge,
        exercise: &'static Exercise,
        file: &Path,
        now: Option<u64>,
    ) -> Result<&CompiledFunction, Outcome> {
        if now.is_none() || self.0.as_ref().map(|(made_of, _)| *made_of) != now {
            self.0 = None;
            let opened = judge.open(exercise, file)?;
            self.0 = Some((now.unwrap_or_default(), opened));
        }
        self.0
            .as_ref()
            .map(|(_, opened)| opened)
            .ok_or_else(|| Outcome::GraderError("nothing was kept".to_owned()))
    }
}

/// What a lock holds, even if somebody panicked with it: nothing here is left half done.
pub(super) fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
