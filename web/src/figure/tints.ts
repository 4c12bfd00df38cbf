/** The place of a clip among those shown together in; the colour it wears out, by its name in tokens.css. */

/** A's, B's, and those of labels that are not nearly one of these; then they come again. */
export const CLIP_TINTS = [
  '--performer-a',
  '--performer-b',
  '--label-0',
  '--label-1',
  '--label-3',
  '--label-5',
] as const;

export const tintOf = (place: number): number => place % CLIP_TINTS.length;
