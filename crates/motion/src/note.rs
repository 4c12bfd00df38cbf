//! Notes: what departs from the plain form of a file, and what was assumed.
//!
//! A note is a kind, a place and the details that its sentence names. The sentence is a template
//! with `{0}`, `{1}` … for the details, so that a front end can say it in another language.

/// One departure from the plain form, never dropped in silence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// What it is about.
    pub kind: NoteKind,
    /// The line of the file, from 1; none for a note about the whole motion.
    pub line: Option<usize>,
    /// The column, from 1, in characters.
    pub column: Option<usize>,
    /// The frame of the file, from 0, where the note is about one.
    pub frame: Option<usize>,
    /// What the template's `{0}`, `{1}` … stand for.
    pub details: Vec<String>,
}

impl Note {
    /// A note about the whole motion.
    pub fn new(kind: NoteKind, details: Vec<String>) -> Self {
        Self {
            kind,
            line: None,
            column: None,
            frame: None,
            details,
        }
    }

    /// The same note with its place in the file.
    #[must_use]
    pub fn at(mut self, line: usize, column: usize) -> Self {
        self.line = Some(line);
        self.column = Some(column);
        self
    }

    /// The same note with the frame that it is about.
    #[must_use]
    pub fn at_frame(mut self, frame: usize) -> Self {
        self.frame = Some(frame);
        self
    }

    /// The English sentence.
    pub fn message(&self) -> String {
        fill(self.kind.template(), &self.details)
    }
}

/// Puts `details` in the places `{0}`, `{1}` … of `template`; what a detail holds stays as it is.
pub fn fill(template: &str, details: &[String]) -> String {
    let mut text = String::with_capacity(template.len());
    let mut rest = template;
    while let Some((before, after)) = rest.split_once('{') {
        text.push_str(before);
        let place = after.split_once('}');
        let place = place.and_then(|(index, behind)| Some((index.parse::<usize>().ok()?, behind)));
        if let Some((index, behind)) = place {
            text.push_str(details.get(index).map_or("", String::as_str));
            rest = behind;
        } else {
            text.push('{');
            rest = after;
        }
    }
    text.push_str(rest);
    text
}

/// Makes an enum of kinds, each with a name for machines and a sentence for people.
macro_rules! sentence_kinds {
    ($(#[$about:meta])* $kind:ident: $($variant:ident $name:literal $template:literal;)*) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum $kind {
            $(#[doc = $template] $variant,)*
        }

        impl $kind {
            /// Every kind.
            pub const ALL: &'static [$kind] = &[$($kind::$variant,)*];

            /// The kind's name in machine-readable output; it never changes.
            pub fn name(self) -> &'static str {
                match self { $($kind::$variant => $name,)* }
            }

            /// The kind's English sentence with `{0}`, `{1}` … for the details.
            pub fn template(self) -> &'static str {
                match self { $($kind::$variant => $template,)* }
            }
        }
    };
}
pub(crate) use sentence_kinds;

