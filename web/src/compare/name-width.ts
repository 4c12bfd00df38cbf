/** Names and their font in; the room that the longest of them takes beside its row out. */
const paddingPx = 26;
/** Of more names the first are measured. */
const mostMeasured = 400;

export function longestNamePx(names: readonly string[], font: string): number {
  const context = document.createElement('canvas').getContext('2d');
  if (!context) return paddingPx;
  context.font = `500 10.5px ${font}`;
  const widths = names.slice(0, mostMeasured).map((name) => context.measureText(name).width);
  return widths.reduce((most, width) => Math.max(most, width), 0) + paddingPx;
}
