/**
 * A place on the page and a template that reads signals in; the place kept as the template says out,
 * drawn at most once a frame.
 */
import { effect } from '@preact/signals-core';
import { render } from 'lit-html';

/** Views that take longer than this are drawn in more than one frame: no task may last 50 ms. */
const FRAME_MS = 8;

const waiting = new Set<() => void>();
let requested = false;

function request(): void {
  if (requested) return;
  requested = true;
  requestAnimationFrame(drawWaiting);
}

function drawWaiting(): void {
  requested = false;
  const end = performance.now() + FRAME_MS;
  for (const draw of [...waiting]) {
    waiting.delete(draw);
    draw();
    if (performance.now() > end) break;
  }
  if (waiting.size > 0) request();
}

function schedule(draw: () => void): void {
  waiting.add(draw);
  request();
}

/** What goes wrong in one view is told and leaves the others, and its own next try, alone. */
function tellingErrors(update: () => void): void {
  try {
    update();
  } catch (error) {
    reportError(error);
  }
}

/** Runs `update` now, and again as soon as any signal that it read has changed. */
export const followAtOnce = (update: () => void): (() => void) =>
  effect(() => tellingErrors(update));

/** Runs `update` now, and once in the next frame after any signal that it read has changed. */
export function follow(update: () => void): () => void {
  let stop = (): void => undefined;
  const run = (): void => {
    stop();
    let first = true;
    stop = effect(() => {
      if (!first) return schedule(run);
      first = false;
      tellingErrors(update);
    });
  };
  run();
  return () => {
    waiting.delete(run);
    stop();
  };
}

export function mount(place: HTMLElement, template: () => unknown): () => void {
  return follow(() => {
    render(template(), place);
  });
}
