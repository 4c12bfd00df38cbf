/**
 * Unpacking: an archive goes in as a Blob, its motion files come out one by one, each as a Blob of its
 * own. Bytes are read and unpacked in slices, with a turn between them.
 */
import { Inflate } from 'fflate';
import { failureOf } from './failures';
import type { UnpackedEntry } from './protocol';
import type { Failure } from './types';
import { type ZipEntry, ZipError, packedBytesOf, readDirectory } from './zip-directory';

export interface UnzipListener {
  /** Settled once the entry has arrived. */
  entry(entry: UnpackedEntry): Promise<void>;
  entryFailure(name: string, failure: Failure): Promise<void>;
  /** 0 to 1. */
  progress(done: number): void;
  /** Lets messages in; throws when the work is cancelled. */
  turn(): Promise<void>;
}

/** What an archive may unpack to: one file, and all of them; a bomb is refused before it fills memory. */
export interface UnzipLimits {
  readonly entryBytes: number;
  readonly archiveBytes: number;
}

export const UNZIP_LIMITS: UnzipLimits = { entryBytes: 2 ** 30, archiveBytes: 2 ** 32 };

/** Packed bytes read at once. */
const SLICE_BYTES = 2 ** 21;

/** Packed bytes unpacked between two turns: 64 MB at the worst, 1 032 times as much. */
const STEP_BYTES = 2 ** 16;

const STORED = 0;
const DEFLATED = 8;

/** Unpacks the entries that end in `.bvh`; one that cannot be is reported, and the others go on. */
export async function unzipMotions(
  archive: Blob,
  listener: UnzipListener,
  limits = UNZIP_LIMITS,
): Promise<void> {
  const entries = (await readDirectory(archive)).filter(isMotion);
  if (entries.length === 0) throw new ZipError('archive-without-motions');
  const packedTotal = entries.reduce((sum, entry) => sum + entry.packedBytes, 0);
  let packedDone = 0;
  let left = limits.archiveBytes;
  for (const entry of entries) {
    const limit = Math.min(limits.entryBytes, left);
    const blob = await unpackOrReport(archive, entry, limit, listener);
    if (blob !== null) {
      left -= blob.size;
      await listener.entry({ ...splitPath(entry.path), blob });
    }
    packedDone += entry.packedBytes;
    listener.progress(packedTotal === 0 ? 1 : packedDone / packedTotal);
  }
}

/** Whether an entry is a motion file; macOS adds a folder of shadows with the same names. */
function isMotion({ path }: ZipEntry): boolean {
  return /\.bvh$/i.test(path) && !path.startsWith('__MACOSX/');
}

function splitPath(path: string): { name: string; folder: string } {
  const end = path.lastIndexOf('/');
  return { name: path.slice(end + 1), folder: path.slice(0, Math.max(0, end)) };
}

async function unpackOrReport(
  archive: Blob,
  entry: ZipEntry,
  limit: number,
  listener: UnzipListener,
): Promise<Blob | null> {
  try {
    return await unpack(archive, entry, limit, listener);
  } catch (error) {
    if (!(error instanceof ZipError)) throw error;
    await listener.entryFailure(entry.path, failureOf(error.kind));
    return null;
  }
}

async function unpack(
  archive: Blob,
  entry: ZipEntry,
  limit: number,
  listener: UnzipListener,
): Promise<Blob> {
  if (entry.encrypted) throw new ZipError('archive-entry-encrypted');
  if (entry.bytes > limit) throw new ZipError('archive-too-large');
  const packed = await packedBytesOf(archive, entry);
  if (entry.method === STORED) return packed;
  if (entry.method !== DEFLATED) throw new ZipError('archive-entry-method');
  return inflate(packed, limit, listener);
}

async function inflate(packed: Blob, limit: number, listener: UnzipListener): Promise<Blob> {
  const parts: BlobPart[] = [];
  let bytes = 0;
  let ended = false;
  const inflater = new Inflate((part, final) => {
    bytes += part.length;
    ended = final;
    // The size in the directory may lie: what really comes out counts.
    if (bytes > limit) throw new ZipError('archive-too-large');
    parts.push(new Uint8Array(part));
  });
  for (let at = 0; at < packed.size; at += SLICE_BYTES) {
    const slice = new Uint8Array(await packed.slice(at, at + SLICE_BYTES).arrayBuffer());
    for (let step = 0; step < slice.length; step += STEP_BYTES) {
      const last = at + step + STEP_BYTES >= packed.size;
      pushInto(inflater, slice.subarray(step, step + STEP_BYTES), last);
      await listener.turn();
    }
  }
  if (!ended) throw new ZipError('archive-damaged');
  return new Blob(parts);
}

function pushInto(inflater: Inflate, slice: Uint8Array<ArrayBuffer>, last: boolean): void {
  try {
    inflater.push(slice, last);
  } catch (error) {
    throw error instanceof ZipError ? error : new ZipError('archive-damaged');
  }
}
