/**
 * Changes of clips in, one new list of clips out. What comes for one clip after another while many are
 * read waits for its neighbours: each new list costs the page as much as it has clips.
 */
import type { ClipId, ClipSource } from '../engine/types';
import { newClip, type Clip } from './clips';
import type { Store } from './store';

type Fields = Partial<Clip>;

/** The page may spend so much of its time on changes that can wait. */
const waitForCost = 8;
const leastWaitMs = 16;
const mostWaitMs = 250;

interface Waiting {
  readonly fields: Map<ClipId, Fields>;
  timer: ReturnType<typeof setTimeout> | null;
  waitMs: number;
}

const waitingOf = new WeakMap<Store, Waiting>();

function waiting(store: Store): Waiting {
  const known = waitingOf.get(store);
  if (known) return known;
  const made = { fields: new Map<ClipId, Fields>(), timer: null, waitMs: leastWaitMs };
  waitingOf.set(store, made);
  return made;
}

/** Changes some fields of one clip, and whatever waits. */
export function patchClip(store: Store, id: ClipId, fields: Fields): void {
  patchClips(store, [[id, fields]]);
}

/** The same for several at once. */
export function patchClips(
  store: Store,
  changes: Iterable<readonly [ClipId, Fields]>,
  added: readonly Clip[] = [],
): void {
  const before = store.clips.peek();
  const next = [...before, ...added];
  const late = waiting(store).fields;
  for (const [id, fields] of [...late, ...changes]) {
    if (next[id]) next[id] = { ...next[id], ...fields };
  }
  late.clear();
  store.clips.value = next;
}

/** Changes some fields of one clip a moment later, together with others. */
export function patchClipSoon(store: Store, id: ClipId, fields: Fields): void {
  const late = waiting(store);
  late.fields.set(id, { ...late.fields.get(id), ...fields });
  late.timer ??= setTimeout(() => {
    late.timer = null;
    const start = performance.now();
    flushClips(store);
    const cost = performance.now() - start;
    late.waitMs = Math.min(mostWaitMs, Math.max(leastWaitMs, cost * waitForCost));
  }, late.waitMs);
}

/** Makes the changes that wait. */
export function flushClips(store: Store): void {
  if (waiting(store).fields.size > 0) patchClips(store, []);
}

/** A clip with the changes that wait. */
export function clipNow(store: Store, id: ClipId): Clip | undefined {
  const clip = store.clips.peek()[id];
  const fields = clip && waiting(store).fields.get(id);
  return fields ? { ...clip, ...fields } : clip;
}

/** Adds clips for these sources, in their order. */
export function addClips(store: Store, sources: readonly ClipSource[]): readonly Clip[] {
  const first = store.clips.peek().length;
  const added = sources.map((source, index) => newClip(first + index, source));
  patchClips(store, [], added);
  return added;
}
