/** The side panel on the page: the store in; what a person does in it, as actions, out. */
import { computed, signal, type ReadonlySignal, type Signal } from '@preact/signals-core';
import { nothing } from 'lit-html';
import type { Context } from '../app/context';
import type { Clip } from '../app/clips';
import type { InspectorTab } from '../app/store';
import { follow, mount } from '../common/mount';
import type { ClipResult, PerformerResult, Role } from '../engine/types';
import { notesAtOnce } from './doctor';
import { inspector, type InspectorProps } from './inspector';
import { copiesOf, withJoint, type JointCopies } from '../app/joint-choices';
import { createRefusals, type Refusals } from './refusals';
import { whySubject, type WhySubject } from './why-subject';

interface PanelState {
  readonly refusals: Refusals;
  readonly pointed: Signal<Role | null>;
  readonly noteLimit: Signal<number>;
  readonly width: Signal<number>;
  /** A candidate gone to by intensity; it counts while the playhead is on its frame. */
  readonly goneTo: Signal<{
    readonly performer: PerformerResult;
    readonly candidate: number;
  } | null>;
  readonly subject: ReadonlySignal<WhySubject | null>;
  /** The keypose under the pointer, wherever that is. */
  readonly hovered: ReadonlySignal<number | null>;
  readonly copies: ReadonlySignal<JointCopies>;
}

const usualWidth = 272;
/** Left and right of what the panel holds. */
const paddingPx = 14;
const none: JointCopies = { clips: 0, changes: [] };

function createState({ store }: Context): PanelState {
  const goneTo: PanelState['goneTo'] = signal(null);
  const stillThere = computed(() => {
    const gone = goneTo.value;
    const performer = store.openPerformer.value;
    if (!gone || gone.performer !== performer) return null;
    const frame = performer.keyposes?.candidates[gone.candidate];
    return frame === store.playback.value.frame ? gone.candidate : null;
  });
  const subject = computed(() => {
    const keyposes = store.openPerformer.value?.keyposes;
    return keyposes ? whySubject(keyposes, store.currentKeypose.value, stillThere.value) : null;
  });
  const hovered = computed(() => {
    const frame = store.hoverFrame.value;
    const keypose = frame === null ? -1 : store.keyposeFrames.value.indexOf(frame);
    return keypose < 0 ? null : (store.openPerformer.value?.keyposes?.keyposes[keypose] ?? null);
  });
  const copies = computed(() => {
    const clip = store.openClip.value;
    if (!clip || store.inspectorTab.value !== 'body') return none;
    return copiesOf(store.present.value, clip, store.performer.value);
  });
  return {
    refusals: createRefusals(),
    pointed: signal(null),
    noteLimit: signal(notesAtOnce),
    width: signal(usualWidth),
    goneTo,
    subject,
    hovered,
    copies,
  };
}

/** Shows a tab and puts the focus on a field of it. */
function goToField({ store }: Context, tab: InspectorTab, id: string): void {
  store.inspectorTab.value = tab;
  // The tab shows with the next frame.
  requestAnimationFrame(() => requestAnimationFrame(() => document.getElementById(id)?.focus()));
}

interface Open {
  readonly clip: Clip;
  readonly result: ClipResult;
  readonly performer: PerformerResult;
}

type Events = {
  [Key in keyof InspectorProps as Key extends `on${string}` ? Key : never]: InspectorProps[Key];
};

function whyEvents({ store, playback }: Context, state: PanelState, { performer }: Open) {
  const frameOf = (candidate: number): number => performer.keyposes?.candidates[candidate] ?? 0;
  return {
    onHover(candidate: number | null) {
      const frame = candidate === null ? null : frameOf(candidate);
      if (store.hoverFrame.peek() !== frame) store.hoverFrame.value = frame;
    },
    onGo(candidate: number) {
      playback.seek(frameOf(candidate));
      state.goneTo.value = { performer, candidate };
    },
  };
}

function eventsOf(context: Context, state: PanelState, open: Open): Events {
  const { store, actions, playback } = context;
  const { clip } = open;
  const performer = store.performer.peek();
  return {
    ...whyEvents(context, state, open),
    onTab: (tab) => {
      store.inspectorTab.value = tab;
    },
    onOption: (key, value) => actions.setOption(key, value),
    onReset: (keys) => actions.resetOptions(keys),
    onDecide: (key, value) => actions.decide({ id: clip.id, key, value }),
    onPerformer: (index) => actions.choosePerformer(index),
    onFrame: (frame) => playback.seek(frame),
    onLeaveOut: (leaveOut) =>
      actions.decide({ id: clip.id, key: 'leadingRestFrames', value: leaveOut ? undefined : 0 }),
    onField: (tab, id) => goToField(context, tab, id),
    onMore: () => {
      state.noteLimit.value += notesAtOnce;
    },
    onPoint: (role) => {
      state.pointed.value = role;
    },
    onJoint: (role, joint) => {
      const joints = withJoint(clip.decisions.joints ?? [], performer, role, joint);
      actions.decideJoints([{ id: clip.id, joints }]);
    },
    onCopy: () => actions.decideJoints(state.copies.peek().changes),
    onExport: (kind) => actions.exportClip(clip.id, kind),
  };
}

function propsOf(context: Context, state: PanelState, open: Open): InspectorProps {
  const { store, language } = context;
  const { result, performer } = open;
  return {
    ...open,
    ...eventsOf(context, state, open),
    words: language.words.value,
    tab: store.inspectorTab.value,
    performerIndex: store.performer.value,
    options: store.options.value,
    defaults: store.defaults.value,
    coarsestHz: store.options.value.scaleMinHz ?? store.defaults.value?.scaleMinHz ?? Infinity,
    notes: [...result.notes, ...performer.notes],
    limit: state.noteLimit.value,
    refusals: state.refusals,
    pointed: state.pointed.value,
    copies: state.copies.value,
    subject: state.subject.value,
    hovered: state.hovered.value,
    width: state.width.value,
  };
}

function watchWidth(place: HTMLElement, width: Signal<number>): void {
  new ResizeObserver(([entry]) => {
    const inner = (entry?.contentRect.width ?? 0) - 2 * paddingPx;
    if (inner > 0) width.value = Math.round(inner);
  }).observe(place);
}

export function mountInspector(place: HTMLElement, context: Context): void {
  const { store, language } = context;
  const state = createState(context);
  const body = document.createElement('div');
  body.className = 'inspector-body';
  place.append(body);
  watchWidth(body, state.width);
  follow(() => {
    void store.openId.value;
    state.noteLimit.value = notesAtOnce;
  });
  mount(body, () => {
    place.setAttribute('aria-label', language.words.value.t('inspector.label'));
    const clip = store.openClip.value;
    const result = clip?.result;
    const performer = store.openPerformer.value;
    if (!clip || !result || !performer) return nothing;
    return inspector(propsOf(context, state, { clip, result, performer }));
  });
}
