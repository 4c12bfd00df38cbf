//! Files for other programs: a set compared and the kind of a file go in, its bytes come out.

use comparison::report::{self, Subject};

/// The bytes of a file; none of a kind that there is not.
pub fn bytes(kind: &str, subject: &Subject) -> Option<Vec<u8>> {
    let vectors = subject.comparison.vectors();
    let distance = subject.comparison.settings.distance;
    Some(match kind {
        "features-csv" => report::features_csv(subject.names, &vectors, distance).into_bytes(),
        "features-npy" => report::features_npy(&vectors),
        "matrix-csv" => report::matrix_csv(subject).into_bytes(),
        "matrix-npy" => report::matrix_npy(subject),
        "tree-newick" => subject.newick().into_bytes(),
        "evaluation-csv" => report::evaluation_csv(subject).into_bytes(),
        "evaluation-json" => report::evaluation_json(subject).into_bytes(),
        _ => return None,
    })
}
