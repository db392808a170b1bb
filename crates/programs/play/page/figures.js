// How does one figure live on the page? Its numbers are moved beside it or in it, and the server draws it anew.

import { flush, format } from './address.js';
import { announce, button, make, signButton, trouble } from './dom.js';
import { drawingGrid } from './drawings.js';
import { mineSwitch } from './mine.js';
import { ask, busy, latest, reason } from './net.js';
import { parametersOf } from './panel.js';
import * as show from './show.js';
import { sizes } from './sizes.js';
import { T, join, same, say } from './words.js';

/** So long after the last change the drawing is said aloud, in milliseconds. */
const CALM = 700;
/** So long a button says what it did, in milliseconds. */
const SAID = 2500;

/** One figure with everything that moves it. */
export const figure = (place, context) => {
  const { lecture, figure: its, values, name } = context;
  const wrong = trouble();
  const waiting = make('p', { class: 'waiting', words: T.working });
  const size = sizes(its);
  let set = {};
  let drawings = [];
  let calm = null;
  // Counts the changes made beside the drawing, so that a late answer to a drag takes nothing back.
  let version = 0;
  let left = false;

  const keep = () => {
    const changed = Object.fromEntries(its.parameters.filter((p) => set[p.name] !== p.default).map((p) => [p.name, Number(set[p.name].toPrecision(6))]));
    context.keep({ ...changed, mine: mine.exercise() }, name);
  };

  /** Takes what the server answered: where a drag led, and the drawings. */
  const take = async (answer, settled, dragged) => {
    if (dragged) {
      Object.assign(set, answer.set);
      panel.show(set);
    }
    drawings = answer.drawings;
    await grid.show(drawings);
    waiting.hidden = true;
    panel.hands(drawings.some((d) => d.handles?.length));
    keep();
    if (!settled) return;
    mine.changed();
    clearTimeout(calm);
    calm = setTimeout(() => announce(join(drawings.map((d) => d.alt))), CALM);
  };

  const draw = latest(async ({ move, settled }) => {
    const done = busy();
    const [began, before] = [performance.now(), version];
    const [pixels, sharp] = size.next(settled && !move?.dragged, grid.pixelWidth(), drawings.length);
    const asked = { figure: its.stem, set, ...(pixels && { size: pixels }) };
    try {
      const answer = await (move
        ? ask('/api/drag', { ...asked, drawing: move.drawing, handle: move.handle, to: move.to })
        : ask('/api/figure', asked));
      if (left) return;
      size.took(pixels, performance.now() - began);
      wrong.show(null);
      await take(answer, settled, move && before === version);
      if (settled && !sharp && !draw.waits()) draw({ settled: true });
    } catch (error) {
      waiting.hidden = true;
      wrong.show(reason(error));
    } finally {
      done();
    }
  });

  const valueOf = (names) => {
    const moved = its.parameters.filter((p) => names.includes(p.name));
    const text = join(moved.map((p) => panel.words(p.name)), ', ');
    return { text, first: moved[0] && { ...moved[0], value: set[moved[0].name] } };
  };
  const room = (element) => {
    if (show.isOn()) return element.parentElement.clientHeight;
    return window.innerWidth < 640 ? Infinity : Math.max(300, window.innerHeight - 260);
  };
  const grid = drawingGrid({
    onmove: (drawing, handle, to, settled) => draw({ move: { drawing, handle, to, dragged: !settled }, settled }),
    valueOf,
    room,
  });
  const panel = parametersOf(its, values, (name_, value, settled) => {
    set[name_] = value;
    version += 1;
    draw({ settled });
    keep();
  });
  set = panel.values();
  const mine = mineSwitch(its, lecture, values.get('mine'), () => set, () => keep());

  const reset = () => {
    set = panel.reset();
    version += 1;
    draw({ settled: true });
    keep();
  };
  const at = lecture.figures.indexOf(its);
  const step = (to) => {
    const next = lecture.figures[Math.min(lecture.figures.length - 1, Math.max(0, to))];
    if (next !== its) context.go(format(next.stem));
  };

  const [first, ...also] = its.numbers;
  const tools = make('div', { class: 'tools' },
    signButton('←', T.previous, () => step(at - 1), { disabled: at === 0, 'data-test': 'previous' }),
    signButton('→', T.next, () => step(at + 1), { disabled: at === lecture.figures.length - 1, 'data-test': 'next' }),
    its.parameters.length > 0 && button(T.reset, reset, { 'data-test': 'reset', class: 'reset' }),
    copyButton(),
    button(T.full, show.start, { 'data-test': 'full' }));
  place.append(make('article', { class: 'figure', 'data-figure': its.stem },
    make('div', { class: 'heading' },
      make('h1', { 'data-test': 'figure-title' }, make('span', { class: 'number' }, first), ' ', make('span', { words: its.title })),
      also.length > 0 && make('span', { class: 'also' }, also.join(' · ')),
      tools),
    make('div', { class: `workspace${its.parameters.length || its.mine.length ? '' : ' bare'}` },
      make('div', { class: 'picture' }, grid.element, waiting, wrong.element),
      make('div', { class: 'panel' }, panel.element, mine.control)),
    make('p', { class: 'caption', 'data-test': 'caption', words: its.caption }),
    mine.element,
    related(its, lecture)));
  draw({ settled: true });

  return {
    title: join([same(first), its.title]),
    show: { before: () => step(at - 1), after: () => step(at + 1) },
    keys: {
      r: reset,
      m: mine.toggle,
      ArrowLeft: () => step(at - 1),
      ArrowRight: () => step(at + 1),
      Home: () => step(0),
      End: () => step(lecture.figures.length - 1),
    },
    leave: () => {
      left = true;
      clearTimeout(calm);
      grid.leave();
      mine.leave();
    },
  };
};

