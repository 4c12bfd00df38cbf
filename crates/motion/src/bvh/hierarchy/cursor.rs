//! A cursor in a line of the hierarchy: from word to word, knowing its place.

use crate::bvh::place::Place;

/// What is left of a line. Where that begins is worked out only when asked for.
#[derive(Clone, Copy, Debug)]
pub struct Cursor<'a> {
    /// The text that is left, without white space at its beginning.
    pub rest: &'a str,
    text: &'a str,
    /// The place of the first character of all the text.
    text_place: Place,
}

impl<'a> Cursor<'a> {
    /// At the beginning of a text.
    pub fn new(text: &'a str, place: Place) -> Self {
        let cursor = Self {
            rest: text,
            text,
            text_place: place,
        };
        cursor.past_spaces()
    }

    /// The line.
    pub fn line(self) -> usize {
        self.text_place.line
    }

    /// The place of the first character that is left.
    pub fn place(self) -> Place {
        let gone_over = &self.text[..self.text.len() - self.rest.len()];
        Place {
            line: self.text_place.line,
            column: self.text_place.column + gone_over.chars().count(),
        }
    }

    /// Past the next `bytes` and the white space after them.
    pub fn past(self, bytes: usize) -> Self {
        self.advanced(bytes).past_spaces()
    }

    /// Past all of the line.
    pub fn at_end(self) -> Self {
        self.advanced(self.rest.len())
    }

    /// Whether a brace comes next.
    pub fn is_at_brace(self) -> bool {
        matches!(self.rest.as_bytes().first(), Some(b'{' | b'}'))
    }

    /// The next word and what follows it; a word ends at white space or a brace.
    pub fn word(self) -> (&'a str, Self) {
        let end = word_end(self.rest);
        (&self.rest[..end], self.past(end))
    }

    /// The name that fills the line, up to a brace that stands alone or at the end of the line.
    pub fn name(self) -> (&'a str, Self) {
        if !self.rest.as_bytes().contains(&b'{') {
            return (self.rest.trim_end(), self.at_end());
        }
        let opens_alone = |(at, _): &(usize, &str)| {
            let before = self.rest[..*at].chars().next_back();
            before.is_none_or(char::is_whitespace)
        };
        let opening = self.rest.match_indices('{').find(opens_alone);
        let end = opening.map_or(self.rest.len(), |(at, _)| at);
        let name = self.rest[..end].trim_end();
        let name = match opening {
            None => name.strip_suffix('{').unwrap_or(name).trim_end(),
            Some(_) => name,
        };
        (name, self.past(name.len()))
    }

    fn advanced(self, bytes: usize) -> Self {
        Self {
            rest: &self.rest[bytes..],
            ..self
        }
    }

    fn past_spaces(self) -> Self {
        let mut bytes = self.rest.bytes();
        let spaces = bytes.position(|byte| byte != b' ').unwrap_or(0);
        if self
            .rest
            .as_bytes()
            .get(spaces)
            .is_some_and(u8::is_ascii_graphic)
        {
            return self.advanced(spaces);
        }
        Self {
            rest: self.rest.trim_start(),
            ..self
        }
    }
}

/// By byte: white space, braces and all that is not ASCII.
static MAY_END_A_WORD: [bool; 256] = {
    let mut may_end = [false; 256];
    let mut byte = 0;
    while byte < 256 {
        may_end[byte] = matches!(byte as u8, b'\t'..=b'\r' | b' ' | b'{' | b'}' | 0x80..);
        byte += 1;
    }
    may_end
};

/// Where the first word of a text ends.
fn word_end(text: &str) -> usize {
    let mut bytes = text.bytes();
    let end = bytes.position(|byte| MAY_END_A_WORD[usize::from(byte)]);
    match end {
        // White space of several bytes ends a word too, other characters of several bytes do not.
        Some(end) if !text.as_bytes()[end].is_ascii() => {
            let is_end = |c: char| c.is_whitespace() || c == '{' || c == '}';
            text.find(is_end).unwrap_or(text.len())
        }
        end => end.unwrap_or(text.len()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn name(text: &str) -> (&str, &str) {
        let (name, after) = Cursor::new(text, Place { line: 1, column: 1 }).name();
        (name, after.rest)
    }

    #[test]
    fn a_name_is_the_rest_of_the_line_but_for_a_brace() {
        assert_eq!(name("Bip01 L UpperArm "), ("Bip01 L UpperArm", ""));
        assert_eq!(name("mixamorig:Hips {"), ("mixamorig:Hips", "{"));
        assert_eq!(name("左 腕{"), ("左 腕", "{"));
        assert_eq!(name("a{b} c { OFFSET"), ("a{b} c", "{ OFFSET"));
        assert_eq!(name("{"), ("", "{"));
        assert_eq!(name(""), ("", ""));
    }

    #[test]
    fn a_word_ends_at_white_space_of_any_kind_or_a_brace() {
        for text in ["左a", "左a\u{3000}b", "左a b", "左a{", "左a}\u{3000}"] {
            let place = Place { line: 1, column: 1 };
            assert_eq!(Cursor::new(text, place).word().0, "左a", "{text}");
        }
    }

    #[test]
    fn columns_count_characters() {
        let (word, after) = Cursor::new(" 左腕 x", Place { line: 3, column: 5 }).word();
        assert_eq!((word, after.rest), ("左腕", "x"));
        assert_eq!(after.place(), Place { line: 3, column: 9 });
    }
}
