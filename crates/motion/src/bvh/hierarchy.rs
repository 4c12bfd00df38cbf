//! The hierarchy: decoded lines go in, the skeleton of every performer comes out.

use nalgebra::Vector3;

use super::Limits;
use super::error::{ErrorKind, ParseError, Place, excerpt};
use super::number::{self, Mark, Word};
use crate::note::{Note, NoteKind};
use crate::skeleton::{Axis, Channel, Joint, Skeleton};

/// A decoded line of the hierarchy.
#[derive(Clone, Copy, Debug)]
pub struct TextLine<'a> {
    /// The text without indent.
    pub text: &'a str,
    /// Where the text begins.
    pub place: Place,
}

/// What the lines of a hierarchy say.
#[derive(Debug, Default)]
pub struct Hierarchy {
    /// One skeleton for each ROOT.
    pub skeletons: Vec<Skeleton>,
    /// What was assumed.
    pub notes: Vec<Note>,
    /// The first number with a decimal mark: the mark and its place.
    pub mark: Option<(Mark, Place)>,
}

/// Reads all lines of a hierarchy; `end` names what stands after them.
pub fn read(
    lines: &[TextLine<'_>],
    end: (&str, Place),
    limits: &Limits,
) -> Result<Hierarchy, ParseError> {
    let mut builder = Builder::new(limits);
    for line in lines {
        builder.line(Cursor::new(*line))?;
    }
    builder.finish(end)
}

/// A place in a line, going from word to word.
#[derive(Clone, Copy, Debug)]
struct Cursor<'a> {
    rest: &'a str,
    place: Place,
}

impl<'a> Cursor<'a> {
    fn new(line: TextLine<'a>) -> Self {
        Self {
            rest: line.text,
            place: line.place,
        }
        .trimmed()
    }

    fn advanced(self, bytes: usize) -> Self {
        let (over, rest) = self.rest.split_at(bytes);
        Self {
            rest,
            place: Place {
                line: self.place.line,
                column: self.place.column + over.chars().count(),
            },
        }
    }

    fn trimmed(self) -> Self {
        self.advanced(self.rest.len() - self.rest.trim_start().len())
    }

    /// The next word, which ends at white space, and what follows it.
    fn word(self) -> (&'a str, Self) {
        let end = self.rest.find(char::is_whitespace);
        let end = end.unwrap_or(self.rest.len());
        (&self.rest[..end], self.advanced(end).trimmed())
    }

    /// The name that fills the line, up to a brace that stands alone or at its end.
    fn name(self) -> (&'a str, Self) {
        let mut end = self.rest.trim_end().len();
        let mut at = self;
        while !at.rest.is_empty() {
            if at.rest.starts_with('{') {
                end = self.rest.len() - at.rest.len();
                break;
            }
            at = at.word().1;
        }
        let name = self.rest[..end].trim_end();
        let name = name.strip_suffix('{').unwrap_or(name);
        (name.trim_end(), self.advanced(name.len()).trimmed())
    }
}

#[derive(Clone, Copy, Debug)]
enum Block {
    Joint(usize),
    Unknown,
}

#[derive(Debug)]
struct Builder<'a> {
    limits: &'a Limits,
    found: Hierarchy,
    joints: usize,
    hierarchies: usize,
    blocks: Vec<Block>,
    /// What was declared and waits for its brace.
    declared: Option<Block>,
    /// Channel names that the last CHANNELS line still lacks.
    missing_channels: usize,
    has_offset: Vec<bool>,
}

impl<'a> Builder<'a> {
    fn new(limits: &'a Limits) -> Self {
        Self {
            limits,
            found: Hierarchy::default(),
            joints: 0,
            hierarchies: 0,
            blocks: Vec::new(),
            declared: None,
            missing_channels: 0,
            has_offset: Vec::new(),
        }
    }

    fn line(&mut self, mut at: Cursor<'_>) -> Result<(), ParseError> {
        while !at.rest.is_empty() {
            at = self.item(at)?;
        }
        Ok(())
    }

