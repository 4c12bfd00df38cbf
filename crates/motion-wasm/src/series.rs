//! The series of one performer as flat arrays; empty where there are none.

use motion::analysis::{Analysis, KeyposeAnalysis, PerformerAnalysis};

/// A performer's results, or none where the index or the results are not there.
pub fn performer(analysis: &Analysis, index: usize) -> Option<&PerformerAnalysis> {
    analysis.performers.get(index)
}

/// A performer's keyposes, or none.
pub fn keyposes(analysis: &Analysis, index: usize) -> Option<&KeyposeAnalysis> {
    performer(analysis, index)?.keyposes.as_ref().ok()
}

/// Frames of the file from frames of the speed.
pub fn file_frames(keyposes: &KeyposeAnalysis, frames: &[usize]) -> Vec<i32> {
    frames
        .iter()
        .map(|frame| signed(keyposes.first_frame + frame))
        .collect()
}

/// Indices as signed numbers of 32 bits, which hold all of them.
pub fn signed_all(values: &[usize]) -> Vec<i32> {
    values.iter().map(|value| signed(*value)).collect()
}

/// The scale of each entry of the traces: a candidate's k-th entry is of scale k.
pub fn trace_scales(offsets: &[usize]) -> Vec<i32> {
    let lengths = offsets.windows(2).map(|pair| pair[1] - pair[0]);
    lengths.flat_map(|length| (0..length).map(signed)).collect()
}

/// Where each entry of the traces lies between the frames of the file.
pub fn trace_places(keyposes: &KeyposeAnalysis) -> Vec<f64> {
    let places = keyposes.extraction.traces.places.iter();
    places
        .map(|place| keyposes.first_frame as f64 + place)
        .collect()
}

/// The scale of each candidate's largest u; −1 without a trace.
pub fn strongest_scales(keyposes: &KeyposeAnalysis) -> Vec<i32> {
    let extraction = &keyposes.extraction;
    let strongest = |candidate| extraction.traces.strongest_scale(candidate);
    (0..extraction.candidates.len())
        .map(|candidate| strongest(candidate).map_or(-1, signed))
        .collect()
}

/// An index as a signed number of 32 bits; none in a clip is larger.
pub fn signed(value: usize) -> i32 {
    i32::try_from(value).unwrap_or(i32::MAX)
}
