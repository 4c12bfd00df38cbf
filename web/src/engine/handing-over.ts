/**
 * Handing results over without a copy: a value goes in, the buffers of its arrays come out.
 */

/** The buffers of all typed arrays in a value of plain objects and arrays. */
export function buffersOf(value: unknown): ArrayBuffer[] {
  const buffers = new Set<ArrayBuffer>();
  collect(value, buffers);
  return [...buffers];
}

function collect(value: unknown, buffers: Set<ArrayBuffer>): void {
  if (typeof value !== 'object' || value === null || value instanceof Blob) return;
  if (ArrayBuffer.isView(value)) {
    if (value.buffer instanceof ArrayBuffer) buffers.add(value.buffer);
    return;
  }
  for (const member of Object.values(value)) collect(member, buffers);
}
