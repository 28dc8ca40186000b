//! Portal files: any bytes give a file or an error, and a file gives a graph or an error.
#![no_main]

use libfuzzer_sys::fuzz_target;
use stabline::formats::prt;
use stabline::scene::{CellOrder, PortalGraph, RawGraph};

fuzz_target!(|bytes: &[u8]| {
    if let Ok(file) = prt::read(bytes)
        && let Ok(graph) = PortalGraph::from_raw(RawGraph::from(file))
    {
        CellOrder::new(&graph);
    }
});
