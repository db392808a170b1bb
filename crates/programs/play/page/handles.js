// What can be dragged in the drawing itself? Rings over it, that a mouse, a finger or the arrow keys move.

import { make } from './dom.js';
import { capture } from './parameters.js';
import { say } from './words.js';

/** One step of an arrow key, in parts of the drawing. */
const STEP = 0.01;

/**
 * The rings over one drawing. `onmove(handle, [x, y], settled)` asks for the drawing in which the handle is there;
 * `valueOf(names)` says what the parameters are now.
 */
export const handleLayer = (onmove, valueOf) => {
  const layer = make('div', { class: 'handles' });
  let rings = [];

  const ring = (at) => {
    const element = make('div', { class: 'handle', role: 'slider', tabindex: 0, 'data-handle': at, 'data-test': 'handle' });
    const state = { element, x: 0, y: 0, aim: null, key: null, offset: null, text: '' };
    element.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      event.preventDefault();
      element.focus({ preventScroll: true });
      capture(element, event.pointerId);
      const [x, y] = place(event);
      state.offset = [state.x - x, state.y - y];
      element.classList.add('held');
    });
    element.addEventListener('pointermove', (event) => {
      if (!state.offset || event.buttons === 0) return;
      const [x, y] = place(event);
      onmove(at, [x + state.offset[0], y + state.offset[1]].map(within), false);
    });
    const end = (event) => {
      if (!state.offset) return;
      const [x, y] = place(event);
      const to = [x + state.offset[0], y + state.offset[1]].map(within);
      state.offset = null;
      element.classList.remove('held');
      onmove(at, to, true);
    };
    element.addEventListener('pointerup', end);
    element.addEventListener('pointercancel', () => {
      state.offset = null;
      element.classList.remove('held');
    });
    element.addEventListener('keydown', (event) => {
      const [dx, dy] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key] ?? [0, 0];
      if ((!dx && !dy) || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      const step = STEP * (event.shiftKey ? 10 : 1);
      // Turning back begins where the handle is, not where the keys have led beyond its end.
      if (event.key !== state.key) state.aim = null;
      state.key = event.key;
      // What did not move the handle adds up, so that whole numbers and circles are left behind at last.
      state.aim = [within((state.aim?.[0] ?? state.x) + dx * step), within((state.aim?.[1] ?? state.y) + dy * step)];
      onmove(at, state.aim, true);
    });
    return state;
  };

  const place = (event) => {
    const box = layer.getBoundingClientRect();
    return [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
  };
  const within = (x) => Math.min(1, Math.max(0, x));

  return {
    element: layer,
    held: () => rings.some((state) => state.offset),
    /** Puts the rings where the drawing has them. */
    show: (handles) => {
      if (rings.length !== handles.length) {
        rings = handles.map((_, at) => ring(at));
        layer.replaceChildren(...rings.map((state) => state.element));
      }
      handles.forEach((handle, at) => {
        const state = rings[at];
        const { element } = state;
        const { text, first } = valueOf(handle.moves);
        if (state.text !== text.en) state.aim = null;
        Object.assign(state, { x: handle.x, y: handle.y, text: text.en });
        element.style.left = `${100 * handle.x}%`;
        element.style.top = `${100 * handle.y}%`;
        element.dataset.moves = handle.moves.join(' ');
        say(element, handle.name, 'aria-label');
        say(element, handle.name, 'title');
        say(element, text, 'aria-valuetext');
        if (first) {
          element.setAttribute('aria-valuemin', first.least);
          element.setAttribute('aria-valuemax', first.greatest);
          element.setAttribute('aria-valuenow', Number(first.value.toPrecision(6)));
        }
      });
    },
  };
};
