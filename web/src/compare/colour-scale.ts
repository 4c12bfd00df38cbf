/** The stops of the theme and a largest distance in; the colour of any distance out, on a square-root scale. */
export type Rgb = readonly [red: number, green: number, blue: number];
type Lab = readonly [number, number, number];

const steps = 1024;

/** `#rrggbb` as three numbers from 0 to 255. */
export function rgbOf(hex: string): Rgb {
  const value = Number.parseInt(hex.slice(1), 16);
  return [(value >> 16) & 255, (value >> 8) & 255, value & 255];
}

const linear = (byte: number): number =>
  byte <= 10.31475 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4;

const byteOf = (value: number): number => {
  const bent = value <= 0.0031308 ? value * 12.92 : 1.055 * value ** (1 / 2.4) - 0.055;
  return Math.round(255 * Math.min(1, Math.max(0, bent)));
};

/** Björn Ottosson's OKLab (2020), from sRGB. */
function labOf([red, green, blue]: Rgb): Lab {
  const [r, g, b] = [linear(red), linear(green), linear(blue)];
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}

function rgbOfLab([light, a, b]: Lab): Rgb {
  const l = (light + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (light - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (light - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    byteOf(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
    byteOf(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
    byteOf(-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s),
  ];
}

/** A colour as a pixel of image data, on the little-endian machines that browsers run on. */
export const pixelOf = ([red, green, blue]: Rgb): number =>
  ((255 << 24) | (blue << 16) | (green << 8) | red) >>> 0;

export class ColourScale {
  /** Pixels from 0 to the maximum, even in the square root of the distance. */
  readonly pixels: Uint32Array;
  /** Steps of the square root of a distance. */
  private readonly stepsOfRoot: number;

  constructor(stops: readonly string[], maximum: number) {
    this.stepsOfRoot = maximum > 0 ? (steps - 1) / Math.sqrt(maximum) : 0;
    const labs = stops.map((stop) => labOf(rgbOf(stop)));
    this.pixels = Uint32Array.from({ length: steps }, (_, step) =>
      pixelOf(between(labs, step / (steps - 1))),
    );
  }

  pixel(distance: number): number {
    const place = Math.round(Math.sqrt(Math.max(0, distance)) * this.stepsOfRoot);
    return this.pixels[Math.min(steps - 1, place)];
  }

  /** Those of many distances from 0 up: a million of them have one frame. */
  pixelsOf(distances: Float32Array): Uint32Array {
    const { pixels, stepsOfRoot } = this;
    const found = new Uint32Array(distances.length);
    for (let k = 0; k < distances.length; k += 1) {
      const place = (Math.sqrt(distances[k]) * stepsOfRoot + 0.5) | 0;
      found[k] = pixels[place < steps ? place : steps - 1];
    }
    return found;
  }

  /** The same as `#rrggbb`. */
  css(distance: number): string {
    const pixel = this.pixel(distance);
    const bytes = [pixel & 255, (pixel >> 8) & 255, (pixel >> 16) & 255];
    return `#${bytes.map((byte) => byte.toString(16).padStart(2, '0')).join('')}`;
  }
}

function between(labs: readonly Lab[], part: number): Rgb {
  const place = part * (labs.length - 1);
  const index = Math.min(labs.length - 2, Math.floor(place));
  const rest = place - index;
  const [from, to] = [labs[index], labs[index + 1]];
  return rgbOfLab([0, 1, 2].map((k) => from[k] * (1 - rest) + to[k] * rest) as unknown as Lab);
}
