// Which view does the address ask for? This module finds it, puts it on the page, and hands it the keys.

import { claims } from './claims.js';
import { announce, button, make } from './dom.js';
import { figure, overview, unknown } from './figures.js';
import * as address from './address.js';
import { frameOfPage, helpDialog } from './frame.js';
import { loops } from './loops.js';
import { measure } from './measure.js';
import { ask, busy, reason } from './net.js';
import * as show from './show.js';
import { steps } from './steps.js';
import { T, firstLanguage, join, now, onLanguage, remembered, same, say, speak } from './words.js';

const place = document.getElementById('main');
const VIEWS = { '': overview, loops, story: loops, steps, claims, measure };

let lecture = null;
let current = null;
const help = helpDialog();

/** What a name means: a view, a figure, a claim, or nothing. */
const find = (name, values) => {
  const wanted = name.toLowerCase();
  const claim = lecture.claims.find((c) => c.stem.toLowerCase() === wanted || c.stem === values.get('claim'));
  if (claim) return { view: claims, claim };
  if (Object.hasOwn(VIEWS, name)) return { view: VIEWS[name] };
  const { figures } = lecture;
  const found = figures.find((f) => f.stem.toLowerCase() === wanted)
    ?? figures.find((f) => f.stem.toLowerCase().startsWith(`${wanted}-`))
    ?? figures.find((f) => f.name.toLowerCase() === wanted);
  if (found) return { view: figure, figure: found };
  // A figure may show several items of the lecture; an error in the slides is shown best by its own switch.
  const byNumber = lecture.claims.find((c) => c.number.toLowerCase() === wanted);
  const shows = figures.find((f) => f.numbers.some((n) => n.toLowerCase() === wanted));
  if (shows && !byNumber?.erratum) return { view: figure, figure: shows };
  return byNumber ? { view: claims, claim: byNumber } : { view: unknown };
};

/** Counts the views, so that one that was left no longer writes the address. */
let turn = 0;

const route = () => {
  // The address may change before it is known what there is.
  if (!lecture) return;
  address.forget();
  turn += 1;
  const its = turn;
  const { name, values } = address.read();
  const found = find(name, values);
  current?.leave?.();
  place.replaceChildren();
  place.className = '';
  const context = {
    lecture,
    name,
    values,
    ...found,
    /** Keeps the state in the address; another name for it may be given. */
    keep: (state, as = name) => { if (its === turn) address.replace(as, state); },
    go: (hash) => { location.hash = hash; },
  };
  current = found.view(place, context) ?? {};
  show.attach(current.show);
  titled();
  for (const link of document.querySelectorAll('#views a')) {
    const to = link.hash.replace(/^#/, '');
    const here = VIEWS[to] === found.view || (to === '' && found.view === figure);
    if (here) link.setAttribute('aria-current', 'page');
    else link.removeAttribute('aria-current');
  }
};

/** After a step to another view the reader begins at its title. */
const arrive = () => {
  route();
  if (!lecture) return;
  window.scrollTo(0, 0);
  const heading = place.querySelector('h1');
  if (heading) {
    heading.tabIndex = -1;
    heading.focus({ preventScroll: true });
  }
  if (current.title) announce(current.title);
};

const titled = () => {
  document.title = now(current?.title ? join([current.title, same('lightlab')], ' – ') : same('lightlab'));
};

/** Whether this element does something with arrow keys itself. */
const usesArrows = (element) =>
  element.closest?.('input, select, textarea, canvas, [role=slider], [role=application], [data-arrows], dialog') !== null;

const isTyping = (element) => element.closest?.('select, textarea, input[type=text]') !== null;

document.addEventListener('keydown', (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
  const { key, target } = event;
  if (key === 'Escape' && show.isOn() && !help.open) {
    show.stop();
    return;
  }
  const single = key.length === 1;
  if (single && (remembered('letters') === 'off' || isTyping(target) || help.open)) return;
  if (!single && usesArrows(target)) return;
  if (key === ' ' && target.closest?.('button, a, summary') !== null) return;
  const own = current?.keys?.[key];
  const general = { f: show.toggle, '?': () => help.showModal() }[key];
  const act = own ?? general;
  if (!act || (['Home', 'End'].includes(key) && !show.isOn())) return;
  event.preventDefault();
  act(event);
});

// The address is up to date before a link or the browser's own buttons leave it.
document.addEventListener('click', (event) => {
  if (event.target.closest?.('a')) address.flush();
}, true);
document.getElementById('skip').addEventListener('click', (event) => {
  event.preventDefault();
  place.focus();
});
window.addEventListener('hashchange', arrive);

const start = async () => {
  place.replaceChildren(make('p', { class: 'lead', words: T.working }));
  const done = busy();
  try {
    lecture = await ask('/api/lecture');
    route();
  } catch (error) {
    place.replaceChildren(
      make('p', { class: 'trouble', role: 'status', words: reason(error) ?? T.gone }),
      button(T.again, start));
  } finally {
    done();
  }
};

speak(firstLanguage());
say(document.getElementById('skip'), T.skip);
onLanguage(titled);
frameOfPage(help);
start();
