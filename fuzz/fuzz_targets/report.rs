//! Results: what is read and written again is the same result.
#![no_main]

use libfuzzer_sys::fuzz_target;
use stabline::report::PvsReport;

fuzz_target!(|bytes: &[u8]| {
    if let Ok(report) = PvsReport::read(bytes) {
        let mut text = Vec::new();
        report.write(&mut text).unwrap();
        assert_eq!(PvsReport::read(&text), Ok(report));
    }
});
