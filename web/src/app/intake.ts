/**
 * What was dropped or picked in; the motion files in it out, one by one: files, the files of folders
 * at any depth, archives. What else lies in a folder is passed over; what else was given by itself is told.
 */
import { letMessagesIn } from '../engine/turns';
import type { ClipSource } from '../engine/types';

/** One thing given: a file, or a folder with everything in it. */
export type Given =
  | { readonly file: File; readonly folder: string }
  | { readonly directory: FileSystemDirectoryEntry };

export interface IntakeEvents {
  readonly onSource: (source: ClipSource) => void;
  readonly onArchive: (archive: ClipSource) => Promise<void>;
  /** A file given by itself that is neither a motion nor an archive. */
  readonly onOther: (name: string) => void;
  /** A folder without a motion. */
  readonly onEmpty: (name: string) => void;
}

/** Leaves out the resource forks that macOS puts beside files. */
export const isMotionName = (name: string): boolean =>
  /\.bvh$/i.test(name) && !name.startsWith('._');
const isArchiveName = (name: string): boolean => /\.zip$/i.test(name);

const naturalOrder = new Intl.Collator(undefined, { numeric: true });

/** Must run while the drop event is handled: afterwards the browser has forgotten the items. */
export function givenByDrop(transfer: DataTransfer): Given[] {
  const items = [...transfer.items].filter(({ kind }) => kind === 'file');
  return items.flatMap((item): Given[] => {
    const entry = item.webkitGetAsEntry();
    if (entry?.isDirectory) return [{ directory: entry as FileSystemDirectoryEntry }];
    const file = item.getAsFile();
    return file ? [{ file, folder: '' }] : [];
  });
}

/** Files of an input; those of a folder input know their path. */
export function givenByInput(files: Iterable<File>): Given[] {
  return [...files].flatMap((file): Given[] => {
    const path = file.webkitRelativePath;
    if (path && !isMotionName(file.name)) return [];
    return [{ file, folder: path.split('/').slice(0, -1).join('/') }];
  });
}

/** All entries of a folder: a reader gives at most a hundred at a time, then an empty list. */
export async function allEntries(
  reader: Pick<FileSystemDirectoryReader, 'readEntries'>,
): Promise<FileSystemEntry[]> {
  const all: FileSystemEntry[] = [];
  for (;;) {
    const some = await new Promise<FileSystemEntry[]>((resolve, reject) =>
      reader.readEntries(resolve, reject),
    );
    if (some.length === 0) return all.sort((a, b) => naturalOrder.compare(a.name, b.name));
    all.push(...some);
  }
}

const fileOf = (entry: FileSystemFileEntry): Promise<File> =>
  new Promise((resolve, reject) => entry.file(resolve, reject));

interface Found {
  readonly entry: FileSystemEntry;
  readonly folder: string;
  file?: Promise<File>;
}

/** Files asked for together, since each answer takes its time, however small the file. */
const filesTogether = 16;

/**
 * Asks for a file and the next ones, in a task of its own: while questions are open the browser goes on
 * handing over answers, thousands of them in one task.
 */
async function askTogether(next: readonly Found[]): Promise<void> {
  await letMessagesIn();
  for (const found of next) {
    if (found.entry.isDirectory || !isMotionName(found.entry.name)) continue;
    found.file = fileOf(found.entry as FileSystemFileEntry);
    // Its error is thrown when its turn comes.
    found.file.catch(() => undefined);
  }
}

/** The motions of a folder and of those in it. */
export async function* motionsIn(directory: FileSystemDirectoryEntry): AsyncGenerator<ClipSource> {
  const waiting: Found[] = [{ entry: directory, folder: '' }];
  for (let next = waiting.pop(); next; next = waiting.pop()) {
    const { entry, folder } = next;
    if (entry.isDirectory) {
      const inside = folder ? `${folder}/${entry.name}` : entry.name;
      const entries = await allEntries((entry as FileSystemDirectoryEntry).createReader());
      waiting.push(...entries.reverse().map((child) => ({ entry: child, folder: inside })));
    } else if (isMotionName(entry.name)) {
      if (!next.file) await askTogether([...waiting.slice(1 - filesTogether), next]);
      if (next.file) yield { name: entry.name, folder, blob: await next.file };
    }
  }
}

async function takeFolder(
  directory: FileSystemDirectoryEntry,
  events: IntakeEvents,
  signal: AbortSignal,
): Promise<void> {
  let found = 0;
  for await (const source of motionsIn(directory)) {
    if (signal.aborted) return;
    events.onSource(source);
    found += 1;
  }
  if (found === 0) events.onEmpty(directory.name);
}

async function takeFile({ name, ...rest }: ClipSource, events: IntakeEvents): Promise<void> {
  if (isMotionName(name)) events.onSource({ name, ...rest });
  else if (isArchiveName(name)) await events.onArchive({ name, ...rest });
  else events.onOther(name);
}

/** The page answers in between when many files are given: asking a file for its size may take 0.5 ms. */
const turnMs = 10;

/** Goes through everything given, in order; ends early after an abort. */
export async function takeIn(
  given: readonly Given[],
  events: IntakeEvents,
  signal: AbortSignal,
): Promise<void> {
  let turnedMs = performance.now();
  for (const item of given) {
    if (performance.now() - turnedMs > turnMs) {
      await letMessagesIn();
      turnedMs = performance.now();
    }
    if (signal.aborted) return;
    if ('directory' in item) await takeFolder(item.directory, events, signal);
    else await takeFile({ name: item.file.name, folder: item.folder, blob: item.file }, events);
  }
}
