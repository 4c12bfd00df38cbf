// Files that the page has written, read again by the plain rules of their formats. In: text or bytes. Out:
// tables, arrays, merges, sizes.

/** RFC 4180: rows end with CRLF, a quote within quotes is doubled. */
export function csvRows(text: string): string[][] {
  const rows: string[][] = [];
  for (const line of text.matchAll(/((?:"(?:[^"]|"")*"|[^"\r\n])*)\r\n/g)) {
    const fields = [...(line[1] ?? '').matchAll(/(?:^|,)("(?:[^"]|"")*"|[^,]*)/g)];
    rows.push(
      fields.map(([, field = '']) =>
        field.startsWith('"') ? field.slice(1, -1).replaceAll('""', '"') : field,
      ),
    );
  }
  return rows;
}

export interface NumpyArray {
  readonly shape: readonly number[];
  readonly values: Float64Array;
}

/** An array of 64-bit floats, version 1.0 of the format. */
export function readNpy(bytes: Uint8Array): NumpyArray {
  const head = new TextDecoder('latin1').decode(bytes.subarray(0, 10));
  if (!head.startsWith('\x93NUMPY\x01\x00')) throw new Error('no .npy file');
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  const start = 10 + view.getUint16(8, true);
  const header = new TextDecoder('latin1').decode(bytes.subarray(10, start));
  const found = /^\{'descr': '<f8', 'fortran_order': False, 'shape': \((.*)\), \} *\n$/.exec(
    header,
  );
  if (!found || start % 64 !== 0) throw new Error(`the header ${header}`);
  const shape = (found[1] ?? '').split(',').filter(Boolean).map(Number);
  const count = (bytes.length - start) / 8;
  if (count !== shape.reduce((a, b) => a * b, 1)) throw new Error('values are missing');
  const values = Float64Array.from({ length: count }, (_, k) =>
    view.getFloat64(start + 8 * k, true),
  );
  return { shape, values };
}

export interface Branch {
  /** Of a leaf. */
  readonly name: string | null;
  readonly children: readonly Branch[];
  readonly length: number;
}

/** Felsenstein's rules: a quoted name has its quotes doubled. */
export function readNewick(text: string): Branch {
  let at = 0;
  const take = (pattern: RegExp): string => {
    pattern.lastIndex = at;
    const [found = ''] = pattern.exec(text) ?? [];
    at += found.length;
    return found;
  };
  const branch = (): Branch => {
    const children: Branch[] = [];
    if (take(/\(/y)) {
      do children.push(branch());
      while (take(/,/y));
      if (!take(/\)/y)) throw new Error(`no end of a cluster at ${at}`);
    }
    const quoted = take(/'(?:[^']|'')*'/y);
    const name = quoted ? quoted.slice(1, -1).replaceAll("''", "'") : take(/[^(),:;']+/y);
    const length = take(/:/y) ? Number(take(/[^(),:;]+/y)) : 0;
    return { name: children.length > 0 ? null : name, children, length };
  };
  const root = branch();
  if (text.slice(at).trim() !== ';') throw new Error(`what follows the tree: ${text.slice(at)}`);
  return root;
}

export interface Cluster {
  /** Sorted. */
  readonly names: readonly string[];
  readonly height: number;
}

/** The clusters of two leaves and more, each with the height of its merge. */
export function clustersOf(root: Branch): Cluster[] {
  const found: Cluster[] = [];
  const visit = (branch: Branch): Cluster => {
    if (branch.name !== null) return { names: [branch.name], height: 0 };
    const below = branch.children.map((child) => ({ child, cluster: visit(child) }));
    const heights = below.map(({ child, cluster }) => cluster.height + child.length);
    const names = below.flatMap(({ cluster }) => cluster.names).sort();
    const cluster = { names, height: Math.max(...heights) };
    if (Math.max(...heights) - Math.min(...heights) > 1e-9)
      throw new Error('branches of one merge differ');
    found.push(cluster);
    return cluster;
  };
  visit(root);
  return found;
}

/** SciPy's merges as clusters of names. */
export function clustersOfMerges(
  names: readonly string[],
  merges: readonly (readonly number[])[],
): Cluster[] {
  const all: Cluster[] = names.map((name) => ({ names: [name], height: 0 }));
  for (const [a = 0, b = 0, height = 0] of merges) {
    const members = [a, b].flatMap((item) => all[item]?.names ?? []);
    all.push({ names: members.sort(), height });
  }
  return all.slice(names.length);
}

/** Width and height of a PNG in pixels. */
export function pngSize(bytes: Uint8Array): { width: number; height: number } {
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  if (view.getBigUint64(0) !== 0x89504e470d0a1a0an) throw new Error('no PNG');
  return { width: view.getUint32(16), height: view.getUint32(20) };
}
