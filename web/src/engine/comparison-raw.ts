/**
 * The only file that imports the generated bindings of the comparison; what comes out are copies that
 * JavaScript owns. Clips are known by their ids, items by their place in the comparison made last.
 */
import type * as Compare from './comparison-types';
import { refusing } from './core-failure';
import init, { ComparisonHandle, initSync, WarpHandle } from './generated/comparison_wasm';
import { bodyParts, type BodyPart, type ClipId } from './types';

/** The core of comparing, ready for work. */
export interface ComparisonCore {
  /** A set of its own; whoever makes it frees it, once. */
  newSet(): CoreSet;
  newWarping(
    a: Compare.PostureSequence,
    b: Compare.PostureSequence,
    settings: Compare.WarpSettings,
  ): CoreWork<Compare.Warping>;
  /** Bytes of the WebAssembly memory; it never shrinks. */
  memoryBytes(): number;
}

/** Clips and their comparison; all but the first five speak of the one made last. */
export interface CoreSet {
  setFeature(clip: ClipId, name: string, feature: Compare.ClipFeature): void;
  removeFeatures(clips: Int32Array): void;
  /** Where clips lay on a map made elsewhere. */
  recallPlaces(known: Compare.MapPlaces): void;
  begin(settings: Compare.ComparisonSettings, keepsPlaces: boolean): void;
  /** A few milliseconds of work. Returns the part done; 1 when the comparison is there. */
  step(): number;
  free(): void;
  comparison(settings: Compare.ComparisonSettings): Compare.Comparison;
  /** Clips that it does not cover, on its map. */
  arrivals(): Compare.MapPlaces;
  cut(clusters: number): Compare.Cut;
  neighbours(clip: ClipId, most: number): readonly Compare.Neighbour[];
  picture(region: Compare.MatrixRegion): CoreWork<Compare.MatrixPicture>;
  explain(a: ClipId, b: ClipId): CoreWork<Compare.Explanation>;
  evaluate(labelled: Compare.LabelledCut): CoreWork<Compare.Evaluation>;
  file(kind: Compare.ComparisonExportKind, labelled: Compare.LabelledCut): CoreWork<Blob>;
}

/** Work of the core in pieces; whoever begins it frees it, once. It speaks of what was when it began. */
export interface CoreWork<T> {
  /** A few milliseconds of work. Returns the part done; 1 when the result is there. */
  step(): number;
  /** The result, once. */
  take(): T;
  free(): void;
}

/** Loads the module: from beside the page, or from the bytes given. */
export async function loadComparisonCore(wasm?: Uint8Array<ArrayBuffer>): Promise<ComparisonCore> {
  const { memory } = wasm === undefined ? await init() : initSync({ module: wasm });
  return {
    newSet: () => new WasmSet(),
    newWarping: warpingOf,
    memoryBytes: () => memory.buffer.byteLength,
  };
}

class WasmSet implements CoreSet {
  private readonly handle = new ComparisonHandle();

  setFeature(clip: ClipId, name: string, feature: Compare.ClipFeature): void {
    const { recorded, acrossRigs, recordedByJoint, acrossRigsByJoint } = feature;
    refusing(() =>
      this.handle.setFeature(clip, name, recorded, acrossRigs, recordedByJoint, acrossRigsByJoint),
    );
  }

  removeFeatures(clips: Int32Array): void {
    this.handle.removeFeatures(clips);
  }

  recallPlaces({ clips, places }: Compare.MapPlaces): void {
    clips.forEach((clip, k) => this.handle.recallPlace(clip, places[2 * k], places[2 * k + 1]));
  }

  begin(settings: Compare.ComparisonSettings, keepsPlaces: boolean): void {
    refusing(() => this.handle.begin(settings, keepsPlaces));
  }

  step(): number {
    return refusing(() => this.handle.step());
  }

  comparison(settings: Compare.ComparisonSettings): Compare.Comparison {
    const { handle } = this;
    return refusing(() => {
      const [pairs, automaticClusters, legendMaximum, maximum, spread] = handle.numbers();
      return {
        settings,
        clips: handle.clips(),
        pairs,
        tree: treeOf(handle),
        automaticClusters,
        legendMaximum,
        maximum,
        nearest: handle.nearest(),
        nearestDistances: handle.nearestDistances(),
        map: handle.map(),
        spread,
      };
    });
  }

  arrivals(): Compare.MapPlaces {
    return { clips: this.handle.arrivals(), places: this.handle.arrivalPlaces() };
  }

  cut(clusters: number): Compare.Cut {
    return refusing(() => {
      const clusterOfItem = this.handle.cut(clusters);
      const found = clusterOfItem.reduce((most, one) => Math.max(most, one + 1), 0);
      return { clusters: found, clusterOfItem, height: this.handle.cutHeight(found) };
    });
  }

