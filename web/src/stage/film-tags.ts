/** In: a scene, its names, a camera. Out: where its numbers and letters are, to be drawn into a picture. */
import type { PerspectiveCamera } from 'three';
import { performerLetter } from '../figure/performer-letter';
import type { StageScene } from './stage-scene';
import { ABOVE, aimTag, tagWidth } from './stage-tags';
import { layTags, type TagArea, type TagPlace } from './tag-layout';

export interface FilmTag extends TagPlace {
  readonly text: string;
  readonly kind: 'current' | 'ghost' | 'letter';
  /** Place of the clip among those of the picture, for letters. */
  readonly tint: number;
}

/** Under the chosen figure and its ghosts; empty for none. */
export interface FilmNumbers {
  readonly current: string;
  readonly ghosts: readonly string[];
}

const tag = (kind: FilmTag['kind'], text: string, tint = 0): FilmTag => ({
  kind,
  text,
  tint,
  x: 0,
  y: 0,
  width: tagWidth(text),
});

export function filmTags(
  scene: StageScene,
  numbers: FilmNumbers,
  camera: PerspectiveCamera,
  area: TagArea,
): FilmTag[] {
  const { chosenFigure: figure, figures, ghostViews } = scene;
  const standing = figure?.drawable ? figure.pose : null;
  const ground = numbers.ghosts.map((text, i) => ({
    tag: tag('ghost', text),
    pose: ghostViews[i]?.pose ?? null,
  }));
  ground.push({ tag: tag('current', numbers.current), pose: standing });
  const onGround = ground
    .filter(({ tag, pose }) => tag.text !== '' && aimTag(tag, pose, 0, camera, area))
    .map(({ tag }) => tag);
  const letters = (figures.length > 1 ? figures : []).flatMap(({ pose, drawable }, place) => {
    const letter = tag('letter', performerLetter(place), place);
    return drawable && aimTag(letter, pose, pose.top + ABOVE, camera, area) ? [letter] : [];
  });
  layTags(onGround, area);
  layTags(letters, area);
  return [...onGround, ...letters];
}
