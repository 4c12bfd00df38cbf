/** A tag and a class in; a new element of the page out. */
export function element(name: string, className: string): HTMLElement {
  const node = document.createElement(name);
  node.className = className;
  return node;
}
