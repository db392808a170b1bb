// What happened at one pixel? The z-buffer's story and the ray tracer's, side by side, with every number.

import { make, svgElement, trouble } from './dom.js';
import { lookValues } from './look.js';
import { ask, busy, latest, reason } from './net.js';
import { matrix, swatch, table } from './tables.js';
import { T, join, number, same, say, vector } from './words.js';

/** So many pixels across are shown around the chosen one. */
const SIDE = 9;
/** Longer lists are folded. */
const LONG = 6;

const yesNo = (is) => (is === null || is === undefined ? same('–') : is ? T.yes : T.no);
const triangleOf = (test) => test.name ?? same(`${test.object} #${test.triangle}`);

/** A part of the story under its title; long ones are folded. */
const part = (words, content, folded = false) => (folded
  ? make('details', { class: 'part' }, make('summary', { words }), content)
  : make('section', { class: 'part' }, make('h4', { words }), content));

const counted = (counts) => make('ul', { class: 'counts' }, (counts ?? []).map(({ what, count }) =>
  make('li', {}, make('b', {}, count === null || count === undefined ? '' : count.toLocaleString('en').replaceAll(',', '\u202f')), ' ', make('span', { words: what }))));

const testsTitle = (tests) => join([T.tests, same(`(${tests.length})`)]);

const zbufferTests = (tests) => table(T.tests,
  [T.order, T.triangle, T.edges, T.inside, same('α, β, γ'), same('z'), T.before, T.nearer, T.what],
  tests.map((test) => ({
    kind: test.nearer ? 'nearest' : test.inside ? '' : 'missed',
    cells: [String(test.order), triangleOf(test), (test.edges ?? []).map((e) => number(e, 3)).join(', '), yesNo(test.inside),
      test.weights ? test.weights.map((w) => number(w, 3)).join(', ') : '–', number(test.z, 5),
      number(test.before, 5), yesNo(test.inside ? test.nearer : null), test.words ?? same('')],
  })));

const rayTests = (tests) => table(T.tests,
  [T.order, T.triangle, same('t'), same('γ'), same('β'), T.inside, T.nearer, T.what],
  tests.map((test) => ({
    kind: test.nearer ? 'nearest' : test.inside ? '' : 'missed',
    cells: [String(test.order), triangleOf(test), number(test.t), number(test.gamma, 3), number(test.beta, 3),
      yesNo(test.inside), yesNo(test.inside ? test.nearer : null), test.words ?? same(test.exit ?? '')],
  })));

const tests = (list, draw) => (list?.length ? part(testsTitle(list), draw(list), list.length > LONG) : null);

const light = (shading) => shading && part(T.light, [
  shading.mode && make('p', { words: shading.mode }),
  make('p', { class: 'vectors' }, [[T.point, shading.point], [T.normal, shading.normal], [T.toEye, shading.to_eye]]
    .filter(([, v]) => v).map(([words, v]) => make('span', {}, make('span', { words }), ' ', make('code', {}, vector(v))))),
  table(T.light, [T.term, T.formula, T.numbers, T.value], [
    ...(shading.terms ?? []).map((term) => ({ cells: [term.name, make('code', {}, term.formula ?? ''), term.numbers ?? same(''), vector(term.value)] })),
    { kind: 'sum', cells: [T.sum, '', same(''), vector(shading.sum)] },
  ]),
  corners(shading.corners),
]);

/** What a corner contributes, where light is computed at corners. */
const corners = (list) => (list?.length ? part(T.corners, table(T.corners, [T.corner, T.weight, T.point, T.normal, T.value],
  list.map((c) => ({ cells: [typeof c.name === 'object' ? c.name : same(c.name), number(c.weight), vector(c.point), vector(c.normal), vector(c.color)] }))), true) : null);

const column = (name, its, content) => make('section', { class: 'column', 'data-story': name, label: T[name] },
  make('h3', { words: T[name] }),
  make('p', { class: 'result' }, its.color && swatch(its.color), ' ', make('span', { words: its.summary ?? same('') })),
  counted(its.counts), content);

const zbufferColumn = (its) => column('zbuffer', its, [tests(its.tests, zbufferTests), light(its.shading)]);

