/** In: where tags would like to be. Out: where they are, apart from each other and from the words on the stage. */

export interface TagPlace {
  x: number;
  y: number;
  readonly width: number;
}

/** Widths that the words in the lower corners of the stage take up, in CSS pixels. */
export interface Corners {
  readonly left: number;
  readonly right: number;
}

export interface TagArea extends Corners {
  readonly width: number;
  readonly height: number;
}

export const TAG_HEIGHT = 16;
const GAP = 3;
const EDGE = 8;
/** Height of the words in the corners, with air above. */
const CORNER_HEIGHT = 34;

/** Moves the tags (middles x, y) and puts them in order from the left. */
export function layTags(tags: TagPlace[], area: TagArea): void {
  for (let i = 0; i < tags.length; i++) keepInside(tags[i], area);
  tags.sort(fromLeft);
  for (let round = 0; round < 12 && pushApart(tags); round++);
  sweep(tags, area);
}

const fromLeft = (a: TagPlace, b: TagPlace): number => a.x - b.x;

/** Inside the stage and above the words in its lower corners. */
function keepInside(tag: TagPlace, { width, height, left, right }: TagArea): void {
  const half = tag.width / 2;
  tag.x = Math.min(Math.max(tag.x, EDGE + half), width - EDGE - half);
  const overWords = tag.x - half < left + GAP * 4 || tag.x + half > width - right - GAP * 4;
  const lowest = height - (overWords ? CORNER_HEIGHT : EDGE) - TAG_HEIGHT / 2;
  tag.y = Math.max(EDGE + TAG_HEIGHT / 2, Math.min(tag.y, lowest));
}

/** How far two neighbours are too near to each other; 0 where they are not. */
function overlap(a: TagPlace, b: TagPlace): number {
  if (Math.abs(a.y - b.y) >= TAG_HEIGHT + GAP) return 0;
  return Math.max(0, (a.width + b.width) / 2 + GAP - (b.x - a.x));
}

/** Each of two that overlap goes half the way; true if any did. */
function pushApart(tags: readonly TagPlace[]): boolean {
  let moved = false;
  for (let i = 1; i < tags.length; i++) {
    const over = overlap(tags[i - 1], tags[i]);
    if (over < 0.25) continue;
    tags[i - 1].x -= over / 2;
    tags[i].x += over / 2;
    moved = true;
  }
  return moved;
}

/** What is left of overlaps goes to the right, and back from the edge. */
function sweep(tags: readonly TagPlace[], area: TagArea): void {
  for (let i = 0; i < tags.length; i++) {
    keepInside(tags[i], area);
    for (let j = 0; j < i; j++) tags[i].x += overlap(tags[j], tags[i]);
  }
  let right = area.width - EDGE;
  for (let i = tags.length - 1; i >= 0; i--) {
    const tag = tags[i];
    if (tag.x + tag.width / 2 <= right) break;
    tag.x = right - tag.width / 2;
    right = tag.x - tag.width / 2 - GAP;
  }
}