sentence_kinds! {
    /// What a note is about.
    NoteKind:
    Encoding "encoding" "The text is {0}, not UTF-8; names were decoded from it.";
    UnnamedJoint "unnamed-joint" "A joint has no name; it is called {0}.";
    RelativePositions "relative-positions" "The positions of {0} are tiny against its OFFSET; they were added to it instead of replacing it.";
    SeveralPerformers "several-performers" "The file has {0} ROOTs; each is a performer of its own.";
    RepeatedHierarchy "repeated-hierarchy" "A second HIERARCHY stands here; it was read as a further performer.";
    AlternatingRows "alternating-rows" "Rows are as wide as one performer and there are {0} for each frame; they were taken in turns.";
    FramesWithoutMotion "frames-without-motion" "“Frames:” stands without MOTION; the motion was taken to start here.";
    MissingMotion "missing-motion" "MOTION is missing; the motion was taken to start at the first row of numbers.";
    MotionWithoutFrames "motion-without-frames" "MOTION has no “Frames:” line; the rows present were counted ({0}).";
    FrameCount "frame-count" "“Frames:” says {0}, {1} complete rows are present; the rows present were used.";
    IncompleteLastRow "incomplete-last-row" "The last row has {0} of {1} values; it was left out.";
    WrappedRows "wrapped-rows" "Rows are wrapped over several lines; the values were read as one stream, {0} to a frame.";
    SkippedChannel "skipped-channel" "The channel {0} of {1} is neither a position nor a rotation; its values were skipped.";
    PartialPosition "partial-position" "{0} has {1} position channels; the other components come from its OFFSET.";
    TextAfterMotion "text-after-motion" "Text after the last row was ignored: {0}";
    FrameTimeMissing "frame-time-missing" "“Frame Time:” is missing; 1/30 s was assumed.";
    FrameTimeInvalid "frame-time-invalid" "The frame time “{0}” is not usable; 1/30 s was assumed.";
    FrameTimeIsRate "frame-time-is-rate" "The frame time {0} was taken as frames per second.";
    FrameTimeIsMilliseconds "frame-time-is-milliseconds" "The frame time {0} was taken as milliseconds.";
    FrameTimeIsSeconds "frame-time-is-seconds" "The frame time {0} was taken as seconds, though it is long.";
    NotANumber "not-a-number" "Values that are not numbers: {0} (first: {1}); the joints hold their previous value.";
    DecimalComma "decimal-comma" "Numbers are written with a decimal comma; it was read as a point.";
    ChannelCount "channel-count" "CHANNELS of {0} says {1}, {2} names follow; the names were counted.";
    MissingEndSite "missing-end-site" "{0} has no End Site.";
    MissingOffset "missing-offset" "{0} has no OFFSET; zero was assumed.";
    OffsetNotANumber "offset-not-a-number" "The OFFSET of {0} holds “{1}”, which is no number; zero was assumed for it.";
    MissingBrace "missing-brace" "A closing brace is missing; the hierarchy was closed at {0}.";
    MissingHierarchy "missing-hierarchy" "The keyword HIERARCHY is missing; the file was read from its first ROOT.";
    UnknownLine "unknown-line" "A line was not understood and ignored: {0}";
    FurtherNotes "further-notes" "{0} more notes of the kind “{1}” were left out.";
    NoMotion "no-motion" "The file has no motion; only the skeleton is shown.";
    TooShort "too-short" "Too few frames to find keyposes: {0}.";
    NotHuman "not-human" "This is not a human body ({0}); all joints are analysed in root coordinates, and it is not compared with human motions.";
    Mirrored "mirrored" "Left and right look swapped against the direction of feet and knees; the names were kept.";
    EndEffectorFallback "end-effector-fallback" "{0} has no usable end; {1} stands for it.";
    EndSitesUnequal "end-sites-unequal" "The End Sites of left and right differ too much; none of this file's End Sites was used.";
    ShiftedArmNames "shifted-arm-names" "The names of the arms are shifted by one joint; the shape was followed instead.";
    ShiftedLegNames "shifted-leg-names" "The names of the legs are shifted by one joint; the shape was followed instead.";
    HipsTogether "hips-together" "The hips lie together in the OFFSETs; their mean places in the motion were used.";
    RestIsNoBody "rest-is-no-body" "The OFFSETs are no standing body; the trunk's length was taken from the motion.";
    NoLeftAndRight "no-left-and-right" "There is no left and right in the hips; root coordinates were used.";
    TrunkFromMotion "trunk-from-motion" "The trunk's direction in the OFFSETs is unusable; the mean of the motion was used.";
    LeadingTPose "leading-t-pose" "A T-pose stands before the motion; leading frames left out: {0}.";
    LeadingBlendedTPose "leading-blended-t-pose" "A T-pose is blended into the motion; leading frames left out: {0}.";
    LeadingJump "leading-jump" "The motion begins with a jump: frame 0 was left out.";
    LeadingByHand "leading-by-hand" "Leading frames left out by hand: {0}.";
    Discontinuity "discontinuity" "The motion jumps here: a step of {0} body heights in one frame.";
    LowPassLeftOut "low-pass-left-out" "The cut-off of {0} Hz is not below half the frame rate; the low-pass filter was left out.";
    ScalesLeftOut "scales-left-out" "Time scales at or above half the frame rate were left out; the finest is {0} Hz.";
    UpAssumed "up-assumed" "The up axis is not clear from the motion; +Y was assumed.";
    UnitUnknown "unit-unknown" "No unit makes this a body of usual height; lengths are shown in body heights.";
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_message_names_its_details() {
        let note = Note::new(NoteKind::FrameCount, vec!["10".into(), "9".into()]).at(7, 1);
        let expected =
            "“Frames:” says 10, 9 complete rows are present; the rows present were used.";
        assert_eq!(note.message(), expected);
    }

    #[test]
    fn braces_of_the_template_and_of_details_stay() {
        let details = ["{1}".to_owned(), "b".to_owned()];
        assert_eq!(fill("“{” {0} {1} {x} {", &details), "“{” {1} b {x} {");
    }

    #[test]
    fn names_are_unique() {
        let mut names: Vec<_> = NoteKind::ALL.iter().map(|kind| kind.name()).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), NoteKind::ALL.len());
    }
}
