/** What templates need and lit has only as style attributes, which the page's policy forbids. */
import { nothing, type ElementPart } from 'lit-html';
import { Directive, directive, PartType, type PartInfo } from 'lit-html/directive.js';

class StyleDirective extends Directive {
  constructor(part: PartInfo) {
    super(part);
    if (part.type !== PartType.ELEMENT) throw new Error('styled() stands inside a tag');
  }

  override render(properties: Readonly<Record<string, string>>): typeof nothing {
    void properties;
    return nothing;
  }

  override update(
    part: ElementPart,
    [properties]: [Readonly<Record<string, string>>],
  ): typeof nothing {
    const { style } = part.element as HTMLElement | SVGElement;
    for (const [name, value] of Object.entries(properties)) style.setProperty(name, value);
    return nothing;
  }
}

/** Sets CSS properties of the element by name. */
export const styled = directive(StyleDirective);

class NodeDirective extends Directive {
  private key: unknown = undefined;

  override render(...parameters: [key: unknown, draw: (element: Element) => void]): typeof nothing {
    void parameters;
    return nothing;
  }

  override update(
    part: ElementPart,
    [key, draw]: [unknown, (element: Element) => void],
  ): typeof nothing {
    if (key !== this.key) {
      this.key = key;
      part.element.replaceChildren();
      draw(part.element);
    }
    return nothing;
  }
}

/** Lets `draw` fill the element by hand whenever `key` is another one. */
export const drawn = directive(NodeDirective);
