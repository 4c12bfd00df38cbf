//! The hierarchy: decoded lines go in, the skeleton of every performer comes out.

mod channels;
mod cursor;
mod skeletons;

use nalgebra::Vector3;

use super::Limits;
use super::error::{ErrorKind, ParseError, excerpt};
use super::notes::Notes;
use super::number::{self, Mark, Word, mixed_marks};
use super::place::Place;
use crate::note::NoteKind;
use crate::skeleton::{Channel, Skeleton};
use channels::Channels;
pub use cursor::Cursor;
use skeletons::Skeletons;

/// What the lines of a hierarchy say.
#[derive(Debug, Default)]
pub struct Hierarchy {
    /// One skeleton for each ROOT.
    pub skeletons: Vec<Skeleton>,
    /// The decimal mark of its numbers.
    pub mark: Option<Mark>,
}

/// Reads all `lines`; `end` is what stands after them.
pub fn read<'a>(
    lines: impl Iterator<Item = Cursor<'a>>,
    end: Cursor<'a>,
    limits: &Limits,
    notes: &mut Notes,
) -> Result<Hierarchy, ParseError> {
    let mut builder = Builder::new(limits, notes);
    for line in lines {
        builder.line(line)?;
    }
    builder.finish(end)
}

/// What a pair of braces holds.
#[derive(Clone, Copy, Debug)]
enum Block {
    Joint(usize),
    Unknown,
}

#[derive(Debug)]
struct Builder<'n, 't> {
    limits: &'n Limits,
    notes: &'n mut Notes,
    skeletons: Skeletons,
    mark: Option<Mark>,
    hierarchies: usize,
    second_root: Option<Place>,
    blocks: Vec<Block>,
    /// What was declared and waits for its brace.
    declared: Option<Block>,
    channels: Option<Channels<'t>>,
}

type Step<'t> = Result<Cursor<'t>, ParseError>;

impl<'n, 't> Builder<'n, 't> {
    fn new(limits: &'n Limits, notes: &'n mut Notes) -> Self {
        Self {
            limits,
            notes,
            skeletons: Skeletons::default(),
            mark: None,
            hierarchies: 0,
            second_root: None,
            blocks: Vec::new(),
            declared: None,
            channels: None,
        }
    }

    fn line(&mut self, mut at: Cursor<'t>) -> Result<(), ParseError> {
        while !at.rest.is_empty() {
            at = self.item(at)?;
        }
        Ok(())
    }

    /// Reads a brace, a channel, or a keyword with what belongs to it.
    fn item(&mut self, at: Cursor<'t>) -> Step<'t> {
        if let Some(after) = self.channel(at) {
            return Ok(after);
        }
        if at.rest.starts_with('{') {
            self.blocks
                .push(self.declared.take().unwrap_or(Block::Unknown));
            return Ok(at.past(1));
        }
        self.need_brace(at)?;
        match at.rest.starts_with('}') {
            true => Ok(self.close(at)),
            false => self.keyword(at),
        }
    }

    fn keyword(&mut self, at: Cursor<'t>) -> Step<'t> {
        let (keyword, after) = at.word();
        let is = |known: &str| keyword.eq_ignore_ascii_case(known);
        if is("offset") {
            self.offset(at, after)
        } else if is("channels") {
            Ok(self.begin_channels(at, after))
        } else if is("joint") {
            self.joint(at, after, false)
        } else if is("end") && after.word().0.eq_ignore_ascii_case("site") {
            self.joint(at, after.word().1, true)
        } else if is("endsite") {
            self.joint(at, after, true)
        } else if is("root") {
            self.root(at, after)
        } else if is("hierarchy") {
            Ok(self.hierarchy(at, after))
        } else {
            Ok(self.unknown(at))
        }
    }

    /// Notes a line that is not understood; a brace in it opens a block of its own.
    fn unknown(&mut self, at: Cursor<'t>) -> Cursor<'t> {
        self.notes
            .add(NoteKind::UnknownLine, at.place(), vec![excerpt(at.rest)]);
        let after = at.name().1;
        match after.rest.starts_with('{') {
            true => after,
            false => at.at_end(),
        }
    }

    fn need_brace(&self, at: Cursor<'_>) -> Result<(), ParseError> {
        let Some(Block::Joint(joint)) = self.declared else {
            return Ok(());
        };
        let details = vec![excerpt(at.rest), self.skeletons.called(joint)];
        Err(ParseError::new(
            ErrorKind::ExpectedBrace,
            at.place(),
            details,
        ))
    }

    fn close(&mut self, at: Cursor<'t>) -> Cursor<'t> {
        if self.blocks.pop().is_none() {
            self.notes
                .add(NoteKind::UnknownLine, at.place(), vec!["}".to_owned()]);
        }
        at.past(1)
    }

    fn close_all(&mut self, at: Cursor<'_>, called: &str) {
        if !self.blocks.is_empty() {
            self.blocks.clear();
            self.notes
                .add(NoteKind::MissingBrace, at.place(), vec![called.to_owned()]);
        }
    }

    fn hierarchy(&mut self, at: Cursor<'t>, after: Cursor<'t>) -> Cursor<'t> {
        self.hierarchies += 1;
        if self.skeletons.count() > 0 {
            self.close_all(at, "HIERARCHY");
            self.notes
                .add(NoteKind::RepeatedHierarchy, at.place(), Vec::new());
        }
        after
    }

    fn root(&mut self, at: Cursor<'t>, after: Cursor<'t>) -> Step<'t> {
        self.close_all(at, "ROOT");
        self.skeletons.end(self.notes);
        if self.hierarchies == 0 && self.skeletons.count() == 0 {
            self.notes
                .add(NoteKind::MissingHierarchy, at.place(), Vec::new());
        }
        if self.skeletons.count() == 1 {
            self.second_root = Some(at.place());
        }
        self.add_joint(at, after, None, false)
    }

    fn joint(&mut self, at: Cursor<'t>, after: Cursor<'t>, is_end_site: bool) -> Step<'t> {
        let parent = self.blocks.iter().rev().find_map(|block| match block {
            Block::Joint(joint) => Some(*joint),
            Block::Unknown => None,
        });
        if parent.is_none() {
            let details = vec![excerpt(at.rest)];
            return Err(ParseError::new(
                ErrorKind::JointOutsideRoot,
                at.place(),
                details,
            ));
        }
        self.add_joint(at, after, parent, is_end_site)
    }

    fn add_joint(
        &mut self,
        at: Cursor<'t>,
        after: Cursor<'t>,
        parent: Option<usize>,
        is_end_site: bool,
    ) -> Step<'t> {
        if self.skeletons.joint_count() == self.limits.joints {
            let details = vec![self.limits.joints.to_string()];
            return Err(ParseError::new(
                ErrorKind::TooManyJoints,
                at.place(),
                details,
            ));
        }
        let (name, rest) = after.name();
        let mut name = name.to_owned();
        if name.is_empty() && !is_end_site {
            name = format!("Joint{}", self.skeletons.joint_count() + 1);
            self.notes
                .add(NoteKind::UnnamedJoint, at.place(), vec![name.clone()]);
        }
        let joint = self.skeletons.add(name, parent, is_end_site, at.place());
        self.declared = Some(Block::Joint(joint));
        Ok(rest)
    }

