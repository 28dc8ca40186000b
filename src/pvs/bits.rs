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

    pub fn intersects(&self, other: &Bits) -> bool {
        self.words.iter().zip(&other.words).any(|(a, b)| a & b != 0)
    }

    pub fn assign_intersection(&mut self, a: &Bits, b: &Bits) {
        for ((out, a), b) in self.words.iter_mut().zip(&a.words).zip(&b.words) {
            *out = a & b;
        }
    }

    pub fn assign_shared_intersection(&mut self, a: &Bits, b: &SharedBits) {
        for ((out, a), b) in self.words.iter_mut().zip(&a.words).zip(&b.words) {
            *out = a & b.load(Relaxed);
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

impl SharedBits {
    pub fn new(bits: &Bits) -> SharedBits {
        SharedBits { words: bits.words.iter().map(|&w| AtomicU64::new(w)).collect() }
    }

    pub fn remove(&self, member: u32) {
        self.words[member as usize / 64].fetch_and(!(1 << (member % 64)), Relaxed);
    }

    pub fn intersects(&self, other: &Bits) -> bool {
        self.words.iter().zip(&other.words).any(|(a, b)| a.load(Relaxed) & b != 0)
    }

    /// The members now.
    pub fn snapshot(&self) -> Bits {
        Bits { words: self.words.iter().map(|w| w.load(Relaxed)).collect() }
    }
}
