/** A standard human in a T-pose, to show on it which joint stands for which part. Lengths in body heights. */
import type { Body, Role, Skeleton } from '../engine/types';
import { flatFigure, type FlatFigure } from './flat-figure';

type Place = readonly [x: number, y: number, z: number];
type SidedPart = 'hip' | 'shoulder' | 'elbow' | 'wrist' | 'finger' | 'knee' | 'ankle' | 'toe';

/** Of the left side; the right one mirrors it. Proportions of the body of the method, feet turned out a little. */
const leftPlaces: Readonly<Record<SidedPart, Place>> = {
  hip: [0.057, 0.565, 0],
  knee: [0.068, 0.3, 0],
  ankle: [0.076, 0.055, 0],
  toe: [0.118, 0.014, 0.09],
  shoulder: [0.1055, 0.85, 0],
  elbow: [0.272, 0.83, 0],
  wrist: [0.42, 0.815, 0],
  finger: [0.5, 0.807, 0],
};
const middlePlaces = { pelvis: [0, 0.6, 0], neck: [0, 0.898, 0], head: [0, 1.03, 0] } as const;

const parts = Object.keys(leftPlaces) as SidedPart[];
const parentParts: Readonly<Record<SidedPart, SidedPart | null>> = {
  hip: null,
  knee: 'hip',
  ankle: 'knee',
  toe: 'ankle',
  shoulder: null,
  elbow: 'shoulder',
  wrist: 'elbow',
  finger: 'wrist',
};

type Name = Role | 'pelvis';

const sided = (side: 'left' | 'right') =>
  parts.map((part): readonly [Name, Place, Name] => {
    const [x, y, z] = leftPlaces[part];
    const parent = parentParts[part];
    return [
      `${side}_${part}`,
      [side === 'left' ? x : -x, y, z],
      parent ? `${side}_${parent}` : part === 'hip' ? 'pelvis' : 'neck',
    ];
  });

const joints: readonly (readonly [Name, Place, Name | null])[] = [
  ['pelvis', middlePlaces.pelvis, null],
  ['neck', middlePlaces.neck, 'pelvis'],
  ['head', middlePlaces.head, 'neck'],
  ...sided('left'),
  ...sided('right'),
];

const names = joints.map(([name]) => name);

const skeleton: Skeleton = {
  labels: names,
  parents: Int32Array.from(joints, ([, , parent]) => (parent ? names.indexOf(parent) : -1)),
  endSites: new Uint8Array(joints.length),
};

const body: Body = {
  kind: 'human',
  pelvis: 0,
  height: 1,
  joints: names.flatMap((name, joint) =>
    name === 'pelvis' ? [] : [{ role: name, joint, source: 'name' as const }],
  ),
};

export function standardFigure(): FlatFigure {
  const pose = joints.flatMap(([, place]) => place);
  const up = { axis: '+Y', source: 'found' } as const;
  return flatFigure(pose, { skeleton, body, up, groundHeight: 0 }, 0);
}

/** Where a part of the standard body is, x to the viewer's right, y up from the ground. */
export function standardPlace(name: Name): readonly [number, number] {
  const [, [x, y] = [0, 0]] = joints.find(([one]) => one === name) ?? [];
  return [x, y];
}
