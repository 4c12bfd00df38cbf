//! Tables as comma-separated values (RFC 4180): keyposes, candidates or traces of one file go in, a
//! row for each comes out.

use result_text::csv::field;
use result_text::json::number;

use super::provenance::{VERSION, parameters_text};
use super::{Subject, Table};
use crate::analysis::KeyposeAnalysis;
use crate::part_change::PartChange;

/// The first line of a table.
pub fn header(table: Table) -> &'static str {
    match table {
        Table::Keyposes => {
            "file,performer,number,frame,time_s,intensity,rank,strongest_hz,left_arm_percent,\
             right_arm_percent,left_leg_percent,right_leg_percent,head_percent,posture,sha256,\
             version,parameters\r\n"
        }
        Table::Candidates => {
            "file,performer,number,frame,time_s,intensity,rank,strongest_hz,is_keypose,sha256,\
             version,parameters\r\n"
        }
        Table::Traces => "file,performer,candidate,scale_hz,frame,place,u\r\n",
    }
}

/// The rows of one file, without [`header`]; performers count from 0, keyposes and candidates from 1.
pub fn rows(subject: &Subject, table: Table) -> String {
    let mut text = String::new();
    let file = field(subject.file);
    for (performer, found) in subject.analysis.performers.iter().enumerate() {
        let Ok(found) = &found.keyposes else {
            continue;
        };
        let start = format!("{file},{performer}");
        match table {
            Table::Keyposes => add_keyposes(&mut text, &start, subject, found),
            Table::Candidates => add_candidates(&mut text, &start, subject, found),
            Table::Traces => add_traces(&mut text, &start, found),
        }
    }
    text
}

fn add_keyposes(text: &mut String, start: &str, subject: &Subject, found: &KeyposeAnalysis) {
    let end = provenance(subject);
    let ranks = found.extraction.ranks();
    for (index, &candidate) in found.extraction.selection.kept.iter().enumerate() {
        let moment = moment(subject, found, candidate, ranks[candidate]);
        let percents = percents(found.part_changes.get(index));
        let posture = found.postures.get(index).map_or_else(String::new, |words| {
            let names: Vec<String> = words.iter().map(|word| word.name()).collect();
            names.join(" ")
        });
        let number = index + 1;
        text.push_str(&format!(
            "{start},{number},{moment},{percents},{posture},{end}\r\n"
        ));
    }
}

fn add_candidates(text: &mut String, start: &str, subject: &Subject, found: &KeyposeAnalysis) {
    let end = provenance(subject);
    let extraction = &found.extraction;
    for (candidate, rank) in extraction.ranks().into_iter().enumerate() {
        let moment = moment(subject, found, candidate, rank);
        let is_kept = extraction.selection.kept.binary_search(&candidate).is_ok();
        let number = candidate + 1;
        text.push_str(&format!("{start},{number},{moment},{is_kept},{end}\r\n"));
    }
}

fn add_traces(text: &mut String, start: &str, found: &KeyposeAnalysis) {
    let extraction = &found.extraction;
    let (traces, first) = (&extraction.traces, found.first_frame);
    for candidate in 0..extraction.candidates.len() {
        let number_of = candidate + 1;
        for (scale_hz, entry) in extraction.scales_hz.iter().zip(traces.entries(candidate)) {
            let scale_hz = number(*scale_hz);
            let frame = first + traces.frames[entry];
            let place = number(first as f64 + traces.places[entry]);
            let u = number(traces.contributions[entry]);
            text.push_str(&format!(
                "{start},{number_of},{scale_hz},{frame},{place},{u}\r\n"
            ));
        }
    }
}

/// Frame, time, intensity, rank and strongest scale of a candidate.
fn moment(subject: &Subject, found: &KeyposeAnalysis, candidate: usize, rank: usize) -> String {
    let frame = found.frame_of(candidate);
    let time_s = number(frame as f64 * subject.analysis.frame_time_s);
    let intensity = number(found.extraction.intensity[candidate]);
    let strongest_hz = found
        .strongest_hz(candidate)
        .map_or_else(String::new, number);
    format!("{frame},{time_s},{intensity},{rank},{strongest_hz}")
}

/// The change of each part of the body; empty fields where there is none.
fn percents(change: Option<&PartChange>) -> String {
    let change = change.copied().unwrap_or_default();
    change
        .map(|percent| percent.map_or_else(String::new, number))
        .join(",")
}

fn provenance(subject: &Subject) -> String {
    let parameters = parameters_text(&subject.analysis.options);
    format!("{},{VERSION},{parameters}", subject.sha256)
}
