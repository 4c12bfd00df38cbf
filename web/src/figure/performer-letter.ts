/** Number of a performer from 0 in; its letter out: A, B … Z, then numbers. */
export function performerLetter(performer: number): string {
  return performer < 26 ? String.fromCharCode(65 + performer) : String(performer + 1);
}
