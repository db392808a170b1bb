//! How much work is too much? Comparing pairs costs the square of their number at worst, and cutting more.

use std::cell::Cell;

/// How many pairs of polygons may still be compared.
///
/// Who finds it spent stops at once, with whatever it has; who gave it looks at the end and throws that away.
pub(super) struct Budget(Cell<u64>);

impl Budget {
    pub(super) fn new(comparisons: u64) -> Self {
        Self(Cell::new(comparisons))
    }

    pub(super) fn unlimited() -> Self {
        Self::new(u64::MAX)
    }

    /// Takes the price of some comparisons; `false` if there is not enough left.
    pub(super) fn pay(&self, comparisons: usize) -> bool {
        self.0.set(self.0.get().saturating_sub(comparisons as u64));
        !self.is_spent()
    }

    pub(super) fn is_spent(&self) -> bool {
        self.0.get() == 0
    }
}
