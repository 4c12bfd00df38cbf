/**
 * Many clips in, one after another; what comparing needs of each out. A clip's motion is freed before
 * the next one is read, and the bytes of the next ones arrive meanwhile.
 */
import type { PostureSequence } from './clip-feature';
import { featureLength, packFeature } from './comparison-protocol';
import { failureIn, readingError } from './failure-in';
import { incomparableOf } from './failures';
import type { SurveyGroup } from './protocol';
import type { Core, CoreClip, Survey } from './raw';
import { failedSurveys } from './survey-groups';
import { SLICE_BYTES, slicesOf } from './slices';
import type { ClipSurvey, SurveyItem } from './types';

/** Files whose bytes are on their way while another is worked on. */
const AHEAD = 4;

/** Steps until one says 1, with looks at messages between. */
type Steps = (step: () => number) => Promise<void>;

/** The surveys of the clips, in their order; a file that cannot be read says why. */
export async function surveyAll(
  core: Core,
  items: readonly SurveyItem[],
  steps: Steps,
): Promise<SurveyGroup> {
  const files = items.map(({ source }) => new FileAhead(source.blob));
  const surveys: ClipSurvey[] = [];
  for (const [index, item] of items.entries()) {
    for (const file of files.slice(index, index + AHEAD)) file.fetch();
    surveys.push(await surveyOrFailure(core, item, files[index], steps));
  }
  return packed(surveys);
}

/** A file that may be read before its turn, if it is small. */
class FileAhead {
  private readonly blob: Blob;
  private bytes: Promise<ArrayBuffer> | null = null;

  constructor(blob: Blob) {
    this.blob = blob;
  }

  fetch(): void {
    if (this.blob.size > SLICE_BYTES) return;
    this.bytes ??= this.blob.arrayBuffer();
    // Its error is thrown when its turn comes.
    this.bytes.catch(() => undefined);
  }

  async *slices(): AsyncGenerator<Uint8Array> {
    if (this.bytes === null) {
      yield* slicesOf(this.blob);
      return;
    }
    const bytes = await this.bytes;
    this.bytes = null;
    if (bytes.byteLength > 0) yield new Uint8Array(bytes);
  }
}

async function surveyOrFailure(
  core: Core,
  { id, source }: SurveyItem,
  file: FileAhead,
  steps: Steps,
): Promise<ClipSurvey> {
  const clip = core.newClip();
  try {
    await read(clip, source.blob.size, file, steps);
    clip.beginAnalysis({}, {});
    await steps(() => clip.stepSurvey());
    return surveyOf(id, clip.survey());
  } catch (error) {
    const failure = failureIn(error);
    if (failure === null) throw error;
    return failedSurveys([{ id, source }], failure)[0];
  } finally {
    clip.free();
  }
}

async function read(clip: CoreClip, bytes: number, file: FileAhead, steps: Steps): Promise<void> {
  clip.beginReading(bytes);
  try {
    for await (const slice of file.slices()) {
      await steps(() => {
        clip.push(slice);
        return 1;
      });
    }
  } catch (error) {
    throw readingError(error, false);
  }
  clip.endReading();
}

function surveyOf(id: number, { frames, frameTimeS, performers }: Survey): ClipSurvey {
  const feature = performers.find(({ comparable }) => comparable)?.comparable ?? null;
  const incomparable = feature === null ? incomparableOf(performers) : null;
  return { id, failure: null, frames, frameTimeS, feature, incomparable };
}

function packed(surveys: readonly ClipSurvey[]): SurveyGroup {
  const features = surveys.flatMap(({ feature }) => (feature === null ? [] : [feature]));
  const values = new Float64Array(features.length * featureLength);
  features.forEach((feature, index) => packFeature(feature, values, index));
  return {
    surveys: surveys.map(({ feature, ...rest }) => ({
      ...rest,
      performer: feature?.performer ?? null,
    })),
    features: values,
  };
}

/** The postures of a performer once the poses are made. */
export function posturesOf(clip: CoreClip, performer: number): PostureSequence {
  const found = clip.survey().performers[performer];
  const count = found?.analysedFrames ?? 0;
  return {
    firstFrame: found?.leadingRestFrames ?? 0,
    values: clip.postures(performer, 0, count),
  };
}
