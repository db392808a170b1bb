// What do three loops make of one scene? Painter, z-buffer and ray tracer side by side, with one camera for all of them.

import { finite, format } from './address.js';
import { button, fresh, make, trouble } from './dom.js';
import { copyButton } from './figures.js';
import { lookControls, lookFrom, lookValues } from './look.js';
import { busy, frame, latest, reason } from './net.js';
import { orbit } from './orbit.js';
import { picture } from './picture.js';
import { refiner } from './refine.js';
import * as show from './show.js';
import { storyOf } from './story.js';
import { T, join, number, same, say } from './words.js';

const LOOPS = ['painter', 'zbuffer', 'raytrace'];
/** The painter's pictures come at least so far apart while something moves, in milliseconds: the z-buffer goes first. */
const PAINTER_PAUSE = 150;
/** It works at most one part in so many of the time, however long it takes. */
const PAINTER_SHARE = 3;
/** Frames a second are counted over so many milliseconds. */
const COUNTED = 1000;
/** So long after the last change everything counts as still, in milliseconds. */
const STILL = 250;

/** One of the three pictures, with what is said about it. */
const screen = (name, on) => {
  const hint = fresh('hint');
  const canvas = make('canvas', {
    tabindex: 0, role: 'application', width: 640, height: 480, 'data-loop': name, label: T[name], 'aria-describedby': hint,
  });
  const cross = make('div', { class: 'cross', 'aria-hidden': 'true' });
  const mark = make('div', { class: 'mark-pixel', 'aria-hidden': 'true' });
  cross.hidden = true;
  mark.hidden = true;
  const time = make('span', { class: 'time', 'data-test': `${name}-time` });
  const rate = make('span', { class: 'rate', 'data-test': `${name}-rate` });
  const notes = make('ul', { class: 'notes' });
  const wrong = trouble();
  const larger = button(T.enlarge, () => on.enlarge(name), { 'data-test': `enlarge-${name}`, 'aria-pressed': 'false' });
  const progress = name === 'raytrace' && make('progress', { max: 1, value: 0, label: T.refining });
  const element = make('figure', { class: 'loop', 'data-screen': name },
    make('figcaption', {}, make('h2', { words: T[name] }), make('p', { words: T[`${name}Lead`] }), larger),
    make('div', { class: 'frame' }, canvas, cross, mark),
    make('p', { class: 'numbers' }, time, rate, progress),
    notes, wrong.element,
    make('p', { class: 'unseen', id: hint, words: T.orbitKeys }));
  const shown = picture(canvas);
  const steer = orbit(canvas, { ...on, cross });
  return {
    name, element, canvas, shown, wrong, larger, progress, mark, steer,
    time: (words) => say(time, words),
    rate: (text) => { rate.textContent = text; },
    notes: (list) => notes.replaceChildren(...list.map((note) => make('li', { lang: 'en' }, note))),
  };
};

