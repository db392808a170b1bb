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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whoever_pays_the_last_of_it_is_told() {
        let budget = Budget::new(5);
        assert!(budget.pay(3) && !budget.is_spent());
        assert!(!budget.pay(2) && budget.is_spent());
        assert!(!budget.pay(1), "nothing comes back");
    }
}
