// What happens next, and what then? A method one step at a time: forward, back, to any step.

import { finite, format } from './address.js';
import { button, choice, make, signButton, svgElement, trouble } from './dom.js';
import { copyButton } from './figures.js';
import { lookFrom, lookValues } from './look.js';
import { ask, busy, latest, reason } from './net.js';
import { parameterRow } from './parameters.js';
import * as show from './show.js';
import { matrix } from './tables.js';
import { T, join, number, same, say } from './words.js';

const KINDS = { depth: T.depthKind, painter: T.painterKind, solve: T.solveKind };
const HOWS = ['cramer', 'inverse', 'elimination'];
/** A step is shown so long while it plays, in milliseconds. */
const PACE = 1200;

/** The numbers of the depth grids, as their figure has them. */
const depthsOf = (lecture) => lecture.figures.find((f) => f.name === 'depth-grids')?.parameters ?? [];

/** The scenes in which the order of painting is worth seeing: small ones first. */
const PAINTED = 'cycle';

/** What the address asks for, as the server is asked. */
const questionFrom = (values, lecture) => {
  const kind = Object.hasOwn(KINDS, values.get('kind')) ? values.get('kind') : 'depth';
  if (kind === 'depth') {
    return { kind, ...Object.fromEntries(depthsOf(lecture).map((p) => [p.name, finite(values, p.name, p.default, p.least, p.greatest)])) };
  }
  const look = lookFrom(values, lecture);
  if (kind === 'painter') return { kind, look: { ...look, scene: values.get('scene') ? look.scene : lecture.scenes.find((s) => s.name === PAINTED)?.name ?? look.scene } };
  const how = HOWS.includes(values.get('how')) ? values.get('how') : HOWS[0];
  const pixel = [finite(values, 'i', null, 0, look.width - 1), finite(values, 'j', null, 0, look.height - 1)];
  return pixel.includes(null) ? { kind, how } : { kind, how, look, pixel: pixel.map(Math.round) };
};

/** The same for the address. */
const valuesOf = ({ look, pixel, ...rest }) => ({ ...rest, ...(look && lookValues(look)), ...(pixel && { i: pixel[0], j: pixel[1] }) });

/** What one step shows. */
const shown = async (step) => {
  const parts = [];
  if (step.svg) parts.push(svgElement(step.svg, step.alt ?? step.words));
  if (step.png) {
    const image = make('img', { src: step.png });
    say(image, step.alt ?? step.words, 'alt');
    await image.decode().catch(() => {});
    parts.push(image);
  }
  const system = step.matrix && [matrix(step.matrix, step.rhs, step.marked)];
  if (system) parts.push(make('div', { class: 'system' }, system));
  if (step.lines?.length) parts.push(make('ul', { class: 'lines' }, step.lines.map((words) => make('li', { words }))));
  if (step.solution) parts.push(make('p', { class: 'lines' }, step.solution.map((x, k) => `${['β', 'γ', 't'][k]} = ${number(x)}`).join('   ')));
  return parts;
};

