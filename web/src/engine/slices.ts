/**
 * A file in slices: a Blob goes in, its bytes come out piece by piece, the next one being read while
 * the last one is worked on. Nothing is ever held whole.
 */

/** Bytes of a slice: 4 MB. */
export const SLICE_BYTES = 4 * 2 ** 20;

/** The slices of a Blob, in order. */
export async function* slicesOf(blob: Blob, sliceBytes = SLICE_BYTES): AsyncGenerator<Uint8Array> {
  const read = (at: number) => blob.slice(at, at + sliceBytes).arrayBuffer();
  let next = blob.size > 0 ? read(0) : null;
  for (let at = sliceBytes; next !== null; at += sliceBytes) {
    const bytes = await next;
    next = at < blob.size ? read(at) : null;
    // An error of the reading ahead is thrown when its turn comes, not as an unhandled one before.
    next?.catch(() => undefined);
    yield new Uint8Array(bytes);
  }
}
