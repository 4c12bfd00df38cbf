import { expect, test, vi } from 'vitest';
import { createFullScreen, type Screen } from './full-screen';

class FakeScreen extends EventTarget {
  fullscreenElement: object | null = null;
  fullscreenEnabled = true;
  refuses = false;
  readonly documentElement = {
    requestFullscreen: vi.fn(() => {
      if (this.refuses) return Promise.reject(new TypeError('not allowed'));
      this.change({});
      return Promise.resolve();
    }),
  };
  readonly exitFullscreen = vi.fn(() => Promise.resolve(this.change(null)));

  change(element: object | null): void {
    this.fullscreenElement = element;
    this.dispatchEvent(new Event('fullscreenchange'));
  }

  press(key: string, prevented = false): void {
    const event = Object.assign(new Event('keydown', { cancelable: true }), { key });
    if (prevented) event.preventDefault();
    this.dispatchEvent(event);
  }
}

function make() {
  const screen = new FakeScreen();
  return { screen, full: createFullScreen(screen as unknown as Screen) };
}

test('the same command enters and leaves', () => {
  const { screen, full } = make();
  full.toggle();
  expect([full.active.value, screen.fullscreenElement]).toEqual([true, {}]);
  full.toggle();
  expect([full.active.value, screen.fullscreenElement]).toEqual([false, null]);
});

test('when the browser leaves by Escape, the page follows', () => {
  const { screen, full } = make();
  full.toggle();
  screen.change(null);
  expect(full.active.value).toBe(false);
});

test('where the screen cannot be had the window is filled, until Escape', async () => {
  for (const lacks of ['enabled', 'leave'] as const) {
    const { screen, full } = make();
    if (lacks === 'enabled') screen.fullscreenEnabled = false;
    else screen.refuses = true;
    full.toggle();
    await Promise.resolve();
    expect([full.active.value, screen.fullscreenElement]).toEqual([true, null]);
    screen.press('Escape', true);
    expect(full.active.value).toBe(true);
    screen.press('Escape');
    expect(full.active.value).toBe(false);
  }
});
