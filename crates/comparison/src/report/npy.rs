//! Arrays as NumPy reads them: numbers and their shape go in, the bytes of an `.npy` file come out.
//!
//! Source: NumPy Enhancement Proposal 1, format version 1.0.

/// Magic word and version.
const MAGIC: &[u8] = b"\x93NUMPY\x01\x00";

/// The data begin at a multiple of this.
const ALIGNMENT: usize = 64;

/// What comes before the numbers of a table of 64-bit floats.
pub fn head(rows: usize, columns: usize) -> Vec<u8> {
    let header =
        format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({rows}, {columns}), }}");
    let before = MAGIC.len() + size_of::<u16>();
    let length = (before + header.len() + 1).next_multiple_of(ALIGNMENT) - before;
    let mut bytes = Vec::with_capacity(before + length);
    bytes.extend_from_slice(MAGIC);
    bytes.extend_from_slice(&(length as u16).to_le_bytes());
    bytes.extend_from_slice(header.as_bytes());
    bytes.resize(before + length - 1, b' ');
    bytes.push(b'\n');
    bytes
}

/// Adds the numbers of a row, little-endian.
pub fn push_row(out: &mut Vec<u8>, row: &[f64]) {
    out.extend(row.iter().flat_map(|value| value.to_le_bytes()));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bytes_are_those_that_numpy_writes() {
        // numpy.save of [[1.0, -2.5]], NumPy 2.1.
        let mut bytes = head(1, 2);
        push_row(&mut bytes, &[1.0, -2.5]);
        let mut expected =
            b"\x93NUMPY\x01\x00\x76\x00{'descr': '<f8', 'fortran_order': False, 'shape': (1, 2), }"
                .to_vec();
        expected.resize(127, b' ');
        expected.push(b'\n');
        expected.extend_from_slice(&[0, 0, 0, 0, 0, 0, 0xf0, 0x3f, 0, 0, 0, 0, 0, 0, 4, 0xc0]);
        assert_eq!(bytes, expected);
    }
}
