/** A canvas and its size in CSS pixels in; its context, cleared and in the device's pixels, out. */
export function prepareCanvas(
  canvas: HTMLCanvasElement,
  width: number,
  height: number,
): CanvasRenderingContext2D | null {
  const ratio = window.devicePixelRatio;
  const [across, down] = [Math.max(1, Math.round(width * ratio)), Math.round(height * ratio)];
  const context = canvas.getContext('2d');
  // Another size clears and allocates anew: only where it is another one.
  if (canvas.width !== across) canvas.width = across;
  if (canvas.height !== down) canvas.height = down;
  context?.setTransform(1, 0, 0, 1, 0, 0);
  context?.clearRect(0, 0, across, down);
  context?.scale(ratio, ratio);
  return context;
}

/** Tells when the device has other pixels: another screen, or the browser's zoom. Returns what ends that. */
export function watchPixelRatio(onChange: () => void): () => void {
  let query: MediaQueryList | null = null;
  const watch = (): void => {
    query?.removeEventListener('change', change);
    query = matchMedia(`(resolution: ${window.devicePixelRatio}dppx)`);
    query.addEventListener('change', change);
  };
  const change = (): void => {
    watch();
    onChange();
  };
  watch();
  return () => query?.removeEventListener('change', change);
}
