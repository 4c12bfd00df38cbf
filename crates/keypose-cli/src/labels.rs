//! Labels from where files lie or from their names: a rule and a path go in, a label or none comes out.
//! The rules are those of the browser (docs/formats.md, "Labels").

use std::path::Path;

use crate::files::file_name;

const PLACEHOLDER: &str = "{label}";

/// Where labels come from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LabelRule {
    /// The folder that a file lies in.
    Folder,
    /// Its name.
    Pattern(Pattern),
}

/// A pattern of file names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pattern {
    /// Texts that stand for themselves: one more than `wilds`.
    literals: Vec<String>,
    wilds: Vec<Wild>,
    /// Whether the pattern itself says how the file's ending reads.
    with_extension: bool,
}

/// What stands for other signs, between two literals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Wild {
    /// The label: one sign or more.
    Label,
    /// Any signs or none.
    Any,
}

/// The rule of that name: `folder`, or a pattern.
///
/// # Errors
/// A sentence that says what is wrong with the pattern.
pub fn rule(text: &str) -> Result<LabelRule, String> {
    match text {
        "folder" => Ok(LabelRule::Folder),
        _ => Pattern::new(text).map(LabelRule::Pattern),
    }
}

impl LabelRule {
    /// The label of a file; none where the rule finds none.
    pub fn label(&self, path: &Path) -> Option<String> {
        match self {
            LabelRule::Folder => {
                let folder = path.parent()?.file_name()?;
                Some(folder.to_string_lossy().into_owned())
            }
            LabelRule::Pattern(pattern) => pattern.label(&file_name(path)).map(str::to_owned),
        }
    }
}

impl Pattern {
    /// Reads a pattern.
    ///
    /// # Errors
    /// A sentence that says what is wrong with it.
    pub fn new(text: &str) -> Result<Self, String> {
        let without = text.replace(PLACEHOLDER, "");
        let fault = match text.matches(PLACEHOLDER).count() {
            _ if without.contains(['{', '}']) => "a brace that belongs to no {label}",
            0 => "{label} is missing; expected folder or a pattern as {label}_*",
            2.. => "{label} stands there more than once",
            _ if text.contains("{label}*") || text.contains("*{label}") => {
                "{label} and * with nothing between them"
            }
            _ => return Ok(Self::split(text)),
        };
        Err(fault.to_owned())
    }

    /// The label in a file's name; none where the name does not match.
    pub fn label<'a>(&self, file_name: &'a str) -> Option<&'a str> {
        let name = match self.with_extension {
            true => file_name,
            false => without_extension(file_name),
        };
        let mut rest = name.strip_prefix(self.literals[0].as_str())?;
        let mut label = None;
        for (index, wild) in self.wilds.iter().enumerate() {
            let next = self.literals[index + 1].as_str();
            let least = match wild {
                Wild::Label => rest.chars().next()?.len_utf8(),
                Wild::Any => 0,
            };
            let end = match index + 1 == self.wilds.len() {
                true => rest.strip_suffix(next)?.len(),
                false => least + rest[least..].find(next)?,
            };
            if end < least {
                return None;
            }
            if *wild == Wild::Label {
                label = Some(&rest[..end]);
            }
            rest = &rest[end + next.len()..];
        }
        label
    }

    fn split(text: &str) -> Self {
        let mut pattern = Self {
            literals: vec![String::new()],
            wilds: Vec::new(),
            with_extension: without_extension(text).len() < text.len(),
        };
        let mut rest = text;
        while let Some(sign) = rest.chars().next() {
            if let Some(after) = rest.strip_prefix(PLACEHOLDER) {
                pattern.add(Wild::Label);
                rest = after;
            } else if sign == '*' {
                pattern.add(Wild::Any);
                rest = rest.trim_start_matches('*');
            } else {
                let last = pattern.literals.len() - 1;
                pattern.literals[last].push(sign);
                rest = &rest[sign.len_utf8()..];
            }
        }
        pattern
    }

    fn add(&mut self, wild: Wild) {
        self.wilds.push(wild);
        self.literals.push(String::new());
    }
}

/// A name without `.bvh`, in any case.
fn without_extension(name: &str) -> &str {
    let start = name.len().saturating_sub(".bvh".len());
    match name.get(start..) {
        Some(end) if end.eq_ignore_ascii_case(".bvh") => &name[..start],
        _ => name,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn label(pattern: &str, name: &str) -> Option<String> {
        Pattern::new(pattern)
            .unwrap()
            .label(name)
            .map(str::to_owned)
    }

    /// The cases of the browser's test (web/src/app/label-pattern.test.ts).
    #[test]
    fn labels_are_those_of_the_browser() {
        for (pattern, name, expected) in [
            ("{label}_*", "05_08.bvh", Some("05")),
            ("{label}_*", "slow_walk_3.bvh", Some("slow")),
            ("*_{label}", "anna_slow_walk.bvh", Some("slow_walk")),
            ("*_{label}_*", "anna_walk_tired_3.bvh", Some("walk")),
            ("{label}", "walk.bvh", Some("walk")),
            ("{label}", "歩き.bvh", Some("歩き")),
            ("{label}_*", "walk.bvh", None),
            ("{label}_*", "_8.bvh", None),
            ("s{label}_*", "05_08.bvh", None),
            ("{label}_08", "05_09.bvh", None),
            ("ab{label}b", "ab.bvh", None),
            ("ab-{label}", "ab-.bvh", None),
            ("{label}_*", "__x.bvh", Some("_")),
            ("*_{label}", "a_walk.BVH", Some("walk")),
            ("{label}_*.bvh", "walk_1.bvh", Some("walk")),
            ("{label}.bvh", "walk.BVH", None),
            ("*.{label}", "take.3.bvh", Some("3")),
            ("Take{label}", "take3.bvh", None),
            ("**_{label}", "a_b.bvh", Some("b")),
        ] {
            let found = label(pattern, name);
            assert_eq!(found.as_deref(), expected, "{pattern} {name}");
        }
    }

    #[test]
    fn a_wrong_pattern_says_what_is_wrong() {
        for (pattern, expected) in [
            ("*_walk", "is missing"),
            ("", "is missing"),
            ("{label}_{label}", "more than once"),
            ("{label}_{take}", "brace"),
            ("{label", "brace"),
            ("{label}*", "nothing between"),
            ("*{label}_1", "nothing between"),
        ] {
            let fault = Pattern::new(pattern).unwrap_err();
            assert!(fault.contains(expected), "{pattern}: {fault}");
        }
    }

    #[test]
    fn a_folder_is_the_one_that_the_file_lies_in() {
        let label = |path: &str| LabelRule::Folder.label(Path::new(path));
        assert_eq!(label("set/walks/a.bvh").as_deref(), Some("walks"));
        assert_eq!(label("a.bvh"), None);
    }
}
