/** In: the theme's CSS custom properties at an element. Out: colours and lights for the stage. */
import { Color, SRGBColorSpace, Vector3 } from 'three';

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

export interface Palette {
  readonly left: Color;
  readonly right: Color;
  readonly trunk: Color;
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
    gridStrength: 0.55,
    shadowStrength: 0.58,
  },
  dark: {
    sky: new Vector3(0.62, 0.66, 0.74),
    ground: new Vector3(0.2, 0.2, 0.23),
    sun: new Vector3(0.78, 0.74, 0.7),
    rim: new Vector3(0.16, 0.17, 0.2),
    gridStrength: 0.55,
    shadowStrength: 0.72,
  },
};

/** The bodies' colours are made for flat drawing; lit, they need this much of white or black mixed in. */
const TINT: Readonly<Record<Theme, { readonly toward: string; readonly amount: number }>> = {
  light: { toward: '#ffffff', amount: 0.23 },
  dark: { toward: '#000000', amount: 0.1 },
};

const SHADOW: Readonly<Record<Theme, string>> = { light: '#2b3142', dark: '#000000' };

/** The design's light theme, for pages that lack a property. */
const FALLBACK = {
  '--left': '#0a7fb8',
  '--right': '#d1690a',
  '--trunk': '#565c67',
  '--stage-a': '#fbfbfc',
  '--stage-b': '#e7e9ed',
  '--line3': '#868a93',
} as const;

type Property = keyof typeof FALLBACK;

export function readPalette(element: Element, theme: Theme): Palette {
  const style = getComputedStyle(element);
  const read = (name: Property): Color => {
    const value = style.getPropertyValue(name).trim();
    return new Color().setStyle(value === '' ? FALLBACK[name] : value, SRGBColorSpace);
  };
  const body = (name: Property): Color => tinted(read(name), theme);
  return {
    left: body('--left'),
    right: body('--right'),
    trunk: body('--trunk'),
    stageTop: read('--stage-a').convertLinearToSRGB(),
    stageBottom: read('--stage-b').convertLinearToSRGB(),
    grid: read('--line3'),
    shadow: new Color().setStyle(SHADOW[theme], SRGBColorSpace),
    lighting: LIGHTING[theme],
  };
}

/** Mixed as eyes see it, in sRGB. */
function tinted(colour: Color, theme: Theme): Color {
  const { toward, amount } = TINT[theme];
  const other = new Color().setStyle(toward, SRGBColorSpace).convertLinearToSRGB();
  return colour.convertLinearToSRGB().lerp(other, amount).convertSRGBToLinear();
}
