/** The sentences of films in Japanese. */
import type { englishFilm } from './en-film';
import type { Message } from './message';

export const japaneseFilm: Readonly<Record<keyof typeof englishFilm, Message>> = {
  film: '動画',
  'film.title': '動画として保存',
  'film.size': '大きさ',
  'film.rate': '毎秒のフレーム数',
  'film.length': '{0} 秒 · {1} フレーム',
  'film.all': '全体',
  'film.loop': 'A–B（{0}～{1} 秒）',
  'film.speed': '{0} 倍速',
  'film.about': '今のステージのとおりに描きます。',
  'film.save': '動画を保存',
  'film.cancel': 'キャンセル',
  'film.stop': '動画を中止',
  'film.progress': '{1} フレーム中 {0}',
  'film.name': '{0} と {1}',
  'film.no-encoder':
    'このブラウザーは動画を作れません。新しい Chrome、Edge、Firefox、Safari なら作れます。',
  'film.waits': '時間伸縮を計算しています。',
  'film.failed': '動画を中止しました：{0} もう一度お試しください。',
  'film.failed.no-codec':
    'この大きさの動画はこのブラウザーでは作れません。小さい方か、別のブラウザーをお試しください。',
  'film.failed.no-graphics':
    '描画が止まりました。描画を使うほかのページを閉じて、もう一度お試しください。',
};
