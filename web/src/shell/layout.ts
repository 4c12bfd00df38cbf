/** An empty root in; the places of the page out, which stay for good and are filled by the views. */
import { html, render } from 'lit-html';

const names = [
  'top-bar',
  'empty',
  'workspace',
  'library',
  'study',
  'compare',
  'pair',
  'stage',
  'stage-figure',
  'stage-overlay',
  'transport',
  'strip',
  'timeline',
  'inspector',
  'scrim',
  'notices',
  'drop-veil',
  'help',
  'spoken-caption',
] as const;

export type PlaceName = (typeof names)[number];
export type Places = Readonly<Record<PlaceName, HTMLElement>>;

const skeleton = html`
  <header id="top-bar" class="top-bar"></header>
  <main id="empty" class="empty" hidden></main>
  <div id="workspace" class="workspace" hidden>
    <aside id="library" class="library"></aside>
    <main id="study" class="study">
      <section id="stage" class="stage">
        <div id="stage-figure" class="stage-figure"></div>
        <div id="stage-overlay" class="stage-overlay"></div>
      </section>
      <div class="time">
        <div id="transport" class="transport" role="toolbar"></div>
        <div id="strip" class="strip-place"></div>
        <div id="timeline" class="timeline-place"></div>
      </div>
    </main>
    <main id="compare" class="compare" hidden></main>
    <main id="pair" class="pair" hidden></main>
    <aside id="inspector" class="inspector"></aside>
    <div id="scrim" class="scrim" hidden></div>
  </div>
  <div id="notices" class="notices"></div>
  <div id="drop-veil" class="drop-veil" hidden></div>
  <dialog id="help" class="dialog" aria-labelledby="help-title"></dialog>
  <div id="spoken-caption" class="spoken" aria-live="polite"></div>
`;

export function layOut(root: HTMLElement): Places {
  render(skeleton, root);
  const place = (name: PlaceName): HTMLElement => {
    const element = root.querySelector<HTMLElement>(`#${name}`);
    if (!element) throw new Error(`no place ${name}`);
    return element;
  };
  return Object.fromEntries(names.map((name) => [name, place(name)])) as Record<
    PlaceName,
    HTMLElement
  >;
}
