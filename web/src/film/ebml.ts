/** Identifiers and values in; elements of EBML (RFC 8794) as bytes out. */

export type Bytes = Uint8Array<ArrayBuffer>;

const LONGEST = 8;

/** Big-endian; in as many bytes as it needs, or in `width`. */
function bigEndian(value: number, width?: number): number[] {
  const bytes: number[] = [];
  for (let rest = value; rest > 0 || bytes.length === 0; rest = Math.floor(rest / 256))
    bytes.unshift(rest % 256);
  while (bytes.length < (width ?? 0)) bytes.unshift(0);
  return bytes;
}

/** A size: the first byte's leading zeros tell how many bytes follow. All ones would mean "unknown". */
export function sizeBytes(size: number): number[] {
  let width = 1;
  while (width < LONGEST && size >= 2 ** (7 * width) - 1) width++;
  const bytes = bigEndian(size, width);
  bytes[0] |= 2 ** (8 - width);
  return bytes;
}

/** The beginning of an element whose content comes elsewhere. */
export const head = (id: number, size: number): Bytes =>
  Uint8Array.from([...bigEndian(id), ...sizeBytes(size)]);

export function joined(parts: readonly Bytes[]): Bytes {
  const all = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

export function master(id: number, ...children: readonly Bytes[]): Bytes {
  const content = joined(children);
  return joined([head(id, content.length), content]);
}

/** `width` bytes where the length must not depend on the value. */
export const unsigned = (id: number, value: number, width?: number): Bytes =>
  master(id, Uint8Array.from(bigEndian(value, width)));

export function float(id: number, value: number): Bytes {
  const content = new Uint8Array(8);
  new DataView(content.buffer).setFloat64(0, value);
  return master(id, content);
}

export const text = (id: number, value: string): Bytes =>
  master(id, new TextEncoder().encode(value));
