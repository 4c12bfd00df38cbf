//! One test for each decision of `docs/bvh.md`: a small file goes in, the clip and the exact
//! words of its notes, or of its error, come out.

use motion::bvh::{ErrorKind, Limits, ParseError, Reader, parse};
use motion::clip::Clip;
use motion::kinematics::Kinematics;
use motion::note::{Note, NoteKind};
use motion::skeleton::{Axis, Channel};
use nalgebra::Vector3;

/// A root with six channels, a joint with three, an End Site: 12 lines, rows of 9 values.
const HIERARCHY: &str = "\
HIERARCHY
ROOT Hips
{
  OFFSET 0 1 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Spine
  {
    OFFSET 0.0 10.0 0.0
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    { OFFSET 0 5 0 } } }
";

/// A header for `frames`, 25 frames per second: lines 12 to 14.
fn header(frames: usize) -> String {
    format!("MOTION\nFrames: {frames}\nFrame Time: 0.04\n")
}

/// A row of nine values.
const ROW: &str = "1 2 3 4 5 6 7 8 9.5\n";

fn with_rows(frames: usize, rows: &str) -> String {
    format!("{HIERARCHY}{}{rows}", header(frames))
}

fn clip(text: impl AsRef<[u8]>) -> Clip {
    parse(text.as_ref()).expect("a clip")
}

fn error(text: impl AsRef<[u8]>) -> ParseError {
    parse(text.as_ref()).expect_err("an error")
}

/// `line:column kind: sentence` of a note; a dash where there is no place.
fn shown(note: &Note) -> String {
    let place = match (note.line, note.column) {
        (Some(line), Some(column)) => format!("{line}:{column}"),
        _ => "-".to_owned(),
    };
    format!("{place} {}: {}", note.kind.name(), note.message())
}

fn notes(clip: &Clip) -> Vec<String> {
    clip.notes.iter().map(shown).collect()
}

fn shown_error(text: impl AsRef<[u8]>) -> String {
    let error = error(text);
    format!(
        "{}:{} {}: {error}",
        error.line,
        error.column,
        error.kind.name()
    )
}

fn names(clip: &Clip) -> Vec<&str> {
    let joints = &clip.performers[0].skeleton.joints;
    joints.iter().map(|joint| joint.name.as_str()).collect()
}

#[test]
fn a_plain_file_has_no_notes() {
    let clip = clip(with_rows(2, &ROW.repeat(2)));
    assert_eq!(notes(&clip), [""; 0]);
    assert_eq!(
        (clip.frames, clip.row_width, clip.frame_time_s),
        (2, 9, 0.04)
    );
    assert_eq!(
        clip.frame_values(0, 1),
        [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.5]
    );
    assert_eq!(names(&clip), ["Hips", "Spine", ""]);
}

#[test]
fn keywords_and_channel_names_are_read_in_any_case() {
    let plain = with_rows(1, ROW);
    let name_less = |text: &str| {
        let mut clip = clip(text);
        for joint in &mut clip.performers[0].skeleton.joints {
            joint.name.make_ascii_lowercase();
        }
        clip
    };
    assert_eq!(name_less(&plain.to_lowercase()), name_less(&plain));
    assert_eq!(name_less(&plain.to_uppercase()), name_less(&plain));
}

#[test]
fn a_joint_name_is_the_rest_of_the_line() {
    for name in [
        "Bip01 L UpperArm",
        "mixamorig:Hips",
        "spine.001",
        "左腕",
        "Joint",
        "OFFSET 1",
    ] {
        let text = with_rows(1, ROW).replace("Spine", name);
        assert_eq!(names(&clip(&text))[1], name);
        assert_eq!(names(&clip(text.replace("\n  {\n", " {\n")))[1], name);
        assert_eq!(names(&clip(text.replace("\n  {\n", "{\n")))[1], name);
    }
}

#[test]
fn equal_names_are_told_apart_by_their_path() {
    let text = with_rows(1, ROW).replace("Spine", "Hips");
    let clip = clip(text);
    assert_eq!(notes(&clip), [""; 0]);
    assert_eq!(
        clip.performers[0].skeleton.labels(),
        ["Hips", "Hips/Hips", "Hips/Hips/end"]
    );
}

