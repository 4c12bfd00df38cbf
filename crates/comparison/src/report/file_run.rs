//! A file for other programs, in parts: a set compared and the kind of the file go in, its bytes come
//! out a few at a time. The matrix of ten thousand clips is a table of two gigabytes.

use super::{Labels, Subject, evaluation, features, matrix, npy};
use crate::evaluation::{OneNearest, OneNearestRun};
use crate::feature::FEATURE_LENGTH;

/// A part is handed out when it has so many bytes.
const PART_BYTES: usize = 1 << 20;

/// Pairs that are looked at in the time of one number of text.
const PAIRS_OF_A_NUMBER: usize = 32;

/// What a file holds and how.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileKind {
    /// The features as a table of text.
    FeaturesCsv,
    /// The same as an array of NumPy.
    FeaturesNpy,
    /// All distances as a table of text: a line of names, then a row for each clip.
    MatrixCsv,
    /// The same as an array of NumPy, without names.
    MatrixNpy,
    /// The tree in Newick's notation.
    TreeNewick,
    /// Labels, clusters and nearest clips as a table of text.
    EvaluationCsv,
    /// The same with the scores, as JSON.
    EvaluationJson,
}

impl FileKind {
    /// Each with its name at the borders.
    const NAMES: [(FileKind, &'static str); 7] = [
        (FileKind::FeaturesCsv, "features-csv"),
        (FileKind::FeaturesNpy, "features-npy"),
        (FileKind::MatrixCsv, "matrix-csv"),
        (FileKind::MatrixNpy, "matrix-npy"),
        (FileKind::TreeNewick, "tree-newick"),
        (FileKind::EvaluationCsv, "evaluation-csv"),
        (FileKind::EvaluationJson, "evaluation-json"),
    ];

    /// The kind of that name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        let found = Self::NAMES.into_iter().find(|(_, known)| *known == name);
        found.map(|(kind, _)| kind)
    }

    /// Numbers of a row, about; none of a file without rows.
    fn numbers_of_a_row(self, items: usize) -> Option<usize> {
        match self {
            Self::FeaturesCsv | Self::FeaturesNpy => Some(FEATURE_LENGTH),
            Self::MatrixCsv | Self::MatrixNpy => Some(items),
            Self::EvaluationCsv => Some(10),
            Self::TreeNewick | Self::EvaluationJson => None,
        }
    }
}

/// A file while it is written. Every call takes the same subject.
#[derive(Clone, Debug)]
pub struct FileRun {
    kind: FileKind,
    judging: OneNearestRun,
    /// What an evaluation needs before its first line.
    nearest: Option<OneNearest>,
    /// Rows written; none before the head is.
    rows: Option<usize>,
    out: Vec<u8>,
    is_done: bool,
}

impl FileRun {
    /// Nothing written yet. The labels are those of the subject.
    #[must_use]
    pub fn new(kind: FileKind, labels: &Labels) -> Self {
        let of_item = match kind {
            FileKind::EvaluationCsv | FileKind::EvaluationJson => labels.of_item.clone(),
            _ => Vec::new(),
        };
        Self {
            kind,
            judging: OneNearestRun::new(of_item),
            nearest: None,
            rows: None,
            out: Vec::new(),
            is_done: false,
        }
    }

    /// Writes about `numbers` numbers more, but nothing while a whole part waits for
    /// [`Self::take_part`]. Returns the part of the file that is written, 1 when it is whole.
    pub fn step(&mut self, subject: &Subject, numbers: usize) -> f64 {
        let Some(nearest) = &self.nearest else {
            self.judge(subject, numbers);
            return 0.0;
        };
        match self.rows {
            None => {
                self.out.extend(head(self.kind, subject, nearest));
                self.rows = Some(0);
            }
            Some(done) => self.rows = Some(self.push_rows(subject, done, numbers)),
        }
        let (rows, items) = (self.rows.unwrap_or_default(), subject.names.len());
        self.is_done = rows == items || self.kind.numbers_of_a_row(items).is_none();
        match self.is_done {
            true => 1.0,
            false => rows as f64 / items as f64,
        }
    }

    /// Takes what is written, if it is enough for a part or the end; else nothing.
    pub fn take_part(&mut self) -> Vec<u8> {
        match self.is_done || self.out.len() >= PART_BYTES {
            true => std::mem::take(&mut self.out),
            false => Vec::new(),
        }
    }

    fn judge(&mut self, subject: &Subject, numbers: usize) {
        let comparison = subject.comparison;
        let (distances, spread) = (&comparison.distances, &comparison.spread);
        let pairs = numbers.saturating_mul(PAIRS_OF_A_NUMBER);
        if self.judging.step(distances, spread, pairs) >= 1.0 {
            self.nearest = Some(std::mem::take(&mut self.judging).finish());
        }
    }

    /// Adds rows after the first `done`. Returns how many there are then.
    fn push_rows(&mut self, subject: &Subject, done: usize, numbers: usize) -> usize {
        let items = subject.names.len();
        let of_a_row = self.kind.numbers_of_a_row(items).unwrap_or(1);
        let end = items.min(done + (numbers / of_a_row.max(1)).max(1));
        let mut item = done;
        while item < end && self.out.len() < PART_BYTES {
            push_row(
                &mut self.out,
                self.kind,
                subject,
                self.nearest.as_ref(),
                item,
            );
            item += 1;
        }
        item
    }
}

