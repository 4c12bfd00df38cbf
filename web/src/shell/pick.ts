/** A press on "choose" in; what the person picked in the browser's own dialog out. */
import { givenByInput, type Given } from '../app/intake';

export interface Picker {
  readonly files: () => void;
  readonly folder: () => void;
}

function input(parent: Element, onPick: (given: Given[]) => void): HTMLInputElement {
  const element = document.createElement('input');
  element.type = 'file';
  element.multiple = true;
  element.hidden = true;
  element.addEventListener('change', () => {
    onPick(givenByInput(element.files ?? []));
    element.value = '';
  });
  parent.append(element);
  return element;
}

export function createPicker(parent: Element, onPick: (given: Given[]) => void): Picker {
  const files = input(parent, onPick);
  files.accept = '.bvh,.zip';
  const folder = input(parent, onPick);
  folder.webkitdirectory = true;
  return { files: () => files.click(), folder: () => folder.click() };
}
