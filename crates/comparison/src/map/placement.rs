//! A new item on a map: its distances to the items there in, its place out.
//!
//! Gower 1968, "Adding a point to vector diagrams in multivariate analysis": `½ (XᵀX)⁻¹ Xᵀ (q − d²)`, X
//! the places from their middle, q the items' squared distances from the middle in all dimensions, d the
//! distances of the new one.

use super::alignment::{middle, minus};
use super::{Map, Place};

/// Below this part of the spread an axis has none.
const NO_SPREAD: f64 = 1e-12;

/// Where an item lies that has these distances to the items of the map, which stay where they are, in
/// their order. On an axis along which they do not differ it lies in their middle.
#[must_use]
pub fn gower_place(map: &Map, distances: &[f64]) -> Place {
    let middle = middle(&map.places);
    let (mut squares, mut sums) = ([0.0; 3], [0.0; 2]);
    let items = map.places.iter().zip(&map.squares_from_middle);
    for ((place, square), distance) in items.zip(distances) {
        let [x, y] = minus(*place, middle);
        let from = (square - distance * distance) / 2.0;
        squares = [squares[0] + x * x, squares[1] + x * y, squares[2] + y * y];
        sums = [sums[0] + x * from, sums[1] + y * from];
    }
    let [x, y] = solve(squares, sums);
    [middle[0] + x, middle[1] + y]
}

/// The shortest solution of `[[xx, xy], [xy, yy]] · place = sums`.
fn solve([xx, xy, yy]: [f64; 3], [x, y]: Place) -> Place {
    let (size, determinant) = (xx + yy, xx * yy - xy * xy);
    if determinant > NO_SPREAD * size * size {
        return [
            (yy * x - xy * y) / determinant,
            (xx * y - xy * x) / determinant,
        ];
    }
    match size > 0.0 {
        true => [
            (xx * x + xy * y) / size / size,
            (xy * x + yy * y) / size / size,
        ],
        false => [0.0; 2],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::condensed::Condensed;
    use crate::map::{of_matrix, procrustes};

    const POINTS: [Place; 5] = [[0.0, 0.0], [2.0, 0.0], [0.0, 1.0], [3.0, 3.0], [-1.0, 2.0]];

    fn distance(one: Place, other: Place) -> f64 {
        let [x, y] = minus(one, other);
        (x * x + y * y).sqrt()
    }

    #[test]
    fn a_point_of_the_plane_comes_to_its_place() {
        let matrix = Condensed::from_fn(5, |one, other| distance(POINTS[one], POINTS[other]));
        let known: Vec<(usize, Place)> = POINTS.into_iter().enumerate().collect();
        let map = procrustes(&of_matrix(&matrix), &known);
        for new in [[1.0, 1.0], [-4.0, 7.0], POINTS[3]] {
            let found = gower_place(&map, &POINTS.map(|point| distance(point, new)));
            assert!(distance(found, new) < 1e-13, "{found:?} {new:?}");
        }
    }

    #[test]
    fn a_point_beside_a_line_comes_to_its_foot() {
        let line: [Place; 3] = [[0.0, 0.0], [0.6, 0.8], [1.8, 2.4]];
        let map = Map {
            places: line.to_vec(),
            spread: 1.0,
            squares_from_middle: line
                .map(|place| distance(place, middle(&line)))
                .map(|d| d * d)
                .to_vec(),
        };
        let beside = [0.6 - 0.8, 0.8 + 0.6];
        let found = gower_place(&map, &line.map(|place| distance(place, beside)));
        assert!(distance(found, line[1]) < 1e-14, "{found:?}");
    }

    #[test]
    fn an_empty_map_and_a_map_of_one() {
        let mut map = Map {
            places: Vec::new(),
            spread: 1.0,
            squares_from_middle: Vec::new(),
        };
        assert_eq!(gower_place(&map, &[]), [0.0; 2]);
        map.places.push([1.0, 2.0]);
        map.squares_from_middle.push(0.0);
        assert_eq!(gower_place(&map, &[5.0]), [1.0, 2.0]);
    }
}
