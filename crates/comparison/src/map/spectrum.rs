//! Leading eigenvectors of a symmetric matrix: its product with a vector in, eigenvalues and two axes
//! out.
//!
//! Lanczos' method (1950) from a fixed start, each new vector made orthogonal to all before, twice. With
//! as many steps as the matrix has rows every eigenvalue is found, whatever their multiplicity: where
//! the vectors so far span an invariant space, the method goes on from a vector outside it.

use std::mem;

use super::tridiagonal::{EigenSteps, Tridiagonal};

/// Below this part of the matrix' size a vector is only rounding.
const ROUNDING: f64 = 1e-13;

/// The residual, as a part of the largest eigenvalue, at which an axis is found.
const CONVERGED: f64 = 1e-13;

/// Steps between two looks at what is found.
const STEPS_A_LOOK: usize = 10;

/// What is known of the eigenvalues.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Spectrum {
    /// All eigenvalues if there were as many steps as rows, else approximations of those at the ends,
    /// in descending order.
    pub values: Vec<f64>,
    /// The unit eigenvectors of the two largest; zeros where there are not so many.
    pub axes: [Vec<f64>; 2],
}

/// The spectrum of the matrix of `size` rows that `apply` multiplies a vector (first argument) by: all of
/// it if `most_steps` products are enough for that, else the leading part.
pub fn spectrum(
    size: usize,
    most_steps: usize,
    mut apply: impl FnMut(&[f64], &mut [f64]),
) -> Spectrum {
    let mut steps = SpectrumSteps::new(size, most_steps);
    loop {
        if let Some(vector) = steps.wanted() {
            let mut product = vec![0.0; size];
            apply(vector, &mut product);
            steps.take(product);
        } else if steps.look() {
            return steps.finish();
        }
    }
}

/// [`spectrum`] in pieces: whoever drives it multiplies.
pub struct SpectrumSteps {
    size: usize,
    /// Products at most.
    most: usize,
    /// Orthogonal unit vectors.
    basis: Vec<Vec<f64>>,
    /// The next one, and how large it was.
    next: Option<(Vec<f64>, f64)>,
    tridiagonal: Tridiagonal,
    start: Start,
    /// The largest number of the tridiagonal matrix.
    scale: f64,
    state: State,
}

/// What it waits for.
enum State {
    /// The product of a vector, which couples so much with the one before.
    Multiplying(Vec<f64>, f64),
    /// The eigenvalues so far, or of all.
    Looking(EigenSteps, IsLast),
    Found(Spectrum),
}

/// Whether there are no more products to be taken.
type IsLast = bool;

impl Default for State {
    fn default() -> Self {
        State::Found(Spectrum::default())
    }
}

impl SpectrumSteps {
    /// Nothing known yet.
    pub fn new(size: usize, most_steps: usize) -> Self {
        let mut steps = Self {
            size,
            most: most_steps.min(size),
            basis: Vec::new(),
            next: None,
            tridiagonal: Tridiagonal::default(),
            start: Start::default(),
            scale: 0.0,
            state: State::default(),
        };
        steps.go_on();
        steps
    }

    /// The vector whose product is to be taken; none while eigenvalues are looked for.
    pub fn wanted(&self) -> Option<&[f64]> {
        match &self.state {
            State::Multiplying(vector, _) => Some(vector),
            _ => None,
        }
    }

    /// Products taken.
    pub fn products(&self) -> usize {
        self.basis.len()
    }

    /// Takes the product of the vector that was wanted, and adds that vector to the basis.
    pub fn take(&mut self, mut product: Vec<f64>) {
        let State::Multiplying(vector, coupling) = mem::take(&mut self.state) else {
            return;
        };
        let diagonal = dot(&product, &vector);
        self.tridiagonal.push(diagonal, coupling);
        self.basis.push(vector);
        self.scale = self.scale.max(diagonal.abs()).max(coupling);
        self.make_orthogonal(&mut product);
        let length = dot(&product, &product).sqrt();
        self.scale = self.scale.max(length);
        if length > ROUNDING * self.scale {
            divide(&mut product, length);
            self.next = Some((product, length));
        }
        let is_time = self.most < self.size && self.basis.len().is_multiple_of(STEPS_A_LOOK);
        match is_time && self.next.is_some() {
            true => self.state = State::Looking(EigenSteps::new(&self.tridiagonal), false),
            false => self.go_on(),
        }
    }

