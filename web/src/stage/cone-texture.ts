/** In: rounded cones of all figures. Out: one texture from which every shader of the stage reads them. */
import { DataTexture, FloatType, NearestFilter, RGBAFormat } from 'three';
import type { BoneCone, Side } from '../figure/bone-cone';

/** Texels of one cone: start and radius, end and radius, limb, side, whether it is trunk. */
const TEXELS = 3;
/** Numbers of one cone in `data`. */
export const TEXTURE_STRIDE = TEXELS * 4;

/** Sides as the shaders number them. */
export const SIDE_NUMBER: Readonly<Record<Side, number>> = { left: 0, right: 1, trunk: 2 };

export class ConeTexture {
  readonly data: Float32Array;
  readonly texture: DataTexture;

  constructor(cones: number) {
    const rows = Math.max(1, cones);
    this.data = new Float32Array(rows * TEXTURE_STRIDE);
    this.texture = new DataTexture(this.data, TEXELS, rows, RGBAFormat, FloatType);
    this.texture.minFilter = this.texture.magFilter = NearestFilter;
    this.texture.needsUpdate = true;
  }

  /** Writes limb and side of the bones whose first cone has number `first`. */
  setBones(bones: readonly BoneCone[], first: number): void {
    bones.forEach((bone, i) => {
      const at = (first + i) * TEXTURE_STRIDE + 8;
      this.data[at] = bone.limb;
      this.data[at + 1] = SIDE_NUMBER[bone.side];
      this.data[at + 2] = bone.side === 'trunk' ? 1 : 0;
    });
  }

  changed(): void {
    this.texture.needsUpdate = true;
  }

  dispose(): void {
    this.texture.dispose();
  }
}
