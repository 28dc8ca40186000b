//! Cases: what is read and written again is the same case, and has one answer.
#![no_main]

use libfuzzer_sys::fuzz_target;
use stabline::forge::Input;
use stabline::vectors::Case;

fuzz_target!(|bytes: &[u8]| {
    if let Ok(case) = Case::read(bytes) {
        assert_eq!(Case::read(case.to_line().as_bytes()).unwrap(), case);
        if let Ok(input) = Input::of_case(&case) {
            // Boxes are written by their least and greatest corners.
            let other = input.case(case.tc_id, "", &[]);
            assert_eq!(Input::of_case(&other).unwrap().case(case.tc_id, "", &[]), other);
        }
    }
});
