// Runs in the app's page before the app. Notes when files are dropped, when keyposes are known, when a set is
// compared and its matrix first drawn, when the figures are handed to WebGL, how long tasks take and when a worker
// last spoke. Out: `window.probe`.
(() => {
  const probe = {
    droppedMs: 0,
    keyposesMs: 0,
    frameMs: 0,
    firstPictureMs: 0,
    comparedMs: 0,
    longestTaskMs: 0,
    workerMs: 0,
    cancelMs: 0,
  };
  window.probe = probe;

  const drop = () =>
    Object.assign(probe, { droppedMs: performance.now(), keyposesMs: 0, frameMs: 0 });
  addEventListener('drop', drop, { capture: true });

  const watch = (type, note) =>
    new PerformanceObserver((list) => list.getEntries().forEach(note)).observe({ type });
  watch('longtask', ({ duration }) => {
    probe.longestTaskMs = Math.max(probe.longestTaskMs, duration);
  });
  const mark = performance.mark.bind(performance);
  performance.mark = (name, options) => {
    if (name === 'keyposes') probe.keyposesMs = performance.now();
    if (name === 'comparison-first-picture') probe.firstPictureMs ||= performance.now();
    if (name === 'comparison-full') probe.comparedMs = performance.now();
    return mark(name, options);
  };

  // Draw calls do nothing: without a GPU they would measure the software rasteriser. Figures are the
  // only things that are drawn in instances.
  const context = WebGL2RenderingContext.prototype;
  context.drawArrays = context.drawElements = () => undefined;
  context.drawArraysInstanced = context.drawElementsInstanced = () => {
    if (probe.keyposesMs > 0) probe.frameMs ||= performance.now();
  };

  window.Worker = class extends Worker {
    constructor(...parameters) {
      super(...parameters);
      this.addEventListener('message', () => (probe.workerMs = performance.now()));
    }

    terminate() {
      probe.workerMs = performance.now();
      super.terminate();
    }
  };
})();
