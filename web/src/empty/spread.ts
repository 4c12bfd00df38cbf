/** In: wanted places, ascending, and how wide each thing is. Out: places near them where nothing overlaps. */

/** Things keep `gap` between them and stay within `least` and `most`; where they do not fit, they share what there is. */
export function spread(
  wanted: readonly number[],
  widths: readonly number[],
  gap: number,
  least: number,
  most: number,
): number[] {
  const half = widths.map((width) => width / 2);
  const apart = half.map((own, index) => (index > 0 ? own + half[index - 1] + gap : 0));
  const needed = apart.reduce((sum, distance) => sum + distance, half[0] + half[half.length - 1]);
  const share = Math.min(1, (most - least) / needed);
  const limits = half.map((own) => ({ least: least + own * share, most: most - own * share }));
  const places = wanted.map((place, i) =>
    Math.min(Math.max(place, limits[i].least), limits[i].most),
  );
  for (let i = 1; i < places.length; i++)
    places[i] = Math.max(places[i], places[i - 1] + apart[i] * share);
  for (let i = places.length - 1; i >= 0; i--) {
    const next = i + 1 < places.length ? places[i + 1] - apart[i + 1] * share : limits[i].most;
    places[i] = Math.min(places[i], next);
  }
  return places;
}

/** How many of the first things fit side by side. */
export function fitting(widths: readonly number[], gap: number, room: number): number {
  let used = -gap;
  const tooMany = widths.findIndex((width) => (used += width + gap) > room);
  return tooMany < 0 ? widths.length : tooMany;
}