    /// Reads one brace or one keyword with what belongs to it.
    fn item<'t>(&mut self, at: Cursor<'t>) -> Result<Cursor<'t>, ParseError> {
        if at.rest.starts_with('{') {
            return Ok(self.open(at));
        }
        if self.missing_channels > 0 && !at.rest.starts_with('}') {
            if let Some(channel) = channel(at.word().0).filter(|known| *known != Channel::Other) {
                self.missing_channels -= 1;
                self.add_channel(channel, at);
                return Ok(at.word().1);
            }
        }
        self.need_brace(at)?;
        if at.rest.starts_with('}') {
            return Ok(self.close(at));
        }
        let (keyword, after) = at.word();
        match keyword.to_ascii_uppercase().as_str() {
            "HIERARCHY" => self.hierarchy(at, after),
            "ROOT" => self.root(at, after),
            "JOINT" => self.joint(at, after, false),
            "ENDSITE" => self.joint(at, after, true),
            "END" if after.word().0.eq_ignore_ascii_case("site") => {
                self.joint(at, after.word().1, true)
            }
            "OFFSET" => self.offset(at, after),
            "CHANNELS" => self.channels(at, after),
            _ => Ok(self.unknown(at)),
        }
    }

    fn note(&mut self, kind: NoteKind, at: Cursor<'_>, details: Vec<String>) {
        let note = Note::new(kind, details).at(at.place.line, at.place.column);
        self.found.notes.push(note);
    }

    fn unknown<'t>(&mut self, at: Cursor<'t>) -> Cursor<'t> {
        self.note(NoteKind::UnknownLine, at, vec![excerpt(at.rest)]);
        let (name, after) = at.name();
        if after.rest.is_empty() || name.is_empty() {
            return at.advanced(at.rest.len());
        }
        self.declared = Some(Block::Unknown);
        after
    }

    fn need_brace(&self, at: Cursor<'_>) -> Result<(), ParseError> {
        let Some(Block::Joint(_)) = self.declared else {
            return Ok(());
        };
        let details = vec![excerpt(at.word().0), self.name_of_declared()];
        Err(ParseError::new(ErrorKind::ExpectedBrace, at.place, details))
    }

    fn name_of_declared(&self) -> String {
        match self.declared {
            Some(Block::Joint(joint)) => self.called(joint),
            _ => String::new(),
        }
    }

    fn open<'t>(&mut self, at: Cursor<'t>) -> Cursor<'t> {
        let block = self.declared.take().unwrap_or(Block::Unknown);
        self.blocks.push(block);
        at.advanced(1).trimmed()
    }

    fn close<'t>(&mut self, at: Cursor<'t>) -> Cursor<'t> {
        self.declared = None;
        self.missing_channels = 0;
        if self.blocks.pop().is_none() {
            self.note(NoteKind::UnknownLine, at, vec!["}".to_owned()]);
        }
        at.advanced(1).trimmed()
    }

    fn hierarchy<'t>(
        &mut self,
        at: Cursor<'t>,
        after: Cursor<'t>,
    ) -> Result<Cursor<'t>, ParseError> {
        self.hierarchies += 1;
        if !self.found.skeletons.is_empty() {
            self.close_all(at, "HIERARCHY");
            self.note(NoteKind::RepeatedHierarchy, at, Vec::new());
        }
        Ok(after)
    }

    fn close_all(&mut self, at: Cursor<'_>, closed_at: &str) {
        if self.blocks.is_empty() {
            return;
        }
        self.blocks.clear();
        self.note(NoteKind::MissingBrace, at, vec![closed_at.to_owned()]);
    }

    fn root<'t>(&mut self, at: Cursor<'t>, after: Cursor<'t>) -> Result<Cursor<'t>, ParseError> {
        self.close_all(at, "ROOT");
        self.finish_skeleton();
        if self.hierarchies == 0 && self.found.skeletons.is_empty() {
            self.note(NoteKind::MissingHierarchy, at, Vec::new());
        }
        self.found.skeletons.push(Skeleton::default());
        self.has_offset.clear();
        self.add_joint(at, after, None, false)
    }

    fn joint<'t>(
        &mut self,
        at: Cursor<'t>,
        after: Cursor<'t>,
        is_end_site: bool,
    ) -> Result<Cursor<'t>, ParseError> {
        let parent = self.blocks.iter().rev().find_map(|block| match block {
            Block::Joint(joint) => Some(*joint),
            Block::Unknown => None,
        });
        if parent.is_none() {
            let details = vec![excerpt(at.rest)];
            return Err(ParseError::new(
                ErrorKind::JointOutsideRoot,
                at.place,
                details,
            ));
        }
        self.add_joint(at, after, parent, is_end_site)
    }

    fn add_joint<'t>(
        &mut self,
        at: Cursor<'t>,
        after: Cursor<'t>,
        parent: Option<usize>,
        is_end_site: bool,
    ) -> Result<Cursor<'t>, ParseError> {
        self.joints += 1;
        if self.joints > self.limits.joints {
            let details = vec![self.limits.joints.to_string()];
            return Err(ParseError::new(ErrorKind::TooManyJoints, at.place, details));
        }
        let (name, rest) = after.name();
        let mut name = name.to_owned();
        if name.is_empty() && !is_end_site {
            name = format!("Joint{}", self.joints);
            self.note(NoteKind::UnnamedJoint, at, vec![name.clone()]);
        }
        let joints = &mut self.skeleton().joints;
        let index = joints.len();
        joints.push(Joint {
            name,
            parent,
            offset: Vector3::zeros(),
            channels: Vec::new(),
            first_channel: 0,
            is_end_site,
            line: at.place.line,
        });
        self.has_offset.push(false);
        self.declared = Some(Block::Joint(index));
        Ok(rest)
    }

    /// The skeleton of the last ROOT; there is one once a joint was declared.
    fn skeleton(&mut self) -> &mut Skeleton {
        if self.found.skeletons.is_empty() {
            self.found.skeletons.push(Skeleton::default());
        }
        let last = self.found.skeletons.len() - 1;
        &mut self.found.skeletons[last]
    }

    /// The joint of the innermost block.
    fn current(&self) -> Option<usize> {
        match self.blocks.last() {
            Some(Block::Joint(joint)) => Some(*joint),
            _ => None,
        }
    }

    /// What messages call a joint.
    fn called(&self, joint: usize) -> String {
        let Some(skeleton) = self.found.skeletons.last() else {
            return String::new();
        };
        let own = &skeleton.joints[joint];
        match own.parent {
            Some(parent) if own.is_end_site => format!("{}/end", skeleton.joints[parent].name),
            _ => own.name.clone(),
        }
    }

    fn offset<'t>(&mut self, at: Cursor<'t>, after: Cursor<'t>) -> Result<Cursor<'t>, ParseError> {
        let Some(joint) = self.current() else {
            return Ok(self.unknown(at));
        };
        let mut offset = Vector3::zeros();
        let mut rest = after;
        for component in 0..3 {
            let (word, next) = rest.word();
            if word.is_empty() || word.starts_with(['{', '}']) {
                let details = vec![self.called(joint), component.to_string()];
                return Err(ParseError::new(ErrorKind::ShortOffset, rest.place, details));
            }
            offset[component] = self.offset_number(joint, rest)?;
            rest = next;
        }
        self.skeleton().joints[joint].offset = offset;
        self.has_offset[joint] = true;
        Ok(rest)
    }

    fn offset_number(&mut self, joint: usize, at: Cursor<'_>) -> Result<f64, ParseError> {
        let word = at.word().0;
        if let Some(mark) = number::mark(word.as_bytes()) {
            let (first, _) = *self.found.mark.get_or_insert((mark, at.place));
            if first != mark {
                return Err(mixed_marks(word, first, at.place));
            }
        }
        match number::word(word.as_bytes()) {
            Word::Number(number) => Ok(number),
            Word::NotANumber => {
                let details = vec![self.called(joint), excerpt(word)];
                self.note(NoteKind::OffsetNotANumber, at, details);
                Ok(0.0)
            }
            Word::Text => Err(ParseError::new(
                ErrorKind::NotANumber,
                at.place,
                vec![excerpt(word)],
            )),
        }
    }

    fn channels<'t>(
        &mut self,
        at: Cursor<'t>,
        after: Cursor<'t>,
    ) -> Result<Cursor<'t>, ParseError> {
        let Some(joint) = self.current() else {
            return Ok(self.unknown(at));
        };
        let (said, mut rest) = after.word();
        let count = said.parse::<usize>().ok();
        if count.is_none() {
            rest = after;
        }
        let before = self.skeleton().joints[joint].channels.len();
        while !rest.rest.is_empty() && !rest.rest.starts_with('}') {
            let (word, next) = rest.word();
            let Some(channel) = channel(word) else { break };
            self.add_channel(channel, rest);
            rest = next;
        }
        let found = self.skeleton().joints[joint].channels.len() - before;
        self.missing_channels = count.unwrap_or(0).saturating_sub(found);
        let said = if count.is_some() { said } else { "nothing" };
        self.check_channels(at, joint, said, found);
        Ok(rest)
    }

    fn check_channels(&mut self, at: Cursor<'_>, joint: usize, said: &str, found: usize) {
        if said == found.to_string() {
            return;
        }
        let details = vec![self.called(joint), said.to_owned(), found.to_string()];
        self.note(NoteKind::ChannelCount, at, details);
    }

    fn add_channel(&mut self, channel: Channel, at: Cursor<'_>) {
        let Some(joint) = self.current() else { return };
        self.skeleton().joints[joint].channels.push(channel);
        if channel == Channel::Other {
            let details = vec![excerpt(at.word().0), self.called(joint)];
            self.note(NoteKind::SkippedChannel, at, details);
        }
    }

    /// Counts the columns of the skeleton just read, and notes what its joints lack.
    fn finish_skeleton(&mut self) {
        let Some(mut skeleton) = self.found.skeletons.pop() else {
            return;
        };
        let mut is_parent = vec![false; skeleton.joints.len()];
        let mut column = 0;
        for joint in &mut skeleton.joints {
            joint.first_channel = column;
            column += joint.channels.len();
            if let Some(parent) = joint.parent {
                is_parent[parent] = true;
            }
        }
        self.found.skeletons.push(skeleton);
        for (joint, is_parent) in is_parent.into_iter().enumerate() {
            self.note_lacks(joint, is_parent);
        }
    }

    fn note_lacks(&mut self, index: usize, is_parent: bool) {
        let has_offset = self.has_offset[index];
        let joint = self.skeleton().joints[index].clone();
        let positions = joint
            .channels
            .iter()
            .filter(|channel| matches!(channel, Channel::Position(_)))
            .count();
        let called = self.called(index);
        let mut lacks = |kind, details| {
            let note = Note::new(kind, details).at(joint.line, 1);
            self.found.notes.push(note);
        };
        if !has_offset {
            lacks(NoteKind::MissingOffset, vec![called.clone()]);
        }
        if positions == 1 || positions == 2 {
            let details = vec![called.clone(), positions.to_string()];
            lacks(NoteKind::PartialPosition, details);
        }
        if !is_parent && !joint.is_end_site {
            lacks(NoteKind::MissingEndSite, vec![called]);
        }
    }

    fn finish(mut self, end: (&str, Place)) -> Result<Hierarchy, ParseError> {
        let at = Cursor {
            rest: end.0,
            place: end.1,
        };
        self.need_brace(at)?;
        self.close_all(at, end.0);
        self.finish_skeleton();
        if self.found.skeletons.is_empty() {
            return Err(ParseError::new(ErrorKind::NoRoot, at.place, Vec::new()));
        }
        Ok(self.found)
    }
}

/// The error of a decimal mark that differs from the one used before.
pub fn mixed_marks(word: &str, used: Mark, at: Place) -> ParseError {
    let used = match used {
        Mark::Point => "point",
        Mark::Comma => "comma",
    };
    let details = vec![excerpt(word), used.to_owned()];
    ParseError::new(ErrorKind::MixedDecimalMarks, at, details)
}

/// The channel of a name; none where the word cannot be the name of a channel.
fn channel(word: &str) -> Option<Channel> {
    let name = word.to_ascii_lowercase();
    let axis = match name.as_bytes().first()? {
        b'x' => Some(Axis::X),
        b'y' => Some(Axis::Y),
        b'z' => Some(Axis::Z),
        b'{' | b'}' => return None,
        _ => None,
    };
    let channel = match (axis, name.get(1..)) {
        (Some(axis), Some("position")) => Channel::Position(axis),
        (Some(axis), Some("rotation")) => Channel::Rotation(axis),
        _ => Channel::Other,
    };
    let is_keyword = [
        "hierarchy",
        "root",
        "joint",
        "end",
        "endsite",
        "offset",
        "channels",
    ]
    .contains(&name.as_str());
    (!is_keyword).then_some(channel)
}
