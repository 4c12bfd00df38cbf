/** Names and their font in; the room that the longest of them takes beside its row out. */
const paddingPx = 26;
/** Of more names the first are measured. */
const mostMeasured = 400;

/** A set that grows is measured again and again, each name of it once. */
let measured: { readonly font: string; readonly widths: Map<string, number> } | null = null;

export function longestNamePx(names: readonly string[], font: string): number {
  const context = document.createElement('canvas').getContext('2d');
  if (!context) return paddingPx;
  context.font = `500 10.5px ${font}`;
  if (measured?.font !== font) measured = { font, widths: new Map() };
  const { widths: before } = measured;
  const widths = new Map<string, number>();
  for (const name of names.slice(0, mostMeasured))
    widths.set(name, before.get(name) ?? context.measureText(name).width);
  measured = { font, widths };
  return Math.max(0, ...widths.values()) + paddingPx;
}
