// What the stage asks of WebGL, watched from outside. In: a page before it opens. Out: calls and triangles of
// the last frame, frames in all, vectors of uniforms.
import type { Page } from '@playwright/test';

export interface Drawn {
  /** Draw calls of the last frame. */
  readonly calls: number;
  /** Triangles of each of these calls. */
  readonly triangles: readonly number[];
  readonly frames: number;
  /** Of the hungriest program. */
  readonly uniformVectors: number;
}

/** To be called before the page opens. `paints`: whether calls reach WebGL, which takes long without a GPU. */
export async function watchDrawing(
  page: Page,
  { paints = true } = {},
): Promise<() => Promise<Drawn>> {
  await page.addInitScript(install, paints);
  return () => page.evaluate(() => (window as unknown as { drawn: Drawn }).drawn);
}

/** Runs in the page. */
function install(paints: boolean): void {
  const drawn = { calls: 0, triangles: [] as number[], frames: 0, uniformVectors: 0 };
  Object.assign(window, { drawn });
  const add = (count: number): void => {
    drawn.calls++;
    drawn.triangles.push(count / 3);
  };
  type Call = (gl: WebGL2RenderingContext, values: readonly unknown[]) => void;
  const wrap = (
    name: keyof WebGL2RenderingContext,
    call: Call,
    when: 'before' | 'after' | 'instead',
  ): void => {
    const prototype = WebGL2RenderingContext.prototype as unknown as Record<string, unknown>;
    const own = prototype[name] as (...values: unknown[]) => unknown;
    prototype[name] = function (this: WebGL2RenderingContext, ...values: unknown[]): unknown {
      if (when !== 'after') call(this, values);
      if (when === 'instead') return undefined;
      const result = Reflect.apply(own, this, values);
      if (when === 'after') call(this, values);
      return result;
    };
  };
  // three.js clears the canvas once a frame.
  wrap(
    'clear',
    () => {
      Object.assign(drawn, { calls: 0, triangles: [], frames: drawn.frames + 1 });
    },
    'before',
  );
  const when = paints ? 'before' : 'instead';
  wrap('drawArrays', (_, [, , count]) => add(Number(count)), when);
  wrap('drawElements', (_, [, count]) => add(Number(count)), when);
  wrap('drawElementsInstanced', (_, [, count, , , n]) => add(Number(count) * Number(n)), when);
  wrap(
    'linkProgram',
    (gl, [program]) => {
      const vectors = vectorsOf(gl, program as WebGLProgram);
      drawn.uniformVectors = Math.max(drawn.uniformVectors, vectors);
    },
    'after',
  );

  function vectorsOf(gl: WebGL2RenderingContext, program: WebGLProgram): number {
    let vectors = 0;
    const uniforms = Number(gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS));
    for (let i = 0; i < uniforms; i++) {
      const { size = 0, type = 0 } = gl.getActiveUniform(program, i) ?? {};
      vectors += size * (type === gl.FLOAT_MAT4 ? 4 : type === gl.FLOAT_MAT3 ? 3 : 1);
    }
    return vectors;
  }
}
