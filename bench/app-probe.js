// Runs in the app's page before the app: notes when a file is dropped, when its keyposes are known, when
// WebGL is given something to draw, how long tasks take, and what workers say. Out: `window.probe`.
// `probe.drawNothing` makes draw calls return at once: without a GPU they would measure the rasteriser.
(() => {
  const probe = { droppedMs: 0, keyposesMs: 0, frameMs: 0, longestTaskMs: 0, workerMs: 0 };
  window.probe = probe;
  addEventListener('drop', () => Object.assign(probe, { droppedMs: performance.now(), keyposesMs: 0, frameMs: 0 }), true);
  new PerformanceObserver((list) => {
    for (const { duration } of list.getEntries()) {
      probe.longestTaskMs = Math.max(probe.longestTaskMs, duration);
    }
  }).observe({ type: 'longtask', buffered: true });
  new PerformanceObserver((list) => {
    for (const { startTime } of list.getEntriesByName('keyposes')) probe.keyposesMs = startTime;
  }).observe({ type: 'mark' });

  const context = WebGL2RenderingContext.prototype;
  for (const name of ['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced']) {
    context[name] = () => {
      probe.lastDrawMs = performance.now();
    };
  }

  // The last sign of life of any worker: what it says, or its end.
  const { Worker } = window;
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
