/** Notes and failures in Japanese by kind; the places `{0}`, `{1}` … are those of the core's sentences. */
export const japaneseNotes: Readonly<Record<string, string>> = {
  encoding: 'テキストは UTF-8 ではなく {0} です。名前はそれとして読みました。',
  'unnamed-joint': '名前のない関節があります。{0} と呼びます。',
  'relative-positions':
    '{0} の位置は OFFSET に比べてごく小さいため、置き換えずに OFFSET に加えました。',
  'several-performers': 'ファイルに ROOT が {0} 個あります。それぞれ別の演者です。',
  'repeated-hierarchy': 'ここに 2 つめの HIERARCHY があります。別の演者として読みました。',
  'alternating-rows': '行の幅は演者 1 人分で、1 フレームに {0} 行あります。順番に割り当てました。',
  'frames-without-motion': 'MOTION なしに「Frames:」があります。ここから動きが始まるとしました。',
  'motion-without-frames': 'MOTION に「Frames:」の行がありません。実際の行を数えました（{0}）。',
  'frame-count': '「Frames:」は {0}、完全な行は {1} です。実際の行を使いました。',
  'incomplete-last-row': '最後の行の値は {1} 個中 {0} 個です。この行は除きました。',
  'wrapped-rows':
    '1 行が複数の行に折り返されています。1 フレーム {0} 個の続いた値として読みました。',
  'skipped-channel': '{1} のチャンネル {0} は位置でも回転でもありません。その値は飛ばしました。',
  'partial-position': '{0} の位置チャンネルは {1} 個です。残りの成分は OFFSET から取りました。',
  'text-after-motion': '最後の行の後の文字は無視しました：{0}',
  'frame-time-missing': '「Frame Time:」がありません。1/30 秒としました。',
  'frame-time-invalid': 'フレーム時間「{0}」は使えません。1/30 秒としました。',
  'frame-time-is-rate': 'フレーム時間 {0} は毎秒のフレーム数と見なしました。',
  'frame-time-is-milliseconds': 'フレーム時間 {0} はミリ秒と見なしました。',
  'frame-time-is-seconds': 'フレーム時間 {0} は長いですが、秒と見なしました。',
  'not-a-number': '数でない値が {0} 個あります（最初：{1}）。関節は直前の値を保ちます。',
  'decimal-comma': '小数点にコンマが使われています。ピリオドとして読みました。',
  'channel-count': '{0} の CHANNELS は {1} ですが、名前は {2} 個あります。名前の数に従いました。',
  'missing-end-site': '{0} に End Site がありません。',
  'missing-offset': '{0} に OFFSET がありません。ゼロとしました。',
  'offset-not-a-number': '{0} の OFFSET に数でない「{1}」があります。ゼロとしました。',
  'missing-brace': '閉じ括弧が足りません。{0} で階層を閉じました。',
  'missing-hierarchy': 'HIERARCHY の語がありません。最初の ROOT から読みました。',
  'unknown-line': '理解できない行を無視しました：{0}',
  'missing-motion': 'MOTION がありません。最初の数の行から動きが始まるとしました。',
  'further-notes': '種類「{1}」の注記があと {0} 件ありますが、省きました。',
  'shifted-leg-names': '脚の名前が関節 1 つ分ずれています。形の方に従いました。',
  'no-motion': 'ファイルに動きがありません。骨格だけを示します。',
  'too-short': '{0} フレームでは短すぎてキーポーズを探せません。',
  'not-human':
    '人の体ではありません（{0}）。すべての関節を根の座標で解析し、人の動きとは比べません。',
  mirrored: '足と膝の向きから見ると左右が入れ替わっているようです。名前はそのままにしました。',
  'end-effector-fallback': '{0} に使える末端がありません。{1} で代えました。',
  'end-sites-unequal':
    '左右の End Site の違いが大きすぎます。このファイルの End Site は使いませんでした。',
  'shifted-arm-names': '腕の名前が関節 1 つ分ずれています。形の方に従いました。',
  'hips-together': 'OFFSET では左右の股関節が重なっています。動きの中の平均の位置を使いました。',
  'rest-is-no-body': 'OFFSET は立った体になっていません。胴の長さは動きから取りました。',
  'no-left-and-right': '股関節から左右が決まりません。根の座標を使いました。',
  'trunk-from-motion': 'OFFSET の胴の向きは使えません。動きの平均を使いました。',
  'leading-t-pose': '動きの前に T ポーズがあります。冒頭の {0} フレームを除きました。',
  'leading-blended-t-pose': 'T ポーズが動きに溶け込んでいます。冒頭の {0} フレームを除きました。',
  'leading-jump': '動きが跳びから始まります。フレーム 0 を除きました。',
  'leading-by-hand': '冒頭の {0} フレームを手動で除きました。',
  discontinuity: 'ここで動きが跳びます。1 フレームで身長の {0} 倍動きます。',
  'low-pass-left-out':
    '遮断周波数 {0} Hz はフレームレートの半分より低くありません。低域通過フィルターは省きました。',
  'scales-left-out':
    'フレームレートの半分以上の時間スケールは省きました。最も細かいものは {0} Hz です。',
  'up-assumed': '動きから上の軸がはっきりしません。+Y としました。',
  'unit-unknown': 'どの単位でも普通の身長になりません。長さは身長を単位として示します。',
};

