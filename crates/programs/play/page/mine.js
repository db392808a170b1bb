// What does the student's own function draw? The server asks it in a process of its own; this shows what came of it.

import { check, choice, make, trouble } from './dom.js';
import { drawingGrid } from './drawings.js';
import { ask, busy, latest, reason } from './net.js';
import { isOn } from './show.js';
import { T, join, same, say } from './words.js';

/** So often it is asked whether the file was saved, in milliseconds. */
const PAUSE = 500;

/**
 * The switch and the drawings of one figure. `first` is the exercise that the address asks for, `values()` the figure's numbers now,
 * `onchange()` is called when it is switched.
 */
export const mineSwitch = (figure, lecture, first, values, onchange) => {
  const names = figure.mine;
  const nothing = { control: null, element: null, exercise: () => null, toggle: () => {}, changed: () => {}, leave: () => {} };
  if (names.length === 0) return nothing;

  const titleOf = (name) => lecture.exercises.find((e) => e.name === name)?.title ?? same(name);
  let exercise = names.includes(first) ? first : names[0];
  let on = names.includes(first);
  let stamp = null;
  let timer = null;

  const wrong = trouble();
  const state = make('p', { class: 'state', role: 'status', 'data-test': 'mine-state' });
  const message = make('p', { class: 'message' });
  const unmoved = make('p', { class: 'hint', 'data-test': 'mine-unmoved' });
  const file = make('p', { class: 'file' });
  const detail = make('pre', { tabindex: 0 });
  const compiler = make('details', { open: true }, make('summary', { words: T.compiler }), detail);
  const grid = drawingGrid({ test: 'mine-drawings', room: () => (window.innerWidth < 640 ? Infinity : window.innerHeight * (isOn() ? 0.5 : 0.8)) });
  const element = make('section', { class: 'mine', label: T.mineLead },
    make('h2', { words: T.mine }), state, message, grid.element, unmoved, compiler, file, wrong.element);

  const take = async (answer) => {
    element.dataset.state = answer.state;
    element.classList.toggle('differs', answer.differing > 0);
    state.replaceChildren(make('strong', { words: answer.title ?? same(answer.state) }));
    if (answer.differs) state.append(' · ', make('span', { 'data-test': 'mine-differs', words: answer.differs }));
    message.hidden = !answer.message;
    if (answer.message) say(message, answer.message);
    const still = figure.parameters.filter((p) => !(answer.moved_by ?? []).includes(p.name));
    unmoved.hidden = answer.state !== 'drawn' || still.length === 0;
    say(unmoved, join([T.unmoved, join(still.map((p) => p.label), ', ')], ' '));
    compiler.hidden = !answer.detail;
    detail.textContent = answer.detail ?? '';
    file.hidden = !answer.file;
    file.replaceChildren(make('code', {}, answer.file ?? ''), ' · ', make('span', { words: T.redraws }));
    await grid.show(answer.drawings ?? []);
    grid.element.hidden = !(answer.drawings?.length);
    grid.layout();
  };

  const draw = latest(async () => {
    const done = busy();
    element.setAttribute('aria-busy', 'true');
    try {
      const answer = await ask('/api/mine', { figure: figure.stem, set: values(), exercise });
      wrong.show(null);
      if (on) await take(answer);
    } catch (error) {
      wrong.show(error.status === 403 ? T.noPermission : reason(error));
    } finally {
      element.removeAttribute('aria-busy');
      done();
    }
  });

  /** A file that was saved is drawn again; the answer itself says whether it was. */
  const watch = async () => {
    clearTimeout(timer);
    if (!on || !lecture.token) return;
    if (document.visibilityState === 'visible') {
      try {
        const answer = await ask(`/api/mine/stamp?exercise=${encodeURIComponent(exercise)}`);
        if (on && stamp !== null && answer.stamp !== stamp) draw();
        stamp = answer.stamp;
      } catch (error) {
        wrong.show(reason(error));
      }
    }
    if (on) timer = setTimeout(watch, PAUSE);
  };

  const apply = () => {
    element.hidden = !on;
    stamp = null;
    clearTimeout(timer);
    if (!on) return;
    if (!lecture.token) {
      element.dataset.state = 'no-permission';
      compiler.hidden = true;
      state.replaceChildren(make('span', { words: T.noPermission }));
      return;
    }
    if (!state.textContent) state.replaceChildren(make('span', { words: T.working }));
    draw();
    watch();
  };
  const set = (to) => {
    on = to;
    box.querySelector('input').checked = on;
    apply();
    onchange();
  };
  const box = check(T.mineLead, on, set, { role: 'switch', 'data-test': 'mine' });
  const which = names.length > 1 && choice(T.exercise, names.map((n) => [n, titleOf(n)]), exercise, (name) => {
    exercise = name;
    if (on) set(true);
  }, { 'data-test': 'mine-exercise' });
  compiler.hidden = true;
  apply();

  return {
    control: make('div', { class: 'mine-control' }, box, which),
    element,
    exercise: () => (on ? exercise : null),
    toggle: () => set(!on),
    changed: () => { if (on && lecture.token) draw(); },
    leave: () => {
      on = false;
      clearTimeout(timer);
      grid.leave();
    },
  };
};
