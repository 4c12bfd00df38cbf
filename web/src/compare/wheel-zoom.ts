/**
 * A turn of the wheel over the matrix or the map in; how much larger it makes them out. Where the page
 * itself scrolls, in a narrow window, the wheel is the page's, as over a map in any page: with Ctrl (as two
 * fingers on a touchpad say it) it makes larger everywhere.
 */
type Wheel = Pick<WheelEvent, 'deltaY' | 'deltaMode' | 'ctrlKey' | 'metaKey'>;

const perLine = 0.05;
const perPixel = 0.002;
/** Two fingers tell smaller steps than a wheel. */
const perPinchPixel = 0.01;

/** null: the turn is not for them. */
export function zoomFactor(event: Wheel, pageScrolls: boolean): number | null {
  const meant = event.ctrlKey || event.metaKey;
  if (pageScrolls && !meant) return null;
  const notch = Math.abs(event.deltaY) >= 50;
  const rate = event.deltaMode === 1 ? perLine : meant && !notch ? perPinchPixel : perPixel;
  return Math.exp(-event.deltaY * rate);
}

/** Whether the page Compare around an element is longer than its window. */
export function pageScrolls(element: Element): boolean {
  const page = element.closest('.compare');
  return page !== null && page.scrollHeight > page.clientHeight + 1;
}
