import { describe, expect, it } from 'vitest';
import { FilmCamera } from './film-camera';
import type { Framing, Stance } from './view';

const framed: Framing = { targetX: 1, targetY: 0.5, targetZ: 2, distance: 4 };
const stance: Stance = {
  framed,
  aspect: 2,
  yawRad: 0,
  elevationRad: 0,
  zoom: 1.5,
  offsetX: 0.25,
  offsetY: 0,
  offsetZ: 0,
};
const walkedTo = (targetX: number): Framing => ({ ...framed, targetX });

/** Where it looks and how far away it is. */
const place = ({ targetX, targetZ, camera }: FilmCamera) => ({
  targetX,
  targetZ,
  distance: camera.position.z - targetZ,
});

describe('the camera of a film', () => {
  it('frames what is there first, with the stance’s own distance and shift', () => {
    const camera = new FilmCamera(stance, true, 1);
    camera.step({ here: { ...walkedTo(5), distance: 6 }, onStage: framed }, 0);
    expect(place(camera)).toEqual({ targetX: 5.25, targetZ: 2, distance: 9 });
  });

  it('follows by the time that passes in the film, in however many pictures', () => {
    const after = (pictures: number): number => {
      const camera = new FilmCamera(stance, true, 1);
      camera.step({ here: walkedTo(1), onStage: framed }, 0);
      for (let i = 0; i < pictures; i++)
        camera.step({ here: walkedTo(1.5), onStage: framed }, 0.2 / pictures);
      return camera.targetX;
    };
    expect(after(12)).toBeCloseTo(after(5), 9);
    expect(after(12)).toBeGreaterThan(1.25);
    expect(after(12)).toBeLessThan(1.75);
  });

  it('stays where the stage’s camera is when that does not follow, as far away as its shape needs', () => {
    const camera = new FilmCamera(stance, false, 1);
    const wider = { here: { ...walkedTo(9), distance: 10 }, onStage: { ...framed, distance: 5 } };
    camera.step(wider, 0);
    camera.step({ ...wider, here: { ...walkedTo(12), distance: 10 } }, 1);
    expect(place(camera)).toEqual({ targetX: 1.25, targetZ: 2, distance: 12 });
  });
});
