//! How values lie on lines: the number of values in each line goes in; whether lines are frames,
//! wrapped or alternating comes out.

use crate::bvh::place::Place;

/// A row that has not the width of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OddRow {
    /// Values in the row.
    pub count: usize,
    /// Where the row ends, or where its first value too much stands.
    pub place: Place,
}

/// The lines so far, by the first of them.
#[derive(Clone, Copy, Debug)]
pub enum Layout {
    /// No line has ended.
    Unknown,
    /// A line is a frame; an odd one must be the last.
    Frames(Option<OddRow>),
    /// Lines are not frames.
    Stream(Stream),
}

/// Lines of which none but the last may have the width of a frame.
#[derive(Clone, Copy, Debug)]
pub struct Stream {
    first: OddRow,
    lines: usize,
    last_count: usize,
    /// Whether all lines but the last are as long as the first.
    is_even: bool,
}

/// What all lines together are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// Each line is a frame.
    Plain,
    /// The last line is not whole.
    Incomplete(OddRow),
    /// Frames go on from line to line, from this one.
    Wrapped(usize),
    /// Performers take turns from this line.
    Alternating(usize),
    /// This row is wrong.
    Broken(OddRow),
}

impl Layout {
    /// A row begins, so that the one before is not the last.
    ///
    /// # Errors
    /// The row that must not stand before another.
    pub fn begin_row(&mut self, width: usize) -> Result<(), OddRow> {
        match self {
            Layout::Frames(Some(row)) => Err(*row),
            Layout::Stream(stream) if stream.last_count == width => Err(stream.first),
            Layout::Stream(stream) => {
                stream.is_even &= stream.last_count == stream.first.count;
                Ok(())
            }
            _ => Ok(()),
        }
    }

    /// A row ends.
    pub fn end_row(&mut self, row: OddRow, width: usize) {
        match self {
            Layout::Unknown if row.count == width => *self = Layout::Frames(None),
            Layout::Unknown => {
                *self = Layout::Stream(Stream {
                    first: row,
                    lines: 1,
                    last_count: row.count,
                    is_even: true,
                });
            }
            Layout::Frames(odd) => *odd = (row.count != width).then_some(row),
            Layout::Stream(stream) => {
                stream.lines += 1;
                stream.last_count = row.count;
            }
        }
    }

    /// What the lines are, all `values` having been read; `widths` are the values of each
    /// performer, `frames` what the file says.
    pub fn shape(&self, values: usize, widths: &[usize], frames: Option<usize>) -> Shape {
        match self {
            Layout::Unknown | Layout::Frames(None) => Shape::Plain,
            Layout::Frames(Some(row)) => Shape::Incomplete(*row),
            Layout::Stream(stream) => stream.shape(values, widths, frames),
        }
    }
}

impl Stream {
    fn shape(&self, values: usize, widths: &[usize], frames: Option<usize>) -> Shape {
        let width: usize = widths.iter().sum();
        let is_whole = values.is_multiple_of(width);
        let expected_lines = frames.map(|frames| frames.saturating_mul(widths.len()));
        let is_said = expected_lines.is_none_or(|lines| lines == self.lines);
        let line = self.first.place.line;
        if self.may_alternate(widths) && (is_said || !is_whole) {
            Shape::Alternating(line)
        } else if is_whole {
            Shape::Wrapped(line)
        } else if self.lines == 1 && self.first.count < width {
            Shape::Incomplete(self.first)
        } else {
            Shape::Broken(self.first)
        }
    }

    fn may_alternate(&self, widths: &[usize]) -> bool {
        let one = self.first.count;
        widths.len() > 1
            && widths.iter().all(|width| *width == one)
            && self.is_even
            && self.last_count <= one
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(line: usize, count: usize) -> OddRow {
        let place = Place { line, column: 1 };
        OddRow { count, place }
    }

    fn shape(counts: &[usize], widths: &[usize], frames: Option<usize>) -> Shape {
        let width = widths.iter().sum();
        let mut layout = Layout::Unknown;
        for (index, &count) in counts.iter().enumerate() {
            if let Err(row) = layout.begin_row(width) {
                return Shape::Broken(row);
            }
            layout.end_row(row(index + 1, count), width);
        }
        layout.shape(counts.iter().sum(), widths, frames)
    }

    #[test]
    fn a_line_is_a_frame() {
        assert_eq!(shape(&[6, 6], &[6], None), Shape::Plain);
        assert_eq!(shape(&[6, 4], &[6], None), Shape::Incomplete(row(2, 4)));
        assert_eq!(shape(&[6, 4, 6], &[6], None), Shape::Broken(row(2, 4)));
        assert_eq!(shape(&[4], &[6], None), Shape::Incomplete(row(1, 4)));
    }

    #[test]
    fn rows_are_wrapped_if_no_line_but_the_last_has_the_width() {
        assert_eq!(shape(&[4, 2, 4, 2], &[6], Some(2)), Shape::Wrapped(1));
        assert_eq!(shape(&[12], &[6], None), Shape::Wrapped(1));
        assert_eq!(shape(&[5, 7, 6], &[6], None), Shape::Wrapped(1));
        assert_eq!(shape(&[4, 6, 2], &[6], None), Shape::Broken(row(1, 4)));
        assert_eq!(shape(&[4, 4], &[6], None), Shape::Broken(row(1, 4)));
    }

    #[test]
    fn performers_alternate_where_rows_are_as_wide_as_one() {
        assert_eq!(
            shape(&[3, 3, 3, 3], &[3, 3], Some(2)),
            Shape::Alternating(1)
        );
        assert_eq!(shape(&[3, 3, 3, 3], &[3, 3], Some(4)), Shape::Wrapped(1));
        assert_eq!(shape(&[3, 3, 3], &[3, 3], Some(2)), Shape::Alternating(1));
        assert_eq!(
            shape(&[3, 3, 3, 1], &[3, 3], Some(2)),
            Shape::Alternating(1)
        );
        assert_eq!(
            shape(&[3, 2, 3], &[3, 3], Some(2)),
            Shape::Broken(row(1, 3))
        );
        assert_eq!(shape(&[3, 4, 3, 4], &[3, 4], Some(2)), Shape::Wrapped(1));
    }
}
