/** Notes and failures in English by kind, those of the core word for word as it tells them. */
export const englishNotes: Readonly<Record<string, string>> = {
  encoding: 'The text is {0}, not UTF-8; names were decoded from it.',
  'unnamed-joint': 'A joint has no name; it is called {0}.',
  'relative-positions':
    'The positions of {0} are tiny against its OFFSET; they were added to it instead of replacing it.',
  'several-performers': 'The file has {0} ROOTs; each is a performer of its own.',
  'repeated-hierarchy': 'A second HIERARCHY stands here; it was read as a further performer.',
  'alternating-rows':
    'Rows are as wide as one performer and there are {0} for each frame; they were taken in turns.',
  'frames-without-motion': '“Frames:” stands without MOTION; the motion was taken to start here.',
  'missing-motion': 'MOTION is missing; the motion was taken to start at the first row of numbers.',
  'motion-without-frames': 'MOTION has no “Frames:” line; the rows present were counted ({0}).',
  'frame-count': '“Frames:” says {0}, {1} complete rows are present; the rows present were used.',
  'incomplete-last-row': 'The last row has {0} of {1} values; it was left out.',
  'wrapped-rows':
    'Rows are wrapped over several lines; the values were read as one stream, {0} to a frame.',
  'skipped-channel':
    'The channel {0} of {1} is neither a position nor a rotation; its values were skipped.',
  'partial-position': '{0} has {1} position channels; the other components come from its OFFSET.',
  'text-after-motion': 'Text after the last row was ignored: {0}',
  'frame-time-missing': '“Frame Time:” is missing; 1/30 s was assumed.',
  'frame-time-invalid': 'The frame time “{0}” is not usable; 1/30 s was assumed.',
  'frame-time-is-rate': 'The frame time {0} was taken as frames per second.',
  'frame-time-is-milliseconds': 'The frame time {0} was taken as milliseconds.',
  'frame-time-is-seconds': 'The frame time {0} was taken as seconds, though it is long.',
  'not-a-number':
    'Values that are not numbers: {0} (first: {1}); the joints hold their previous value.',
  'decimal-comma': 'Numbers are written with a decimal comma; it was read as a point.',
  'channel-count': 'CHANNELS of {0} says {1}, {2} names follow; the names were counted.',
  'missing-end-site': '{0} has no End Site.',
  'missing-offset': '{0} has no OFFSET; zero was assumed.',
  'offset-not-a-number':
    'The OFFSET of {0} holds “{1}”, which is no number; zero was assumed for it.',
  'missing-brace': 'A closing brace is missing; the hierarchy was closed at {0}.',
  'missing-hierarchy': 'The keyword HIERARCHY is missing; the file was read from its first ROOT.',
  'unknown-line': 'A line was not understood and ignored: {0}',
  'further-notes': '{0} more notes of the kind “{1}” were left out.',
  'no-motion': 'The file has no motion; only the skeleton is shown.',
  'too-short': 'Too few frames to find keyposes: {0}.',
  'not-human':
    'This is not a human body ({0}); all joints are analysed in root coordinates, and it is not compared with human motions.',
  mirrored:
    'Left and right look swapped against the direction of feet and knees; the names were kept.',
  'end-effector-fallback': '{0} has no usable end; {1} stands for it.',
  'end-sites-unequal':
    "The End Sites of left and right differ too much; none of this file's End Sites was used.",
  'shifted-arm-names':
    'The names of the arms are shifted by one joint; the shape was followed instead.',
  'shifted-leg-names':
    'The names of the legs are shifted by one joint; the shape was followed instead.',
  'hips-together':
    'The hips lie together in the OFFSETs; their mean places in the motion were used.',
  'rest-is-no-body':
    "The OFFSETs are no standing body; the trunk's length was taken from the motion.",
  'no-left-and-right': 'There is no left and right in the hips; root coordinates were used.',
  'trunk-from-motion':
    "The trunk's direction in the OFFSETs is unusable; the mean of the motion was used.",
  'leading-t-pose': 'A T-pose stands before the motion; leading frames left out: {0}.',
  'leading-blended-t-pose': 'A T-pose is blended into the motion; leading frames left out: {0}.',
  'leading-jump': 'The motion begins with a jump: frame 0 was left out.',
  'leading-by-hand': 'Leading frames left out by hand: {0}.',
  discontinuity: 'The motion jumps here: a step of {0} body heights in one frame.',
  'low-pass-left-out':
    'The cut-off of {0} Hz is not below half the frame rate; the low-pass filter was left out.',
  'scales-left-out':
    'Time scales at or above half the frame rate were left out; the finest is {0} Hz.',
  'up-assumed': 'The up axis is not clear from the motion; +Y was assumed.',
  'unit-unknown': 'No unit makes this a body of usual height; lengths are shown in body heights.',
};