    /// Looks for one more eigenvalue. True once the spectrum is found.
    pub fn look(&mut self) -> bool {
        let State::Looking(steps, _) = &mut self.state else {
            return matches!(self.state, State::Found(_));
        };
        if steps.step() {
            return false;
        }
        if let State::Looking(steps, is_last) = mem::take(&mut self.state) {
            let eigen = steps.finish();
            match is_last || self.has_converged(&eigen) {
                true => self.state = State::Found(self.found(&eigen)),
                false => self.go_on(),
            }
        }
        matches!(self.state, State::Found(_))
    }

    /// The spectrum, once it is found.
    pub fn finish(self) -> Spectrum {
        match self.state {
            State::Found(spectrum) => spectrum,
            _ => Spectrum::default(),
        }
    }

    /// Waits for the product of the next vector, or looks for the last time.
    fn go_on(&mut self) {
        let is_last = self.basis.len() == self.most;
        let next = match is_last {
            true => None,
            false => self.next.take().or_else(|| self.outside()),
        };
        self.state = match next {
            Some((vector, coupling)) => State::Multiplying(vector, coupling),
            None => State::Looking(EigenSteps::new(&self.tridiagonal), true),
        };
    }

    /// A unit vector outside the space of the basis, with its coupling of 0; none if that is all.
    fn outside(&mut self) -> Option<(Vec<f64>, f64)> {
        while self.basis.len() < self.size {
            let mut vector: Vec<f64> = (0..self.size).map(|_| self.start.next()).collect();
            let before = dot(&vector, &vector).sqrt();
            self.make_orthogonal(&mut vector);
            let length = dot(&vector, &vector).sqrt();
            if length > 1e-6 * before {
                divide(&mut vector, length);
                // Once more, for what the division has made larger.
                self.make_orthogonal(&mut vector);
                return Some((vector, 0.0));
            }
        }
        None
    }

    fn make_orthogonal(&self, vector: &mut [f64]) {
        for _ in 0..2 {
            for axis in &self.basis {
                let along = dot(axis, vector);
                for (value, axis) in vector.iter_mut().zip(axis) {
                    *value -= along * axis;
                }
            }
        }
    }

    /// Whether the two largest would not change with more steps.
    fn has_converged(&self, eigen: &[(f64, Vec<f64>)]) -> bool {
        let (Some((_, coupling)), Some((largest, _))) = (&self.next, eigen.first()) else {
            return false;
        };
        let is_found = |(_, vector): &(f64, Vec<f64>)| {
            let residual = vector.last().map_or(0.0, |last| last.abs() * coupling);
            residual <= CONVERGED * largest.abs()
        };
        eigen.iter().take(2).all(is_found)
    }

    fn found(&self, eigen: &[(f64, Vec<f64>)]) -> Spectrum {
        let axis = |index: usize| {
            let mut axis = vec![0.0; self.size];
            let weights = eigen.get(index).map_or(&[][..], |(_, vector)| vector);
            for (weight, vector) in weights.iter().zip(&self.basis) {
                for (sum, value) in axis.iter_mut().zip(vector) {
                    *sum += weight * value;
                }
            }
            axis
        };
        Spectrum {
            values: eigen.iter().map(|(value, _)| *value).collect(),
            axes: [axis(0), axis(1)],
        }
    }
}

/// Numbers from −1 to 1 without a pattern, the same ones every time (xorshift64).
struct Start(u64);

impl Default for Start {
    fn default() -> Self {
        Start(0x9E37_79B9_7F4A_7C15)
    }
}

impl Start {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

fn divide(vector: &mut [f64], length: f64) {
    for value in vector {
        *value /= length;
    }
}

/// In four lanes, added in their order.
fn dot(one: &[f64], other: &[f64]) -> f64 {
    let mut lanes = [0.0; 4];
    let (ones, one_rest) = one.as_chunks::<4>();
    let (others, other_rest) = other.as_chunks::<4>();
    for (one, other) in ones.iter().zip(others) {
        for lane in 0..4 {
            lanes[lane] += one[lane] * other[lane];
        }
    }
    let rest = one_rest.iter().zip(other_rest);
    let rest = rest.fold(0.0, |sum, (one, other)| sum + one * other);
    lanes[0] + lanes[1] + lanes[2] + lanes[3] + rest
}

#[cfg(test)]
mod tests;