  picture({ order, most, ...region }: Compare.MatrixRegion): CoreWork<Compare.MatrixPicture> {
    const rows = order.subarray(region.firstRow, region.firstRow + region.rowCount);
    const columns = order.subarray(region.firstColumn, region.firstColumn + region.columnCount);
    const handle = refusing(() => this.handle.picture(rows, columns, most));
    return workOf(handle, () => ({
      rows: handle.rows(),
      columns: handle.columns(),
      values: handle.takeValues(),
    }));
  }

  explain(a: ClipId, b: ClipId): CoreWork<Compare.Explanation> {
    const handle = refusing(() => this.handle.explain(a, b));
    return workOf(handle, () => explanationOf(a, b, handle.text()));
  }

  neighbours(clip: ClipId, most: number): readonly Compare.Neighbour[] {
    return JSON.parse(refusing(() => this.handle.neighbours(clip, most))) as Compare.Neighbour[];
  }

  evaluate({ clusters, labels }: Compare.LabelledCut): CoreWork<Compare.Evaluation> {
    const { names, numbers } = numbered(labels);
    const handle = refusing(() => this.handle.evaluate(numbers, clusters));
    return workOf(handle, () => evaluationOf(names, handle.takeText()));
  }

  file(
    kind: Compare.ComparisonExportKind,
    { clusters, labels }: Compare.LabelledCut,
  ): CoreWork<Blob> {
    const { names, numbers } = numbered(labels);
    const handle = refusing(() => this.handle.file(kind, names, numbers, clusters));
    // A Blob is not kept in the memory of the worker: a large file may be larger than that.
    const parts: Blob[] = [];
    const step = (): number => {
      const done = handle.step();
      const part = handle.takePart() as Uint8Array<ArrayBuffer>;
      if (part.length > 0) parts.push(new Blob([part]));
      return done;
    };
    return workOf({ step, free: () => handle.free() }, () => new Blob(parts));
  }

  free(): void {
    this.handle.free();
  }
}

function treeOf(handle: ComparisonHandle): Compare.Comparison['tree'] {
  return {
    left: handle.left(),
    right: handle.right(),
    heights: handle.heights(),
    sizes: handle.sizes(),
    leaves: handle.leaves(),
    orderIsOptimal: handle.orderIsOptimal(),
  };
}

/** Labels as numbers in order of their first item; −1: none. */
function numbered(labels: readonly (string | null)[]): {
  readonly names: string[];
  readonly numbers: Int32Array;
} {
  const places = new Map<string, number>();
  const numbers = Int32Array.from(labels, (label) => {
    if (label === null) return -1;
    const place = places.get(label) ?? places.size;
    places.set(label, place);
    return place;
  });
  return { names: [...places.keys()], numbers };
}

interface ExplanationText extends Omit<Compare.Explanation, 'a' | 'b' | 'shares' | 'partShares'> {
  readonly shares: readonly number[];
  readonly partShares: readonly number[];
}

function explanationOf(a: ClipId, b: ClipId, text: string): Compare.Explanation {
  const { partShares, shares, ...rest } = JSON.parse(text) as ExplanationText;
  const ofParts = bodyParts.map((part, index) => [part, partShares[index] ?? 0] as const);
  return {
    ...rest,
    a,
    b,
    shares: Float64Array.from(shares),
    partShares: Object.fromEntries(ofParts) as Record<BodyPart, number>,
  };
}

interface EvaluationText extends Omit<Compare.Evaluation, 'labels' | 'single'> {
  readonly single: readonly number[];
}

function evaluationOf(labels: readonly string[], text: string): Compare.Evaluation {
  const { single, ...rest } = JSON.parse(text) as EvaluationText;
  return { ...rest, labels, single: single.map((label) => labels[label] ?? '') };
}

/** A handle of the core as work whose result `result` takes out of it. */
function workOf<T>(handle: { step(): number; free(): void }, result: () => T): CoreWork<T> {
  return {
    step: () => refusing(() => handle.step()),
    take: () => refusing(result),
    free: () => handle.free(),
  };
}

/** The core counts from the first posture, the page from the file's first frame. */
function warpingOf(
  a: Compare.PostureSequence,
  b: Compare.PostureSequence,
  { band, mirrorB }: Compare.WarpSettings,
): CoreWork<Compare.Warping> {
  const handle = refusing(() => new WarpHandle(a.values, b.values, band, mirrorB));
  return workOf(handle, () => ({
    distance: handle.distance(),
    pathA: handle.pathA().map((frame) => frame + a.firstFrame),
    pathB: handle.pathB().map((frame) => frame + b.firstFrame),
    ahead: handle.ahead(),
    partDistances: handle.partDistances(),
    fullColour: handle.fullColour(),
  }));
}
