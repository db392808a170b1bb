// How fast does a drag become a picture? A made hand drags the z-buffer's picture, through the code that a person's hand uses.

import { make } from './dom.js';
import { lookFrom } from './look.js';
import { threeScreens } from './loops.js';
import { ask } from './net.js';
import { T, join, number, same } from './words.js';

/** So long it is dragged, in milliseconds. */
const DRAGGED = 5000;
/** Before that, what is loaded and compiled at first use is not counted. */
const WARM = 500;
/** The hand goes around once in so many milliseconds, this far from the middle, in pixels. */
const ROUND = 2500;
const REACH = 100;
const POINTER = 1;

const quantile = (sorted, part) => sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))] ?? NaN;

/** The view: it begins by itself. */
export const measure = (place, { lecture, values }) => {
  const look = { ...lookFrom(values, lecture), width: 640, height: 480 };
  let frames = 0;
  let counting = false;
  let left = false;
  let shownUntil = -Infinity;
  let waiting = []; // The times of moves whose picture has not come.
  const latencies = [];

  const three = threeScreens({
    look,
    alone: 'zbuffer',
    onlook: () => {},
    onchoose: () => {},
    onshown: (name, stamp) => {
      // Only a picture of a camera that was not shown yet is a new one.
      if (!counting || name !== 'zbuffer' || stamp === null || stamp <= shownUntil) return;
      shownUntil = stamp;
      frames += 1;
      const covered = waiting.filter((time) => time <= stamp);
      waiting = waiting.filter((time) => time > stamp);
      requestAnimationFrame(() => latencies.push(...covered.map((time) => performance.now() - time)));
    },
  });
  const result = make('div', { class: 'measured', role: 'status', 'data-test': 'measured' }, make('p', { words: T.measuring }));
  place.classList.add('loops', 'measure');
  place.append(make('h1', { words: T.measureTitle }), make('p', { class: 'lead', words: T.measureLead }), result, three.element);

  const { canvas } = three.screens.zbuffer;
  const pointer = (type, x, y, buttons) => canvas.dispatchEvent(new PointerEvent(type, {
    pointerId: POINTER, pointerType: 'mouse', isPrimary: true, bubbles: true, cancelable: true, button: type === 'pointermove' ? -1 : 0, buttons, clientX: x, clientY: y,
  }));
  const nextFrame = () => new Promise((resolve) => { requestAnimationFrame(resolve); });

  /** Goes round for so many milliseconds. */
  const drag = async (duration) => {
    const box = canvas.getBoundingClientRect();
    const [x, y] = [box.left + box.width / 2, box.top + box.height / 2];
    const began = performance.now();
    pointer('pointerdown', x + REACH, y, 1);
    while (performance.now() - began < duration && !left) {
      const angle = (2 * Math.PI * (performance.now() - began)) / ROUND;
      const event = performance.now();
      pointer('pointermove', x + REACH * Math.cos(angle), y + 0.4 * REACH * Math.sin(angle), 1);
      if (counting) waiting.push(event);
      await nextFrame();
    }
    pointer('pointerup', x, y, 0);
    return performance.now() - began;
  };

  const run = async () => {
    await drag(WARM);
    counting = true;
    const took = await drag(DRAGGED);
    counting = false;
    await nextFrame();
    await nextFrame();
    if (left) return;
    const sorted = latencies.toSorted((a, b) => a - b);
    const rounded = (x) => Math.round(x * 10) / 10;
    const measured = {
      frames_per_second: rounded((frames * 1000) / took),
      latency_ms: { median: rounded(quantile(sorted, 0.5)), p95: rounded(quantile(sorted, 0.95)) },
      frames,
      size: [look.width, look.height],
      scene: look.scene,
    };
    result.dataset.measured = JSON.stringify(measured);
    result.replaceChildren(make('dl', {},
      make('div', {}, make('dt', { words: T.shown }), make('dd', {}, number(measured.frames_per_second))),
      make('div', {}, make('dt', { words: join([T.latency, T.median], ', ') }), make('dd', {}, `${number(measured.latency_ms.median)} ms`)),
      make('div', {}, make('dt', { words: join([T.latency, same('p95')], ', ') }), make('dd', {}, `${number(measured.latency_ms.p95)} ms`)),
      make('div', {}, make('dt', { words: T.frames }), make('dd', {}, number(measured.frames)))));
    // Nobody may be waiting for it.
    if (lecture.token) await ask('/api/measured', measured).catch(() => {});
  };
  requestAnimationFrame(() => requestAnimationFrame(run));

  return {
    title: T.measureTitle,
    leave: () => {
      left = true;
      three.leave();
    },
  };
};