/// What comes before the rows: all, of a file that has none.
fn head(kind: FileKind, subject: &Subject, nearest: &OneNearest) -> Vec<u8> {
    let items = subject.names.len();
    match kind {
        FileKind::FeaturesCsv => features::HEADER.into(),
        FileKind::FeaturesNpy => npy::head(items, FEATURE_LENGTH),
        FileKind::MatrixCsv => matrix::head(subject).into(),
        FileKind::MatrixNpy => npy::head(items, items),
        FileKind::TreeNewick => subject.newick().into(),
        FileKind::EvaluationCsv => evaluation::HEADER.into(),
        FileKind::EvaluationJson => evaluation::evaluation_json(subject, nearest).into(),
    }
}

fn push_row(
    out: &mut Vec<u8>,
    kind: FileKind,
    subject: &Subject,
    nearest: Option<&OneNearest>,
    item: usize,
) {
    let comparison = subject.comparison;
    let distance = comparison.settings.distance;
    let feature = distance.vector(&comparison.clips[item]);
    let mut text = String::new();
    match kind {
        FileKind::FeaturesCsv => {
            features::push_row(&mut text, &subject.names[item], feature, distance);
        }
        FileKind::FeaturesNpy => npy::push_row(out, feature),
        FileKind::MatrixCsv => matrix::push_row(&mut text, subject, item),
        FileKind::MatrixNpy => npy::push_row(out, &comparison.distances.row(item)),
        FileKind::EvaluationCsv => evaluation::push_row(&mut text, subject, nearest, item),
        FileKind::TreeNewick | FileKind::EvaluationJson => {}
    }
    out.extend_from_slice(text.as_bytes());
}

#[cfg(test)]
mod tests {
    use std::rc::Rc;

    use super::*;
    use crate::comparison::Comparison;
    use crate::feature::{ClipFeature, JOINTS};
    use crate::report::{evaluation_csv, features_csv, features_npy};
    use crate::settings::Settings;

    fn clip(item: usize) -> Rc<ClipFeature> {
        let number = |k: usize| libm::sin((item * 31 + k * 7) as f64);
        Rc::new(ClipFeature {
            recorded: std::array::from_fn(number),
            across_rigs: [0.0; FEATURE_LENGTH],
            recorded_by_joint: [[0.0; FEATURE_LENGTH]; JOINTS],
            across_rigs_by_joint: [[0.0; FEATURE_LENGTH]; JOINTS],
        })
    }

    /// Its parts, each after as little work as can be.
    fn parts(kind: FileKind, subject: &Subject, labels: &Labels) -> Vec<Vec<u8>> {
        let mut run = FileRun::new(kind, labels);
        let (mut parts, mut done) = (Vec::new(), 0.0);
        while done < 1.0 {
            let now = run.step(subject, 1);
            assert!((done..=1.0).contains(&now), "{kind:?}: {done} then {now}");
            done = now;
            parts.push(run.take_part());
        }
        parts.retain(|part| !part.is_empty());
        parts
    }

    #[test]
    fn the_parts_of_a_file_make_it_whole() {
        let items = 400;
        let clips: Vec<_> = (0..items).map(clip).collect();
        let names: Vec<String> = (0..items).map(|item| format!("clip, {item}")).collect();
        let comparison = Comparison::of(clips, Settings::default()).expect("settings");
        let label = |item: usize| (!item.is_multiple_of(3)).then(|| format!("label {}", item % 5));
        let labels = Labels::new((0..items).map(label));
        let subject = Subject {
            names: &names,
            comparison: &comparison,
            cut: &comparison.cut(7),
            labels: Some(&labels),
        };
        let whole = |kind| parts(kind, &subject, &labels).concat();
        let (vectors, distance) = (comparison.vectors(), comparison.settings.distance);
        let features = features_csv(&names, &vectors, distance);
        assert_eq!(whole(FileKind::FeaturesCsv), features.as_bytes());
        assert_eq!(whole(FileKind::FeaturesNpy), features_npy(&vectors));
        assert_eq!(whole(FileKind::TreeNewick), subject.newick().as_bytes());
        let scores = evaluation_csv(&subject);
        assert_eq!(whole(FileKind::EvaluationCsv), scores.as_bytes());
        let array = whole(FileKind::MatrixNpy);
        assert_eq!(array.len(), 128 + items * items * size_of::<f64>());
        assert!(array.ends_with(&0.0_f64.to_le_bytes()));
        let table = parts(FileKind::MatrixCsv, &subject, &labels);
        assert!(table.len() > 2 && table.iter().all(|part| part.len() < PART_BYTES * 5 / 4));
        let text = String::from_utf8(table.concat()).expect("text");
        assert_eq!(text.lines().count(), items + 1);
    }

    #[test]
    fn every_kind_has_a_name() {
        for (kind, name) in FileKind::NAMES {
            assert_eq!(FileKind::named(name), Some(kind));
        }
        assert_eq!(FileKind::named("matrix"), None);
    }
}
