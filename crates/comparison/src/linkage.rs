//! Vectors or a condensed matrix in; the tree of an agglomerative clustering out.
//!
//! Both linkages follow chains of nearest neighbours (Murtagh 1983; Müllner 2011), with SciPy's
//! start (the first cluster left) and preferences among equal distances (the one before in the
//! chain, then the lowest number), so that their trees are SciPy's.

mod best;
mod chain;
mod on_centroids;
mod on_matrix;
#[cfg(test)]
mod tests;

use crate::condensed::Condensed;
use crate::dendrogram::Dendrogram;
use crate::feature::Vector;
use chain::Chain;
use on_centroids::OnCentroids;
use on_matrix::{GroupAverageRule, OnMatrix, WardRule};

/// Ward's linkage of vectors by their Euclidean distances. The height of a merge is the distance
/// `sqrt(2 · m · n / (m + n)) · |c_m − c_n|` of the two centroids c, for clusters of m and n items:
/// SciPy's scale.
#[must_use]
pub fn ward(vectors: &[Vector]) -> Dendrogram {
    WardSteps::new(vectors).finish()
}

/// The group-average linkage (UPGMA) of a matrix of distances: the height of a merge is the mean
/// distance of the pairs of items between the two clusters.
#[must_use]
pub fn group_average(condensed: &Condensed) -> Dendrogram {
    GroupAverageSteps::new(condensed).finish()
}

/// Up to so many vectors Ward's linkage works on the matrix of their distances as SciPy does, so that
/// where nothing but rounding tells two distances apart it decides as SciPy's; more would take too
/// much memory, and centroids serve.
const MOST_ON_MATRIX: usize = 1_000;

/// [`ward`] in pieces.
pub struct WardSteps {
    walk: WardWalk,
}

enum WardWalk {
    OnMatrix(Chain<OnMatrix<WardRule>>),
    OnCentroids(Chain<OnCentroids>),
}

impl WardSteps {
    /// Nothing merged yet.
    #[must_use]
    pub fn new(vectors: &[Vector]) -> Self {
        let walk = if vectors.len() > MOST_ON_MATRIX {
            WardWalk::OnCentroids(Chain::of(OnCentroids::of(vectors)))
        } else {
            WardWalk::OnMatrix(Chain::of(OnMatrix::of(Condensed::of_vectors(vectors))))
        };
        Self { walk }
    }

    /// Goes on until about `budget` distances have been looked at; how much is done, 0 to 1.
    pub fn step(&mut self, budget: usize) -> f64 {
        match &mut self.walk {
            WardWalk::OnMatrix(chain) => chain.step(budget),
            WardWalk::OnCentroids(chain) => chain.step(budget),
        }
    }

    /// Does what is left; the tree.
    #[must_use]
    pub fn finish(self) -> Dendrogram {
        match self.walk {
            WardWalk::OnMatrix(chain) => chain.finish(),
            WardWalk::OnCentroids(chain) => chain.finish(),
        }
    }
}

/// [`group_average`] that needs no memory beside the matrix, and uses it up.
#[must_use]
pub fn group_average_in_place(condensed: Condensed) -> Dendrogram {
    GroupAverageSteps::in_place(condensed).finish()
}

/// [`group_average`] in pieces.
pub struct GroupAverageSteps {
    chain: Chain<OnMatrix<GroupAverageRule>>,
}

impl GroupAverageSteps {
    /// Nothing merged yet; works on a copy of the matrix.
    #[must_use]
    pub fn new(condensed: &Condensed) -> Self {
        Self::in_place(condensed.clone())
    }

    /// Nothing merged yet; works on the matrix itself.
    #[must_use]
    pub fn in_place(condensed: Condensed) -> Self {
        Self {
            chain: Chain::of(OnMatrix::of(condensed)),
        }
    }

    /// Goes on until about `budget` distances have been looked at; how much is done, 0 to 1.
    pub fn step(&mut self, budget: usize) -> f64 {
        self.chain.step(budget)
    }

    /// Does what is left; the tree.
    #[must_use]
    pub fn finish(self) -> Dendrogram {
        self.chain.finish()
    }

    /// The same, with the memory of the matrix, for another one.
    #[must_use]
    pub fn finish_with_room(self) -> (Dendrogram, Vec<f64>) {
        let (tree, clusters) = self.chain.finish_with_clusters();
        (tree, clusters.into_room())
    }
}
