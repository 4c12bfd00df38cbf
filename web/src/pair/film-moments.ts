/** A wish and a moment of the pair's clock in; what each stage shows and each caption says then out. */
import { qualifiedName } from '../app/names';
import type { FilmCaption } from '../film/film-canvas';
import { frameAt } from '../player/clock';
import { nearestIndex } from '../player/neighbours';
import type { FilmMoment, FilmPane } from '../stage/stage-film';
import type { FilmPoses, Surroundings } from './film-poses';
import type { FilmWish } from './film-wish';
import { ROOM } from './mount-stages';
import type { PairClip } from './pair-clips';
import { sceneOf, type StageScene } from './scene-of';
import { captionOfClip } from './stage-words';

/** Side by side a film's stages are narrower than the page's: the figures at the next keyposes are to be seen. */
const ROOM_FOR_KEYPOSES = 1.45;

export class FilmMoments {
  readonly panes: readonly FilmPane[];
  private readonly scenes: readonly StageScene[];
  private readonly around: (Surroundings | null)[];
  private frames: readonly number[] = [];
  private lastS: number | null = null;

  constructor(
    private readonly wish: FilmWish,
    private readonly poses: FilmPoses,
  ) {
    const { panes, follow, preset, keyposes, superposed } = wish;
    const room = keyposes && !superposed ? ROOM_FOR_KEYPOSES : ROOM;
    this.scenes = panes.map((_, index) => sceneOf(index === 1 ? 1 : 0, wish, poses));
    this.around = panes.map(() => null);
    this.panes = panes.map(({ place, stance }, index) => {
      const { performers, places } = this.scenes[index];
      const chosen = Math.max(0, places.indexOf(place));
      return { performers, chosen, follow, room, stageRoom: ROOM, stance, preset };
    });
  }

  /** Of each stage; `filmS` is the film's own time. */
  async at(pairS: number, filmS: number): Promise<FilmMoment[]> {
    const { clips, alignment } = this.wish;
    this.frames = clips.map(({ frameTimeS, frames }, clip) =>
      frameAt(alignment.timeOf(clip, pairS), frameTimeS, frames),
    );
    const dtS = filmS - (this.lastS ?? filmS);
    this.lastS = filmS;
    await Promise.all(clips.map((clip, i) => this.poses.there(clip, this.frames[i])));
    return Promise.all(this.scenes.map((scene, index) => this.paneAt(scene, index, dtS)));
  }

  /** Of the moment asked for last. */
  captions(): FilmCaption[] {
    return this.wish.clips.map((clip, i) => this.caption(clip, this.frames[i]));
  }

  private async paneAt(scene: StageScene, index: number, dtS: number): Promise<FilmMoment> {
    const { place } = this.wish.panes[index];
    const clip = this.wish.clips[place];
    const current = nearestIndex(clip.keyposes, this.frames[place]);
    let around = this.around[index];
    if (around?.current !== current || around === null) {
      around = await this.poses.around(clip, current, this.wish, scene.places.length);
      this.around[index] = around;
    }
    return {
      frames: scene.places.map((shown) => this.frames[shown]),
      ghosts: around.ghosts,
      trails: around.trails,
      currentTag: this.wish.keyposes && current !== null ? String(current + 1) : '',
      dtS,
    };
  }

  private caption(clip: PairClip, frame: number): FilmCaption {
    const { words, labels } = this.wish;
    const current = nearestIndex(clip.keyposes, frame);
    const { title, posture, remark } = captionOfClip(words, clip, frame, current);
    const { t, format } = words;
    return {
      letter: clip.letter,
      place: clip.place,
      name: qualifiedName(clip.name, clip.qualifier),
      label: labels[clip.place],
      time: t('unit.seconds', format.decimal(frame * clip.frameTimeS, 2)),
      keypose: title,
      posture,
      remark,
    };
  }
}
