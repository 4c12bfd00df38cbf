/**
 * A place on the page and a template that reads signals in; the place kept as the template says out,
 * drawn at most once a frame.
 */
import { effect } from '@preact/signals-core';
import { render } from 'lit-html';

const waiting = new Set<() => void>();

function drawWaiting(): void {
  const draws = [...waiting];
  waiting.clear();
  for (const draw of draws) draw();
}

function schedule(draw: () => void): void {
  if (waiting.size === 0) requestAnimationFrame(drawWaiting);
  waiting.add(draw);
}

/** Runs `update` now, and once in the next frame after any signal that it read has changed. */
export function follow(update: () => void): () => void {
  let stop = (): void => undefined;
  const run = (): void => {
    stop();
    let first = true;
    stop = effect(() => {
      if (!first) return schedule(run);
      first = false;
      // What goes wrong in one view is told and leaves the others, and its own next try, alone.
      try {
        update();
      } catch (error) {
        reportError(error);
      }
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
