//! A part of the matrix as a picture: distances and an order of the items go in, mean distances pixel
//! by pixel come out. Every cell counts, also where ten thousand items make a picture of a thousand
//! pixels: rows of cells are computed four at a time and summed into the pixels they belong to.

use crate::distances::{Columns, Distances};

/// Which cells are pictured.
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    /// Items from top to bottom.
    pub rows: Vec<usize>,
    /// Items from left to right.
    pub columns: Vec<usize>,
    /// At most so many rows and columns of the picture.
    pub most: usize,
}

/// Mean distances, row by row.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Picture {
    /// Pixels from top to bottom.
    pub rows: usize,
    /// Pixels from left to right.
    pub columns: usize,
    /// rows × columns.
    pub values: Vec<f32>,
}

/// [`Picture`] in pieces.
#[derive(Clone, Debug)]
pub struct PictureRun {
    region: Region,
    columns: Columns,
    /// Rows and columns are the same items: the picture is its own mirror image.
    is_symmetric: bool,
    picture: Picture,
    row: usize,
}

impl PictureRun {
    /// Makes ready to picture a region, all of whose items are in the distances.
    pub fn new(distances: &Distances, region: Region) -> Self {
        let most = region.most.max(1);
        let (rows, columns) = (region.rows.len().min(most), region.columns.len().min(most));
        Self {
            columns: distances.columns(&region.columns),
            is_symmetric: region.rows == region.columns,
            picture: Picture {
                rows,
                columns,
                values: vec![0.0; rows * columns],
            },
            region,
            row: 0,
        }
    }

    /// Pictures about `cells` cells more, at least one row of pixels. Returns the part done.
    pub fn step(&mut self, distances: &Distances, cells: usize) -> f64 {
        let mut left = cells.max(1);
        while self.row < self.picture.rows && left > 0 {
            left = left.saturating_sub(self.picture_row(distances));
            self.row += 1;
        }
        match self.picture.rows {
            0 => 1.0,
            rows => self.row as f64 / rows as f64,
        }
    }

    /// The picture.
    pub fn finish(self) -> Picture {
        self.picture
    }

    /// Makes one row of pixels. Returns how many cells it took.
    fn picture_row(&mut self, distances: &Distances) -> usize {
        let (rows, columns) = (self.picture.rows, self.picture.columns);
        let first_column = if self.is_symmetric { self.row } else { 0 };
        let from = edge(first_column, columns, self.region.columns.len());
        let cells = edge(self.row, rows, self.region.rows.len())
            ..edge(self.row + 1, rows, self.region.rows.len());
        let height = cells.len();
        let mut sums = vec![0.0; columns];
        let mut line = vec![0.0; self.region.columns.len() - from];
        for cell in cells {
            let item = self.region.rows[cell];
            self.columns.distances(distances, item, from, &mut line);
            for (column, sum) in sums.iter_mut().enumerate().skip(first_column) {
                let start = edge(column, columns, self.region.columns.len()) - from;
                let end = edge(column + 1, columns, self.region.columns.len()) - from;
                *sum += line[start..end].iter().sum::<f64>();
            }
        }
        for (column, sum) in sums.iter().enumerate().skip(first_column) {
            let width = edge(column + 1, columns, self.region.columns.len())
                - edge(column, columns, self.region.columns.len());
            self.set(column, (sum / (height * width) as f64) as f32);
        }
        height * line.len()
    }

    fn set(&mut self, column: usize, mean: f32) {
        let columns = self.picture.columns;
        self.picture.values[self.row * columns + column] = mean;
        if self.is_symmetric {
            self.picture.values[column * columns + self.row] = mean;
        }
    }
}

/// Where the cells of a pixel begin.
fn edge(pixel: usize, pixels: usize, cells: usize) -> usize {
    pixel * cells / pixels.max(1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::feature::Vector;

    fn distances(items: usize) -> Distances {
        let vector = |item: usize| -> Vector {
            std::array::from_fn(|index| libm::sin((item * 31 + index * 7) as f64))
        };
        Distances::of_vectors((0..items).map(vector).collect(), false)
    }

    fn picture(distances: &Distances, region: Region) -> Picture {
        let mut run = PictureRun::new(distances, region);
        while run.step(distances, 10) < 1.0 {}
        run.finish()
    }

    /// The mean of the cells of each pixel, one by one.
    fn plain(distances: &Distances, region: &Region, rows: usize, columns: usize) -> Vec<f64> {
        let (height, width) = (region.rows.len(), region.columns.len());
        let mut values = Vec::new();
        for pixel in 0..rows * columns {
            let (row, column) = (pixel / columns, pixel % columns);
            let of_row = &region.rows[row * height / rows..(row + 1) * height / rows];
            let of_column =
                &region.columns[column * width / columns..(column + 1) * width / columns];
            let cells = of_row
                .iter()
                .flat_map(|a| of_column.iter().map(|b| distances.at(*a, *b)));
            values.push(cells.sum::<f64>() / (of_row.len() * of_column.len()) as f64);
        }
        values
    }

    #[test]
    fn a_pixel_is_the_mean_of_its_cells() {
        let distances = distances(23);
        let turned: Vec<usize> = (0..23).map(|index| index * 7 % 23).collect();
        for (rows, columns) in [(&turned[..], &turned[..]), (&turned[3..17], &turned[8..])] {
            for most in [1, 5, 10, 64] {
                let region = Region {
                    rows: rows.to_vec(),
                    columns: columns.to_vec(),
                    most,
                };
                let found = picture(&distances, region.clone());
                assert_eq!(
                    (found.rows, found.columns),
                    (rows.len().min(most), columns.len().min(most))
                );
                let expected = plain(&distances, &region, found.rows, found.columns);
                for (value, expected) in found.values.iter().zip(expected) {
                    assert!((f64::from(*value) - expected).abs() < 1e-6);
                }
            }
        }
    }

    #[test]
    fn an_empty_region_is_an_empty_picture() {
        let region = Region {
            rows: Vec::new(),
            columns: vec![0],
            most: 4,
        };
        assert!(picture(&distances(2), region).values.is_empty());
    }
}
