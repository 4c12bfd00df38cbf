//! Adaptive keypose extraction: a motion speed in, keyposes with their reasons out.
//!
//! [`candidates`] finds the minima of the speed, [`scales`] filters it at 72 time scales,
//! [`correspondence`] follows each minimum from scale to scale, [`intensity`] sums what it gathers
//! there, [`significance`] keeps the significant ones ([`ward`], [`analysis_of_variance`]) and
//! [`sureness`] says how clear that cut is. [`extract()`] does all of it and keeps every series on
//! the way; [`evaluation`] holds keyposes against marks.

pub mod analysis_of_variance;
pub mod candidates;
pub mod correspondence;
pub mod evaluation;
pub mod extract;
pub mod intensity;
pub mod options;
pub mod scales;
pub mod significance;
pub mod sureness;
pub mod ward;

pub use analysis_of_variance::AnalysisOfVariance;
pub use extract::{Extraction, Extractor, extract};
pub use intensity::Traces;
pub use options::{Options, OptionsError, SelectionRule};
pub use significance::{Ground, Selection};
pub use sureness::Sureness;
