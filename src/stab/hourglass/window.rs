//! A window of an array of numbers, which loses numbers at both sides, gains them at its end, and
//! can be put back to what it was.

use std::ops::Range;

/// A window of an array.
#[derive(Clone, Debug, Default)]
pub(super) struct Window {
    array: Vec<u32>,
    start: u32,
    end: u32,
}

/// What a window was before a push.
#[derive(Clone, Copy, Debug)]
pub(super) struct Undo {
    start: u32,
    end: u32,
    length: u32,
    /// The place of the array that was written to, and what stood there.
    slot: u32,
    before: u32,
}

impl Window {
    /// How many there are in it.
    #[inline]
    pub(super) fn len(&self) -> usize {
        (self.end - self.start) as usize
    }

    /// The numbers in it.
    pub(super) fn ends(&self) -> &[u32] {
        &self.array[self.start as usize..self.end as usize]
    }

    /// The number at a place.
    #[inline]
    pub(super) fn at(&self, i: usize) -> u32 {
        self.array[self.start as usize + i]
    }

    /// Leaves only some places of it.
    pub(super) fn keep(&mut self, places: Range<usize>) {
        let start = self.start;
        (self.start, self.end) = (start + places.start as u32, start + places.end as u32);
    }

    /// What [`Window::restore`] needs.
    pub(super) fn undo(&self) -> Undo {
        let Window { array, start, end } = self;
        Undo { start: *start, end: *end, length: array.len() as u32, slot: u32::MAX, before: 0 }
    }

    /// Makes it what it was: O(1).
    pub(super) fn restore(&mut self, undo: &Undo) {
        self.array.truncate(undo.length as usize);
        if undo.slot < undo.length {
            self.array[undo.slot as usize] = undo.before;
        }
        (self.start, self.end) = (undo.start, undo.end);
    }

    /// Keeps `before` numbers at the start and `after` at the end, with `new` in between. O(1)
    /// where `after` is zero; else the window is written anew, behind the array.
    pub(super) fn insert(&mut self, before: usize, new: u32, after: usize, undo: &mut Undo) {
        if after == 0 {
            let slot = self.start + before as u32;
            match self.array.get_mut(slot as usize) {
                Some(place) => (undo.slot, undo.before) = (slot, std::mem::replace(place, new)),
                None => self.array.push(new),
            }
            self.end = slot + 1;
            return;
        }
        let (start, end) = (self.start as usize, self.end as usize);
        self.start = self.array.len() as u32;
        self.array.extend_from_within(start..start + before);
        self.array.push(new);
        self.array.extend_from_within(end - after..end);
        self.end = self.array.len() as u32;
    }
}
