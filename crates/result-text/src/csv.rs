//! Fields of comma-separated values (RFC 4180): a text goes in, a field comes out.

/// A text as a field: in quotes where it holds a comma, a quote or the end of a line.
pub fn field(text: &str) -> String {
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