#[test]
fn a_joint_without_a_name_gets_one() {
    let clip = clip(with_rows(1, ROW).replace("JOINT Spine", "JOINT"));
    assert_eq!(names(&clip)[1], "Joint2");
    assert_eq!(
        notes(&clip),
        ["6:3 unnamed-joint: A joint has no name; it is called Joint2."]
    );
}

#[test]
fn utf8_is_read_with_or_without_mark() {
    let text = with_rows(1, ROW).replace("Spine", "脊椎");
    assert_eq!(clip(format!("\u{FEFF}{text}")), clip(text));
}

#[test]
fn utf16_is_read_by_its_mark() {
    let text = with_rows(1, ROW).replace("Spine", "脊椎🦴");
    let units = || "\u{FEFF}".encode_utf16().chain(text.encode_utf16());
    let little: Vec<u8> = units().flat_map(u16::to_le_bytes).collect();
    let big: Vec<u8> = units().flat_map(u16::to_be_bytes).collect();
    for bytes in [little, big] {
        let clip = clip(bytes);
        assert_eq!(names(&clip)[1], "脊椎🦴");
        let expected = "- encoding: The text is UTF-16, not UTF-8; names were decoded from it.";
        assert_eq!(notes(&clip), [expected]);
    }
}

fn with_name(name: &[u8]) -> Vec<u8> {
    let text = with_rows(1, ROW);
    let (before, after) = text.split_once("Spine").expect("a name");
    [before.as_bytes(), name, after.as_bytes()].concat()
}

#[test]
fn shift_jis_is_read_if_it_has_a_kana_or_kanji_of_two_bytes() {
    // The second byte of ボ is a brace in ASCII.
    let clip = clip(with_name(b"\x83\x7B\x81\x5B\x83\x93"));
    assert_eq!(names(&clip)[1], "ボーン");
    let expected = "- encoding: The text is Shift_JIS, not UTF-8; names were decoded from it.";
    assert_eq!(notes(&clip), [expected]);
}

#[test]
fn windows_1252_is_read_otherwise() {
    // 0xDF alone is clean Shift_JIS too, but of one byte.
    let clip = clip(with_name(b"Fu\xDF"));
    assert_eq!(names(&clip)[1], "Fuß");
    let expected = "- encoding: The text is Windows-1252, not UTF-8; names were decoded from it.";
    assert_eq!(notes(&clip), [expected]);
}

#[test]
fn lines_end_with_lf_crlf_or_cr_and_may_be_blank_or_have_tabs() {
    let text = with_rows(2, &ROW.repeat(2));
    let plain = clip(&text);
    for changed in [
        text.replace('\n', "\r\n"),
        text.replace('\n', "\r"),
        text.replace(' ', "\t"),
        text.trim_end().to_owned(),
    ] {
        assert_eq!(clip(changed), plain);
    }
    let blank = clip(text.replace('\n', " \n\n\t\n"));
    assert_eq!((blank.values, blank.notes), (plain.values, plain.notes));
}

#[test]
fn an_end_site_is_known_by_its_keyword_and_may_have_a_name() {
    let text = with_rows(1, ROW)
        .replace("Spine", "EndOfSpine")
        .replace("End Site", "END site Tip");
    let clip = clip(text);
    let joints = &clip.performers[0].skeleton.joints;
    assert_eq!(names(&clip), ["Hips", "EndOfSpine", "Tip"]);
    assert_eq!(
        (joints[1].is_end_site, joints[2].is_end_site),
        (false, true)
    );
    assert_eq!(notes(&clip), [""; 0]);
}

