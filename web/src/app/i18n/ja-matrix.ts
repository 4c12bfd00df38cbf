/** The sentences of the matrix, the tree and the map in Japanese; the keys are those of `en-matrix.ts`. */
import type { Message } from './message';
import type { englishMatrix } from './en-matrix';

export const japaneseMatrix: Readonly<Record<keyof typeof englishMatrix, Message>> = {
  'compare.page': '比較',
  'compare.too-few': '人体の動きが二つあれば比較できます。もう一つドロップしてください。',
  'compare.waiting': '二つ読み込まれしだい、ここで比較します。',
  'compare.progress': '比較中 {0} %',
  'compare.pairs': '{0} 組',
  'compare.apart': '対象外 {0} 件',
  'compare.apart.about': '比較できないクリップ：',
  'compare.apart.pose': 'フレームが一つだけ',
  'compare.apart.skeleton': 'フレームがない',
  'compare.apart.not-human': '人体ではない',
  'compare.apart.unknown': '比べられる動きがない',
  'compare.apart.more': '… ほか {0} 件',

  'legend.alike': '似ている',
  'legend.different': '違う',
  'legend.range': '0～{0}',
  'legend.range.clipped': '0～{0} 以上',
  'legend.label': '色：0（似ている）から {0}（違う）まで。最大の距離は {1}',

  'order.label': '行列の並び順',
  'order.tree': '樹形図',
  'order.by-label': 'ラベル',
  'order.name': '名前',
  'order.top-only':
    '1,000 件を超えると、樹形図の上部だけを最適に並べ、その中は近い側を外に向けます。',

  'matrix.label': '距離行列',
  'matrix.help':
    '矢印キーで組を移動、Space で選択、Enter で並べて見る、＋と－で拡大縮小、0 で全体。',
  'matrix.pair': '{0} と {1}、{2}、{4} 組中 {3} 番目',
  'matrix.pair.unranked': '{0} と {1}、{2}',
  'matrix.itself': '{0} 自身',
  'matrix.rank': '{1} 組中 {0} 番目',
  'matrix.rank.only': 'ただ一つの組',
  'matrix.with': 'と',
  'matrix.open': '開く',
  'matrix.mirrored': '左右反転',
  'matrix.zoom-in': '拡大',
  'matrix.zoom-out': '縮小',
  'matrix.zoom-all': '全体を表示',

  'tree.label': 'クリップの樹形図',
  'tree.cut': '樹形図の切断',
  'tree.clusters': '{0} クラスタ',
  'tree.auto': '自動',
  'tree.auto.about': '見つかったクラスタ数（{0}）に戻す',

  'names.label': '行列の順のクリップ',
  'names.no-label': 'ラベルなし',
  'names.help': 'Enter で一つ目、Shift+Enter で二つ目のクリップを選びます。',

  'map.title': '地図',
  'map.spread': '広がりの {0} %',
  'map.spread.about':
    'クリップどうしの違いのうち、地図に残る割合です。残りを示すには二次元では足りません。',
  'map.expand': '地図を広げる',
  'map.shrink': '地図を元の大きさに戻す',
  'map.zoom-all': '地図全体を表示',
  'map.label': 'クリップの地図：近いほど似ている',
  'map.help':
    '矢印キーでその方向の最も近いクリップへ、Enter で一つ目、Shift+Enter で二つ目のクリップを選びます。',
  'map.point': '{0}、{1}、クラスタ {2}',
  'map.point.arrived': '{0}、{1}、まだ比較していません',
  'map.cluster': 'クラスタ {0}',
  'map.arrived': 'まだ比較していません',
  'map.legend': 'ラベル',
};
