// Is what the slides say true? Each claim with its test, run when it is looked at; errors can be switched off and on.

import { format } from './address.js';
import { button, fresh, make, trouble } from './dom.js';
import { drawingGrid } from './drawings.js';
import { ask, busy, reason } from './net.js';
import * as show from './show.js';
import { T, join, same, say } from './words.js';

/** Trials wait for each other: all of them together would keep the machine from everything else. */
let line = Promise.resolve();
const inLine = (work) => {
  line = line.then(work, work);
  return line;
};

/** What was found already, by claim: a trial gives the same verdict each time. */
const found = new Map();

const VERSIONS = ['slide', 'right'];

/** One claim; `onversion(version)` when its switch is moved. */
const trial = (claim, firstVersion, onversion) => {
  let version = VERSIONS.includes(firstVersion) ? firstVersion : 'slide';
  let answer = null;
  let state = 'waiting';
  let wanted = false;
  const wrong = trouble();
  const verdict = make('span', { class: 'verdict-place', 'aria-live': 'polite', 'data-test': 'verdict' });
  const evidence = make('ul', { class: 'evidence' });
  const says = make('div', { class: 'says', 'aria-live': 'polite', 'data-test': 'says' });
  const grid = drawingGrid({ test: 'claim-drawings', captions: false, room: () => Math.max(260, window.innerHeight - (show.isOn() ? 200 : 360)) });
  const group = fresh('version');
  const radios = VERSIONS.map((name) => {
    const radio = make('input', { type: 'radio', name: group, value: name, 'data-test': 'claim-version' });
    radio.checked = name === version;
    radio.addEventListener('change', () => choose(name));
    return radio;
  });
  const versions = make('fieldset', { class: 'versions', 'data-test': 'claim-switch' },
    make('legend', { class: 'unseen', words: join([T.version, same(claim.number)]) }),
    radios.map((radio, at) => make('label', {}, radio, make('span', { words: at === 0 ? T.slideVersion : T.rightVersion }))));
  versions.hidden = true;
  const runner = button(T.run, () => run(), { 'data-test': 'run' });

  const paint = async () => {
    radios.forEach((radio) => { radio.checked = radio.value === version; });
    element.dataset.version = version;
    const of = answer?.[version];
    says.replaceChildren(...(of ? [
      of.says && make('p', {}, make('code', { words: of.says })),
      of.gives && make('p', { class: 'gives' }, make('span', { 'aria-hidden': 'true' }, '→ '), make('span', { words: of.gives })),
    ].filter(Boolean) : []));
    const drawings = answer?.drawings ?? [];
    const seen = versions.hidden || drawings.length < 2 ? drawings : [drawings[version === 'slide' ? 0 : 1]];
    element.classList.toggle('pictured', seen.length > 0);
    if (seen.length) await grid.show(seen);
  };
  const clear = () => {
    verdict.removeAttribute('data-say-en');
    verdict.removeAttribute('data-say-nl');
    verdict.replaceChildren();
  };
  const choose = (name) => {
    version = name;
    paint();
    onversion(version);
  };
  const run = () => {
    wanted = true;
    if (state !== 'waiting') return;
    state = 'running';
    runner.hidden = true;
    say(verdict, T.working);
    inLine(async () => {
      // Whoever scrolled on waits for what is in sight now.
      if (!wanted || !element.isConnected) {
        state = 'waiting';
        runner.hidden = false;
        clear();
        return;
      }
      const done = busy();
      try {
        answer = found.get(claim.stem) ?? await ask('/api/claim', { claim: claim.stem });
        found.set(claim.stem, answer);
        clear();
        verdict.append(make('span', { class: `verdict ${answer.class}`, words: answer.verdict }),
          ...(answer.expected ? [] : [make('span', { class: 'unexpected', words: T.unexpected })]));
        evidence.replaceChildren(...(answer.evidence ?? []).map((text) => make('li', typeof text === 'object' ? { words: text } : { lang: 'en' }, typeof text === 'object' ? null : text)));
        versions.hidden = !(claim.erratum && (answer.slide || answer.right || (answer.drawings ?? []).length > 1));
        await paint();
        state = 'done';
      } catch (error) {
        state = 'waiting';
        runner.hidden = false;
        clear();
        wrong.show(reason(error));
      } finally {
        done();
      }
    });
  };
  const element = make('article', { class: `claim${claim.erratum ? ' erratum' : ''}`, id: `claim-${claim.stem}`, 'data-claim': claim.stem },
    make('h2', {}, make('a', { class: 'number', href: format(claim.number, { claim: claim.stem }) }, claim.number), ' ', verdict, runner),
    make('div', { class: 'sides' },
      make('div', { class: 'words' },
        make('p', { class: 'quote', lang: 'nl' }, `„${claim.quote}”`),
        make('p', { class: 'translation', lang: 'en' }, `“${claim.translation}”`),
        make('p', { class: 'truth', words: claim.truth }),
        versions, says),
      grid.element,
      make('div', { class: 'words' }, evidence, wrong.element,
        claim.code?.length > 0 && make('p', { class: 'code' }, claim.code.map((name) => make('code', {}, name))))));
  return {
    element,
    run,
    rest: () => { wanted = false; },
    claim,
    flip: () => { if (!versions.hidden) choose(version === 'slide' ? 'right' : 'slide'); },
    leave: grid.leave,
  };
};

