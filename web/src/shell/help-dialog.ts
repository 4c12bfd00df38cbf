/** The list of keys. */
import { html, type TemplateResult } from 'lit-html';
import type { MessageKey, Words } from '../app/i18n/catalogue';
import { iconButton } from '../common/buttons';
import { columns, type KeyLine, type KeyName, type KeyTable } from './help-keys';

function keyLine({ t }: Words, [label, ...alternatives]: KeyLine): TemplateResult {
  const name = (key: KeyName): string => (key.includes('.') ? t(key as MessageKey) : key);
  return html`<div class="help-line">
    <dt>
      ${alternatives.map((keys) => html`<span class="keys">${keys.map((key) => html`<kbd>${name(key)}</kbd>`)}</span>`)}
    </dt>
    <dd>${t(label)}</dd>
  </div>`;
}

function keyTable(words: Words, [title, lines]: KeyTable): TemplateResult {
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
      ${columns.map((tables) => html`<div>${tables.map((table) => keyTable(words, table))}</div>`)}
    </div>
  `;
}
