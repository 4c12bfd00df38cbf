import { expect, test } from 'vitest';
import { filmShape } from './film-shape';
import { filmSheet } from './film-sheet';

test('two stages share the width, over a bar with both captions', () => {
  const { panes, captions, ratio } = filmSheet(filmShape(720, 30), 2, 2);
  expect(ratio).toBe(1);
  expect(panes).toEqual([
    { x: 0, y: 0, width: 639, height: 660 },
    { x: 641, y: 0, width: 639, height: 660 },
  ]);
  expect(captions.map(({ x, y, width }) => [x, y, width])).toEqual([
    [0, 660, 640],
    [640, 660, 640],
  ]);
});

test('a larger film is the same in more pixels', () => {
  const { panes, captions, ratio } = filmSheet(filmShape(1080, 30), 2, 2);
  expect(ratio).toBe(1.5);
  expect(panes.map(({ x, width, height }) => [x, width, height])).toEqual([
    [0, 958, 990],
    [962, 958, 990],
  ]);
  expect(captions).toEqual(filmSheet(filmShape(720, 30), 2, 2).captions);
});

test('one stage fills the width; more than four captions take a second row', () => {
  const { panes, captions, barY } = filmSheet(filmShape(720, 30), 1, 6);
  expect(barY).toBe(600);
  expect(panes).toEqual([{ x: 0, y: 0, width: 1280, height: 600 }]);
  expect(captions.map(({ x, y }) => [x, y])).toEqual([
    [0, 600],
    [320, 600],
    [640, 600],
    [960, 600],
    [0, 660],
    [320, 660],
  ]);
});
