import { expect, it } from 'vitest';
import { Axis } from '../timeline/axis';
import {
  flagCover,
  ribbonLabels,
  ribbonTicks,
  tabCovers,
  uncovered,
  type Cover,
} from './ribbon-labels';

const withUnit = (seconds: string): string => `${seconds} s`;
const labelsOf = (axis: Axis, frameTimeS: number) =>
  ribbonLabels(ribbonTicks(axis, frameTimeS), axis.width, withUnit);

it('labels a second of a few seconds, as there are lines between', () => {
  const texts = labelsOf(new Axis(1028, 480), 1 / 120).map(({ text }) => text);
  expect(texts).toEqual(['1 s', '2 s', '3 s']);
});

it('writes minutes and hours, and parts of seconds where the axis is zoomed', () => {
  const hour = labelsOf(new Axis(1028, 432_000), 1 / 120).map(({ text }) => text);
  expect(hour).toContain('30:00');
  const part = labelsOf(new Axis(1028, 432_000, { first: 240_000, last: 240_240 }), 1 / 120);
  expect(part.map(({ text }) => text)).toContain('33:20.5');
});

it('labels a narrow axis too', () => {
  const texts = labelsOf(new Axis(266, 480), 1 / 120).map(({ text }) => text);
  expect(texts).toEqual(['1 s', '2 s', '3 s']);
});

it('hides what a flag or a tab of the loop covers', () => {
  const labels = labelsOf(new Axis(1028, 480), 1 / 120);
  const shownBeside = (...covers: Cover[]) => uncovered(labels, covers).map(({ text }) => text);
  expect(shownBeside(flagCover(labels[1].x))).toEqual(['1 s', '3 s']);
  expect(shownBeside(flagCover(labels[1].x + 60))).toEqual(['1 s', '2 s', '3 s']);
  const tabs = tabCovers(labels[0].x, labels[2].x - 1);
  expect(shownBeside(...tabs)).toEqual(['2 s', '3 s']);
});
