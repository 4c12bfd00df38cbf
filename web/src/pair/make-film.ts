/** A wish and a film's shape in; the film out. It brings its own graphics and gives them back. */
import type { Context } from '../app/context';
import { FilmCanvas } from '../film/film-canvas';
import { chooseCodec } from '../film/film-codec';
import { filmPalette } from '../film/film-palette';
import type { FilmShape } from '../film/film-shape';
import { filmSheet } from '../film/film-sheet';
import { filmTimes } from '../film/film-times';
import { recordFilm } from '../film/record-film';
import { createStageFilm, type FilmMoment, type StageFilm } from '../stage/stage-film';
import { FilmFailure } from './film-failure';
import { FilmMoments } from './film-moments';
import { FilmPoses } from './film-poses';
import type { FilmWish } from './film-wish';

export interface FilmProgress {
  readonly signal: AbortSignal;
  readonly onProgress: (done: number) => void;
}

export async function makeFilm(
  engine: Context['engine'],
  wish: FilmWish,
  shape: FilmShape,
  progress: FilmProgress,
): Promise<Blob> {
  const codec = await chooseCodec(shape);
  progress.signal.throwIfAborted();
  if (!codec) throw new FilmFailure('no-codec');
  const poses = new FilmPoses(engine);
  const moments = new FilmMoments(wish, poses);
  const sheet = filmSheet(shape, moments.panes.length, wish.clips.length);
  const { width, height } = sheet.panes[0];
  const size = { width, height, ratio: sheet.ratio };
  const tokens = document.documentElement;
  const stage = createStageFilm(tokens, wish.theme, size, moments.panes);
  if (!stage) throw new FilmFailure('no-graphics');
  try {
    const canvas = new FilmCanvas(shape, sheet, filmPalette(tokens), wish.words.language);
    await stage.compiled();
    const { count, momentS } = filmTimes(wish.stretch, shape.rate_hz);
    const draw = async (picture: number): Promise<HTMLCanvasElement> => {
      const all = await moments.at(momentS(picture), picture / shape.rate_hz);
      for (const [pane, moment] of all.entries()) await drawPane(stage, canvas, pane, moment);
      canvas.drawCaptions(moments.captions());
      return canvas.canvas;
    };
    return await recordFilm({ shape, codec, count, draw, ...progress });
  } finally {
    poses.destroy();
    void stage.destroy();
  }
}

async function drawPane(
  stage: StageFilm,
  canvas: FilmCanvas,
  pane: number,
  moment: FilmMoment,
): Promise<void> {
  const picture = await stage.draw(pane, moment);
  if (!picture) throw new FilmFailure('no-graphics');
  canvas.drawPane(pane, picture, stage.tags(pane));
}
