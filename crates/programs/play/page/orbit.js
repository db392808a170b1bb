// How does somebody walk around a scene? By dragging, pinching, a wheel or keys, on any of its pictures.

import { capture } from './parameters.js';
import { ENDS } from './look.js';

/** Degrees for each pixel of a drag. */
const TURN = 0.4;
/** Degrees for each arrow key. */
const KEY_TURN = 3;
const KEY_ZOOM = 1.1;
const WHEEL_ZOOM = 0.0012;
/** A press that moves less than this, in pixels, chooses a pixel. */
const CLICK = 4;

const within = (x, [least, greatest]) => Math.min(greatest, Math.max(least, x));

/**
 * Lets `canvas` be dragged. `get()` is the look of now; `move(changes, event)` changes it, `still()` says that a drag ended;
 * `choose(x, y)` that a point was chosen, in parts of the picture from its top left; `cross` is the element of the cross.
 */
export const orbit = (canvas, { get, move, still, choose, cross }) => {
  const pointers = new Map();
  let travelled = 0;
  let at = null;

  const turn = (dx, dy, event) => {
    const { azimuth, elevation } = get();
    move({ azimuth: (azimuth - dx) % 360, elevation: within(elevation + dy, ENDS.elevation) }, event);
  };
  const zoom = (factor, event) => move({ distance: within(get().distance * factor, ENDS.distance) }, event);
  const spread = () => {
    const [a, b] = [...pointers.values()];
    return Math.hypot(a.x - b.x, a.y - b.y);
  };

  canvas.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    capture(canvas, event.pointerId);
    if (pointers.size === 0) travelled = 0;
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    canvas.classList.add('held');
  });
  canvas.addEventListener('pointermove', (event) => {
    const last = pointers.get(event.pointerId);
    if (!last) return;
    const before = pointers.size === 2 ? spread() : 0;
    const [dx, dy] = [event.clientX - last.x, event.clientY - last.y];
    Object.assign(last, { x: event.clientX, y: event.clientY });
    travelled += Math.hypot(dx, dy);
    if (pointers.size === 2) zoom(before / Math.max(1, spread()), event);
    else if (travelled >= CLICK) turn(dx * TURN, dy * TURN, event);
  });
  const end = (event) => {
    if (!pointers.delete(event.pointerId) || pointers.size > 0) return;
    canvas.classList.remove('held');
    if (travelled < CLICK && event.type === 'pointerup') {
      const box = canvas.getBoundingClientRect();
      choose((event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height);
    } else {
      still();
    }
  };
  canvas.addEventListener('pointerup', end);
  canvas.addEventListener('pointercancel', end);
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    zoom(Math.exp(event.deltaY * WHEEL_ZOOM * (event.deltaMode === 1 ? 16 : 1)), event);
    still();
  }, { passive: false });

  const place = () => {
    cross.hidden = !at;
    if (!at) return;
    const { width, height } = get();
    cross.style.left = `${(100 * (at[0] + 0.5)) / width}%`;
    cross.style.top = `${(100 * (at[1] + 0.5)) / height}%`;
  };
  const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  canvas.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { width, height } = get();
    const many = event.shiftKey ? 10 : 1;
    const step = steps[event.key];
    if (event.key === 'Enter') {
      if (at) choose((at[0] + 0.5) / width, (at[1] + 0.5) / height);
      at ??= [Math.floor(width / 2), Math.floor(height / 2)];
    } else if (event.key === 'Escape' && at) {
      at = null;
    } else if (step && at) {
      at = [within(at[0] + step[0] * many, [0, width - 1]), within(at[1] + step[1] * many, [0, height - 1])];
    } else if (step) {
      turn(step[0] * KEY_TURN * many, step[1] * KEY_TURN * many, event);
      still();
    } else if (event.key === '+' || event.key === '=') {
      zoom(1 / KEY_ZOOM, event);
      still();
    } else if (event.key === '-') {
      zoom(KEY_ZOOM, event);
      still();
    } else {
      return;
    }
    event.preventDefault();
    place();
  });
  canvas.addEventListener('blur', () => {
    at = null;
    place();
  });
  return { place };
};
