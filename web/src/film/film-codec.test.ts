import { afterEach, expect, test, vi } from 'vitest';
import { chooseCodec, filmCodecs } from './film-codec';
import { filmShape } from './film-shape';

const codecOf = (height: number, rate_hz: number): string =>
  filmCodecs(filmShape(height, rate_hz))[0].config.codec;

test('a film is as wide as it is high in 16 : 9, even in pixels', () => {
  expect(filmShape(720, 30)).toEqual({ width: 1280, height: 720, rate_hz: 30 });
  expect(filmShape(1080, 60)).toEqual({ width: 1920, height: 1080, rate_hz: 60 });
});

test('the level of VP9 is the lowest that holds the film', () => {
  expect(codecOf(720, 30)).toBe('vp09.00.31.08');
  expect(codecOf(720, 60)).toBe('vp09.00.40.08');
  expect(codecOf(1080, 30)).toBe('vp09.00.40.08');
  expect(codecOf(1080, 60)).toBe('vp09.00.41.08');
});

test('every picture is to be as good as the others; else so many bits; VP8 stands in for VP9', () => {
  const kinds = filmCodecs(filmShape(720, 25)).map(({ webm, config }) => [
    webm,
    config.codec,
    config.bitrateMode,
  ]);
  expect(kinds).toEqual([
    ['V_VP9', 'vp09.00.31.08', 'quantizer'],
    ['V_VP9', 'vp09.00.31.08', 'variable'],
    ['V_VP8', 'vp8', 'variable'],
  ]);
});

afterEach(() => vi.unstubAllGlobals());

test('the player is asked before the encoder; a kind of encoding that a browser does not know is skipped', async () => {
  const asked: string[] = [];
  const canPlayType = (): string => {
    asked.push('player');
    return '';
  };
  vi.stubGlobal('document', { createElement: () => ({ canPlayType }) });
  vi.stubGlobal('VideoEncoder', {
    isConfigSupported: ({ bitrateMode }: VideoEncoderConfig) => {
      asked.push(String(bitrateMode));
      return bitrateMode === 'quantizer'
        ? Promise.reject(new TypeError('unknown'))
        : Promise.resolve({ supported: true });
    },
  });
  expect((await chooseCodec(filmShape(720, 30)))?.config.bitrateMode).toBe('variable');
  expect(asked).toEqual(['player', 'quantizer', 'variable']);
});