/** A button that puts the address of what is seen onto the clipboard, and says so for a while. */
export const copyButton = () => {
  let timer = null;
  const element = button(T.copy, async () => {
    flush();
    const copied = await navigator.clipboard.writeText(location.href).then(() => true, () => false);
    announce(copied ? T.copied : T.notCopied);
    say(element.firstChild, copied ? T.copiedShort : T.notCopied);
    clearTimeout(timer);
    timer = setTimeout(() => say(element.firstChild, T.copy), SAID);
  }, { 'data-test': 'copy', class: 'copy' });
  return element;
};

/** Kinds of steps that belong to items of the lecture. */
const STEPS = { L13: 'painter', L14: 'painter', L17: 'depth', L50: 'solve', L51: 'solve', L54: 'solve' };

/** Where else this is spoken of. */
const related = (its, lecture) => {
  const said = lecture.claims.filter((claim) => its.numbers.includes(claim.number));
  const kind = its.numbers.map((n) => STEPS[n]).find(Boolean);
  if (said.length === 0 && !kind) return null;
  return make('div', { class: 'related' },
    kind && make('p', {}, make('a', { href: format('steps', { kind }), words: T.alsoSteps })),
    said.length > 0 && make('details', {}, make('summary', { words: T.alsoSaid }),
      make('ul', {}, said.map((claim) => make('li', {},
        make('a', { href: format(claim.number, { claim: claim.stem }) }, make('span', { class: 'number' }, claim.number), ' ', make('span', { words: claim.truth })))))));
};

/** Letters as the slides write them. */
const GREEK = { alpha: 'α', beta: 'β', gamma: 'γ', theta: 'θ', phi: 'φ' };

/** All figures, with their titles. */
const list = (lecture) => make('ul', { class: 'list' }, lecture.figures.map((its) => make('li', {},
  make('a', { href: format(its.stem), 'data-test': 'figure-link', 'data-figure': its.stem },
    make('span', { class: 'number' }, its.numbers[0]),
    make('span', { class: 'title', words: its.title }),
    its.parameters.length > 0 && make('span', { class: 'moves' }, its.parameters.map((p) => make('span', {}, GREEK[p.name] ?? p.name)))))));

/** What there is. */
export const overview = (place, { lecture }) => {
  place.classList.add('overview');
  place.append(
    make('h1', { words: T.overview }),
    make('p', { class: 'lead', words: T.overviewLead }),
    make('ul', { class: 'doors' }, [['#loops', T.loops, T.doorLoops], ['#steps', T.steps, T.doorSteps], ['#claims', T.claimsTitle, T.claimsLead]]
      .map(([href, words, lead]) => make('li', {}, make('a', { href }, make('strong', { words }), make('span', { words: lead }))))),
    make('h2', { words: T.figures }),
    list(lecture),
    make('p', { class: 'foot' }, make('a', { href: '#measure', words: T.measure })));
  return { title: null };
};

/** A name that nothing has. */
export const unknown = (place, { lecture, name }) => {
  place.append(
    make('h1', { 'data-test': 'unknown', words: { en: `${T.unknown.en}: ${name}`, nl: `${T.unknown.nl}: ${name}` } }),
    make('p', { class: 'lead', words: T.unknownLead }),
    list(lecture));
  return { title: T.unknown };
};
