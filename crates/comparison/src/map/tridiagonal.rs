//! Eigenvalues of a symmetric tridiagonal matrix: diagonal and couplings in, eigenvalues with their
//! vectors out.
//!
//! QL with implicit shifts (Martin and Wilkinson 1968; Bowdler, Martin, Reinsch and Wilkinson 1968).

/// Turns until one eigenvalue stands alone; three are usual.
const MOST_SWEEPS: usize = 60;

/// A matrix that grows by a row and a column at a time.
#[derive(Clone, Debug, Default)]
pub struct Tridiagonal {
    diagonal: Vec<f64>,
    /// Between each row and the next.
    couplings: Vec<f64>,
}

impl Tridiagonal {
    /// Adds a row with its coupling to the one before, which the first has none of.
    pub fn push(&mut self, diagonal: f64, coupling: f64) {
        if !self.diagonal.is_empty() {
            self.couplings.push(coupling);
        }
        self.diagonal.push(diagonal);
    }
}

/// The eigenvalues of a matrix with their unit vectors, one after another.
pub struct EigenSteps {
    turning: Turning,
    /// Rows that stand alone.
    rows: usize,
}

impl EigenSteps {
    /// Nothing found yet.
    pub fn new(matrix: &Tridiagonal) -> Self {
        Self {
            turning: Turning::new(matrix),
            rows: 0,
        }
    }

    /// Finds the next eigenvalue; false if there is none.
    pub fn step(&mut self) -> bool {
        let row = self.rows;
        if row == self.turning.diagonal.len() {
            return false;
        }
        let _ = (0..MOST_SWEEPS).any(|_| self.turning.sweep(row));
        self.rows += 1;
        true
    }

    /// What is found, the largest first.
    pub fn finish(self) -> Vec<(f64, Vec<f64>)> {
        let Turning {
            diagonal, vectors, ..
        } = self.turning;
        let mut eigen: Vec<_> = diagonal.into_iter().zip(vectors).collect();
        eigen.sort_by(|one, other| other.0.total_cmp(&one.0));
        eigen
    }
}

/// The matrix while it becomes diagonal.
struct Turning {
    diagonal: Vec<f64>,
    /// One more than there are, the last 0.
    couplings: Vec<f64>,
    /// What has been turned, a row an eigenvalue.
    vectors: Vec<Vec<f64>>,
    /// A coupling below this is 0.
    rounding: f64,
}

impl Turning {
    fn new(matrix: &Tridiagonal) -> Self {
        let size = matrix.diagonal.len();
        let numbers = matrix.diagonal.iter().chain(&matrix.couplings);
        let largest = numbers.fold(0.0_f64, |largest, value| largest.max(value.abs()));
        let unit = |row: usize| {
            let mut vector = vec![0.0; size];
            vector[row] = 1.0;
            vector
        };
        let mut couplings = matrix.couplings.clone();
        couplings.push(0.0);
        Self {
            diagonal: matrix.diagonal.clone(),
            couplings,
            vectors: (0..size).map(unit).collect(),
            rounding: f64::EPSILON * largest / 2.0,
        }
    }

    /// One turn of the block that begins at `first`; true if that row stands alone already.
    fn sweep(&mut self, first: usize) -> bool {
        let last_row = self.diagonal.len() - 1;
        let stands_alone = |row: &usize| self.couplings[*row].abs() <= self.rounding;
        let last = (first..last_row).find(stands_alone).unwrap_or(last_row);
        if last == first {
            return true;
        }
        let (diagonal, couplings) = (&mut self.diagonal, &mut self.couplings);
        let half = (diagonal[first + 1] - diagonal[first]) / (2.0 * couplings[first]);
        let root = (half * half + 1.0).sqrt().copysign(half);
        let mut beyond = diagonal[last] - diagonal[first] + couplings[first] / (half + root);
        let (mut sine, mut cosine, mut shift) = (1.0, 1.0, 0.0);
        for row in (first..last).rev() {
            let (across, along) = (sine * couplings[row], cosine * couplings[row]);
            let length = (across * across + beyond * beyond).sqrt();
            couplings[row + 1] = length;
            if length == 0.0 {
                diagonal[row + 1] -= shift;
                couplings[last] = 0.0;
                return false;
            }
            (sine, cosine) = (across / length, beyond / length);
            beyond = diagonal[row + 1] - shift;
            let moved = (diagonal[row] - beyond) * sine + 2.0 * cosine * along;
            shift = sine * moved;
            diagonal[row + 1] = beyond + shift;
            beyond = cosine * moved - along;
            turn(&mut self.vectors[row..row + 2], sine, cosine);
        }
        diagonal[first] -= shift;
        couplings[first] = beyond;
        couplings[last] = 0.0;
        false
    }
}

/// Turns two vectors in their plane.
fn turn(pair: &mut [Vec<f64>], sine: f64, cosine: f64) {
    let [one, other] = pair else { return };
    for (one, other) in one.iter_mut().zip(other) {
        let before = *other;
        *other = sine * *one + cosine * before;
        *one = cosine * *one - sine * before;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use test_support::Random;

    fn eigen(matrix: &Tridiagonal) -> Vec<(f64, Vec<f64>)> {
        let mut steps = EigenSteps::new(matrix);
        while steps.step() {}
        steps.finish()
    }

    #[test]
    fn values_and_vectors_satisfy_their_definition() {
        let mut random = Random::new(11);
        let mut matrix = Tridiagonal::default();
        for row in 0..40 {
            let coupling = if row % 9 == 4 {
                0.0
            } else {
                random.unit() - 0.5
            };
            matrix.push(random.unit() - 0.5, coupling);
        }
        let eigen = eigen(&matrix);
        assert!(eigen.is_sorted_by(|one, other| one.0 >= other.0));
        for (value, vector) in &eigen {
            for row in 0..40 {
                let mut product = matrix.diagonal[row] * vector[row];
                if row > 0 {
                    product += matrix.couplings[row - 1] * vector[row - 1];
                }
                if row < 39 {
                    product += matrix.couplings[row] * vector[row + 1];
                }
                assert!((product - value * vector[row]).abs() < 1e-14);
            }
            let length: f64 = vector.iter().map(|value| value * value).sum();
            assert!((length - 1.0).abs() < 1e-13);
        }
    }

    #[test]
    fn the_second_difference_has_its_known_values() {
        let mut matrix = Tridiagonal::default();
        for _ in 0..20 {
            matrix.push(2.0, -1.0);
        }
        for (place, (value, _)) in eigen(&matrix).iter().enumerate() {
            let angle = core::f64::consts::PI * (20 - place) as f64 / 21.0;
            let expected = 2.0 - 2.0 * libm::cos(angle);
            assert!((value - expected).abs() < 1e-14, "{value} {expected}");
        }
    }
}
