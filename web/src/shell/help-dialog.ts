/** The list of keys. */
import { html, type TemplateResult } from 'lit-html';
import type { MessageKey, Words } from '../app/i18n/catalogue';
import { iconButton } from '../common/buttons';

type KeySign = '←' | '→' | '↑' | '↓' | '-' | '+' | '[' | ']' | '/' | '?';
type KeyName = MessageKey | KeySign | 'F' | 'K' | 'L' | 'Z' | '0';
/** Keys pressed together; alternatives stand side by side. */
type KeyLine = readonly [MessageKey, ...(readonly KeyName[])[]];

const playbackKeys: readonly KeyLine[] = [
  ['help.play', ['help.space']],
  ['help.frame', ['←'], ['→']],
  ['help.tenth', ['key.shift', '←'], ['key.shift', '→']],
  ['help.keypose', ['K'], ['key.shift', 'K']],
  ['help.ends', ['key.home'], ['key.end']],
  ['help.speed', ['-'], ['+']],
];

const loopKeys: readonly KeyLine[] = [
  ['help.loop', ['L']],
  ['help.loop-ends', ['['], [']']],
  ['help.loop-clear', ['key.shift', 'L']],
];

const timelineKeys: readonly KeyLine[] = [
  ['help.zoom', ['Z'], ['key.shift', 'Z']],
  ['help.zoom-all', ['0']],
];

const pageKeys: readonly KeyLine[] = [
  ['help.clips', ['↑'], ['↓']],
  ['help.remove', ['key.delete']],
  ['help.full-screen', ['F']],
  ['help.filter', ['/']],
  ['help.undo', ['key.ctrl', 'Z']],
  ['help.redo', ['key.ctrl', 'key.shift', 'Z']],
  ['help.this', ['?']],
];

function keyLine({ t }: Words, [label, ...alternatives]: KeyLine): TemplateResult {
  const name = (key: KeyName): string => (key.includes('.') ? t(key as MessageKey) : key);
  return html`<div class="help-line">
    <dt>
      ${alternatives.map((keys) => html`<span class="keys">${keys.map((key) => html`<kbd>${name(key)}</kbd>`)}</span>`)}
    </dt>
    <dd>${t(label)}</dd>
  </div>`;
}

function keyTable(words: Words, title: MessageKey, lines: readonly KeyLine[]): TemplateResult {
  return html`<section>
    <h3>${words.t(title)}</h3>
    <dl>${lines.map((line) => keyLine(words, line))}</dl>
  </section>`;
}

export function helpDialog(words: Words, onClose: () => void): TemplateResult {
  const { t } = words;
  return html`
    <div class="dialog-head">
      <h2 id="help-title">${t('help.title')}</h2>
      ${iconButton({ name: 'x', label: t('help.close'), onPress: onClose })}
    </div>
    <div class="help-tables">
      <div>${keyTable(words, 'help.playback', playbackKeys)}</div>
      <div>
        ${keyTable(words, 'help.loop-title', loopKeys)}${keyTable(words, 'help.timeline', timelineKeys)}
      </div>
      <div>${keyTable(words, 'help.page', pageKeys)}</div>
    </div>
  `;
}
