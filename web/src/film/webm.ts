/**
 * Encoded pictures in; a WebM file out. One track of pictures is all there is (Matroska, RFC 9559, within
 * the WebM guidelines). Clusters go to the browser as they are full; what stands before them is written
 * last, when everything is known: the file has its length and can be searched at once.
 */
import { type Bytes, float, head, joined, master, text, unsigned } from './ebml';

export interface WebmTrack {
  readonly codec: 'V_VP8' | 'V_VP9';
  readonly width: number;
  readonly height: number;
  readonly rate_hz: number;
}

export interface WebmPicture {
  readonly data: Bytes;
  readonly timeS: number;
  /** It needs no other; a cluster begins with it. */
  readonly key: boolean;
}

/** As WebCodecs tells them. */
export interface WebmColour {
  readonly matrix?: string | null;
  readonly transfer?: string | null;
  readonly primaries?: string | null;
  readonly fullRange?: boolean | null;
}

/** Times count in milliseconds. */
const SCALE_NS = 1e6;
/** A block counts its time from its cluster's in 16 bits with a sign. */
const LONGEST_CLUSTER_MS = 32_000;
const TRACK = 1;
/** Bytes of a cluster's place: the same whatever it is. */
const PLACE_WIDTH = 8;

/** ITU-T H.273. */
const MATRICES: Readonly<Record<string, number>> = { rgb: 0, bt709: 1, bt470bg: 5, smpte170m: 6 };
const TRANSFERS: Readonly<Record<string, number>> = { bt709: 1, smpte170m: 6, 'iec61966-2-1': 13 };
const PRIMARIES: Readonly<Record<string, number>> = { bt709: 1, bt470bg: 5, smpte170m: 6 };
const UNSPECIFIED = 2;

interface Cue {
  readonly timeMs: number;
  /** From the first cluster. */
  readonly place: number;
}

export class WebmWriter {
  private readonly clusters: Blob[] = [];
  private readonly cues: Cue[] = [];
  private blocks: Bytes[] = [];
  private beginMs = 0;
  private written = 0;
  private colour: WebmColour = {};

  constructor(private readonly track: WebmTrack) {}

  setColour(colour: WebmColour): void {
    this.colour = colour;
  }

  /** In the order of their times. */
  add({ data, timeS, key }: WebmPicture): void {
    const timeMs = Math.round(timeS * 1000);
    if (key || timeMs - this.beginMs > LONGEST_CLUSTER_MS) this.beginCluster(timeMs);
    this.blocks.push(blockHead(data.length, timeMs - this.beginMs, key), data);
  }

  finish(lengthS: number): Blob {
    this.endCluster();
    const content = [info(lengthS), this.tracks()];
    const before = content.reduce((sum, { length }) => sum + length, 0);
    const cuesLength = cuesElement(this.cues, 0).length;
    content.push(cuesElement(this.cues, before + cuesLength));
    const front = joined(content);
    const parts = [fileHead(), head(0x18538067, front.length + this.written), front];
    return new Blob([...parts, ...this.clusters], { type: 'video/webm' });
  }

  private beginCluster(timeMs: number): void {
    this.endCluster();
    this.beginMs = timeMs;
    this.cues.push({ timeMs, place: this.written });
  }

  /** The bytes of a full cluster become the browser's, which may keep them on the disk. */
  private endCluster(): void {
    if (this.blocks.length === 0) return;
    const content = [unsigned(0xe7, this.beginMs), ...this.blocks];
    const size = content.reduce((sum, { length }) => sum + length, 0);
    const cluster = new Blob([head(0x1f43b675, size), ...content]);
    this.clusters.push(cluster);
    this.written += cluster.size;
    this.blocks = [];
  }

  private tracks(): Bytes {
    const { codec, width, height, rate_hz } = this.track;
    const entry = master(
      0xae,
      unsigned(0xd7, TRACK),
      unsigned(0x73c5, TRACK),
      unsigned(0x83, 1),
      unsigned(0x9c, 0),
      unsigned(0x23e383, Math.round(1e9 / rate_hz)),
      text(0x86, codec),
      master(0xe0, unsigned(0xb0, width), unsigned(0xba, height), colourElement(this.colour)),
    );
    return master(0x1654ae6b, entry);
  }
}

function fileHead(): Bytes {
  return master(
    0x1a45dfa3,
    unsigned(0x4286, 1),
    unsigned(0x42f7, 1),
    unsigned(0x42f2, 4),
    unsigned(0x42f3, 8),
    text(0x4282, 'webm'),
    unsigned(0x4287, 4),
    unsigned(0x4285, 2),
  );
}

function info(lengthS: number): Bytes {
  return master(
    0x1549a966,
    unsigned(0x2ad7b1, SCALE_NS),
    float(0x4489, lengthS * 1000),
    text(0x4d80, 'Keypose'),
    text(0x5741, 'Keypose'),
  );
}

function colourElement({ matrix, transfer, primaries, fullRange }: WebmColour): Bytes {
  const code = (codes: Readonly<Record<string, number>>, name?: string | null): number =>
    codes[name ?? ''] ?? UNSPECIFIED;
  return master(
    0x55b0,
    unsigned(0x55b1, code(MATRICES, matrix)),
    unsigned(0x55b9, fullRange ? 2 : 1),
    unsigned(0x55ba, code(TRANSFERS, transfer)),
    unsigned(0x55bb, code(PRIMARIES, primaries)),
  );
}

/** `first`: where the first cluster begins, from the segment's content. */
function cuesElement(cues: readonly Cue[], first: number): Bytes {
  const points = cues.map(({ timeMs, place }) =>
    master(
      0xbb,
      unsigned(0xb3, timeMs),
      master(0xb7, unsigned(0xf7, TRACK), unsigned(0xf1, first + place, PLACE_WIDTH)),
    ),
  );
  return master(0x1c53bb6b, ...points);
}

/** A SimpleBlock up to its data: the track, the time from the cluster's, whether it is a key. */
function blockHead(dataLength: number, timeMs: number, key: boolean): Bytes {
  const time = [(timeMs >> 8) & 0xff, timeMs & 0xff];
  const about = Uint8Array.from([0x80 | TRACK, ...time, key ? 0x80 : 0]);
  return joined([head(0xa3, about.length + dataLength), about]);
}
