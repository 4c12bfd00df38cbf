import { expect, test } from 'vitest';
import {
  allEntries,
  isMotionName,
  motionsIn,
  takeIn,
  type Given,
  type IntakeEvents,
} from './intake';

type Tree = { readonly [name: string]: Tree | string };

/** A folder as browsers give it: at most a hundred entries at a time. */
function folder(name: string, tree: Tree): FileSystemDirectoryEntry {
  const entries = Object.entries(tree).map(([child, content]) =>
    typeof content === 'string' ? file(child, content) : folder(child, content),
  );
  const createReader = () => {
    let at = 0;
    const readEntries = (give: (some: unknown[]) => void) => give(entries.slice(at, (at += 100)));
    return { readEntries };
  };
  return {
    name,
    isDirectory: true,
    isFile: false,
    createReader,
  } as unknown as FileSystemDirectoryEntry;
}

function file(name: string, content: string) {
  const give = (take: (value: File) => void) => take(new File([content], name));
  return { name, isDirectory: false, isFile: true, file: give };
}

async function taken(
  given: readonly Given[],
  signal = new AbortController().signal,
): Promise<string[]> {
  const log: string[] = [];
  const events: IntakeEvents = {
    onSource: ({ name, folder: where }) => void log.push(`motion ${where}|${name}`),
    onArchive: ({ name }) => Promise.resolve(void log.push(`archive ${name}`)),
    onOther: (name) => void log.push(`other ${name}`),
    onEmpty: (name) => void log.push(`empty ${name}`),
  };
  await takeIn(given, events, signal);
  return log;
}

const given = (name: string): Given => ({ file: new File(['x'], name), folder: '' });

test('a folder of 250 files is read to its end', async () => {
  const tree = Object.fromEntries(Array.from({ length: 250 }, (_, i) => [`${i}.bvh`, 'x']));
  const entries = await allEntries(folder('many', tree).createReader());
  expect(entries).toHaveLength(250);
  expect(entries.slice(0, 3).map(({ name }) => name)).toEqual(['0.bvh', '1.bvh', '2.bvh']);
});

test('motions come from any depth, in order, with their folder', async () => {
  const tree = {
    'b.bvh': 'x',
    a: { 'deep.BVH': 'x', 'notes.txt': 'x' },
    'readme.md': 'x',
    '._b.bvh': 'x',
  };
  const names: string[] = [];
  for await (const { folder: where, name } of motionsIn(folder('set', tree)))
    names.push(`${where}/${name}`);
  expect(names).toEqual(['set/a/deep.BVH', 'set/b.bvh']);
});

test('what is in a folder is passed over, what is given by itself is told', async () => {
  const log = await taken([
    given('walk.bvh'),
    given('notes.txt'),
    given('set.zip'),
    { directory: folder('pictures', { 'a.png': 'x' }) },
    { directory: folder('set', { 'a.bvh': 'x', 'b.txt': 'x' }) },
  ]);
  expect(log).toEqual([
    'motion |walk.bvh',
    'other notes.txt',
    'archive set.zip',
    'empty pictures',
    'motion set|a.bvh',
  ]);
});

test('after an abort nothing more is taken', async () => {
  const abort = new AbortController();
  abort.abort();
  expect(await taken([given('walk.bvh')], abort.signal)).toEqual([]);
});

test('motions go by their suffix', () => {
  expect(isMotionName('花笠踊り.bvh')).toBe(true);
  expect(isMotionName('take.BVH')).toBe(true);
  expect(isMotionName('bvh')).toBe(false);
  expect(isMotionName('._take.bvh')).toBe(false);
});
