//! Proofs: any bytes are a proof that holds, or a flaw with its line.
#![no_main]

use libfuzzer_sys::fuzz_target;
use stabline::verify::verify;

fuzz_target!(|bytes: &[u8]| {
    if let Err(flaw) = verify(bytes) {
        assert!(!flaw.to_string().contains('\n'));
    }
});