#[test]
fn a_joint_has_any_channels_in_any_order() {
    let text = with_rows(1, "1 2 3 4 5 6 7\n")
        .replace(
            "6 Xposition Yposition Zposition Zrotation",
            "6 Zrotation Zposition Yposition Xposition",
        )
        .replace("3 Zrotation Xrotation Yrotation", "1 yrotation");
    let clip = clip(text);
    let joints = &clip.performers[0].skeleton.joints;
    use Channel::{Position, Rotation};
    let expected = [
        Rotation(Axis::Z),
        Position(Axis::Z),
        Position(Axis::Y),
        Position(Axis::X),
        Rotation(Axis::X),
        Rotation(Axis::Y),
    ];
    assert_eq!(joints[0].channels, expected);
    assert_eq!((joints[1].channels.len(), joints[1].first_channel), (1, 6));
    assert_eq!(notes(&clip), [""; 0]);
}

#[test]
fn a_joint_without_channels_holds_still() {
    let text = with_rows(1, "1 2 3 4 5 6\n").replace("3 Zrotation Xrotation Yrotation", "0");
    assert_eq!(notes(&clip(text)), [""; 0]);
}

#[test]
fn the_names_of_channels_count() {
    let says_five = clip(with_rows(1, ROW).replace("CHANNELS 6", "CHANNELS 5"));
    assert_eq!(says_five.row_width, 9);
    let expected =
        "5:3 channel-count: CHANNELS of Hips says 5, 6 names follow; the names were counted.";
    assert_eq!(notes(&says_five), [expected]);
    let wrapped = clip(with_rows(1, ROW).replace(" Zrotation", "\nZrotation"));
    assert_eq!((wrapped.row_width, notes(&wrapped).len()), (9, 0));
}

/// The world positions of all joints in a frame.
fn positions(clip: &Clip, frame: usize) -> Vec<f64> {
    let mut kinematics = Kinematics::new(clip, 0);
    let mut positions = vec![0.0; 3 * kinematics.joint_count()];
    kinematics.positions(frame, &mut positions);
    positions
}

#[test]
fn positions_replace_the_offset_at_any_joint() {
    let text = with_rows(1, "1 2 3 0 0 0 4 5 6\n").replace(
        "3 Zrotation Xrotation Yrotation",
        "3 Xposition Yposition Zposition",
    );
    let clip = clip(text);
    assert_eq!(
        positions(&clip, 0),
        [1.0, 2.0, 3.0, 5.0, 7.0, 9.0, 5.0, 12.0, 9.0]
    );
    assert_eq!(notes(&clip), [""; 0]);
}

#[test]
fn tiny_positions_are_relative() {
    let channels = "3 Xposition Yposition Zposition";
    let text = |rows| with_rows(2, rows).replace("3 Zrotation Xrotation Yrotation", channels);
    let relative = clip(text("1 2 3 0 0 0 0 0.09 0\n1 2 3 0 0 0 0 -0.09 0.01\n"));
    assert_eq!(positions(&relative, 1)[3..6], [1.0, 11.91, 3.01]);
    let expected = "6:1 relative-positions: The positions of Spine are tiny against its OFFSET; they were added to it instead of replacing it.";
    assert_eq!(notes(&relative), [expected]);
    // 1 % of the OFFSET, once, is not tiny.
    let absolute = clip(text("1 2 3 0 0 0 0 0.09 0\n1 2 3 0 0 0 0 -0.1 0.01\n"));
    assert_eq!(positions(&absolute, 0)[3..6], [1.0, 2.09, 3.0]);
    assert_eq!(notes(&absolute), [""; 0]);
}

#[test]
fn one_or_two_positions_replace_their_components() {
    let text = with_rows(1, "4 5 0 0 7 8 9\n")
        .replace(
            "6 Xposition Yposition Zposition Zrotation",
            "4 Xposition Zposition",
        )
        .replace("OFFSET 0 1 0", "OFFSET 0 3 0");
    let clip = clip(text);
    assert_eq!(positions(&clip, 0)[..3], [4.0, 3.0, 5.0]);
    let expected = "2:1 partial-position: Hips has 2 position channels; the other components come from its OFFSET.";
    assert_eq!(notes(&clip), [expected]);
}

