/** What is compared of a clip: plain data that the engine gives and the comparison takes. */

/** What a comparison needs of a clip: the features of its first human performer. */
export interface ClipFeature {
  readonly performer: number;
  /** 12 numbers in squared body heights: means of σxx σyy σzz σxy σyz σzx, then deviations. */
  readonly recorded: Float64Array;
  /** The same on a body of standard lengths. */
  readonly acrossRigs: Float64Array;
  /** 16 joints × 12: what each joint adds. */
  readonly recordedByJoint: Float64Array;
  readonly acrossRigsByJoint: Float64Array;
}

/** The postures of one performer in time, and the frame of the file where they begin. */
export interface PostureSequence {
  readonly firstFrame: number;
  /** Frames × 16 joints × 3, in body heights. */
  readonly values: Float64Array;
}
