//! Every decision about geometry: exact signs, each by the cheapest stage that can prove it.
pub mod filtered;
pub mod gordan;
