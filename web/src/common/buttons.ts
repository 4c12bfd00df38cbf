/** The buttons of the page; one that shows an icon alone has a name and a tip with its key. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { icon, type IconName } from './icons';

export interface IconButton {
  readonly name: IconName;
  readonly label: string;
  readonly size?: number;
  readonly small?: boolean;
  readonly disabled?: boolean;
  /** Given for buttons that stay on or off. */
  readonly pressed?: boolean;
  /** Given for buttons that show and hide a part of the page. */
  readonly expanded?: boolean;
  /** As `aria-keyshortcuts` has it. */
  readonly keys?: string;
  /** The key as the tip shows it. */
  readonly keyText?: string;
  readonly onPress: () => void;
}

export function iconButton(props: IconButton): TemplateResult {
  return html`<button
    type="button"
    class="icon-button ${props.small ? 'small' : ''} ${props.pressed ? 'on' : ''}"
    aria-label=${props.label}
    aria-pressed=${props.pressed === undefined ? nothing : String(props.pressed)}
    aria-expanded=${props.expanded === undefined ? nothing : String(props.expanded)}
    aria-keyshortcuts=${props.keys ?? nothing}
    data-tip=${props.label}
    data-key=${props.keyText ?? nothing}
    ?disabled=${props.disabled ?? false}
    @click=${props.onPress}
  >
    ${icon(props.name, props.size ?? (props.small ? 15 : 16))}
  </button>`;
}