#[test]
fn every_root_is_a_performer() {
    let second = HIERARCHY
        .replace("HIERARCHY\n", "")
        .replace("Hips", "Other");
    let row = format!("{} {ROW}", ROW.trim_end());
    let clip = clip(format!("{HIERARCHY}{second}{}{row}", header(1)));
    assert_eq!((clip.performers.len(), clip.row_width), (2, 18));
    assert_eq!(clip.performers[1].skeleton.joints[0].name, "Other");
    assert_eq!(clip.frame_values(1, 0), clip.frame_values(0, 0));
    let expected = "12:1 several-performers: The file has 2 ROOTs; each is a performer of its own.";
    assert_eq!(notes(&clip), [expected]);
}

#[test]
fn a_repeated_hierarchy_is_a_second_root_and_rows_may_alternate() {
    let rows = "1 1 1 1 1 1 1 1 1\n2 2 2 2 2 2 2 2 2\n".repeat(3);
    let clip = clip(format!("{HIERARCHY}{HIERARCHY}{}{rows}", header(3)));
    assert_eq!(
        (
            clip.frames,
            clip.frame_values(0, 2)[0],
            clip.frame_values(1, 2)[0]
        ),
        (3, 1.0, 2.0)
    );
    let expected = [
        "12:1 repeated-hierarchy: A second HIERARCHY stands here; it was read as a further performer.",
        "13:1 several-performers: The file has 2 ROOTs; each is a performer of its own.",
        "26:1 alternating-rows: Rows are as wide as one performer and there are 2 for each frame; they were taken in turns.",
    ];
    assert_eq!(notes(&clip), expected);
}

#[test]
fn frames_without_motion_begins_the_motion() {
    let clip = clip(with_rows(1, ROW).replace("MOTION\n", ""));
    let expected = "12:1 frames-without-motion: “Frames:” stands without MOTION; the motion was taken to start here.";
    assert_eq!((clip.frames, notes(&clip)), (1, vec![expected.to_owned()]));
}

#[test]
fn rows_without_any_header_begin_the_motion() {
    let clip = clip(format!("{HIERARCHY}{ROW}"));
    assert_eq!((clip.frames, clip.frame_time_s), (1, 1.0 / 30.0));
    let expected = [
        "12:1 missing-motion: MOTION is missing; the motion was taken to start at the first row of numbers.",
        "12:1 frame-time-missing: “Frame Time:” is missing; 1/30 s was assumed.",
        "12:1 motion-without-frames: MOTION has no “Frames:” line; the rows present were counted (1).",
    ];
    assert_eq!(notes(&clip), expected);
}

#[test]
fn motion_without_frames_counts_the_rows() {
    let clip = clip(with_rows(1, &ROW.repeat(3)).replace("Frames: 1\n", ""));
    let expected = "12:1 motion-without-frames: MOTION has no “Frames:” line; the rows present were counted (3).";
    assert_eq!((clip.frames, notes(&clip)), (3, vec![expected.to_owned()]));
}

#[test]
fn the_rows_present_are_used() {
    assert_eq!(
        notes(&clip(
            with_rows(3, &ROW.repeat(3)).replace("Frames: 3", "Frames: 3.0")
        )),
        [""; 0]
    );
    for (said, rows) in [(5, 3), (1, 3), (0, 3)] {
        let clip = clip(with_rows(said, &ROW.repeat(rows)));
        assert_eq!(clip.frames, rows);
        let expected = format!(
            "13:1 frame-count: “Frames:” says {said}, 3 complete rows are present; the rows present were used."
        );
        assert_eq!(notes(&clip), [expected]);
    }
}

#[test]
fn an_incomplete_last_row_is_left_out() {
    for end in ["", "\n", " 1.2e-", " -", " na"] {
        let clip = clip(with_rows(2, &format!("{ROW}1 2 3 4 5{end}")));
        assert_eq!((clip.frames, clip.values.len()), (1, 9), "{end:?}");
        let messages: Vec<_> = clip.notes.iter().map(Note::message).collect();
        let expected = [
            "“Frames:” says 2, 1 complete rows are present; the rows present were used.",
            "The last row has 5 of 9 values; it was left out.",
        ];
        assert_eq!(messages, expected);
        assert_eq!(
            (clip.notes[1].line, clip.notes[1].kind.name()),
            (Some(16), "incomplete-last-row")
        );
    }
}

