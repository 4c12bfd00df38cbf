/** In: two circles. Out: the outline of their convex hull, as angles and as SVG path data. */

/**
 * Angles of the outline: it leaves both circles at `axis ± spread`. null where one circle holds the
 * other; the outline is then the larger circle.
 */
export function hullAngles(
  x1: number,
  y1: number,
  r1: number,
  x2: number,
  y2: number,
  r2: number,
): { axis: number; spread: number } | null {
  const distance = Math.hypot(x2 - x1, y2 - y1);
  if (distance <= Math.abs(r1 - r2) + 1e-9) return null;
  return { axis: Math.atan2(y2 - y1, x2 - x1), spread: Math.acos((r1 - r2) / distance) };
}

/** SVG path data of the hull of two circles, in user units; every outline turns the same way. */
export function hullPath(
  x1: number,
  y1: number,
  r1: number,
  x2: number,
  y2: number,
  r2: number,
): string {
  const angles = hullAngles(x1, y1, r1, x2, y2, r2);
  if (!angles) return r1 >= r2 ? circlePath(x1, y1, r1) : circlePath(x2, y2, r2);
  const from = angles.axis - angles.spread;
  const to = angles.axis + angles.spread;
  const blunt = angles.spread > Math.PI / 2 ? 1 : 0;
  return (
    `M${onCircle(x1, y1, r1, from)}L${onCircle(x2, y2, r2, from)}` +
    `A${short(r2)} ${short(r2)} 0 ${blunt} 1 ${onCircle(x2, y2, r2, to)}` +
    `L${onCircle(x1, y1, r1, to)}A${short(r1)} ${short(r1)} 0 ${1 - blunt} 1 ${onCircle(x1, y1, r1, from)}Z`
  );
}

function circlePath(x: number, y: number, r: number): string {
  const radii = `${short(r)} ${short(r)}`;
  return `M${short(x - r)} ${short(y)}A${radii} 0 1 1 ${short(x + r)} ${short(y)}A${radii} 0 1 1 ${short(x - r)} ${short(y)}Z`;
}

function onCircle(x: number, y: number, r: number, angle: number): string {
  return `${short(x + r * Math.cos(angle))} ${short(y + r * Math.sin(angle))}`;
}

/** Hundredths of a pixel are enough, and keep documents small. */
function short(value: number): string {
  return String(Math.round(value * 100) / 100);
}
