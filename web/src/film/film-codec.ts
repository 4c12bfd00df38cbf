/**
 * The shape of a film in; how this browser encodes it out. VP9, or VP8 where there is no VP9; every picture as
 * good as the others where the browser can do that, else so many bits.
 */
import type { FilmShape } from './film-shape';
import type { WebmTrack } from './webm';

export interface FilmCodec {
  readonly webm: WebmTrack['codec'];
  readonly config: VideoEncoderConfig;
  /** For every picture. */
  readonly options: VideoEncoderEncodeOptions & { readonly vp9?: { readonly quantizer: number } };
}

/** Of 0 to 63, the coarsest: letters stay crisp, grounds without bands. */
const QUANTIZER = 30;

/** What a film may take, not what it takes: with a third of it WebKitGTK blurs the grid and the ghosts. */
const BITS_PER_PIXEL = 0.5;

/** Levels of VP9: how many pixels a second, how many a picture. */
const LEVELS: readonly (readonly [name: string, perSecond: number, perPicture: number])[] = [
  ['30', 20_736_000, 552_960],
  ['31', 36_864_000, 983_040],
  ['40', 83_558_400, 2_228_224],
  ['41', 160_432_128, 2_228_224],
  ['50', 311_951_360, 8_912_896],
];

function vp9({ width, height, rate_hz }: FilmShape): string {
  const pixels = width * height;
  const fits = LEVELS.find(([, most, large]) => pixels * rate_hz <= most && pixels <= large);
  return `vp09.00.${(fits ?? LEVELS[LEVELS.length - 1])[0]}.08`;
}

/** The better first. */
export function filmCodecs(shape: FilmShape): FilmCodec[] {
  const { width, height, rate_hz } = shape;
  const picture = {
    width,
    height,
    framerate: rate_hz,
    latencyMode: 'quality',
    alpha: 'discard',
  } as const;
  const bitrate = Math.round(width * height * rate_hz * BITS_PER_PIXEL);
  const byBits = (codec: string) =>
    ({ codec, ...picture, bitrateMode: 'variable', bitrate }) as const;
  const codec = vp9(shape);
  return [
    {
      webm: 'V_VP9',
      config: { codec, ...picture, bitrateMode: 'quantizer' },
      options: { vp9: { quantizer: QUANTIZER } },
    },
    { webm: 'V_VP9', config: byBits(codec), options: {} },
    { webm: 'V_VP8', config: byBits('vp8'), options: {} },
  ];
}

/** The browser has an encoder at all. */
export const hasEncoder = (): boolean =>
  typeof VideoEncoder === 'function' && typeof VideoFrame === 'function';

/** null: it encodes no film of this shape. */
export async function chooseCodec(shape: FilmShape): Promise<FilmCodec | null> {
  // WebKitGTK sets up its media library for a player only: an encoder that is asked before ends the page.
  document.createElement('video').canPlayType('video/webm');
  for (const codec of filmCodecs(shape)) {
    const { supported } = await VideoEncoder.isConfigSupported(codec.config).catch(() => ({
      supported: false,
    }));
    if (supported) return codec;
  }
  return null;
}