/** The view. */
export const steps = (place, context) => {
  const { lecture, values } = context;
  let question = questionFrom(values, lecture);
  let answer = null;
  let at = Math.max(0, Math.round(finite(values, 'step', 1, 1)) - 1);
  let playing = null;
  let drawn = 0;

  const wrong = trouble();
  const title = make('h1', { words: T.steps });
  const words = make('p', { class: 'step-words', 'aria-live': 'polite', 'data-test': 'step-words' });
  const count = make('output', { class: 'count', 'data-test': 'step-count' });
  const stage = make('div', { class: 'step-stage', 'data-test': 'step-stage' });
  const slider = make('input', { type: 'range', min: 1, max: 1, step: 1, value: 1, label: T.step, 'data-test': 'step-slider' });
  const keep = () => context.keep({ ...valuesOf(question), step: at + 1 });

  const paint = async () => {
    const list = answer?.steps ?? [];
    at = Math.max(0, Math.min(list.length - 1, at));
    const step = list[at];
    for (const [its, off] of [[first, at <= 0], [back, at <= 0], [forward, at >= list.length - 1], [last, at >= list.length - 1]]) its.setAttribute('aria-disabled', String(off));
    slider.max = Math.max(1, list.length);
    slider.value = at + 1;
    slider.style.setProperty('--part', `${(100 * at) / Math.max(1, list.length - 1)}%`);
    const counted = list.length ? join([T.step, same(at + 1), T.of, same(list.length)]) : same('');
    say(slider, counted, 'aria-valuetext');
    say(count, list.length ? same(`${at + 1} / ${list.length}`) : same(''));
    drawn += 1;
    const mine = drawn;
    if (!step) return;
    const parts = await shown(step);
    if (mine !== drawn) return;
    say(words, step.words ?? same(''));
    stage.replaceChildren(...parts);
  };
  const go = (to) => {
    at = to;
    paint();
    keep();
  };
  const pause = () => {
    clearInterval(playing);
    playing = null;
    player.firstChild.textContent = '▶';
    say(player, T.play, 'aria-label');
    say(player, T.play, 'title');
  };
  const play = () => {
    if (playing) {
      pause();
      return;
    }
    if (at >= (answer?.steps.length ?? 0) - 1) go(0);
    player.firstChild.textContent = '❚❚';
    say(player, T.pause, 'aria-label');
    say(player, T.pause, 'title');
    playing = setInterval(() => {
      if (at >= answer.steps.length - 1) pause();
      else go(at + 1);
    }, PACE);
  };
  const by = (to) => () => {
    pause();
    go(to());
  };
  const first = signButton('«', T.first, by(() => 0), { 'data-test': 'step-first' });
  const back = signButton('‹', T.back, by(() => at - 1), { 'data-test': 'step-back' });
  const player = signButton('▶', T.play, play, { 'data-test': 'step-play' });
  const forward = signButton('›', T.forward, by(() => at + 1), { 'data-test': 'step-forward' });
  const last = signButton('»', T.last, by(() => (answer?.steps.length ?? 1) - 1), { 'data-test': 'step-last' });
  player.classList.add('player');
  slider.addEventListener('input', by(() => Number(slider.value) - 1));

  const load = latest(async () => {
    const done = busy();
    try {
      answer = await ask('/api/steps', question);
      wrong.show(null);
      if (answer.title) say(title, answer.title);
      await paint();
    } catch (error) {
      answer = null;
      say(words, same(''));
      stage.replaceChildren();
      wrong.show(reason(error));
      await paint();
    } finally {
      done();
    }
  });
  const change = (next) => {
    pause();
    question = next;
    load();
    keep();
  };
  const anew = (next) => {
    at = 0;
    change(next);
    controls.replaceChildren(...choices());
    // The list that was chosen from was replaced too.
    controls.querySelector('select').focus();
  };

  /** What can be chosen for this kind of steps. */
  const choices = () => {
    const { kind } = question;
    const list = [choice(T.kind, Object.entries(KINDS), kind, (value) => anew(questionFrom(new URLSearchParams({ kind: value }), lecture)), { 'data-test': 'step-kind' })];
    if (kind === 'depth') {
      list.push(...depthsOf(lecture).map((parameter) => {
        const row = parameterRow(parameter, (value) => change({ ...question, [parameter.name]: value }));
        row.set(question[parameter.name]);
        return row.element;
      }));
    }
    if (kind === 'painter') {
      list.push(choice(T.scene, lecture.scenes.map((s) => [s.name, same(s.name)]), question.look.scene,
        (scene) => { at = 0; change({ ...question, look: { ...question.look, scene } }); }, { 'data-test': 'step-scene' }));
    }
    if (kind === 'solve') {
      list.push(choice(T.how, HOWS.map((how) => [how, T[how]]), question.how, (how) => { at = 0; change({ ...question, how }); }, { 'data-test': 'step-how' }));
      list.push(make('p', { class: 'hint' }, question.pixel
        ? [make('a', { href: format('story', { ...lookValues(question.look), i: question.pixel[0], j: question.pixel[1] }), words: join([T.story, same(`(${question.pixel.join(', ')})`)]) }),
          ' · ', make('a', { href: format('steps', { kind, how: question.how }), words: T.worked })]
        : [make('span', { words: T.worked }), ' · ', make('a', { href: '#loops', words: T.storyNone })]));
    }
    return list;
  };
  const controls = make('div', { class: 'look' });
  controls.append(...choices());

  place.classList.add('stepper');
  place.append(
    make('div', { class: 'heading' }, title, make('div', { class: 'tools' }, copyButton(), button(T.full, show.start, { 'data-test': 'full' }))),
    controls,
    make('div', { class: 'step-controls' }, first, back, player, forward, last, slider, count),
    words, wrong.element, stage);
  load();

  const move = (by_) => () => {
    pause();
    go(at + by_);
  };
  return {
    title: T.steps,
    show: { before: move(-1), after: move(1) },
    keys: { ArrowLeft: move(-1), ArrowRight: move(1), Home: by(() => 0), End: by(() => (answer?.steps.length ?? 1) - 1), ' ': play },
    leave: pause,
  };
};
