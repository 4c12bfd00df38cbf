/**
 * The table of contents of a .zip: a Blob goes in, what its central directory says of each entry
 * comes out. Only the directory is read. Source: PKWARE APPNOTE.TXT 6.3, §4.3 and §4.5.
 */
import type { EngineFailureKind } from './failures';

export interface ZipEntry {
  /** The whole name with its folders, `/` between them. */
  readonly path: string;
  readonly encrypted: boolean;
  /** 0 stored, 8 deflated. */
  readonly method: number;
  readonly packedBytes: number;
  readonly bytes: number;
  /** Where the entry's local header begins. */
  readonly headerOffset: number;
}

/** Why a Blob is no archive that can be read; `kind` is that of the failure. */
export class ZipError extends Error {
  readonly kind: EngineFailureKind;

  constructor(kind: EngineFailureKind) {
    super(kind);
    this.name = 'ZipError';
    this.kind = kind;
  }
}

const END = 0x06054b50;
const END_BYTES = 22;
const END_64 = 0x06064b50;
const END_64_LOCATOR = 0x07064b50;
const DIRECTORY_ENTRY = 0x02014b50;
const LOCAL_HEADER = 0x04034b50;
const MAXIMUM_COMMENT_BYTES = 0xffff;
const IN_ZIP64 = 0xffffffff;
const ENCRYPTED_FLAG = 1;
const UTF8_FLAG = 0x800;

/** More entries or a longer directory than anyone packs is refused. */
const MAXIMUM_DIRECTORY_BYTES = 64 * 2 ** 20;

interface DirectoryPlace {
  readonly offset: number;
  readonly bytes: number;
}

/** The entries of an archive, in its order. */
export async function readDirectory(archive: Blob): Promise<ZipEntry[]> {
  const place = await findDirectory(archive);
  const fits = place.offset + place.bytes <= archive.size;
  if (!fits || place.bytes > MAXIMUM_DIRECTORY_BYTES) throw new ZipError('archive-damaged');
  const view = await viewOf(archive, place.offset, place.bytes);
  const entries: ZipEntry[] = [];
  let at = 0;
  while (at + 46 <= view.byteLength && view.getUint32(at, true) === DIRECTORY_ENTRY) {
    const lengths = [28, 30, 32].map((field) => view.getUint16(at + field, true));
    const end = lengths.reduce((sum, length) => sum + length, at + 46);
    if (end > view.byteLength) throw new ZipError('archive-damaged');
    entries.push(entryAt(view, at, lengths[0] ?? 0, lengths[1] ?? 0));
    at = end;
  }
  return entries;
}

/** Where an entry's packed bytes lie. */
export async function packedBytesOf(archive: Blob, entry: ZipEntry): Promise<Blob> {
  const header = await viewOf(archive, entry.headerOffset, 30);
  if (header.byteLength < 30 || header.getUint32(0, true) !== LOCAL_HEADER) {
    throw new ZipError('archive-damaged');
  }
  const names = header.getUint16(26, true) + header.getUint16(28, true);
  const start = entry.headerOffset + 30 + names;
  return archive.slice(start, start + entry.packedBytes);
}

async function findDirectory(archive: Blob): Promise<DirectoryPlace> {
  const tailBytes = Math.min(archive.size, END_BYTES + MAXIMUM_COMMENT_BYTES);
  const tailOffset = archive.size - tailBytes;
  const tail = await viewOf(archive, tailOffset, tailBytes);
  for (let at = tail.byteLength - END_BYTES; at >= 0; at -= 1) {
    if (tail.getUint32(at, true) !== END) continue;
    const bytes = tail.getUint32(at + 12, true);
    const offset = tail.getUint32(at + 16, true);
    const large = offset === IN_ZIP64 || tail.getUint16(at + 10, true) === 0xffff;
    return large ? findDirectory64(archive, tailOffset + at) : { offset, bytes };
  }
  throw new ZipError('not-an-archive');
}

/** Archives above 4 GB or 65 534 entries say the place in a record of their own. */
async function findDirectory64(archive: Blob, end: number): Promise<DirectoryPlace> {
  const locator = await viewOf(archive, end - 20, 20);
  if (locator.byteLength < 20 || locator.getUint32(0, true) !== END_64_LOCATOR) {
    throw new ZipError('archive-damaged');
  }
  const record = await viewOf(archive, Number(locator.getBigUint64(8, true)), 56);
  if (record.byteLength < 56 || record.getUint32(0, true) !== END_64) {
    throw new ZipError('archive-damaged');
  }
  return {
    bytes: Number(record.getBigUint64(40, true)),
    offset: Number(record.getBigUint64(48, true)),
  };
}

function entryAt(view: DataView, at: number, nameBytes: number, extraBytes: number): ZipEntry {
  const flags = view.getUint16(at + 8, true);
  const name = new Uint8Array(view.buffer, view.byteOffset + at + 46, nameBytes);
  const [bytes, packedBytes, headerOffset] = largeSizes(view, at, at + 46 + nameBytes, extraBytes);
  return {
    path: decodeName(name, (flags & UTF8_FLAG) !== 0),
    encrypted: (flags & ENCRYPTED_FLAG) !== 0,
    method: view.getUint16(at + 10, true),
    bytes,
    packedBytes,
    headerOffset,
  };
}

/** Size, packed size and header offset, from the ZIP64 field where the plain ones are full. */
function largeSizes(
  view: DataView,
  at: number,
  extra: number,
  extraBytes: number,
): [number, number, number] {
  const sizes: [number, number, number] = [
    view.getUint32(at + 24, true),
    view.getUint32(at + 20, true),
    view.getUint32(at + 42, true),
  ];
  const end = extra + extraBytes;
  for (let field = extra; field + 4 <= end; field += 4 + view.getUint16(field + 2, true)) {
    if (view.getUint16(field, true) !== 1) continue;
    let next = field + 4;
    sizes.forEach((size, index) => {
      if (size !== IN_ZIP64 || next + 8 > end) return;
      sizes[index] = Number(view.getBigUint64(next, true));
      next += 8;
    });
  }
  return sizes;
}

/** By the flag; else UTF-8 where it decodes (macOS sets no flag), else Shift_JIS, else Windows-1252. */
function decodeName(name: Uint8Array, isUtf8: boolean): string {
  const encodings = isUtf8 ? ['utf-8'] : ['utf-8', 'shift_jis'];
  for (const encoding of encodings) {
    try {
      return new TextDecoder(encoding, { fatal: true }).decode(name).replaceAll('\\', '/');
    } catch {
      // Not in this encoding.
    }
  }
  return new TextDecoder('windows-1252').decode(name).replaceAll('\\', '/');
}

async function viewOf(archive: Blob, offset: number, bytes: number): Promise<DataView> {
  return new DataView(await archive.slice(Math.max(0, offset), offset + bytes).arrayBuffer());
}
