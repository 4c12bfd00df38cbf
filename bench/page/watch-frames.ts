/** The page in; what the callbacks of its frames take, and how often it draws, out. */

/** Milliseconds that callbacks of frames have taken since it was last asked. */
export function watchFrames(): () => number {
  let spent_ms = 0;
  const request = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (callback) =>
    request((time) => {
      const start = performance.now();
      callback(time);
      spent_ms += performance.now() - start;
    });
  return () => {
    const told = spent_ms;
    spent_ms = 0;
    return told;
  };
}

/** Draw calls do nothing: without a GPU they would measure the software rasteriser. How many there were since it was last asked. */
export function drawNothing(): () => number {
  let calls = 0;
  const call = (): void => {
    calls += 1;
  };
  const context = WebGL2RenderingContext.prototype;
  context.drawArrays = context.drawElements = call;
  context.drawArraysInstanced = context.drawElementsInstanced = call;
  return () => {
    const told = calls;
    calls = 0;
    return told;
  };
}
