/** Names of clips in; how they are told apart and shortened out. */
import type { ClipId } from '../engine/types';
import type { Clip } from './clips';

function numbered(clips: readonly Clip[]): (readonly [ClipId, string])[] {
  return clips.map((clip, index) => [clip.id, `(${index + 1})`] as const);
}

function qualified(namesakes: readonly Clip[]): (readonly [ClipId, string])[] {
  const byFolder = groupBy(namesakes, ({ source }) => source.folder);
  return [...byFolder].flatMap(([folder, clips]) => {
    if (clips.length === 1) return [[clips[0].id, folder] as const];
    return numbered(clips).map(([id, number]) => [id, `${folder} ${number}`.trim()] as const);
  });
}

function groupBy<T>(items: readonly T[], key: (item: T) => string): Map<string, T[]> {
  const groups = new Map<string, T[]>();
  for (const item of items) {
    const group = groups.get(key(item));
    if (group) group.push(item);
    else groups.set(key(item), [item]);
  }
  return groups;
}

/** For clips that share their name: the folder or a number that tells them apart. */
export function qualifiers(clips: readonly Clip[]): ReadonlyMap<ClipId, string> {
  const byName = groupBy(clips, ({ source }) => source.name);
  const shared = [...byName.values()].filter((namesakes) => namesakes.length > 1);
  return new Map(shared.flatMap(qualified));
}

/** A name after what tells it from its namesakes; the qualifier may be empty. */
export const qualifiedName = (name: string, qualifier = ''): string =>
  qualifier === '' ? name : `${qualifier} ${name}`;

/** Letters that always show, the ending of the file among them. */
const tailLength = 9;

/** A name in two parts: the first may be cut short, the second, at most `tail` letters, always shows. */
export function splitName(name: string, tail = tailLength): readonly [string, string] {
  const signs = [...name];
  const cut = Math.max(0, signs.length - Math.min(tail, Math.floor(signs.length / 2)));
  return [signs.slice(0, cut).join(''), signs.slice(cut).join('')];
}
