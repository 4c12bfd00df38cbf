/** A stretch of a clock and a rate in; which moment each picture of a film shows out. Pure. */

export interface FilmStretch {
  /** Seconds of the clock. */
  readonly fromS: number;
  readonly toS: number;
  /** Seconds of the clock in one second of the film. */
  readonly speed: number;
}

export interface FilmTimes {
  /** Pictures, at least one. */
  readonly count: number;
  readonly lengthS: number;
  /** The moment of a picture, in seconds of the clock. */
  readonly momentS: (picture: number) => number;
}

/** What rounding may take from a whole number of pictures. */
const ALMOST = 1e-6;

/** Picture n shows the moment n / rate after the first; those until the last moment belong to the film. */
export function filmTimes({ fromS, toS, speed }: FilmStretch, rate_hz: number): FilmTimes {
  const spanS = Math.max(0, toS - fromS) / speed;
  const count = Math.floor(spanS * rate_hz + ALMOST) + 1;
  return {
    count,
    lengthS: count / rate_hz,
    momentS: (picture) => Math.min(fromS + (picture * speed) / rate_hz, toS),
  };
}
