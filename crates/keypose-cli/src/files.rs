//! Files and folders given in; the motion capture files in them out, in order, each once and by a name
//! of its own.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use walkdir::{DirEntry, WalkDir};

/// One file to work on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InputFile {
    /// Where it is.
    pub path: PathBuf,
    /// What output calls it: the path below the folder given, or the file's own name; with as many
    /// of its folders before that as tell it from the others.
    pub label: String,
    /// Where it is from the root, whatever links led to its folder.
    pub place: PathBuf,
}

/// What a call is about.
#[derive(Debug, Default)]
pub struct Inputs {
    /// All files, in the order given; those of a folder in the order of their names.
    pub files: Vec<InputFile>,
    /// A line for each path that does not exist and each folder that cannot be listed.
    pub faults: Vec<String>,
    /// A line for each folder without motion capture files.
    pub remarks: Vec<String>,
}

/// What is found at the paths given. A file that is named twice is taken once.
pub fn collect(paths: &[PathBuf]) -> Inputs {
    let mut inputs = Inputs::default();
    for path in paths {
        if path.is_dir() {
            inputs.add_folder(path);
        } else {
            match path.metadata() {
                Ok(_) => inputs.add(path, file_name(path)),
                Err(error) => inputs.faults.push(format!("{}: {error}", path.display())),
            }
        }
    }
    let mut places = BTreeSet::new();
    inputs
        .files
        .retain(|file| places.insert(file.place.clone()));
    tell_apart(&mut inputs.files);
    inputs
}

impl Inputs {
    /// Says on standard error what could not be found. Returns whether all could.
    pub fn report(&self) -> bool {
        for line in self.faults.iter().chain(&self.remarks) {
            eprintln!("{line}");
        }
        self.faults.is_empty()
    }

    fn add(&mut self, path: &Path, label: String) {
        self.files.push(InputFile {
            path: path.to_path_buf(),
            label,
            place: place(path),
        });
    }

    fn add_folder(&mut self, folder: &Path) {
        let (files, faults) = (self.files.len(), self.faults.len());
        for entry in WalkDir::new(folder).follow_links(true).sort_by_file_name() {
            match entry {
                Ok(entry) if is_motion(&entry) => {
                    let below = entry.path().strip_prefix(folder);
                    self.add(entry.path(), text(below.unwrap_or(entry.path())));
                }
                Ok(_) => {}
                Err(error) => self.faults.push(fault(folder, &error)),
            }
        }
        if (files, faults) == (self.files.len(), self.faults.len()) {
            self.remarks
                .push(format!("{}: no .bvh files there", folder.display()));
        }
    }
}

/// `path: what is wrong`, without the path in what is wrong.
fn fault(folder: &Path, error: &walkdir::Error) -> String {
    let path = error.path().unwrap_or(folder).display();
    match error.io_error() {
        Some(cause) => format!("{path}: {cause}"),
        None => format!("{path}: a link to a folder that it lies in"),
    }
}

fn is_motion(entry: &DirEntry) -> bool {
    let extension = entry.path().extension();
    entry.file_type().is_file()
        && extension.is_some_and(|extension| extension.eq_ignore_ascii_case("bvh"))
}

fn place(path: &Path) -> PathBuf {
    let folder = path.parent().filter(|folder| *folder != Path::new(""));
    let folder = folder.unwrap_or(Path::new(".")).canonicalize();
    match (folder, path.file_name()) {
        (Ok(folder), Some(name)) => folder.join(name),
        _ => path.to_path_buf(),
    }
}

/// Gives files of the same name one folder more each, until no two have the same.
fn tell_apart(files: &mut [InputFile]) {
    loop {
        let mut namesakes: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
        for (index, file) in files.iter().enumerate() {
            namesakes.entry(&file.label).or_default().push(index);
        }
        let same = namesakes.into_values().filter(|same| same.len() > 1);
        let same: Vec<usize> = same.flatten().collect();
        let mut is_longer = false;
        for index in same {
            is_longer |= files[index].lengthen();
        }
        if !is_longer {
            return;
        }
    }
}

impl InputFile {
    /// Puts one folder more before the label. Returns whether there was one.
    fn lengthen(&mut self) -> bool {
        let parts = self.label.split('/').count() + 1;
        let mut start = self.place.as_path();
        for _ in 0..parts {
            match start.parent() {
                Some(above) => start = above,
                None => return false,
            }
        }
        let longer = self.place.strip_prefix(start).map(text);
        longer.is_ok_and(|longer| {
            let is_longer = longer.len() > self.label.len();
            self.label = longer;
            is_longer
        })
    }
}

fn text(path: &Path) -> String {
    path.to_string_lossy().replace('\\', "/")
}

/// The last part of a path, as text.
pub fn file_name(path: &Path) -> String {
    path.file_name()
        .unwrap_or(path.as_os_str())
        .to_string_lossy()
        .into_owned()
}
