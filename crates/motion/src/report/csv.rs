//! Keyposes as comma-separated values (RFC 4180): one row a keypose.

use super::Subject;
use super::json::number;

/// The first line of every table of keyposes.
pub const HEADER: &str = "file,performer,number,frame,time_s,intensity\r\n";

/// The rows of one file, without [`HEADER`]; performers count from 0, keyposes from 1.
pub fn rows(subject: &Subject) -> String {
    let mut text = String::new();
    let file = field(subject.file);
    for (performer, found) in subject.analysis.performers.iter().enumerate() {
        let Ok(keyposes) = &found.keyposes else {
            continue;
        };
        for (index, (frame, intensity)) in keyposes.rows().enumerate() {
            let time_s = number(frame as f64 * subject.analysis.frame_time_s);
            let intensity = number(intensity);
            let order = index + 1;
            text.push_str(&format!(
                "{file},{performer},{order},{frame},{time_s},{intensity}\r\n"
            ));
        }
    }
    text
}

/// A text as a field: in quotes where it holds a comma, a quote or the end of a line.
fn field(text: &str) -> String {
    match text.contains([',', '"', '\r', '\n']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::field;

    #[test]
    fn fields_are_quoted_where_they_must_be() {
        assert_eq!(field("dance.bvh"), "dance.bvh");
        assert_eq!(field("a, \"b\".bvh"), "\"a, \"\"b\"\".bvh\"");
        assert_eq!(field("a\nb"), "\"a\nb\"");
    }
}
