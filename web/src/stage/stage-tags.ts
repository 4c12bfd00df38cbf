/** In: figures and ghosts, their names, the camera. Out: numbers on the ground under them, letters above performers. */
import { type PerspectiveCamera, Vector3 } from 'three';
import { performerLetter } from '../figure/performer-letter';
import { tintOf } from '../figure/tints';
import type { StageProps } from './stage-props';
import type { StageScene } from './stage-scene';
import { layTags, TAG_HEIGHT, type TagArea, type TagPlace } from './tag-layout';

/** Below the place where the figure stands, above its highest joint; CSS pixels, body heights. */
const BELOW_PX = 16;
export const ABOVE = 0.1;
const TAG_WIDTH = 16;
const DIGIT_WIDTH = 7;

const point = new Vector3();

interface Standing {
  readonly middleX: number;
  readonly middleZ: number;
}

export const tagWidth = (text: string): number =>
  Math.max(TAG_WIDTH, 8 + DIGIT_WIDTH * text.length);

/** Puts a tag where it would like to be: on the ground, or at a height above it; false without a figure or behind the eye. */
export function aimTag(
  tag: TagPlace,
  pose: Standing | null,
  height: number,
  camera: PerspectiveCamera,
  area: TagArea,
): boolean {
  if (pose === null) return false;
  point.set(pose.middleX, height, pose.middleZ).project(camera);
  tag.x = (point.x * 0.5 + 0.5) * area.width;
  tag.y = (0.5 - point.y * 0.5) * area.height + (height > 0 ? 0 : BELOW_PX);
  return Math.abs(point.z) <= 1;
}

/** While the figures are on their way. */
const nobody = { pose: null, drawable: false };

class Tag implements TagPlace {
  x = 0;
  y = 0;
  width = TAG_WIDTH;
  readonly element: HTMLElement;
  private drawnX = NaN;
  private drawnY = NaN;

  constructor(target: HTMLElement, name: string, kind: string) {
    this.element = document.createElement(name);
    this.element.className = `stage-tag ${kind}`;
    this.element.hidden = true;
    target.append(this.element);
  }

  setText(text: string): void {
    if (this.element.textContent === text) return;
    this.element.textContent = text;
    this.width = tagWidth(text);
  }

  setTint(tint: number | undefined): void {
    if (tint === undefined) delete this.element.dataset['tint'];
    else this.element.dataset['tint'] = String(tintOf(tint));
  }

  /** Puts the element where the layout left the tag. */
  draw(): void {
    const x = Math.round((this.x - this.width / 2) * 2) / 2;
    const y = Math.round((this.y - TAG_HEIGHT / 2) * 2) / 2;
    if (x === this.drawnX && y === this.drawnY) return;
    this.drawnX = x;
    this.drawnY = y;
    this.element.style.transform = `translate(${x}px, ${y}px)`;
  }
}

export class StageTags {
  private readonly target: HTMLElement;
  private readonly current: Tag;
  private ghosts: readonly Tag[] = [];
  private letters: readonly Tag[] = [];
  private readonly laid: Tag[] = [];
  constructor(target: HTMLElement) {
    this.target = target;
    this.current = new Tag(target, 'span', 'current');
    this.current.element.setAttribute('aria-hidden', 'true');
  }

  setProps({ ghosts, currentTag, performers, chosen, performerName, onChoose }: StageProps): void {
    this.current.setText(currentTag ?? '');
    while (this.ghosts.length < ghosts.length) this.ghosts = [...this.ghosts, this.ghostTag()];
    this.ghosts.forEach((tag, i) => tag.setText(ghosts[i]?.tag ?? ''));
    const count = performers.length > 1 ? performers.length : 0;
    for (const { element } of this.letters.slice(count)) element.remove();
    this.letters = Array.from({ length: count }, (_, i) => {
      const tag = this.letters[i] ?? this.letterTag(i);
      tag.element.setAttribute('aria-pressed', String(i === chosen));
      tag.element.setAttribute('aria-label', performerName?.(i) ?? performerLetter(i));
      tag.setTint(performers[i].tint);
      tag.element.onclick = () => onChoose?.(i);
      return tag;
    });
  }

  /** After the figures have moved, or the camera. */
  place(scene: StageScene, camera: PerspectiveCamera, area: TagArea): void {
    const { chosenFigure: figure, ghostViews } = scene;
    const standing = figure?.drawable ? figure.pose : null;
    this.laid.length = 0;
    this.aim(this.current, standing, 0, camera, area);
    for (let i = 0; i < this.ghosts.length; i++) {
      this.aim(this.ghosts[i], ghostViews[i]?.pose ?? null, 0, camera, area);
    }
    this.lay(area);
    this.laid.length = 0;
    for (let i = 0; i < this.letters.length; i++) {
      const { pose, drawable } = scene.figures[i] ?? nobody;
      this.aim(this.letters[i], drawable ? pose : null, (pose?.top ?? 0) + ABOVE, camera, area);
    }
    this.lay(area);
  }

  destroy(): void {
    for (const { element } of [this.current, ...this.ghosts, ...this.letters]) element.remove();
  }

  private ghostTag(): Tag {
    const tag = new Tag(this.target, 'span', 'ghost');
    tag.element.setAttribute('aria-hidden', 'true');
    return tag;
  }

  private letterTag(performer: number): Tag {
    const tag = new Tag(this.target, 'button', 'letter');
    tag.element.setAttribute('type', 'button');
    tag.setText(performerLetter(performer));
    return tag;
  }

  /** Where the tag would like to be; hidden without a figure or before the eye. */
  private aim(
    tag: Tag,
    pose: Standing | null,
    height: number,
    camera: PerspectiveCamera,
    area: TagArea,
  ): void {
    const shown = tag.element.textContent !== '' && aimTag(tag, pose, height, camera, area);
    if (tag.element.hidden === shown) tag.element.hidden = !shown;
    if (shown) this.laid.push(tag);
  }

  private lay(area: TagArea): void {
    layTags(this.laid, area);
    for (const tag of this.laid) tag.draw();
  }
}
