/** In: WebGL programs. Out: how many vectors of four numbers the hungriest takes as uniforms. */

export function uniformVectors(
  gl: WebGL2RenderingContext,
  programs: readonly WebGLProgram[],
): number {
  return Math.max(0, ...programs.map((program) => vectorsOf(gl, program)));
}

function vectorsOf(gl: WebGL2RenderingContext, program: WebGLProgram): number {
  const count = Number(gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS));
  let vectors = 0;
  for (let i = 0; i < count; i++) {
    const info = gl.getActiveUniform(program, i);
    if (info) vectors += info.size * rowsOf(gl, info.type);
  }
  return vectors;
}

/** Rows of a matrix; everything else takes one vector, the worst case. */
function rowsOf(gl: WebGL2RenderingContext, type: number): number {
  if (type === gl.FLOAT_MAT4) return 4;
  if (type === gl.FLOAT_MAT3) return 3;
  return type === gl.FLOAT_MAT2 ? 2 : 1;
}