export const englishFailures: Readonly<Record<string, string>> = {
  empty: 'The file is empty; a BVH file begins with HIERARCHY. Export the motion again.',
  'not-bvh':
    'Found “{0}” where HIERARCHY was expected; without the skeleton the numbers have no meaning. Choose a BVH file, or export the motion again with its hierarchy.',
  'no-root':
    'Found the end of the hierarchy where a ROOT was expected. Export the motion again with its skeleton.',
  'expected-brace': 'Found “{0}” where “{” was expected for {1}. Put the brace there.',
  'joint-outside-root':
    'Found {0} outside of any ROOT; every joint belongs to one. Look for a closing brace too many above.',
  'short-offset': 'The OFFSET of {0} has {1} numbers, 3 were expected. Write x, y and z.',
  'no-channels':
    'Found a row of numbers, but no joint has CHANNELS. Add them, or export the motion again.',
  'not-a-number': 'Found “{0}” where a number was expected. Correct or remove it.',
  'short-row':
    'Found {0} values in this row where {1} were expected, one for each channel. Complete the row, or export the motion again.',
  'long-row':
    'Found a further value in this row after the {0} that were expected, one for each channel. Remove what is too much, or export the motion again.',
  'text-between-rows': 'Found “{0}” between two rows of numbers. Remove it.',
  'mixed-decimal-marks':
    'Found “{0}”, but the file writes numbers with a decimal {1} elsewhere. Use one of them throughout.',
  'too-many-joints':
    'The file has more than {0} joints, the limit. Remove joints that are not needed.',
  'long-hierarchy':
    'The hierarchy is longer than {0} bytes, the limit. Check that this is a BVH file.',
  'too-many-values': 'The file has more than {0} values, the limit. Cut it into shorter motions.',
  'out-of-memory':
    'The memory does not suffice for {0} more values. Close other motions, or cut this one into shorter ones.',
  'archive-damaged': 'The archive is damaged. Download or pack it again.',
  'archive-entry-encrypted': 'This file of the archive is encrypted. Unpack it first.',
  'archive-entry-method':
    'This file of the archive is packed in a way that cannot be opened here. Unpack it first.',
  'archive-too-large': 'The archive is too large to be opened here. Unpack it first.',
  'archive-without-motions': 'The archive holds no BVH files.',
  'changed-on-disk': 'The file has changed on disk since it was opened. Drop it again.',
  'compared-again': 'The clips have been compared again meanwhile. Try again.',
  'comparison-stopped':
    'The comparison stopped unexpectedly; the clips are not affected. It begins again with the next change.',
  'engine-unavailable': 'The analysis could not be started: {0}',
  'no-such-sample': 'There is no sample {0}.',
  'not-an-archive': 'This is not a .zip archive.',
  'not-open': 'The clip has been closed.',
  'not-human-to-compare': 'This is not a human body; it is not compared with human motions.',
  'too-many-pairs':
    'The group average of {0} clips needs {1} MB of memory, more than the browser gives. Choose Ward’s method, or drop fewer clips.',
  'too-short-to-compare': 'A single pose is no motion; comparing needs two frames or more.',
  'not-readable': 'The browser could not read the file. Drop it again.',
  'worker-died': 'The work on this file ended unexpectedly; the other files are not affected.',
  setting: '{0} is {1}; expected {2}.',
  internal: 'Something unexpected went wrong: {0}',
};
