/** The words and numbers that the timeline shows, in the reader's language. */
export interface TimelineText {
  readonly timeline: string;
  readonly pins: string;
  readonly time: string;
  readonly timeUnits: string;
  readonly speed: string;
  readonly speedUnit: string;
  readonly playhead: string;
  /** Seconds with a fixed number of digits, without the unit. */
  seconds(timeS: number, digits: number): string;
  /** A whole number in the language's digits. */
  count(value: number): string;
  /** A motion speed as shown in the gutter. */
  speedValue(bodyHeightsPerSecond: number): string;
  /** "Keypose 3 of 11, 2.82 seconds". */
  keypose(index: number, count: number, timeS: number): string;
  /** "Keyposes 3 to 5 of 11". */
  keyposes(first: number, last: number, count: number): string;
  /** "2.817 seconds, frame 338". */
  moment(frame: number, timeS: number): string;
}
