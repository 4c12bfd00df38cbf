//! What is in a file, as text for a person.

use std::fmt::{self, Display, Formatter};

use motion::analysis::PerformerAnalysis;
use motion::body::Role;
use motion::note::Note;
use motion::report::source_name;

use crate::study::Study;

/// Shows a study: motion, then each performer, then all notes.
pub struct Inspection<'a>(pub &'a Study);

impl Display for Inspection<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self(study) = self;
        let (frames, frame_time_s) = (study.clip.frames, study.analysis.frame_time_s);
        let length_s = frames.saturating_sub(1) as f64 * frame_time_s;
        let rate_hz = 1.0 / frame_time_s;
        writeln!(f, "{}", study.label)?;
        writeln!(
            f,
            "  motion    {frames} frames, {rate_hz:.2} Hz, {length_s:.3} s"
        )?;
        for (index, performer) in study.analysis.performers.iter().enumerate() {
            if study.analysis.performers.len() > 1 {
                writeln!(f, "  performer {index}")?;
            }
            write_performer(f, study, index, performer)?;
        }
        let notes = study
            .analysis
            .performers
            .iter()
            .flat_map(|performer| performer.notes());
        study
            .clip
            .notes
            .iter()
            .chain(notes)
            .try_for_each(|note| write_note(f, note))
    }
}

fn write_performer(
    f: &mut Formatter<'_>,
    study: &Study,
    index: usize,
    performer: &PerformerAnalysis,
) -> fmt::Result {
    let labels = study.clip.performers[index].skeleton.labels();
    let body = &performer.survey.body;
    let kind = if body.is_human() {
        "human"
    } else {
        "not human"
    };
    writeln!(
        f,
        "  body      {kind}, {} joints and ends, height {:.4} file units, pelvis {}",
        labels.len(),
        performer.survey.height,
        labels[body.pelvis]
    )?;
    write_world(f, performer)?;
    writeln!(
        f,
        "  rest      {} leading frames left out",
        performer.survey.leading_rest.frames
    )?;
    let listed = body
        .joints
        .iter()
        .filter(|joint| joint.role != Role::Pelvis && body.is_human());
    for joint in listed {
        let (role, source) = (joint.role.name(), source_name(joint.source));
        writeln!(f, "    {role:<15} {} ({source})", labels[joint.joint])?;
    }
    Ok(())
}

fn write_world(f: &mut Formatter<'_>, performer: &PerformerAnalysis) -> fmt::Result {
    let unit = performer
        .survey
        .unit
        .map_or("unknown", |(unit, _)| unit.name());
    let (up, ground) = (performer.survey.up.0.name(), performer.survey.ground_height);
    writeln!(f, "  world     up {up}, ground at {ground:.4}, unit {unit}")
}

fn write_note(f: &mut Formatter<'_>, note: &Note) -> fmt::Result {
    write!(f, "  note      ")?;
    if let (Some(line), Some(column)) = (note.line, note.column) {
        write!(f, "{line}:{column}: ")?;
    }
    if let Some(frame) = note.frame {
        write!(f, "frame {frame}: ")?;
    }
    writeln!(f, "{}", note.message())
}
