// How does a view fill the screen, so that the last row of a hall can read it?

import { make, signButton } from './dom.js';
import { T } from './words.js';

const root = document.documentElement;
let steps = null;

/** Whether a view fills the screen. */
export const isOn = () => root.classList.contains('show');

const changed = () => window.dispatchEvent(new Event('resize'));

/** Fills the screen; where the browser does not allow it, at least the window. */
export const start = () => {
  root.classList.add('show');
  root.requestFullscreen?.().catch(() => {});
  changed();
};

/** Back to the page. */
export const stop = () => {
  root.classList.remove('show');
  if (document.fullscreenElement) document.exitFullscreen().catch(() => {});
  changed();
};

/** One or the other. */
export const toggle = () => (isOn() ? stop() : start());

/** `before` and `after` of the view that is seen now, if it has neighbours. */
export const attach = (neighbours) => {
  steps = neighbours ?? null;
  before.hidden = !steps;
  after.hidden = !steps;
};

const before = signButton('←', T.previous, () => steps?.before());
const after = signButton('→', T.next, () => steps?.after());
const leave = signButton('✕', T.leave, stop, { 'data-test': 'leave' });
document.body.append(make('div', { class: 'show-tools' }, before, after, leave));

document.addEventListener('fullscreenchange', () => {
  if (!document.fullscreenElement && isOn()) stop();
});
