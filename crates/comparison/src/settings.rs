//! What a set is compared by: names as the command line and the page have them go in, settings or the
//! reason why they cannot be come out.

use core::fmt;

use crate::distance::{Dissimilarity, Distance};

/// How clusters are joined into a tree.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Linkage {
    /// Ward's method, on the vectors of the features.
    #[default]
    Ward,
    /// Group average (UPGMA), on the distances.
    Average,
}

impl Linkage {
    /// All of them.
    pub const ALL: [Linkage; 2] = [Linkage::Ward, Linkage::Average];

    /// Its name in files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Linkage::Ward => "ward",
            Linkage::Average => "average",
        }
    }

    /// The rule that cuts its tree unless something else is wished: BIC needs Ward's partitions of
    /// vectors, Mojena's rule takes any heights.
    pub fn rule(self) -> CutRule {
        match self {
            Linkage::Ward => CutRule::Bic,
            Linkage::Average => CutRule::Mojena,
        }
    }
}

/// How the number of clusters is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CutRule {
    /// The Bayesian information criterion of a Gaussian model.
    Bic,
    /// Mojena's stopping rule one.
    Mojena,
    /// So many as a person says.
    Number(usize),
}

impl CutRule {
    /// Its name in files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            CutRule::Bic => "bic",
            CutRule::Mojena => "mojena",
            CutRule::Number(_) => "user",
        }
    }
}

/// What a set is compared by. The default: the posture variation of the recorded bodies, Ward's
/// method, and the linkage's own rule.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Settings {
    /// How alike two clips are.
    pub distance: Distance,
    /// How the tree is made.
    pub linkage: Linkage,
    /// How it is cut; none: by the rule of the linkage.
    pub cut: Option<CutRule>,
}

/// Settings that do not go together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SettingsError {
    /// Ward's method or BIC with a distance that has no vectors.
    NoVectors,
}

impl fmt::Display for SettingsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self::NoVectors = self;
        f.write_str("Ward's method and BIC need vectors, which the mirror-aware distance has not: take the group average and Mojena's rule")
    }
}

impl core::error::Error for SettingsError {}

impl Settings {
    /// The rule that the tree is cut by.
    pub fn rule(&self) -> CutRule {
        self.cut.unwrap_or(self.linkage.rule())
    }

    /// Says whether they go together.
    ///
    /// # Errors
    /// [`SettingsError::NoVectors`].
    pub fn validate(&self) -> Result<(), SettingsError> {
        let needs_vectors = self.linkage == Linkage::Ward || self.rule() == CutRule::Bic;
        match needs_vectors && self.distance.choice().mirror_aware {
            true => Err(SettingsError::NoVectors),
            false => Ok(()),
        }
    }
}

impl Distance {
    /// Its name in files and on the command line.
    pub fn name(self) -> &'static str {
        let Distance::PostureVariation(_) = self;
        "posture-variation"
    }

    /// What was chosen of it.
    pub fn choice(self) -> Dissimilarity {
        let Distance::PostureVariation(choice) = self;
        choice
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_distance_without_vectors_has_a_tree_of_group_averages() {
        let distance = Distance::PostureVariation(Dissimilarity {
            mirror_aware: true,
            ..Dissimilarity::default()
        });
        let with = |linkage, cut| {
            Settings {
                distance,
                linkage,
                cut,
            }
            .validate()
        };
        assert_eq!(with(Linkage::Ward, None), Err(SettingsError::NoVectors));
        assert_eq!(with(Linkage::Average, None), Ok(()));
        let bic = Some(CutRule::Bic);
        assert_eq!(with(Linkage::Average, bic), Err(SettingsError::NoVectors));
        assert_eq!(Settings::default().validate(), Ok(()));
    }
}
