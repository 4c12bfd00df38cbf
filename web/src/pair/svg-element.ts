/** A name of SVG and a class in; the element out. */
const SVG_NAMESPACE = 'http://www.w3.org/2000/svg';

export function svgElement<Name extends keyof SVGElementTagNameMap>(
  name: Name,
  className = '',
): SVGElementTagNameMap[Name] {
  const node = document.createElementNS(SVG_NAMESPACE, name);
  if (className !== '') node.setAttribute('class', className);
  return node;
}
