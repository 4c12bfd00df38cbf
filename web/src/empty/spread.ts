/** Wanted places, ascending, in; places that keep a distance within an interval, near the wanted ones, out. */
export function spread(
  wanted: readonly number[],
  distance: number,
  least: number,
  most: number,
): number[] {
  const room = (most - least) / Math.max(1, wanted.length - 1);
  const gap = Math.min(distance, room);
  const places = wanted.map((place) => Math.min(Math.max(place, least), most));
  for (let i = 1; i < places.length; i++) places[i] = Math.max(places[i], places[i - 1] + gap);
  let limit = most;
  for (let i = places.length - 1; i >= 0; i--) {
    places[i] = Math.min(places[i], limit);
    limit = places[i] - gap;
  }
  return places;
}
