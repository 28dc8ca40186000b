//! Bit sets over the directed portals or the cells of one graph: plain words, because the search
//! intersects millions of them.

use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// A set of small integers of a fixed universe.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Bits {
    words: Vec<u64>,
}

impl Bits {
    /// The empty set of a universe of `size` members.
    pub fn new(size: usize) -> Bits {
        Bits { words: vec![0; size.div_ceil(64)] }
    }

    pub fn clear(&mut self) {
        self.words.fill(0);
    }

    pub fn has(&self, member: u32) -> bool {
        self.words[member as usize / 64] >> (member % 64) & 1 == 1
    }

    /// Adds `member`; whether it is new.
    pub fn insert(&mut self, member: u32) -> bool {
        let word = &mut self.words[member as usize / 64];
        let bit = 1 << (member % 64);
        let new = *word & bit == 0;
        *word |= bit;
        new
    }

    pub fn remove(&mut self, member: u32) {
        self.words[member as usize / 64] &= !(1 << (member % 64));
    }

    pub fn assign_intersection(&mut self, a: &Bits, b: &Bits) {
        for ((out, a), b) in self.words.iter_mut().zip(&a.words).zip(&b.words) {
            *out = a & b;
        }
    }

    pub fn assign_shared(&mut self, other: &SharedBits) {
        for (out, other) in self.words.iter_mut().zip(&other.words) {
            *out = other.load(Relaxed);
        }
    }

    pub fn assign_shared_intersection(&mut self, a: &Bits, b: &SharedBits) {
        for ((out, a), b) in self.words.iter_mut().zip(&a.words).zip(&b.words) {
            *out = a & b.load(Relaxed);
        }
    }

    pub fn intersect(&mut self, other: &Bits) {
        for (out, b) in self.words.iter_mut().zip(&other.words) {
            *out &= b;
        }
    }

    pub fn intersects(&self, other: &Bits) -> bool {
        self.words.iter().zip(&other.words).any(|(a, b)| a & b != 0)
    }

    pub fn subtract(&mut self, other: &Bits) {
        for (out, b) in self.words.iter_mut().zip(&other.words) {
            *out &= !b;
        }
    }

    pub fn unite(&mut self, other: &Bits) {
        for (out, b) in self.words.iter_mut().zip(&other.words) {
            *out |= b;
        }
    }

    pub fn count(&self) -> u32 {
        self.words.iter().map(|w| w.count_ones()).sum()
    }

    pub fn is_empty(&self) -> bool {
        self.words.iter().all(|&w| w == 0)
    }

    /// Removes the members for which `keep` does not hold.
    pub fn retain(&mut self, keep: impl Fn(u32) -> bool) {
        for (index, word) in self.words.iter_mut().enumerate() {
            let mut rest = *word;
            while rest != 0 {
                let bit = rest.trailing_zeros();
                rest &= rest - 1;
                if !keep(index as u32 * 64 + bit) {
                    *word &= !(1 << bit);
                }
            }
        }
    }

    /// The words that are not empty, with their indices, instead of those in `into`.
    pub fn words(&self, into: &mut Vec<(u32, u64)>) {
        into.clear();
        let words = self.words.iter().enumerate().map(|(index, &word)| (index as u32, word));
        into.extend(words.filter(|&(_, word)| word != 0));
    }

    /// The members in ascending order.
    pub fn iter(&self) -> impl Iterator<Item = u32> + '_ {
        self.words.iter().enumerate().flat_map(|(i, &word)| {
            std::iter::successors((word != 0).then_some(word), |w| {
                let rest = w & (w - 1);
                (rest != 0).then_some(rest)
            })
            .map(move |w| i as u32 * 64 + w.trailing_zeros())
        })
    }
}

/// A set that threads share, and from which members only ever vanish.
#[derive(Debug)]
pub(crate) struct SharedBits {
    words: Vec<AtomicU64>,
}

impl From<Bits> for SharedBits {
    fn from(bits: Bits) -> SharedBits {
        SharedBits { words: bits.words.into_iter().map(AtomicU64::new).collect() }
    }
}

impl SharedBits {
    pub fn remove(&self, member: u32) {
        self.words[member as usize / 64].fetch_and(!(1 << (member % 64)), Relaxed);
    }

    /// Whether a member is in one of the `words` of another set.
    pub fn intersects(&self, words: &[(u32, u64)]) -> bool {
        words.iter().any(|&(index, word)| self.words[index as usize].load(Relaxed) & word != 0)
    }
}