export const japaneseFailures: Readonly<Record<string, string>> = {
  empty: 'ファイルが空です。BVH ファイルは HIERARCHY で始まります。もう一度書き出してください。',
  'not-bvh':
    'HIERARCHY があるはずの所に「{0}」があります。骨格がなければ数値に意味がありません。BVH ファイルを選ぶか、階層を付けて書き出し直してください。',
  'no-root': 'ROOT があるはずの所で階層が終わっています。骨格を付けて書き出し直してください。',
  'expected-brace': '{1} のための「{」があるはずの所に「{0}」があります。括弧を入れてください。',
  'joint-outside-root':
    '{0} がどの ROOT にも属していません。上に余分な閉じ括弧がないか調べてください。',
  'short-offset': '{0} の OFFSET の数は {1} 個です。3 個（x、y、z）必要です。',
  'no-channels':
    '数の行がありますが、どの関節にも CHANNELS がありません。加えるか、書き出し直してください。',
  'not-a-number': '数があるはずの所に「{0}」があります。直すか消してください。',
  'short-row':
    'この行の値は {0} 個ですが、チャンネルごとに 1 個、{1} 個必要です。補うか、書き出し直してください。',
  'long-row':
    'この行には必要な {0} 個より多くの値があります。余分を消すか、書き出し直してください。',
  'text-between-rows': '数の行の間に「{0}」があります。消してください。',
  'mixed-decimal-marks':
    '「{0}」がありますが、ほかの所では小数の印に「{1}」が使われています。どちらかに揃えてください。',
  'too-many-joints': '関節が上限の {0} 個を超えています。要らない関節を除いてください。',
  'long-hierarchy': '階層が上限の {0} バイトより長いです。BVH ファイルかどうか確かめてください。',
  'too-many-values': '値が上限の {0} 個を超えています。短い動きに分けてください。',
  'out-of-memory':
    'あと {0} 個の値のためのメモリーが足りません。ほかの動きを閉じるか、短い動きに分けてください。',
  'archive-damaged': '書庫が壊れています。もう一度ダウンロードするか、作り直してください。',
  'archive-entry-encrypted': '書庫の中のこのファイルは暗号化されています。先に展開してください。',
  'archive-entry-method':
    '書庫の中のこのファイルの圧縮方式はここでは開けません。先に展開してください。',
  'archive-too-large': '書庫が大きすぎてここでは開けません。先に展開してください。',
  'archive-without-motions': '書庫に BVH ファイルがありません。',
  'changed-on-disk': '開いた後にファイルが変わりました。もう一度ドロップしてください。',
  'compared-again': 'その間に比較がやり直されました。もう一度試してください。',
  'comparison-stopped':
    '比較が思いがけず止まりました。クリップに影響はありません。次の変更で始め直します。',
  'engine-unavailable': '解析を始められませんでした：{0}',
  'no-such-sample': 'サンプル {0} はありません。',
  'not-an-archive': '.zip の書庫ではありません。',
  'not-open': 'クリップは閉じられています。',
  'not-human-to-compare': '人体ではないため、人の動作とは比較しません。',
  'too-many-pairs':
    '{0} 個のクリップの群平均法には {1} MB のメモリーが要りますが、ブラウザーから得られません。Ward 法を選ぶか、クリップを減らしてください。',
  'too-short-to-compare': '1つの姿勢だけで動作がありません。比較には2フレーム以上が必要です。',
  'not-readable': 'ブラウザーがファイルを読めませんでした。もう一度ドロップしてください。',
  'worker-died': 'このファイルの処理が思いがけず終わりました。ほかのファイルに影響はありません。',
  setting: '{0} が {1} です。期待される値：{2}',
  internal: '思いがけない問題が起きました：{0}',
};
