//! The BLAKE3 hash of a file's bytes, by which results name their input.
//!
//! BLAKE3 (O'Connor, Aumasson, Neves, Wilcox-O'Hearn 2020, section 2) cuts its input into chunks of
//! 1024 bytes. A chunk is 16 blocks, compressed one after the other; the chunks' values are the
//! leaves of a binary tree whose left subtrees are the largest complete ones, and the root's value
//! is the hash. This is the plain hash with 32 bytes of output, portable. It is written out because
//! the published crate's build script calls a C compiler even where it is told to use none of its
//! output; a test compares the two.
//!
//! Complexity: linear in the bytes, and one value of 32 bytes a level of the tree.

const BLOCK: usize = 64;
const CHUNK: usize = 1024;

const CHUNK_START: u32 = 1;
const CHUNK_END: u32 = 2;
const PARENT: u32 = 4;
const ROOT: u32 = 8;

/// The first 32 bits of the fractions of the square roots of the first eight primes.
const START: [u32; 8] = [
    0x6a09_e667,
    0xbb67_ae85,
    0x3c6e_f372,
    0xa54f_f53a,
    0x510e_527f,
    0x9b05_688c,
    0x1f83_d9ab,
    0x5be0_cd19,
];

/// How the words of a block are permuted from one round to the next.
const PERMUTATION: [usize; 16] = [2, 6, 3, 10, 7, 0, 4, 13, 1, 11, 12, 5, 9, 14, 15, 8];

/// Subtrees of more bytes than this are hashed side by side, on the threads at hand.
const SIDE_BY_SIDE: usize = 64 * CHUNK;

/// The hash of the bytes, as 64 hexadecimal digits.
pub fn hex(bytes: &[u8]) -> String {
    let value = subtree(bytes, 0, ROOT);
    value.iter().flat_map(|word| word.to_le_bytes()).map(|byte| format!("{byte:02x}")).collect()
}

/// The value of the tree over `bytes`, whose first chunk is number `first`.
fn subtree(bytes: &[u8], first: u64, root: u32) -> [u32; 8] {
    if bytes.len() <= CHUNK {
        return chunk(bytes, first, root);
    }
    // The left subtree takes the most chunks that are a power of two and leave some for the right.
    let chunks = bytes.len().div_ceil(CHUNK);
    let left_chunks = 1 << (chunks - 1).ilog2();
    let (left, right) = bytes.split_at(left_chunks * CHUNK);
    let mut words = [0; 16];
    let of_left = || subtree(left, first, 0);
    let of_right = || subtree(right, first + left_chunks as u64, 0);
    let (left, right) = match bytes.len() > SIDE_BY_SIDE {
        true => rayon::join(of_left, of_right),
        false => (of_left(), of_right()),
    };
    words[..8].copy_from_slice(&left);
    words[8..].copy_from_slice(&right);
    compress(&START, &words, 0, BLOCK as u32, PARENT | root)
}

fn chunk(bytes: &[u8], number: u64, root: u32) -> [u32; 8] {
    let last = bytes.len().div_ceil(BLOCK).max(1) - 1;
    let mut value = START;
    for index in 0..=last {
        let block = &bytes[index * BLOCK..bytes.len().min((index + 1) * BLOCK)];
        let mut padded = [0; BLOCK];
        padded[..block.len()].copy_from_slice(block);
        let word = |i: usize| u32::from_le_bytes([0, 1, 2, 3].map(|byte| padded[4 * i + byte]));
        let mut flags = 0;
        if index == 0 {
            flags |= CHUNK_START;
        }
        if index == last {
            flags |= CHUNK_END | root;
        }
        let words = std::array::from_fn(word);
        value = compress(&value, &words, number, block.len() as u32, flags);
    }
    value
}

fn compress(
    value: &[u32; 8],
    block: &[u32; 16],
    counter: u64,
    length: u32,
    flags: u32,
) -> [u32; 8] {
    let mut state = [0; 16];
    state[..8].copy_from_slice(value);
    state[8..12].copy_from_slice(&START[..4]);
    state[12..].copy_from_slice(&[counter as u32, (counter >> 32) as u32, length, flags]);
    let mut words = *block;
    for _ in 0..7 {
        // The columns of a 4 x 4 square, then its diagonals. Written out, so that the state stays
        // in registers.
        mix(&mut state, [0, 4, 8, 12], words[0], words[1]);
        mix(&mut state, [1, 5, 9, 13], words[2], words[3]);
        mix(&mut state, [2, 6, 10, 14], words[4], words[5]);
        mix(&mut state, [3, 7, 11, 15], words[6], words[7]);
        mix(&mut state, [0, 5, 10, 15], words[8], words[9]);
        mix(&mut state, [1, 6, 11, 12], words[10], words[11]);
        mix(&mut state, [2, 7, 8, 13], words[12], words[13]);
        mix(&mut state, [3, 4, 9, 14], words[14], words[15]);
        words = PERMUTATION.map(|from| words[from]);
    }
    std::array::from_fn(|i| state[i] ^ state[i + 8])
}

#[inline(always)]
fn mix(state: &mut [u32; 16], [a, b, c, d]: [usize; 4], first: u32, second: u32) {
    for (word, turn, small_turn) in [(first, 16, 12), (second, 8, 7)] {
        state[a] = state[a].wrapping_add(state[b]).wrapping_add(word);
        state[d] = (state[d] ^ state[a]).rotate_right(turn);
        state[c] = state[c].wrapping_add(state[d]);
        state[b] = (state[b] ^ state[c]).rotate_right(small_turn);
    }
}

#[cfg(test)]
mod tests {
    use super::hex;

    #[test]
    fn agrees_with_the_published_crate() {
        let bytes: Vec<u8> = (0..300_000u32).map(|i| (i % 251) as u8).collect();
        // Around the ends of blocks, of chunks, and of complete subtrees.
        let ends = [
            0, 64, 128, 1024, 2048, 3072, 4096, 5120, 8192, 16_384, 31_744, 32_768, 39_999, 65_536,
            299_999,
        ];
        for end in ends {
            for length in [end, end + 1, usize::saturating_sub(end, 1)] {
                let input = &bytes[..length];
                assert_eq!(hex(input), blake3::hash(input).to_hex().as_str(), "{length} bytes");
            }
        }
    }
}