    fn offset(&mut self, at: Cursor<'t>, after: Cursor<'t>) -> Step<'t> {
        let Some(Block::Joint(joint)) = self.blocks.last().copied() else {
            return Ok(self.unknown(at));
        };
        let mut offset = Vector3::zeros();
        let mut rest = after;
        for component in 0..3 {
            if rest.rest.is_empty() || rest.is_at_brace() {
                let details = vec![self.skeletons.called(joint), component.to_string()];
                return Err(ParseError::new(
                    ErrorKind::ShortOffset,
                    rest.place(),
                    details,
                ));
            }
            let (word, after) = rest.word();
            offset[component] = self.offset_number(joint, word, rest)?;
            rest = after;
        }
        self.skeletons.set_offset(joint, offset);
        Ok(rest)
    }

    /// Reads a word of an OFFSET, which stands at a cursor.
    fn offset_number(
        &mut self,
        joint: usize,
        word: &str,
        at: Cursor<'_>,
    ) -> Result<f64, ParseError> {
        self.check_mark(word, at)?;
        match number::word(word.as_bytes()) {
            Word::Number(number) => Ok(number),
            Word::NotANumber => {
                let details = vec![self.skeletons.called(joint), excerpt(word)];
                self.notes
                    .add(NoteKind::OffsetNotANumber, at.place(), details);
                Ok(0.0)
            }
            Word::Text => {
                let details = vec![excerpt(word)];
                Err(ParseError::new(ErrorKind::NotANumber, at.place(), details))
            }
        }
    }

    fn check_mark(&mut self, word: &str, at: Cursor<'_>) -> Result<(), ParseError> {
        let Some(mark) = number::mark(word.as_bytes()) else {
            return Ok(());
        };
        if self.mark.is_none() && mark == Mark::Comma {
            self.notes
                .add(NoteKind::DecimalComma, at.place(), Vec::new());
        }
        let used = *self.mark.get_or_insert(mark);
        match used == mark {
            true => Ok(()),
            false => Err(mixed_marks(word, used, at.place())),
        }
    }

    fn begin_channels(&mut self, at: Cursor<'t>, after: Cursor<'t>) -> Cursor<'t> {
        let Some(Block::Joint(joint)) = self.blocks.last().copied() else {
            return self.unknown(at);
        };
        let (channels, names) = Channels::begin(joint, at.place(), after);
        self.channels = Some(channels);
        match names.rest.is_empty() {
            true => names,
            false => self.channel(names).unwrap_or(names),
        }
    }

    /// Takes a channel, or ends the channels at what is none.
    fn channel(&mut self, at: Cursor<'t>) -> Option<Cursor<'t>> {
        let channels = self.channels.as_mut()?;
        let joint = channels.joint;
        let Some((channel, after)) = channels.take(at) else {
            self.end_channels();
            return None;
        };
        self.skeletons.add_channel(joint, channel);
        if channel == Channel::Other {
            let details = vec![excerpt(at.word().0), self.skeletons.called(joint)];
            self.notes
                .add(NoteKind::SkippedChannel, at.place(), details);
        }
        Some(after)
    }

    fn end_channels(&mut self) {
        let ended = self.channels.take();
        let Some(channels) = ended.filter(|channels| !channels.is_as_said()) else {
            return;
        };
        let called = self.skeletons.called(channels.joint);
        let details = vec![called, channels.said.to_owned(), channels.found.to_string()];
        self.notes
            .add(NoteKind::ChannelCount, channels.place, details);
    }

    fn finish(mut self, end: Cursor<'_>) -> Result<Hierarchy, ParseError> {
        self.end_channels();
        self.need_brace(end)?;
        self.close_all(end, end.rest);
        self.skeletons.end(self.notes);
        if self.skeletons.count() == 0 {
            return Err(ParseError::new(ErrorKind::NoRoot, end.place(), Vec::new()));
        }
        if let Some(place) = self.second_root {
            let details = vec![self.skeletons.count().to_string()];
            self.notes.add(NoteKind::SeveralPerformers, place, details);
        }
        Ok(Hierarchy {
            skeletons: self.skeletons.whole(),
            mark: self.mark,
        })
    }
}