const rayColumn = (its, solve) => column('raytrace', its, [
  its.ray && part(T.ray, make('p', { class: 'vectors' },
    make('span', {}, make('span', { words: T.origin }), ' ', make('code', {}, vector(its.ray.origin))),
    make('span', {}, make('span', { words: T.direction }), ' ', make('code', {}, vector(its.ray.direction))),
    its.interval && make('span', {}, make('span', { words: T.interval }), ' ', make('code', {}, its.interval.map((t) => number(t)).join(' … '))))),
  tests(its.tests, rayTests),
  its.system && part(T.system, [
    make('div', { class: 'system' },
      matrix(its.system.matrix),
      matrix([['β'], ['γ'], ['t']]), make('span', { class: 'equals' }, '='), matrix((its.system.rhs ?? []).map((x) => [x]))),
    make('p', {}, make('code', {}, `β = ${number(its.system.beta)}   γ = ${number(its.system.gamma)}   t = ${number(its.system.t)}`)),
    make('ul', { class: 'held' }, (its.system.inside ?? []).map(({ test, holds }) =>
      make('li', { class: holds ? 'holds' : 'refuted' }, make('span', { 'aria-hidden': 'true' }, holds ? '✓ ' : '✗ '), make('code', {}, test), ' ', make('span', { class: 'unseen', words: yesNo(holds) })))),
    make('p', {}, make('button', { type: 'button', class: 'main', onclick: solve, 'data-test': 'solve' }, make('span', { words: T.solveSteps }))),
  ]),
  light(its.shading),
  its.shadows?.length > 0 && part(T.shadowRays, table(T.shadowRays, [T.lightName, T.origin, T.direction, T.met, T.lit],
    its.shadows.map((s) => ({ cells: [s.light, vector(s.origin), vector(s.direction), s.met, yesNo(s.lit)] })))),
]);

/** The pixels around the chosen one in one picture, magnified. */
const magnified = (name) => {
  const canvas = make('canvas', { width: SIDE, height: SIDE, class: 'magnified', role: 'img', label: join([T.around, T[name]], ': ') });
  const element = make('figure', {}, make('div', { class: 'glass' }, canvas, make('span', { class: 'middle', 'aria-hidden': 'true' })), make('figcaption', { words: T[name] }));
  return { element, show: (part_) => canvas.getContext('2d').putImageData(part_, 0, 0) };
};

/** The place where stories are told; `solve(values)` opens the steps of a pixel's system. */
export const storyOf = (solve) => {
  const wrong = trouble();
  const title = make('h2', { words: T.storyNone });
  const body = make('div', { class: 'told' });
  const element = make('section', { class: 'story', 'aria-live': 'off', 'data-test': 'story' }, title, wrong.element, body);
  const glasses = { zbuffer: magnified('zbuffer'), raytrace: magnified('raytrace') };
  let magnifying = null;
  let refreshed = false;
  let left = false;

  const told = (story, look) => {
    const verdict = make('div', { class: `verdict-of ${story.agree ? 'same' : 'differs'}`, role: 'status' },
      make('p', {}, make('strong', { words: story.agree ? T.agree : T.differ })),
      story.why?.length > 0 && make('ul', {}, story.why.map((words) => make('li', { words }))));
    const { outside } = story;
    const seen = outside?.svg ? svgElement(outside.svg, outside.alt) : outside?.png && make('img', { src: outside.png });
    if (outside?.png && !outside.svg) say(seen, outside.alt, 'alt');
    const values = { kind: 'solve', how: 'cramer', ...lookValues(look), ...(look.width !== 640 && { size: `${look.width}x${look.height}` }), i: story.pixel[0], j: story.pixel[1] };
    body.replaceChildren(
      make('div', { class: 'glance' }, verdict,
        make('div', { class: 'glasses' }, glasses.zbuffer.element, glasses.raytrace.element),
        seen && make('figure', { class: 'outside' }, seen, make('figcaption', { words: T.outside }))),
      make('div', { class: 'columns' }, zbufferColumn(story.zbuffer), rayColumn(story.raytrace, () => solve(values))));
  };

  const tell = latest(async ({ look, pixel, bring }) => {
    const done = busy();
    try {
      const story = await ask('/api/story', { look, pixel });
      wrong.show(null);
      if (!left && magnifying) told(story, look);
      if (bring && element.getBoundingClientRect().top > window.innerHeight - 160) {
        const calm = window.matchMedia('(prefers-reduced-motion: reduce)').matches;
        element.scrollIntoView({ behavior: calm ? 'auto' : 'smooth', block: 'start' });
      }
    } catch (error) {
      wrong.show(reason(error));
    } finally {
      done();
    }
  });

  const refresh = () => {
    if (!magnifying || refreshed) return;
    refreshed = true;
    requestAnimationFrame(() => {
      refreshed = false;
      if (!magnifying) return;
      const { i, row, pictures } = magnifying;
      for (const name of ['zbuffer', 'raytrace']) glasses[name].show(pictures[name].around(i, row, SIDE));
    });
  };

  return {
    element,
    /** Looks again at the pixels around: a picture has changed. */
    refresh,
    /** Tells the story of this pixel (none with null); `bring` scrolls to it if it is out of sight. */
    tell: (look, pixel, pictures, bring) => {
      magnifying = pixel && { i: pixel[0], row: look.height - 1 - pixel[1], pictures };
      say(title, pixel ? join([T.story, same(`(${pixel.join(', ')})`)]) : T.storyNone);
      if (!pixel) {
        body.replaceChildren();
        return;
      }
      refresh();
      tell({ look, pixel, bring });
    },
    leave: () => {
      left = true;
      magnifying = null;
    },
  };
};
