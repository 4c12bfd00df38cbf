//! Keyposes against marks: frames of both in; precision, recall and F out.
//!
//! A keypose is correct if its distance from a mark is shorter than a quarter of the interval
//! between marks on that side (outside the first and the last mark the one neighbouring interval
//! counts), one to one, in order of closeness. A mark may be an interval, a held pose: a keypose
//! anywhere in it is right, and further ones in it are false.
//!
//! Source: Miura et al., "Adaptive Keypose Extraction from Motion Capture Data", 2014, §4.4.

/// A true keypose: one frame, or the frames of a held pose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mark {
    /// The first frame.
    pub from: usize,
    /// The last frame, not before the first.
    pub to: usize,
}

impl Mark {
    /// A mark of one frame.
    pub fn at(frame: usize) -> Self {
        Self {
            from: frame,
            to: frame,
        }
    }
}

/// Which keyposes are judged.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Span {
    /// All of them.
    #[default]
    Clip,
    /// Those in the span that the marks cover, with a quarter of the outer interval on each side.
    Marks,
}

/// How well keyposes agree with marks.
#[derive(Clone, Debug, PartialEq)]
pub struct Evaluation {
    /// Correct keyposes over judged keyposes; 0 without any.
    pub precision: f64,
    /// Correct keyposes over marks; 0 without any.
    pub recall: f64,
    /// `2 R P / (R + P)`; 0 where both are.
    pub f: f64,
    /// How many keyposes are correct.
    pub correct: usize,
    /// How many keyposes were judged.
    pub judged: usize,
    /// How many marks there are.
    pub marks: usize,
    /// For each keypose the index of its mark, if it is correct.
    pub mark_of: Vec<Option<usize>>,
}

/// Judges keyposes (frames) against marks, both in ascending order.
///
/// A single mark has no interval: only a keypose in it is correct.
pub fn evaluate(keyposes: &[usize], marks: &[Mark], span: Span) -> Evaluation {
    let mark_of = assign(keyposes, marks);
    let correct = mark_of.iter().flatten().count();
    let judged = match span {
        Span::Clip => keyposes.len(),
        Span::Marks => keyposes
            .iter()
            .filter(|&&frame| is_covered(frame, marks))
            .count(),
    };
    let ratio = |part: usize, whole: usize| {
        if whole == 0 {
            0.0
        } else {
            part as f64 / whole as f64
        }
    };
    let (precision, recall) = (ratio(correct, judged), ratio(correct, marks.len()));
    let f = match correct {
        0 => 0.0,
        _ => 2.0 * recall * precision / (recall + precision),
    };
    Evaluation {
        precision,
        recall,
        f,
        correct,
        judged,
        marks: marks.len(),
        mark_of,
    }
}

/// The marks of correct keyposes, the closest pairs first; of equals the earlier keypose.
fn assign(keyposes: &[usize], marks: &[Mark]) -> Vec<Option<usize>> {
    let mut pairs = Vec::new();
    for (mark_index, mark) in marks.iter().enumerate() {
        let (before, after) = intervals(marks, mark_index);
        for (keypose_index, &frame) in keyposes.iter().enumerate() {
            let (distance, interval) = if frame < mark.from {
                (mark.from - frame, before)
            } else {
                (frame.saturating_sub(mark.to), after)
            };
            if distance == 0 || 4 * distance < interval {
                pairs.push((distance, keypose_index, mark_index));
            }
        }
    }
    pairs.sort_unstable();
    let mut mark_of = vec![None; keyposes.len()];
    let mut is_taken = vec![false; marks.len()];
    for (_, keypose, mark) in pairs {
        if mark_of[keypose].is_none() && !is_taken[mark] {
            mark_of[keypose] = Some(mark);
            is_taken[mark] = true;
        }
    }
    mark_of
}

/// The intervals before and after a mark; outside the first and the last mark the neighbouring one.
fn intervals(marks: &[Mark], index: usize) -> (usize, usize) {
    let gap = |left: usize| Some(marks.get(left + 1)?.from.saturating_sub(marks[left].to));
    let (before, after) = (index.checked_sub(1).and_then(gap), gap(index));
    (before.or(after).unwrap_or(0), after.or(before).unwrap_or(0))
}

/// Whether a frame lies in the span of the marks or a quarter of the outer interval beside it.
fn is_covered(frame: usize, marks: &[Mark]) -> bool {
    let (Some(first), Some(last)) = (marks.first(), marks.last()) else {
        return false;
    };
    let (before, _) = intervals(marks, 0);
    let (_, after) = intervals(marks, marks.len() - 1);
    4 * first.from.saturating_sub(frame) <= before && 4 * frame.saturating_sub(last.to) <= after
}

#[cfg(test)]
mod tests {
    use super::*;

    fn marks(frames: &[usize]) -> Vec<Mark> {
        frames.iter().map(|&frame| Mark::at(frame)).collect()
    }

    #[test]
    fn a_quarter_of_the_interval_on_that_side_is_too_far() {
        let marks = marks(&[100, 140, 240]);
        let correct = |frame| evaluate(&[frame], &marks, Span::Clip).correct == 1;
        // Before the first mark its only interval, 40, counts.
        assert!(correct(91) && !correct(90));
        assert!(correct(109) && !correct(110));
        assert!(correct(131) && !correct(130));
        assert!(correct(164) && !correct(165));
        assert!(correct(216) && !correct(215));
        assert!(correct(264) && !correct(265));
    }

    #[test]
    fn the_closest_keypose_takes_the_mark() {
        let found = evaluate(&[97, 102, 205], &marks(&[100, 200]), Span::Clip);
        assert_eq!(found.mark_of, [None, Some(0), Some(1)]);
        assert_eq!((found.correct, found.judged, found.marks), (2, 3, 2));
        assert_eq!((found.precision, found.recall), (2.0 / 3.0, 1.0));
        assert!((found.f - 0.8).abs() < 1e-15);
    }

    #[test]
    fn a_held_pose_has_one_keypose() {
        let marks = [Mark { from: 100, to: 150 }, Mark::at(200)];
        let found = evaluate(&[104, 149, 161, 199], &marks, Span::Clip);
        assert_eq!(found.mark_of, [Some(0), None, None, Some(1)]);
        // The interval to the next mark is 50.
        assert_eq!(evaluate(&[163], &marks, Span::Clip).correct, 0);
        assert_eq!(evaluate(&[162], &marks, Span::Clip).correct, 1);
    }

    #[test]
    fn the_span_of_the_marks_leaves_out_what_lies_beyond() {
        let marks = marks(&[100, 140, 240]);
        let keyposes = [40, 90, 100, 140, 240, 265, 266];
        assert_eq!(evaluate(&keyposes, &marks, Span::Clip).judged, 7);
        assert_eq!(evaluate(&keyposes, &marks, Span::Marks).judged, 5);
    }

    #[test]
    fn nothing_to_compare_scores_nothing() {
        assert_eq!(evaluate(&[], &marks(&[1, 2]), Span::Marks).f, 0.0);
        assert_eq!(evaluate(&[5], &[], Span::Marks).judged, 0);
        assert_eq!(evaluate(&[5], &marks(&[5]), Span::Marks).f, 1.0);
        assert_eq!(evaluate(&[6], &marks(&[5]), Span::Clip).f, 0.0);
    }
}
