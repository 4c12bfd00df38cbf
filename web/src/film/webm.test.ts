import { expect, test } from 'vitest';
import { sizeBytes } from './ebml';
import { WebmWriter } from './webm';

/** Elements that hold others. */
const masters = new Set([
  0x1a45dfa3, 0x18538067, 0x1549a966, 0x1654ae6b, 0xae, 0xe0, 0x55b0, 0x1c53bb6b, 0xbb, 0xb7,
  0x1f43b675,
]);

interface Element {
  readonly id: number;
  /** Of its first byte in the file, and of its content. */
  readonly at: number;
  readonly contentAt: number;
  readonly content: Uint8Array;
  readonly children: readonly Element[];
}

/** A number whose first byte says by its leading zeros how long it is. */
function variable(bytes: Uint8Array, at: number, marked: boolean): [value: number, next: number] {
  const width = Math.clz32(bytes[at]) - 23;
  let value = marked ? bytes[at] : bytes[at] & (2 ** (8 - width) - 1);
  for (let i = 1; i < width; i++) value = value * 256 + bytes[at + i];
  return [value, at + width];
}

function read(bytes: Uint8Array, from = 0, to = bytes.length): Element[] {
  const found: Element[] = [];
  for (let at = from; at < to;) {
    const [id, sizeAt] = variable(bytes, at, true);
    const [size, contentAt] = variable(bytes, sizeAt, false);
    expect(contentAt + size).toBeLessThanOrEqual(to);
    const children = masters.has(id) ? read(bytes, contentAt, contentAt + size) : [];
    const content = bytes.subarray(contentAt, contentAt + size);
    found.push({ id, at, contentAt, content, children });
    at = contentAt + size;
  }
  return found;
}

const every = (elements: readonly Element[], id: number): Element[] =>
  elements.flatMap((one) => [...(one.id === id ? [one] : []), ...every(one.children, id)]);

const number = ({ content }: Element): number =>
  content.reduce((value, byte) => value * 256 + byte, 0);

async function film(pictures: number, keyEvery: number): Promise<Element[]> {
  const writer = new WebmWriter({ codec: 'V_VP9', width: 1280, height: 720, rate_hz: 25 });
  writer.setColour({ matrix: 'bt709', transfer: 'bt709', primaries: 'bt709', fullRange: false });
  for (let n = 0; n < pictures; n++) {
    const data = Uint8Array.from({ length: 200 + n }, () => n);
    writer.add({ data, timeS: n / 25, key: n % keyEvery === 0 });
  }
  const blob = writer.finish(pictures / 25);
  expect(blob.type).toBe('video/webm');
  return read(new Uint8Array(await blob.arrayBuffer()));
}

test('sizes take as few bytes as they need, and never all ones', () => {
  expect(sizeBytes(5)).toEqual([0x85]);
  expect(sizeBytes(126)).toEqual([0xfe]);
  expect(sizeBytes(127)).toEqual([0x40, 0x7f]);
  expect(sizeBytes(2 ** 14 - 1)).toEqual([0x20, 0x3f, 0xff]);
  expect(sizeBytes(2 ** 33)).toEqual([0x0a, 0, 0, 0, 0]);
});

test('the file says its kind, its length, its size and its rate', async () => {
  const elements = await film(10, 5);
  expect(elements.map(({ id }) => id)).toEqual([0x1a45dfa3, 0x18538067]);
  const one = (id: number): Element => {
    const found = every(elements, id);
    expect(found).toHaveLength(1);
    return found[0];
  };
  expect(new TextDecoder().decode(one(0x4282).content)).toBe('webm');
  expect(new TextDecoder().decode(one(0x86).content)).toBe('V_VP9');
  const { content } = one(0x4489);
  expect(new DataView(content.buffer, content.byteOffset).getFloat64(0)).toBe(400);
  expect(number(one(0xb0))).toBe(1280);
  expect(number(one(0xba))).toBe(720);
  expect(number(one(0x23e383))).toBe(40e6);
  expect(number(one(0x55b1))).toBe(1);
});

test('every picture is there in its place, with its time and its bytes', async () => {
  const elements = await film(60, 50);
  const clusters = every(elements, 0x1f43b675);
  expect(clusters.map(({ children }) => number(children[0]))).toEqual([0, 2000]);
  const pictures = clusters.flatMap(({ children }) => {
    const begin = number(children[0]);
    return children.slice(1).map(({ content }) => ({
      timeMs: begin + new DataView(content.buffer, content.byteOffset).getInt16(1),
      key: content[3] === 0x80,
      length: content.length - 4,
      value: content[4],
    }));
  });
  expect(pictures).toEqual(
    Array.from({ length: 60 }, (_, n) => ({
      timeMs: n * 40,
      key: n % 50 === 0,
      length: 200 + n,
      value: n,
    })),
  );
});

test('the cues point at the clusters', async () => {
  const elements = await film(120, 50);
  const segment = elements[1];
  const places = every(elements, 0xf1).map(number);
  const clusters = every(elements, 0x1f43b675).map(({ at }) => at - segment.contentAt);
  expect(places).toEqual(clusters);
  expect(every(elements, 0xb3).map(number)).toEqual([0, 2000, 4000]);
});

test('a long run without keys is cut into clusters that its blocks can count in', async () => {
  const elements = await film(2000, 5000);
  const begins = every(elements, 0xe7).map(number);
  expect(begins).toEqual([0, 32_040, 64_080]);
});
