//! Which box next? The nearest that is met; the others wait.

use super::tree::{Child, Node, WIDTH};

/// Where one bundle is on its way through the tree.
pub(super) struct Walk {
    /// The next child, where that is decided.
    next: Option<Child>,
    waiting: Stack,
}

impl From<Option<Child>> for Walk {
    /// The way that begins with this child.
    #[inline(always)]
    fn from(next: Option<Child>) -> Self {
        Self { next, waiting: Stack::default() }
    }
}

impl Walk {
    /// Opens leaves until the next one is a node. `None` at the end of the way.
    #[inline(always)]
    pub(super) fn next_node(&mut self, t1: &mut f32, open: &mut impl FnMut(usize) -> f32) -> Option<usize> {
        loop {
            let child = match self.next.take() {
                Some(child) => child,
                None => {
                    let waiting = self.waiting.pop()?;
                    // The search may have become shorter since the box was put aside.
                    if waiting.enter() > *t1 {
                        continue;
                    }
                    waiting.child()
                }
            };
            match child.as_leaf() {
                Some(leaf) => *t1 = open(leaf),
                None => return Some(child.0 as usize),
            }
        }
    }

    /// Goes on to the nearest child that is met, and puts the others aside.
    #[inline(always)]
    pub(super) fn choose(&mut self, node: &Node, enter: &[f32; WIDTH], met: u32) {
        let waiting = |met: u32| {
            let k = met.trailing_zeros() as usize % WIDTH;
            Waiting::new(enter[k], node.children[k])
        };
        let rest = met & met.wrapping_sub(1);
        if met == 0 {
        } else if rest == 0 {
            self.next = Some(waiting(met).child());
        } else if rest & (rest - 1) == 0 {
            let (a, b) = (waiting(met), waiting(rest));
            self.waiting.push(Waiting(a.0.max(b.0)));
            self.next = Some(Waiting(a.0.min(b.0)).child());
        } else {
            let first = self.waiting.len;
            let mut met = met;
            while met != 0 {
                self.waiting.push_sorted(first, waiting(met));
                met &= met - 1;
            }
        }
    }
}

/// A child put aside, with where the bundle enters it: the bits of that number, then the child, so that they are ordered by
/// one comparison. (Where it is negative the order is another one; nothing depends on it.)
#[derive(Clone, Copy, Default, PartialEq, PartialOrd)]
struct Waiting(u64);

impl Waiting {
    #[inline(always)]
    fn new(enter: f32, child: Child) -> Self {
        Self(u64::from(enter.to_bits()) << 32 | u64::from(child.0))
    }

    #[inline(always)]
    fn enter(self) -> f32 {
        f32::from_bits((self.0 >> 32) as u32)
    }

    #[inline(always)]
    fn child(self) -> Child {
        Child(self.0 as u32)
    }
}

/// Children put aside. The first few need no memory of their own; more happen only in a badly balanced tree.
struct Stack {
    few: [Waiting; Stack::FEW],
    len: usize,
    more: Vec<Waiting>,
}

impl Default for Stack {
    #[inline(always)]
    fn default() -> Self {
        Self { few: [Waiting::default(); Self::FEW], len: 0, more: Vec::new() }
    }
}

impl Stack {
    const FEW: usize = 32;

    #[inline(always)]
    fn push(&mut self, item: Waiting) {
        match self.few.get_mut(self.len) {
            Some(place) => {
                *place = item;
                self.len += 1;
            }
            None => self.more.push(item),
        }
    }

    /// Pushes the item below those from `first` on that are nearer.
    #[inline(always)]
    fn push_sorted(&mut self, first: usize, item: Waiting) {
        if self.len == Self::FEW {
            return self.more.push(item);
        }
        let mut place = self.len;
        while place > first && self.few[place - 1] < item {
            self.few[place] = self.few[place - 1];
            place -= 1;
        }
        self.few[place] = item;
        self.len += 1;
    }

    #[inline(always)]
    fn pop(&mut self) -> Option<Waiting> {
        if self.len == Self::FEW
            && let Some(item) = self.more.pop()
        {
            return Some(item);
        }
        self.len = self.len.checked_sub(1)?;
        self.few.get(self.len).copied()
    }
}