/** The three pictures of a look. `shown(name, stamp)` is called when the z-buffer's picture of a look was put. */
export const threeScreens = ({ look: first, alone: firstAlone, onlook, onchoose, onshown = () => {} }) => {
  let look = first;
  let alone = firstAlone;
  let stamp = null; // When the event happened that led to the look of now.
  let moved = -Infinity;
  let calm = null;
  let painterTimer = null;
  let painterBegan = -Infinity;
  const arrivals = [];
  const size = () => ({ width: look.width, height: look.height });
  const isSeen = (name) => !alone || alone === name;

  const change = (changes, event) => {
    look = { ...look, ...changes };
    stamp = event?.timeStamp ?? null;
    moved = performance.now();
    onlook(look, false);
    request();
    clearTimeout(calm);
    calm = setTimeout(() => onlook(look, true), STILL);
  };
  const on = {
    get: () => look,
    move: change,
    still: () => {},
    choose: (x, y) => onchoose([Math.floor(Math.min(0.99999, Math.max(0, x)) * look.width), look.height - 1 - Math.floor(Math.min(0.99999, Math.max(0, y)) * look.height)]),
    enlarge: (name) => {
      enlarge(alone === name ? null : name);
      onlook(look, true);
    },
  };
  const screens = Object.fromEntries(LOOPS.map((name) => [name, screen(name, on)]));
  const element = make('div', { class: 'screens' }, LOOPS.map((name) => screens[name].element));

  const simple = (name, after) => latest(async (its) => {
    const done = busy();
    const asked = stamp;
    try {
      const answer = await frame({ look: its, renderer: name, scale: 1, rows: null, samples: 1 });
      // Of a size that is no longer wanted: the next one is on its way.
      if (its.width === look.width && its.height === look.height) screens[name].shown.put(answer, 1, its);
      screens[name].wrong.show(null);
      screens[name].time(same(`${number(answer.micros / 1000, 3)} ms`));
      screens[name].notes(answer.notes);
      after?.(asked);
    } catch (error) {
      screens[name].wrong.show(reason(error));
    } finally {
      done();
    }
  });
  const drawZbuffer = simple('zbuffer', (asked) => {
    const at = performance.now();
    arrivals.push(at);
    while (arrivals[0] < at - COUNTED) arrivals.shift();
    // Only while it moves are frames a second worth counting.
    if (at - moved < STILL && arrivals.length > 2) {
      screens.zbuffer.rate(`${Math.round(((arrivals.length - 1) * 1000) / (at - arrivals[0]))} fps`);
    }
    onshown('zbuffer', asked);
  });
  let painterTook = 0;
  const drawPainter = simple('painter', () => { painterTook = performance.now() - painterBegan; });
  const tracer = refiner({
    put: (rows, scale) => {
      screens.raytrace.shown.put(rows, scale, size());
      onshown('raytrace', null);
    },
    progress: ({ scale, samples, part, elapsed, notes, over }) => {
      const { raytrace } = screens;
      raytrace.wrong.show(null);
      raytrace.progress.value = over ? 1 : scale > 1 ? 0.1 / scale : (samples - 1 + part) / 3;
      const passed = same(`${number(elapsed / 1000, 3)} s`);
      const how = same(scale > 1 ? `1/${scale}` : `${samples * samples}×, ${Math.round(100 * part)} %`);
      raytrace.time(join(over ? [passed, T.finished] : [passed, T.refining, how], ' · '));
      if (notes.length) raytrace.notes(notes);
    },
    failed: (error) => screens.raytrace.wrong.show(reason(error)),
  });

  const request = () => {
    if (isSeen('zbuffer')) drawZbuffer(look);
    if (isSeen('painter') && painterTimer === null) {
      const wait = Math.max(0, painterBegan + Math.max(PAINTER_PAUSE, PAINTER_SHARE * painterTook) - performance.now());
      painterTimer = setTimeout(() => {
        painterTimer = null;
        painterBegan = performance.now();
        drawPainter(look);
      }, wait);
    }
    if (isSeen('raytrace')) tracer.draw(look);
  };

  const enlarge = (name) => {
    alone = name;
    if (name) element.dataset.alone = name;
    else delete element.dataset.alone;
    tracer.stop();
    for (const each of LOOPS) {
      const { larger, element: figure } = screens[each];
      figure.hidden = !isSeen(each);
      larger.setAttribute('aria-pressed', String(alone === each));
      say(larger.firstChild, alone === each ? T.allThree : T.enlarge);
    }
    request();
  };
  enlarge(alone);

  return {
    element,
    change,
    screens,
    get look() { return look; },
    get alone() { return alone; },
    /** Marks a pixel in all pictures; none with null. */
    mark: (pixel) => LOOPS.forEach((name) => {
      const { mark } = screens[name];
      mark.hidden = !pixel;
      if (!pixel) return;
      mark.style.left = `${(100 * (pixel[0] + 0.5)) / look.width}%`;
      mark.style.top = `${(100 * (look.height - 1 - pixel[1] + 0.5)) / look.height}%`;
    }),
    leave: () => {
      clearTimeout(calm);
      clearTimeout(painterTimer);
      tracer.stop();
    },
  };
};

/** The view: controls, the three pictures, and the story of a pixel that was chosen. */
export const loops = (place, context) => {
  const { lecture, values } = context;
  const look = lookFrom(values, lecture);
  const [i, j] = [finite(values, 'i', null, 0, look.width - 1), finite(values, 'j', null, 0, look.height - 1)];
  let { width, height } = look;
  let pixel = i === null || j === null ? null : [Math.round(i), Math.round(j)];

  const keep = () => context.keep({ ...lookValues(three.look), alone: three.alone, ...(pixel && { i: pixel[0], j: pixel[1] }) }, pixel ? 'story' : 'loops');
  const alone = LOOPS.includes(values.get('alone')) ? values.get('alone') : null;
  const story = storyOf((to) => { context.go(format('steps', to)); });
  const three = threeScreens({
    look,
    alone,
    onlook: (next, settled) => {
      // The same place in a picture of another size.
      if (pixel && (next.width !== width || next.height !== height)) {
        pixel = [Math.floor(((pixel[0] + 0.5) * next.width) / width), Math.floor(((pixel[1] + 0.5) * next.height) / height)];
      }
      ({ width, height } = next);
      keep();
      if (pixel && settled) tell(false);
    },
    onchoose: (chosen) => choose(chosen),
    onshown: () => story.refresh(),
  });
  const tell = (bring) => {
    three.mark(pixel);
    story.tell(three.look, pixel, { zbuffer: three.screens.zbuffer.shown, raytrace: three.screens.raytrace.shown }, bring);
  };
  const choose = (chosen) => {
    pixel = chosen;
    keep();
    tell(true);
  };
  const reset = () => three.change({ azimuth: 0, elevation: 0, distance: 1 });
  const controls = lookControls(look, lecture, (changes) => three.change(changes));

  place.classList.add('loops');
  place.append(
    make('div', { class: 'heading' },
      make('h1', { words: T.loops }),
      make('div', { class: 'tools' }, button(T.reset, reset, { 'data-test': 'reset' }), copyButton(), button(T.full, show.start, { 'data-test': 'full' }))),
    controls,
    make('p', { class: 'hint', words: T.orbitHelp }),
    three.element,
    story.element);
  if (pixel) tell(false);
  return {
    get title() { return pixel ? join([T.story, same(`(${pixel.join(', ')})`)], ' ') : T.loops; },
    keys: { r: reset },
    leave: () => {
      three.leave();
      story.leave();
    },
  };
};
