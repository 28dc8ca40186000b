//! REJECT lumps: which sectors cannot see which.
//!
//! One bit for each ordered pair of sectors, `from * sectors + to`, counted from the lowest bit of
//! the first byte; 1 says that the pair cannot see each other. Rows are not padded.

/// Why a lump says nothing about some pairs; in games such pairs may see each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum RejectError {
    /// No byte at all.
    #[error("the REJECT lump is empty: every sector may see every other")]
    Empty,
    /// Too few bytes.
    #[error("the REJECT lump has {got} bytes, expected {expected}")]
    Short {
        /// How many there are.
        got: usize,
        /// How many the sectors need.
        expected: usize,
    },
}

/// The pairs of sectors that cannot see each other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RejectTable {
    sectors: usize,
    /// Invariant: as many bytes as `sectors` squared bits need, the bits past them zero.
    bytes: Vec<u8>,
}

impl RejectTable {
    /// A table by which every sector may see every other.
    ///
    /// # Panics
    /// If `sectors` squared exceeds the address space.
    pub fn new(sectors: usize) -> RejectTable {
        let bits = sectors.checked_mul(sectors).expect("a table larger than the address space");
        RejectTable { sectors, bytes: vec![0; bits.div_ceil(8)] }
    }

    /// Reads a lump for a map of so many sectors. Bytes past the last pair are left out: builders
    /// write some, and games do not read them.
    ///
    /// # Errors
    /// A lump that is too short.
    pub fn read(lump: &[u8], sectors: usize) -> Result<RejectTable, RejectError> {
        let bits = sectors.saturating_mul(sectors);
        let expected = bits.div_ceil(8);
        match lump.get(..expected) {
            Some(bytes) => {
                let mut bytes = bytes.to_vec();
                if let (Some(last), used @ 1..) = (bytes.last_mut(), bits % 8) {
                    *last &= (1 << used) - 1;
                }
                Ok(RejectTable { sectors, bytes })
            }
            None if lump.is_empty() => Err(RejectError::Empty),
            None => Err(RejectError::Short { got: lump.len(), expected }),
        }
    }

    /// The bytes of the lump.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// The number of sectors.
    pub fn sectors(&self) -> usize {
        self.sectors
    }

    /// Whether the table says that one sector cannot see another.
    ///
    /// # Panics
    /// If there is no such sector.
    pub fn rejects(&self, from: usize, to: usize) -> bool {
        let bit = self.bit(from, to);
        self.bytes[bit / 8] >> (bit % 8) & 1 == 1
    }

    /// Says that one sector cannot see another.
    ///
    /// # Panics
    /// If there is no such sector.
    pub fn reject(&mut self, from: usize, to: usize) {
        let bit = self.bit(from, to);
        self.bytes[bit / 8] |= 1 << (bit % 8);
    }

    fn bit(&self, from: usize, to: usize) -> usize {
        let sectors = self.sectors;
        assert!(from < sectors, "sector {from} of {sectors}");
        assert!(to < sectors, "sector {to} of {sectors}");
        from * sectors + to
    }
}
