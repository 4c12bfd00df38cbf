/**
 * Files in; whether the same file was given before, and as which clip, out. Size and date are looked at
 * only of files with one path: the browser may have to ask the disk for them.
 */
import type { ClipId, ClipSource } from '../engine/types';

interface Known {
  readonly source: ClipSource;
  id: ClipId | null;
}

function isSame(a: ClipSource, b: ClipSource): boolean {
  if (a.blob.size !== b.blob.size) return false;
  if (!(a.blob instanceof File) || !(b.blob instanceof File)) return true;
  return a.blob.lastModified === b.blob.lastModified;
}

export class KnownSources {
  private readonly byPath = new Map<string, Known[]>();

  /** What is known of a file; it is known from now on, without a clip at first. */
  of(source: ClipSource): Known {
    const path = `${source.folder}/${source.name}`;
    const namesakes = this.byPath.get(path) ?? [];
    this.byPath.set(path, namesakes);
    const known = namesakes.find((one) => isSame(one.source, source));
    if (known) return known;
    const added: Known = { source, id: null };
    namesakes.push(added);
    return added;
  }
}

export type { Known };