#[test]
fn wrapped_rows_are_one_stream() {
    let clip = clip(with_rows(2, "1 2 3 4\n5 6 7 8 9\n\n1 2 3 4 5\n6 7 8 9\n"));
    assert_eq!(clip.frames, 2);
    assert_eq!(
        clip.frame_values(0, 1),
        [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]
    );
    let expected = "15:1 wrapped-rows: Rows are wrapped over several lines; the values were read as one stream, 9 to a frame.";
    assert_eq!(notes(&clip), [expected]);
    let one_line = with_rows(2, &ROW.repeat(2).replace('\n', " "));
    assert_eq!(parse(one_line.as_bytes()).expect("a clip").frames, 2);
}

#[test]
fn a_row_too_short_or_too_long_is_an_error() {
    let short = "16:8 short-row: Found 4 values in this row where 9 were expected, one for each channel. Complete the row, or export the motion again.";
    assert_eq!(
        shown_error(with_rows(3, &format!("{ROW}1 2 3 4\n{ROW}"))),
        short
    );
    let long = "16:21 long-row: Found a further value in this row after the 9 that were expected, one for each channel. Remove what is too much, or export the motion again.";
    assert_eq!(
        shown_error(with_rows(3, &format!("{ROW}1 2 3 4 5 6 7 8 9.5 10\n{ROW}"))),
        long
    );
    // The last row too: more than a row is no incomplete row.
    assert_eq!(
        shown_error(with_rows(2, &format!("{ROW}1 2 3 4 5 6 7 8 9.5 10"))),
        long
    );
    let first = "15:8 short-row: Found 4 values in this row where 9 were expected, one for each channel. Complete the row, or export the motion again.";
    assert_eq!(
        shown_error(with_rows(3, &format!("1 2 3 4\n{ROW}{ROW}"))),
        first
    );
}

#[test]
fn other_channels_are_skipped() {
    let text = with_rows(1, "1 2 3 4 5 6 77 7 8 9\n").replace(
        "3 Zrotation Xrotation Yrotation",
        "4 Xscale Zrotation Xrotation Yrotation",
    );
    let clip = clip(text);
    let spine = &clip.performers[0].skeleton.joints[1];
    assert_eq!(spine.channels[0], Channel::Other);
    let expected = "9:16 skipped-channel: The channel Xscale of Spine is neither a position nor a rotation; its values were skipped.";
    assert_eq!(notes(&clip), [expected]);
}

#[test]
fn text_after_the_last_row_is_ignored() {
    let clip = clip(with_rows(1, &format!("{ROW}# by hand\n# and more\n")));
    let expected = "16:1 text-after-motion: Text after the last row was ignored: # by hand";
    assert_eq!((clip.frames, notes(&clip)), (1, vec![expected.to_owned()]));
    let behind = with_rows(1, &ROW.replace('\n', " ; end\n"));
    assert_eq!(parse(behind.as_bytes()).expect("a clip").frames, 1);
}

#[test]
fn text_between_rows_is_an_error() {
    let text = with_rows(2, &format!("{ROW}# half\n{ROW}"));
    let expected = "16:1 text-between-rows: Found “# half” between two rows of numbers. Remove it.";
    assert_eq!(shown_error(text), expected);
    let text = with_rows(1, &ROW.replace('5', "five"));
    let expected =
        "15:9 not-a-number: Found “five” where a number was expected. Correct or remove it.";
    assert_eq!(shown_error(text.replace("9.five", "9")), expected);
}

/// The seconds and the note that a frame time gives.
fn frame_time(text: &str) -> (f64, String) {
    let clip = clip(with_rows(1, ROW).replace("0.04", text));
    (clip.frame_time_s, notes(&clip).join("\n"))
}

#[test]
fn a_frame_time_is_in_seconds() {
    for text in ["0.0417083750417", "0.0005", ".5", "8.333e-3"] {
        assert_eq!(
            frame_time(text),
            (text.parse().expect("a number"), String::new())
        );
    }
}

