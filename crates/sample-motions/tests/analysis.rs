//! What the analysis finds in the samples: no notes, the right body, the true keyposes.

use motion::analysis::{Decisions, PerformerAnalysis, analyse};
use motion::bvh;
use motion::keypose::Options;
use motion::keypose::evaluation::{Mark, Span, evaluate};
use motion::world::Unit;
use sample_motions::{Rig, Sample, true_keyposes};

fn analysed(sample: &Sample) -> PerformerAnalysis {
    let clip = bvh::parse(&sample_motions::bvh(sample)).expect("a clip");
    assert!(clip.notes.is_empty(), "{}: {:?}", sample.id(), clip.notes);
    let mut analysis = analyse(&clip, &Decisions::default(), &Options::default()).expect("options");
    assert!((analysis.frame_time_s * sample.rate.hz() - 1.0).abs() < 1e-6);
    analysis.performers.remove(0)
}

#[test]
fn the_true_keyposes_are_found() {
    for sample in Sample::all() {
        let found = analysed(&sample).keyposes.expect("keyposes").keyposes();
        let marks: Vec<Mark> = true_keyposes(&sample)
            .iter()
            .map(|mark| Mark {
                from: mark.from,
                to: mark.to,
            })
            .collect();
        let evaluation = evaluate(&found, &marks, Span::Clip);
        assert!(
            evaluation.f >= 0.9,
            "{}: F {} of {found:?}",
            sample.id(),
            evaluation.f
        );
    }
}

#[test]
fn the_body_the_unit_and_the_ground_are_found() {
    for sample in Sample::all() {
        let (id, found) = (sample.id(), analysed(&sample));
        assert!(found.survey.body.is_human(), "{id}");
        assert!(
            found.notes().next().is_none(),
            "{id}: {:?}",
            found.survey.notes
        );
        assert_eq!(found.survey.leading_rest.frames, 0, "{id}");
        let unit = match sample.rig {
            Rig::Hik => Unit::Centimetre,
            Rig::Poser => Unit::Inch,
            Rig::Vrm => Unit::Metre,
        };
        assert_eq!(found.survey.unit.map(|(unit, _)| unit), Some(unit), "{id}");
        assert!(
            found.survey.ground_height.abs() < 0.02 * found.survey.height,
            "{id}: {}",
            found.survey.ground_height
        );
    }
}