/** The view: all claims, or those of one number. */
export const claims = (place, context) => {
  const { lecture, claim: asked, values, name } = context;
  const onlyErrata = values.get('only') === 'errata';
  const list = lecture.claims.filter((c) => (asked ? c.number === asked.number : !onlyErrata || c.erratum));
  const trials = list.map((claim) => trial(claim, claim === asked ? values.get('version') : null, (version) => {
    if (asked) context.keep({ claim: claim.stem, version }, name);
  }));
  const observer = new IntersectionObserver((entries) => {
    for (const entry of entries) {
      const its = trials.find((t) => t.element === entry.target);
      if (entry.isIntersecting) its.run();
      else its.rest();
    }
  }, { rootMargin: '120px' });
  trials.forEach((t) => observer.observe(t.element));

  const link = (href, words, here) => make('a', { href, 'aria-current': here ? 'true' : null, words });
  place.classList.add('claims');
  place.append(
    make('div', { class: 'heading' },
      make('h1', {}, asked && make('span', { class: 'number' }, `${asked.number} `), make('span', { words: T.claimsTitle })),
      make('div', { class: 'tools' }, button(T.full, show.start, { 'data-test': 'full' }))),
    make('p', { class: 'lead', words: T.claimsLead }),
    make('nav', { class: 'filters', label: T.claims },
      link('#claims', T.allClaims, !asked && !onlyErrata), link('#claims?only=errata', T.errata, !asked && onlyErrata)),
    make('div', { class: 'trials' }, trials.map((t) => t.element)));

  /** The claim that the eye is on: the one with the focus, or the first that is in the middle of the window. */
  const current = () => trials.find((t) => t.element.contains(document.activeElement))
    ?? trials.find((t) => t.claim === asked && t.element.getBoundingClientRect().bottom > 0)
    ?? trials.find((t) => t.element.getBoundingClientRect().bottom > window.innerHeight * 0.4);
  const first = trials.find((t) => t.claim === asked);
  if (first && first !== trials[0]) requestAnimationFrame(() => first.element.scrollIntoView({ block: 'start' }));

  const numbers = [...new Set(lecture.claims.filter((c) => c.erratum).map((c) => c.number))];
  const step = (by) => {
    const at = numbers.indexOf(asked?.number);
    const next = numbers[Math.min(numbers.length - 1, Math.max(0, at + by))];
    if (at >= 0 && next !== asked.number) context.go(format(next, { claim: lecture.claims.find((c) => c.number === next).stem }));
  };
  const neighbours = asked?.erratum ? { before: () => step(-1), after: () => step(1) } : null;
  return {
    title: asked ? join([same(asked.number), T.claimsTitle]) : T.claimsTitle,
    show: neighbours,
    keys: { s: () => current()?.flip(), ...(neighbours && { ArrowLeft: neighbours.before, ArrowRight: neighbours.after }) },
    leave: () => {
      observer.disconnect();
      trials.forEach((t) => t.leave());
    },
  };
};
