//! True keyposes from JSON: a file or a folder of them in, the marks of each motion out.
//!
//! A file holds one object, or an array of them: `{"file": "walk.bvh", "frames": [55, 121]}`.
//! `keyposes` may stand for `frames`; an element is a frame, or `[from, to]` for a held pose.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use motion::keypose::evaluation::Mark;
use serde_json::Value;
use walkdir::WalkDir;

use crate::files::file_name;

/// Marks by the name of the motion file.
#[derive(Debug, Default)]
pub struct Marks(BTreeMap<String, Vec<Mark>>);

impl Marks {
    /// Reads a file, or every .json below a folder.
    ///
    /// # Errors
    /// A file that cannot be read or has another form; the message names it.
    pub fn read(path: &Path) -> Result<Self> {
        let mut marks = Self::default();
        for file in mark_files(path)? {
            let text =
                std::fs::read_to_string(&file).with_context(|| file.display().to_string())?;
            marks
                .add(&text)
                .with_context(|| file.display().to_string())?;
        }
        Ok(marks)
    }

    /// The marks of a motion, by its label or the last part of it.
    pub fn of(&self, label: &str) -> Option<&[Mark]> {
        let name = file_name(Path::new(label));
        self.0
            .get(label)
            .or_else(|| self.0.get(&name))
            .map(Vec::as_slice)
    }

    fn add(&mut self, text: &str) -> Result<()> {
        match serde_json::from_str(text)? {
            Value::Array(objects) => objects
                .iter()
                .try_for_each(|object| self.add_object(object)),
            object => self.add_object(&object),
        }
    }

    fn add_object(&mut self, object: &Value) -> Result<()> {
        let file = object
            .get("file")
            .and_then(Value::as_str)
            .context("no “file” with a name")?;
        let frames = object.get("keyposes").or_else(|| object.get("frames"));
        let frames = frames
            .and_then(Value::as_array)
            .context("no “keyposes” or “frames”")?;
        let mut marks = frames.iter().map(mark).collect::<Result<Vec<_>>>()?;
        marks.sort_by_key(|mark| (mark.from, mark.to));
        self.0.insert(file.to_owned(), marks);
        Ok(())
    }
}

fn mark_files(path: &Path) -> Result<Vec<PathBuf>> {
    if !path.is_dir() {
        return Ok(vec![path.to_path_buf()]);
    }
    let mut files = Vec::new();
    for entry in WalkDir::new(path).sort_by_file_name() {
        let entry = entry?;
        if entry
            .path()
            .extension()
            .is_some_and(|extension| extension == "json")
        {
            files.push(entry.into_path());
        }
    }
    Ok(files)
}

fn mark(value: &Value) -> Result<Mark> {
    let frame = |value: &Value| value.as_u64().and_then(|frame| usize::try_from(frame).ok());
    if let Some(at) = frame(value) {
        return Ok(Mark { from: at, to: at });
    }
    let ends: Option<Vec<usize>> = value
        .as_array()
        .and_then(|ends| ends.iter().map(frame).collect());
    match ends.as_deref() {
        Some(&[from, to]) if from <= to => Ok(Mark { from, to }),
        _ => bail!("found {value}; expected a frame, or [from, to] with from not after to"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_and_held_poses_are_read() {
        let mut marks = Marks::default();
        marks
            .add(r#"{"file": "a.bvh", "keyposes": [[20, 30], 7]}"#)
            .unwrap();
        let expected = [Mark { from: 7, to: 7 }, Mark { from: 20, to: 30 }];
        assert_eq!(marks.of("folder/a.bvh").unwrap(), expected);
        assert!(marks.of("b.bvh").is_none());
    }

    #[test]
    fn an_odd_mark_is_named() {
        let error = Marks::default()
            .add(r#"{"file": "a.bvh", "frames": [[3, 2]]}"#)
            .unwrap_err();
        assert_eq!(
            error.to_string(),
            "found [3,2]; expected a frame, or [from, to] with from not after to"
        );
    }
}
