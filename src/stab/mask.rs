//! Sets of constraints: one bit each, any number of them, the first 128 without an allocation.

/// A set of small indices.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Mask {
    low: u128,
    /// Bits 128 and up, in blocks of 128; missing blocks are empty.
    high: Vec<u128>,
}

impl Mask {
    /// The set `{0, …, count - 1}`.
    pub(super) fn first(count: usize) -> Mask {
        let mut mask = Mask::default();
        (0..count).for_each(|index| mask.insert(index));
        mask
    }

    pub(super) fn insert(&mut self, index: usize) {
        match (index / 128).checked_sub(1) {
            None => self.low |= 1 << index,
            Some(block) => {
                if self.high.len() <= block {
                    self.high.resize(block + 1, 0);
                }
                self.high[block] |= 1 << (index % 128);
            }
        }
    }

    pub(super) fn contains(&self, index: usize) -> bool {
        match (index / 128).checked_sub(1) {
            None => self.low >> index & 1 == 1,
            Some(block) => self.high.get(block).is_some_and(|bits| bits >> (index % 128) & 1 == 1),
        }
    }

    pub(super) fn intersection(&self, other: &Mask) -> Mask {
        let low = self.low & other.low;
        if self.high.is_empty() || other.high.is_empty() {
            return Mask { low, high: Vec::new() };
        }
        Mask { low, high: self.high.iter().zip(&other.high).map(|(a, b)| a & b).collect() }
    }

    /// How many members the two sets share.
    pub(super) fn common(&self, other: &Mask) -> usize {
        let high = self.high.iter().zip(&other.high).map(|(a, b)| (a & b).count_ones());
        ((self.low & other.low).count_ones() + high.sum::<u32>()) as usize
    }

    /// The set's bits, where none is 128 or more.
    pub(super) fn one_block(&self) -> Option<u128> {
        self.high.is_empty().then_some(self.low)
    }

    pub(super) fn is_subset_of(&self, other: &Mask) -> bool {
        self.low & !other.low == 0
            && (self.high.iter().enumerate())
                .all(|(block, bits)| bits & !other.high.get(block).unwrap_or(&0) == 0)
    }

    pub(super) fn len(&self) -> usize {
        let high: u32 = self.high.iter().map(|bits| bits.count_ones()).sum();
        (self.low.count_ones() + high) as usize
    }

    /// The members in ascending order.
    pub(super) fn members(&self) -> impl Iterator<Item = usize> + '_ {
        std::iter::once(&self.low).chain(&self.high).enumerate().flat_map(|(block, &bits)| {
            let mut rest = bits;
            std::iter::from_fn(move || {
                let index = rest.trailing_zeros();
                (rest != 0).then(|| {
                    rest &= rest - 1;
                    block * 128 + index as usize
                })
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sets_beyond_one_block_behave_like_sets() {
        let odd = (0..400).filter(|i| i % 2 == 1);
        let mut odds = Mask::default();
        odd.clone().for_each(|i| odds.insert(i));
        assert!(odds.members().eq(odd));
        assert_eq!(odds.len(), 200);
        assert!(odds.contains(399) && !odds.contains(398) && !odds.contains(1000));
        let small = Mask::first(10);
        assert_eq!(small.intersection(&odds).len(), 5);
        assert!(odds.intersection(&small).is_subset_of(&small));
        assert!(!odds.is_subset_of(&small) && !small.is_subset_of(&odds));
    }
}
