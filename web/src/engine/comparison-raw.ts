/**
 * The only file that imports the generated bindings of the comparison; what comes out are copies that
 * JavaScript owns. Clips are known by their ids, items by their place in the comparison made last.
 */
import type {
  ClipFeature,
  Comparison,
  ComparisonExportKind,
  ComparisonSettings,
  Cut,
  Evaluation,
  Explanation,
  LabelledCut,
  MapPlaces,
  MatrixPicture,
  MatrixRegion,
  Neighbour,
  PostureSequence,
  Warping,
  WarpSettings,
} from './comparison-types';
import { refusing } from './core-failure';
import init, { ComparisonHandle, initSync, WarpHandle } from './generated/comparison_wasm';
import { bodyParts, type BodyPart, type ClipId } from './types';

/** The core of comparing, ready for work. */
export interface ComparisonCore {
  /** A set of its own; whoever makes it frees it, once. */
  newSet(): CoreSet;
  newWarping(a: PostureSequence, b: PostureSequence, settings: WarpSettings): CoreWarping;
  /** Bytes of the WebAssembly memory; it never shrinks. */
  memoryBytes(): number;
}

/** Clips and their comparison; all but the first five speak of the one made last. */
export interface CoreSet {
  setFeature(clip: ClipId, name: string, feature: ClipFeature): void;
  removeFeature(clip: ClipId): void;
  /** Where clips lay on a map made elsewhere. */
  recallPlaces(known: MapPlaces): void;
  begin(settings: ComparisonSettings, keepsPlaces: boolean): void;
  /** A few milliseconds of work. Returns the part done; 1 when the comparison is there. */
  step(): number;
  comparison(settings: ComparisonSettings): Comparison;
  /** Clips that it does not cover, on its map. */
  arrivals(): MapPlaces;
  cut(clusters: number): Cut;
  beginPicture(region: MatrixRegion): void;
  stepPicture(): number;
  takePicture(): MatrixPicture;
  explain(a: ClipId, b: ClipId): Explanation;
  neighbours(clip: ClipId, most: number): readonly Neighbour[];
  evaluate(labelled: LabelledCut): Evaluation;
  exportFile(kind: ComparisonExportKind, labelled: LabelledCut): Blob;
  free(): void;
}

/** Two motions on their way along each other. */
export interface CoreWarping {
  step(): number;
  warping(): Warping;
  free(): void;
}

/** Loads the module: from beside the page, or from the bytes given. */
export async function loadComparisonCore(wasm?: Uint8Array<ArrayBuffer>): Promise<ComparisonCore> {
  const { memory } = wasm === undefined ? await init() : initSync({ module: wasm });
  return {
    newSet: () => new WasmSet(),
    newWarping: (a, b, settings) => new WasmWarping(a, b, settings),
    memoryBytes: () => memory.buffer.byteLength,
  };
}

class WasmSet implements CoreSet {
  private readonly handle = new ComparisonHandle();

  setFeature(clip: ClipId, name: string, feature: ClipFeature): void {
    const { recorded, acrossRigs, recordedByJoint, acrossRigsByJoint } = feature;
    refusing(() =>
      this.handle.setFeature(clip, name, recorded, acrossRigs, recordedByJoint, acrossRigsByJoint),
    );
  }

  removeFeature(clip: ClipId): void {
    this.handle.removeFeature(clip);
  }

  recallPlaces({ clips, places }: MapPlaces): void {
    clips.forEach((clip, k) => this.handle.recallPlace(clip, places[2 * k], places[2 * k + 1]));
  }

  begin(settings: ComparisonSettings, keepsPlaces: boolean): void {
    refusing(() => this.handle.begin(settings, keepsPlaces));
  }

  step(): number {
    return refusing(() => this.handle.step());
  }

  comparison(settings: ComparisonSettings): Comparison {
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

  arrivals(): MapPlaces {
    return { clips: this.handle.arrivals(), places: this.handle.arrivalPlaces() };
  }

  cut(clusters: number): Cut {
    return refusing(() => {
      const clusterOfItem = this.handle.cut(clusters);
      const found = clusterOfItem.reduce((most, one) => Math.max(most, one + 1), 0);
      return { clusters: found, clusterOfItem, height: this.handle.cutHeight(found) };
    });
  }

  beginPicture({ order, most, ...region }: MatrixRegion): void {
    const rows = order.subarray(region.firstRow, region.firstRow + region.rowCount);
    const columns = order.subarray(region.firstColumn, region.firstColumn + region.columnCount);
    refusing(() => this.handle.beginPicture(rows, columns, most));
  }

  stepPicture(): number {
    return refusing(() => this.handle.stepPicture());
  }

  takePicture(): MatrixPicture {
    const rows = this.handle.pictureRows();
    const columns = this.handle.pictureColumns();
    return { rows, columns, values: this.handle.takePicture() };
  }

  explain(a: ClipId, b: ClipId): Explanation {
    const found = JSON.parse(refusing(() => this.handle.explain(a, b))) as ExplanationText;
    const { partShares, shares, ...rest } = found;
    const ofParts = bodyParts.map((part, index) => [part, partShares[index] ?? 0] as const);
    return {
      ...rest,
      a,
      b,
      shares: Float64Array.from(shares),
      partShares: Object.fromEntries(ofParts) as Record<BodyPart, number>,
    };
  }

  neighbours(clip: ClipId, most: number): readonly Neighbour[] {
    return JSON.parse(refusing(() => this.handle.neighbours(clip, most))) as Neighbour[];
  }

  evaluate({ clusters, labels }: LabelledCut): Evaluation {
    const { names, numbers } = numbered(labels);
    const text = refusing(() => this.handle.evaluate(numbers, clusters));
    const { single, ...rest } = JSON.parse(text) as EvaluationText;
    return { ...rest, labels: names, single: single.map((label) => names[label] ?? '') };
  }

  exportFile(kind: ComparisonExportKind, { clusters, labels }: LabelledCut): Blob {
    const { names, numbers } = numbered(labels);
    const bytes = refusing(() => this.handle.exportFile(kind, names, numbers, clusters));
    return new Blob([bytes as Uint8Array<ArrayBuffer>]);
  }

  free(): void {
    this.handle.free();
  }
}

function treeOf(handle: ComparisonHandle): Comparison['tree'] {
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

interface ExplanationText extends Omit<Explanation, 'a' | 'b' | 'shares' | 'partShares'> {
  readonly shares: readonly number[];
  readonly partShares: readonly number[];
}

interface EvaluationText extends Omit<Evaluation, 'labels' | 'single'> {
  readonly single: readonly number[];
}

class WasmWarping implements CoreWarping {
  private readonly handle: WarpHandle;
  private readonly a: PostureSequence;
  private readonly b: PostureSequence;

  constructor(a: PostureSequence, b: PostureSequence, { band, mirrorB }: WarpSettings) {
    this.a = a;
    this.b = b;
    this.handle = refusing(() => new WarpHandle(a.values, b.values, band, mirrorB));
  }

  step(): number {
    return refusing(() => this.handle.step());
  }

  /** The core counts from the first posture, the page from the file's first frame. */
  warping(): Warping {
    const { handle, a, b } = this;
    return refusing(() => ({
      distance: handle.distance(),
      pathA: handle.pathA().map((frame) => frame + a.firstFrame),
      pathB: handle.pathB().map((frame) => frame + b.firstFrame),
      ahead: handle.ahead(),
      partDistances: handle.partDistances(),
      fullColour: handle.fullColour(),
    }));
  }

  free(): void {
    this.handle.free();
  }
}
