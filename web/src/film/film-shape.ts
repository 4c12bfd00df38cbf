/** What can be chosen about a film: its size and its rate. */

export interface FilmShape {
  /** Pixels. */
  readonly width: number;
  readonly height: number;
  readonly rate_hz: number;
}

export const filmHeights = [720, 1080] as const;
export const filmRates_hz = [25, 30, 60] as const;
/** Room for a pair side by side. */
const ASPECT = 16 / 9;

export const filmShape = (height: number, rate_hz: number): FilmShape => ({
  width: Math.round(height * ASPECT),
  height,
  rate_hz,
});
