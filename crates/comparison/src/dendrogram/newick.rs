//! A tree, the order of its leaves and the names of its items in; Newick text out.

use super::Dendrogram;
use std::fmt::Write;

/// What is still to be written, last first.
enum Piece {
    /// A cluster below a merge of that height.
    Cluster(usize, f64),
    Text(&'static str),
    /// The end of a cluster's children, and the length of the branch to it.
    Close(f64),
}

impl Dendrogram {
    /// The tree as Newick: the branch lengths add up to the height of a merge on every way from it
    /// down to its leaves, which stand in the order of `leaves` (one that the tree allows). An item
    /// without a name bears its number. Names of more than letters, digits, `.`, `-` and `+` are
    /// quoted, a quote in them doubled (Felsenstein's rules; an underscore without quotes would mean
    /// a blank); a sign that does not print, as the end of a line, becomes a blank.
    #[must_use]
    pub fn newick<S: AsRef<str>>(&self, leaves: &[usize], names: &[S]) -> String {
        let places = self.places(leaves);
        let mut text = String::new();
        let mut pieces = vec![Piece::Text(";")];
        if let Some(root) = self.root() {
            pieces.push(Piece::Cluster(root, self.height(root)));
        }
        while let Some(piece) = pieces.pop() {
            match piece {
                Piece::Text(written) => text.push_str(written),
                Piece::Close(length) => write_close(&mut text, length),
                Piece::Cluster(cluster, above) => {
                    let length = (above - self.height(cluster)).max(0.0);
                    match self.children(cluster) {
                        Some((left, right)) if places[right] < places[left] => {
                            self.open(&mut pieces, cluster, (right, left), length);
                        }
                        Some(children) => self.open(&mut pieces, cluster, children, length),
                        None => write_leaf(&mut text, names, cluster, length),
                    }
                }
            }
        }
        text
    }

    fn open(&self, pieces: &mut Vec<Piece>, cluster: usize, children: (usize, usize), length: f64) {
        let height = self.height(cluster);
        pieces.push(Piece::Close(length));
        pieces.push(Piece::Cluster(children.1, height));
        pieces.push(Piece::Text(","));
        pieces.push(Piece::Cluster(children.0, height));
        pieces.push(Piece::Text("("));
    }

    /// Where the first leaf of every item and cluster stands.
    fn places(&self, leaves: &[usize]) -> Vec<usize> {
        let mut places = vec![0; self.items];
        for (place, &item) in leaves.iter().enumerate() {
            places[item] = place;
        }
        for merge in &self.merges {
            places.push(places[merge.left].min(places[merge.right]));
        }
        places
    }

    fn height(&self, cluster: usize) -> f64 {
        let merge = cluster.checked_sub(self.items);
        merge.map_or(0.0, |index| self.merges[index].height)
    }
}

fn write_close(text: &mut String, length: f64) {
    let _ = write!(text, "):{length}");
}

fn write_leaf<S: AsRef<str>>(text: &mut String, names: &[S], item: usize, length: f64) {
    let number = item.to_string();
    let name = names.get(item).map_or(number.as_str(), AsRef::as_ref);
    let _ = write!(text, "{}:{length}", escaped(name));
}

fn escaped(name: &str) -> String {
    let is_plain = |letter: char| letter.is_alphanumeric() || matches!(letter, '.' | '-' | '+');
    if !name.is_empty() && name.chars().all(is_plain) {
        return name.to_owned();
    }
    let name = name.replace(char::is_control, " ").replace('\'', "''");
    format!("'{name}'")
}
