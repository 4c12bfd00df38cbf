/** In: the theme's CSS custom properties at an element. Out: colours and lights for the stage. */
import { Color, SRGBColorSpace, Vector3 } from 'three';
import { CLIP_TINTS } from '../figure/tints';

export type Theme = 'light' | 'dark';

export interface Lighting {
  /** Hemisphere light from above and below, the sun, and the light along the edges. */
  readonly sky: Vector3;
  readonly ground: Vector3;
  readonly sun: Vector3;
  readonly rim: Vector3;
  readonly gridStrength: number;
  readonly shadowStrength: number;
}

/** Of the left, the right, the trunk. */
export type BodyColours = readonly [Color, Color, Color];

export interface Palette {
  readonly left: Color;
  readonly right: Color;
  readonly trunk: Color;
  /** Bodies of different clips, in the order of tints.ts. */
  readonly tints: readonly BodyColours[];
  /** All of a body while it rests before the motion. */
  readonly rest: Color;
  readonly stageTop: Color;
  readonly stageBottom: Color;
  readonly grid: Color;
  readonly shadow: Color;
  readonly lighting: Lighting;
}

/** Direction to the sun. */
export const SUN_DIRECTION = new Vector3(0.45, 0.82, 0.36).normalize();

const LIGHTING: Readonly<Record<Theme, Lighting>> = {
  light: {
    sky: new Vector3(0.98, 1, 1.04),
    ground: new Vector3(0.5, 0.5, 0.54),
    sun: new Vector3(0.52, 0.5, 0.47),
    rim: new Vector3(0.1, 0.1, 0.11),
    gridStrength: 0.45,
    shadowStrength: 0.58,
  },
  dark: {
    sky: new Vector3(0.62, 0.66, 0.74),
    ground: new Vector3(0.2, 0.2, 0.23),
    sun: new Vector3(0.78, 0.74, 0.7),
    rim: new Vector3(0.16, 0.17, 0.2),
    gridStrength: 0.45,
    shadowStrength: 0.72,
  },
};

/** How a body's flat colour becomes that of a lit one: first mixed with white (less than 0: away from it), then scaled. */
interface Tint {
  readonly white: number;
  readonly gain: number;
}

const TINTS: Readonly<Record<Theme, Readonly<Record<'limbs' | 'trunk' | 'rest', Tint>>>> = {
  light: {
    limbs: { white: 0.15, gain: 1.2 },
    trunk: { white: 0.31, gain: 1 },
    rest: { white: 0.35, gain: 1 },
  },
  dark: {
    limbs: { white: -0.1, gain: 0.9 },
    trunk: { white: 0, gain: 0.76 },
    rest: { white: -0.1, gain: 0.8 },
  },
};

const WHITE = new Color(1, 1, 1);

const SHADOW: Readonly<Record<Theme, string>> = { light: '#2b3142', dark: '#000000' };

/** The design's light theme, for pages that lack a property. */
const FALLBACK = {
  '--left': '#0a7fb8',
  '--right': '#d1690a',
  '--trunk': '#565c67',
  '--stage-a': '#fbfbfc',
  '--stage-b': '#e7e9ed',
  '--line3': '#868a93',
  '--performer-a': '#059690',
  '--performer-b': '#872582',
  '--label-0': '#1756b6',
  '--label-1': '#e34c6e',
  '--label-3': '#b29001',
  '--label-5': '#b06505',
} as const;

type Property = keyof typeof FALLBACK;

/** How much of the trunk's own colour is left in a tinted body. */
const TRUNK_LEFT = 0.35;

export function readPalette(element: Element, theme: Theme): Palette {
  const style = getComputedStyle(element);
  const read = (name: Property): Color => {
    const value = style.getPropertyValue(name).trim();
    return new Color().setStyle(value === '' ? FALLBACK[name] : value, SRGBColorSpace);
  };
  return {
    left: tinted(read('--left'), TINTS[theme].limbs),
    right: tinted(read('--right'), TINTS[theme].limbs),
    trunk: tinted(read('--trunk'), TINTS[theme].trunk),
    tints: CLIP_TINTS.map((name) => bodyOf(read(name), read('--trunk'), TINTS[theme])),
    rest: tinted(read('--line3'), TINTS[theme].rest),
    stageTop: read('--stage-a').convertLinearToSRGB(),
    stageBottom: read('--stage-b').convertLinearToSRGB(),
    grid: read('--line3'),
    shadow: new Color().setStyle(SHADOW[theme], SRGBColorSpace),
    lighting: LIGHTING[theme],
  };
}

function bodyOf(colour: Color, trunk: Color, { limbs }: (typeof TINTS)[Theme]): BodyColours {
  const limb = tinted(colour.clone(), limbs);
  return [limb, limb, tinted(colour.clone().lerp(trunk, TRUNK_LEFT), limbs)];
}

/** Mixed in sRGB, as eyes see it; scaled as light is. */
function tinted(colour: Color, { white, gain }: Tint): Color {
  return colour.convertLinearToSRGB().lerp(WHITE, white).convertSRGBToLinear().multiplyScalar(gain);
}
