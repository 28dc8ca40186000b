//! NumPy matrices: what is read and written again is the same matrix.
#![no_main]

use libfuzzer_sys::fuzz_target;
use stabline::formats::npy::NpyMatrix;

fuzz_target!(|bytes: &[u8]| {
    if let Ok(matrix) = NpyMatrix::read(bytes) {
        let mut text = NpyMatrix::header(matrix.rows, matrix.columns);
        text.extend_from_slice(&matrix.entries);
        assert_eq!(NpyMatrix::read(&text), Ok(matrix));
    }
});