#[test]
fn an_unusable_frame_time_is_a_thirtieth() {
    for text in ["0", "-0.04", "nan", "soon", "0.00049", "251", "1e400"] {
        let note = format!(
            "14:1 frame-time-invalid: The frame time “{text}” is not usable; 1/30 s was assumed."
        );
        assert_eq!(frame_time(text), (1.0 / 30.0, note));
    }
    let clip = clip(with_rows(1, ROW).replace("Frame Time: 0.04\n", ""));
    assert_eq!(clip.frame_time_s, 1.0 / 30.0);
    let expected = "12:1 frame-time-missing: “Frame Time:” is missing; 1/30 s was assumed.";
    assert_eq!(notes(&clip), [expected]);
}

#[test]
fn a_usual_rate_is_frames_per_second() {
    for (text, rate) in [
        ("30", 30.0),
        ("29.97", 29.97),
        ("119.9", 119.9),
        ("250", 250.0),
        ("1000", 1000.0),
    ] {
        let note = format!(
            "14:1 frame-time-is-rate: The frame time {text} was taken as frames per second."
        );
        assert_eq!(frame_time(text), (1.0 / rate, note));
    }
}

#[test]
fn other_large_frame_times_are_milliseconds_or_seconds() {
    for (text, milliseconds) in [("33.33", 33.33), ("8.33", 8.33), ("4", 4.0), ("249", 249.0)] {
        let note = format!(
            "14:1 frame-time-is-milliseconds: The frame time {text} was taken as milliseconds."
        );
        assert_eq!(frame_time(text), (milliseconds / 1000.0, note));
    }
    for (text, seconds) in [("1", 1.0), ("3.9", 3.9)] {
        let note = format!(
            "14:1 frame-time-is-seconds: The frame time {text} was taken as seconds, though it is long."
        );
        assert_eq!(frame_time(text), (seconds, note));
    }
}

#[test]
fn a_joint_holds_its_value_where_there_is_no_number() {
    let rows = "1 2 3 4 5 6 7 8 nan\n1 -nan(ind) inf 1.#QNAN 1.#INF -1.#IND 7 8 9.5\n";
    let clip = clip(with_rows(2, rows));
    assert_eq!(
        clip.frame_values(0, 0),
        [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.5]
    );
    assert_eq!(
        clip.frame_values(0, 1),
        [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.5]
    );
    let expected = "15:17 not-a-number: Values that are not numbers: 6 (first: nan); the joints hold their previous value.";
    assert_eq!(notes(&clip), [expected]);
    assert_eq!(clip.notes[0].frame, Some(0));
}

#[test]
fn a_motion_may_begin_without_a_number() {
    for end in ["\n", ""] {
        let clip = clip(with_rows(1, &format!(" NaN 2 3 4 5 6 7 8 9.5{end}")));
        assert_eq!(clip.frame_values(0, 0)[..3], [0.0, 2.0, 3.0]);
        let expected = "15:2 not-a-number: Values that are not numbers: 1 (first: NaN); the joints hold their previous value.";
        assert_eq!(notes(&clip), [expected]);
    }
}

#[test]
fn a_decimal_comma_is_read_if_used_throughout() {
    let rows = "1,5 2 -3,25 4 5 6 7 8 9\n";
    let text = with_rows(1, rows)
        .replace("0.0 10.0 0.0", "0,0 10,0 0,0")
        .replace("0.04", "0,04");
    let clip = clip(text);
    assert_eq!(clip.frame_values(0, 0)[..3], [1.5, 2.0, -3.25]);
    assert_eq!(
        clip.performers[0].skeleton.joints[1].offset,
        Vector3::new(0.0, 10.0, 0.0)
    );
    let expected =
        "8:12 decimal-comma: Numbers are written with a decimal comma; it was read as a point.";
    assert_eq!(notes(&clip), [expected]);
}

#[test]
fn a_decimal_comma_of_the_frame_time_alone_is_read() {
    let note =
        "14:1 decimal-comma: Numbers are written with a decimal comma; it was read as a point.";
    assert_eq!(frame_time("0,04"), (0.04, note.to_owned()));
}

