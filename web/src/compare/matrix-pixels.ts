/** A picture of distances and the positions under the pixels in; the pixels of the matrix out. */
import type { MatrixPicture, MatrixRegion } from '../engine/comparison-types';
import type { ColourScale } from './colour-scale';

/** A picture and the part of the matrix that it shows. */
export interface PlacedPicture {
  readonly region: MatrixRegion;
  readonly picture: MatrixPicture;
}

/** The colour of every value, once for as long as scale and picture last. */
export const colourPicture = ({ values }: MatrixPicture, scale: ColourScale): Uint32Array =>
  scale.pixelsOf(values);

/** Whether every value is one distance, not the mean of many. */
export const isExact = ({ region, picture }: PlacedPicture): boolean =>
  picture.rows === region.rowCount && picture.columns === region.columnCount;

/** Rows or columns of the picture under the pixels; −1 where it has nothing to show. */
function binsOf(positions: Int32Array, first: number, count: number, bins: number): Int32Array {
  return positions.map((position) => {
    const within = position - first;
    return position < 0 || within < 0 || within >= count ? -1 : Math.floor((within * bins) / count);
  });
}

export interface Painting {
  readonly placed: PlacedPicture;
  readonly colours: Uint32Array;
  /** Positions under the rows and the columns of pixels. */
  readonly rows: Int32Array;
  readonly columns: Int32Array;
  readonly background: number;
}

/** Paints columns × rows pixels, row by row; gaps, the diagonal and what is not known stay background. */
export function paintMatrix(out: Uint32Array, painting: Painting): void {
  const { placed, colours, rows, columns, background } = painting;
  const { region, picture } = placed;
  const exact = isExact(placed);
  const rowBins = binsOf(rows, region.firstRow, region.rowCount, picture.rows);
  const { firstColumn, columnCount } = region;
  const columnBins = binsOf(columns, firstColumn, columnCount, picture.columns);
  const width = columns.length;
  for (let y = 0; y < rows.length; y += 1) {
    const start = y * width;
    if (y > 0 && rows[y] === rows[y - 1]) {
      out.copyWithin(start, start - width, start);
      continue;
    }
    const base = rowBins[y] * picture.columns;
    for (let x = 0; x < width; x += 1) {
      const hidden = base < 0 || columnBins[x] < 0 || (exact && rows[y] === columns[x]);
      out[start + x] = hidden ? background : colours[base + columnBins[x]];
    }
  }
}
