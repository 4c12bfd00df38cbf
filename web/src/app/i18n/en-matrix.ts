/** The sentences of the matrix, the tree and the map in English. */
import type { Message } from './message';

export const englishMatrix = {
  'compare.page': 'Compare',
  'compare.too-few': 'Two clips with a human body can be compared: drop another.',
  'compare.waiting': 'As soon as two clips are read they are compared here.',
  'compare.progress': 'Comparing, {0} %',
  'compare.pairs': { one: '{0} pair', other: '{0} pairs' },
  'compare.apart': { one: '{0} clip stands apart', other: '{0} clips stand apart' },
  'compare.apart.about': 'They cannot be compared:',
  'compare.apart.pose': 'one frame only',
  'compare.apart.skeleton': 'no frames',
  'compare.apart.not-human': 'not a human body',
  'compare.apart.unknown': 'no movement to compare',
  'compare.apart.more': { one: '… and {0} more', other: '… and {0} more' },

  'legend.alike': 'alike',
  'legend.different': 'different',
  'legend.range': '0 – {0}',
  'legend.range.clipped': '0 – {0} or more',
  'legend.label': 'Colours: from 0, alike, to {0}, different; the largest distance is {1}',

  'order.label': 'Order of the matrix',
  'order.tree': 'Tree',
  'order.by-label': 'Label',
  'order.name': 'Name',
  'order.top-only':
    'Above 1,000 clips the order is optimal in the upper part of the tree; inside it, the nearer side is turned outward.',

  'matrix.label': 'Matrix of distances',
  'matrix.help':
    'Arrow keys go from pair to pair, Space selects, Enter opens the pair, plus and minus zoom, 0 shows all.',
  'matrix.pair': '{0} with {1}, {2}, {3} of {4} pairs',
  'matrix.pair.unranked': '{0} with {1}, {2}',
  'matrix.itself': '{0} with itself',
  'matrix.rank': '{0} of {1} pairs',
  'matrix.rank.only': 'the only pair',
  'matrix.with': 'with',
  'matrix.open': 'open',
  'matrix.mirrored': 'mirrored',
  'matrix.zoom-in': 'Zoom in',
  'matrix.zoom-out': 'Zoom out',
  'matrix.zoom-all': 'Show all',

  'tree.label': 'Tree of the clips',
  'tree.cut': 'Cut of the tree',
  'tree.clusters': { one: '{0} cluster', other: '{0} clusters' },
  'tree.auto': 'auto',
  'tree.auto.about': 'Back to the number of clusters that was found ({0})',

  'names.label': 'Clips in the order of the matrix',
  'names.no-label': 'no label',
  'names.help': 'Enter chooses the first clip of the pair, Shift+Enter the second.',

  'map.title': 'Map',
  'map.spread': '{0} % of the spread',
  'map.spread.about':
    'The map keeps so much of the differences between the clips; the rest needs more than two dimensions.',
  'map.expand': 'Enlarge the map',
  'map.shrink': 'Back to the small map',
  'map.zoom-all': 'Show the whole map',
  'map.label': 'Map of the clips: near is alike',
  'map.help':
    'Arrow keys go to the nearest clip in that direction, Enter chooses the first clip of the pair, Shift+Enter the second.',
  'map.point': '{0}, {1}, cluster {2}',
  'map.point.arrived': '{0}, {1}, not compared yet',
  'map.cluster': 'cluster {0}',
  'map.arrived': 'not compared yet',
  'map.legend': 'Labels',
} satisfies Readonly<Record<string, Message>>;