#[test]
fn decimal_commas_and_points_together_are_an_error() {
    let expected = "15:1 mixed-decimal-marks: Found “1,5”, but the file writes numbers with a decimal point elsewhere. Use one of them throughout.";
    assert_eq!(shown_error(with_rows(1, "1,5 2 3 4 5 6 7 8 9\n")), expected);
    let commas = HIERARCHY.replace("0.0 10.0 0.0", "0,0 10,0 0,0");
    let expected = "15:17 mixed-decimal-marks: Found “9.5”, but the file writes numbers with a decimal comma elsewhere. Use one of them throughout.";
    assert_eq!(shown_error(format!("{commas}{}{ROW}", header(1))), expected);
    // A comma between numbers is no decimal comma.
    assert_eq!(
        error(with_rows(1, "1, 2, 3, 4\n")).kind.name(),
        "not-a-number"
    );
}

#[test]
fn a_file_without_motion_shows_its_skeleton() {
    let no_motion = "- no-motion: The file has no motion; only the skeleton is shown.";
    for end in ["", "MOTION", "MOTION\nFrames: 0\nFrame Time: 0.04\n"] {
        let clip = clip(format!("{HIERARCHY}{end}"));
        assert_eq!(
            (clip.frames, clip.performers.len(), clip.row_width),
            (0, 1, 9)
        );
        assert_eq!(notes(&clip), [no_motion]);
    }
    assert_eq!(clip(with_rows(1, ROW)).frames, 1);
}

#[test]
fn nesting_is_no_matter_but_the_number_of_joints_is_limited() {
    let chain = |joints: usize| {
        let mut text = String::from("HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 0\n");
        for depth in 1..joints {
            let indent = "\t".repeat(depth % 100);
            text += &format!("{indent}JOINT a\n{indent}{{\n{indent}OFFSET 0 1 0\n");
        }
        text + &"}\n".repeat(joints)
    };
    assert_eq!(
        clip(chain(10_000)).performers[0].skeleton.joints.len(),
        10_000
    );
    let expected = "30003:1 too-many-joints: The file has more than 10000 joints, the limit. Remove joints that are not needed.";
    assert_eq!(shown_error(chain(10_001)), expected);
}

#[test]
fn the_number_of_values_is_limited() {
    let limits = Limits {
        values: 20,
        ..Limits::DEFAULT
    };
    let mut reader = Reader::with_limits(None, limits);
    let error = reader
        .push(with_rows(3, &ROW.repeat(3)).as_bytes())
        .expect_err("an error");
    let expected = "The file has more than 20 values, the limit. Cut it into shorter motions.";
    assert_eq!(
        (error.line, error.column, error.to_string().as_str()),
        (17, 5, expected)
    );
    assert_eq!(reader.finish().expect_err("the same error"), error);
}

#[test]
fn a_frame_count_that_cannot_be_reserves_no_memory() {
    let clip = clip(with_rows(usize::MAX, ROW));
    assert_eq!(clip.frames, 1);
    assert!(clip.values.capacity() < 4096);
}

#[test]
fn a_missing_closing_brace_is_assumed() {
    let clip = clip(with_rows(1, ROW).replace("} } }", "}"));
    assert_eq!(clip.frames, 1);
    let expected =
        "12:1 missing-brace: A closing brace is missing; the hierarchy was closed at MOTION.";
    assert_eq!(notes(&clip), [expected]);
}

#[test]
fn a_missing_opening_brace_is_an_error() {
    let text = with_rows(1, ROW).replace("JOINT Spine\n  {", "JOINT Spine\n");
    let expected = "8:5 expected-brace: Found “OFFSET 0.0 10.0 0.0” where “{” was expected for Spine. Put the brace there.";
    assert_eq!(shown_error(text), expected);
}

#[test]
fn what_stands_outside_or_is_unknown_is_said() {
    let text = with_rows(1, ROW).replace("} } }", "} } } }\nJOINT Lost { OFFSET 0 0 0 }");
    let expected = "12:1 joint-outside-root: Found JOINT Lost { OFFSET 0 0 0 } outside of any ROOT; every joint belongs to one. Look for a closing brace too many above.";
    assert_eq!(shown_error(text), expected);
    let clip = clip(with_rows(1, ROW).replace("    End Site", "    COLOR 1 0 0\n    End Site"));
    assert_eq!(
        notes(&clip),
        ["10:5 unknown-line: A line was not understood and ignored: COLOR 1 0 0"]
    );
}

