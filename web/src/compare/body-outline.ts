/** A standing body seen from the front: SVG path data of its parts, in body heights, out. */
import { RADII, spineRadius } from '../figure/radii';
import { hullPath } from '../figure/cone-outline';
import { standardPlace } from '../figure/standard-body';
import type { BodyPart } from '../engine/types';

type Place = readonly [x: number, y: number];
type Radii = readonly [number, number];

/** Units of the drawing for one body height. */
export const outlineScale = 84;
/** The ground in the drawing. */
export const outlineGround = 96;

const cone = ([x1, y1]: Place, [x2, y2]: Place, [r1, r2]: Radii): string =>
  hullPath(
    x1 * outlineScale,
    outlineGround - y1 * outlineScale,
    r1 * outlineScale,
    x2 * outlineScale,
    outlineGround - y2 * outlineScale,
    r2 * outlineScale,
  );

type Side = 'left' | 'right';

function arm(side: Side): string {
  const [shoulder, elbow, wrist, finger] = (['shoulder', 'elbow', 'wrist', 'finger'] as const).map(
    (joint) => standardPlace(`${side}_${joint}`),
  );
  return (
    cone(shoulder, elbow, RADII.upperArm) +
    cone(elbow, wrist, RADII.forearm) +
    cone(wrist, finger, RADII.hand)
  );
}

function leg(side: Side): string {
  const [hip, knee, ankle, toe] = (['hip', 'knee', 'ankle', 'toe'] as const).map((joint) =>
    standardPlace(`${side}_${joint}`),
  );
  return (
    cone(hip, knee, RADII.thigh) + cone(knee, ankle, RADII.shin) + cone(ankle, toe, RADII.foot)
  );
}

function head(): string {
  const neck = standardPlace('neck');
  const [x, top] = standardPlace('head');
  const at = (below: number): Place => [x, top - below];
  return cone(neck, at(0.08), RADII.neck) + cone(at(0.055), at(0.03), RADII.head);
}

function trunk(): string {
  const [pelvis, neck] = [standardPlace('pelvis'), standardPlace('neck')];
  const chestFraction = 0.7;
  const chest: Place = [0, pelvis[1] + chestFraction * (neck[1] - pelvis[1])];
  const shoulder = (side: Side): string =>
    cone(chest, standardPlace(`${side}_shoulder`), RADII.shoulder);
  return (
    cone(standardPlace('left_hip'), standardPlace('right_hip'), RADII.pelvis) +
    cone(pelvis, chest, [spineRadius(0), spineRadius(chestFraction)]) +
    cone(chest, neck, [spineRadius(chestFraction), spineRadius(1)]) +
    shoulder('left') +
    shoulder('right')
  );
}

/** Legs and arms first: the trunk lies on them. */
export const partOutlines: readonly (readonly [BodyPart, string])[] = [
  ['left-leg', leg('left')],
  ['right-leg', leg('right')],
  ['left-arm', arm('left')],
  ['right-arm', arm('right')],
  ['head', head()],
];

export const trunkOutline = trunk();
