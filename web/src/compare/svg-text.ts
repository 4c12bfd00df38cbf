/** Names, attributes and contents in; SVG as text out, every name from a file escaped. */
const entities: Readonly<Record<string, string>> = {
  '&': '&amp;',
  '<': '&lt;',
  '>': '&gt;',
  '"': '&quot;',
};

/** Signs that XML does not allow are left out. */
const escaped = (text: string): string =>
  text
    .replace(/[\u0000-\u0008\u000b\u000c\u000e-\u001f\ufffe\uffff]/g, '')
    .replace(/[&<>"]/g, (sign) => entities[sign] ?? sign);

export type Attributes = Readonly<Record<string, string | number>>;

const number = (value: number): string => String(Math.round(value * 1000) / 1000);

const attribute = ([name, value]: [string, string | number]): string =>
  ` ${name}="${typeof value === 'number' ? number(value) : escaped(value)}"`;

export function tag(name: string, attributes: Attributes, content = ''): string {
  const list = Object.entries(attributes).map(attribute).join('');
  return content ? `<${name}${list}>${content}</${name}>` : `<${name}${list}/>`;
}

export const textTag = (content: string, attributes: Attributes): string =>
  tag('text', attributes, escaped(content));

export interface Sheet {
  readonly width: number;
  readonly height: number;
  readonly ground: string;
  readonly title: string;
}

const fonts = 'Inter, Roboto, Helvetica, Arial, sans-serif';

export function svgSheet({ width, height, ground, title }: Sheet, content: string): string {
  const attributes = {
    xmlns: 'http://www.w3.org/2000/svg',
    width,
    height,
    viewBox: `0 0 ${number(width)} ${number(height)}`,
    'font-family': fonts,
  };
  const back = tag('rect', { width, height, fill: ground });
  return tag('svg', attributes, `<title>${escaped(title)}</title>${back}${content}`);
}