#[test]
fn offsets_are_checked() {
    let text = with_rows(1, ROW);
    let expected =
        "8:15 short-offset: The OFFSET of Spine has 1 numbers, 3 were expected. Write x, y and z.";
    assert_eq!(
        shown_error(text.replace("OFFSET 0.0 10.0 0.0", "OFFSET 0.0")),
        expected
    );
    let expected =
        "8:16 not-a-number: Found “ten” where a number was expected. Correct or remove it.";
    assert_eq!(shown_error(text.replace("10.0", "ten")), expected);
    let nan = clip(text.replace("10.0", "nan"));
    let expected = "8:16 offset-not-a-number: The OFFSET of Spine holds “nan”, which is no number; zero was assumed for it.";
    assert_eq!(notes(&nan), [expected]);
    let missing = clip(text.replace("    OFFSET 0.0 10.0 0.0\n", ""));
    assert_eq!(
        notes(&missing),
        ["6:3 missing-offset: Spine has no OFFSET; zero was assumed."]
    );
}

#[test]
fn a_leaf_without_end_site_is_noted() {
    let clip = clip(with_rows(1, ROW).replace("End Site\n    { OFFSET 0 5 0 }", ""));
    assert_eq!(
        notes(&clip),
        ["6:3 missing-end-site: Spine has no End Site."]
    );
}

#[test]
fn a_hierarchy_without_its_keyword_is_read_from_its_root() {
    let clip = clip(with_rows(1, ROW).replace("HIERARCHY", "# by a tool"));
    let expected = [
        "1:1 unknown-line: A line was not understood and ignored: # by a tool",
        "2:1 missing-hierarchy: The keyword HIERARCHY is missing; the file was read from its first ROOT.",
    ];
    assert_eq!(notes(&clip), expected);
}

#[test]
fn what_is_no_bvh_file_is_said_to_be_none() {
    let empty =
        "1:1 empty: The file is empty; a BVH file begins with HIERARCHY. Export the motion again.";
    assert_eq!(shown_error(""), empty);
    assert_eq!(shown_error(" \n\n"), empty);
    let no_bvh = |found: &str, place: &str| {
        format!(
            "{place} not-bvh: Found “{found}” where HIERARCHY was expected; without the skeleton the numbers have no meaning. Choose a BVH file, or export the motion again with its hierarchy."
        )
    };
    assert_eq!(shown_error("\n 1 2 3\n"), no_bvh("1 2 3", "2:2"));
    assert_eq!(shown_error("{\"json\": 1}"), no_bvh("{\"json\": 1}", "1:1"));
    let long = "x".repeat(1 << 20);
    assert_eq!(
        shown_error(&long),
        no_bvh(&format!("{}…", &long[..40]), "1:1")
    );
    let expected = "2:1 no-root: Found the end of the hierarchy where a ROOT was expected. Export the motion again with its skeleton.";
    assert_eq!(shown_error("HIERARCHY\nMOTION\n"), expected);
}

#[test]
fn rows_without_channels_are_an_error() {
    let text = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\n}\nMOTION\nFrames: 1\nFrame Time: 0.1\n 1\n";
    let expected = "9:2 no-channels: Found a row of numbers, but no joint has CHANNELS. Add them, or export the motion again.";
    assert_eq!(shown_error(text), expected);
}

#[test]
fn the_page_names_every_kind() {
    let page = include_str!("../../../docs/bvh.md");
    let is_of_reading = |kind: &&NoteKind| **kind <= NoteKind::NoMotion;
    let notes = NoteKind::ALL
        .iter()
        .filter(is_of_reading)
        .map(|kind| kind.name());
    let errors = ErrorKind::ALL.iter().map(|kind| kind.name());
    for name in notes.chain(errors) {
        assert!(page.contains(&format!("`{name}`")), "{name}");
    }
}
