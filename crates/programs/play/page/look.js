// What do the three loops look at, and how? One look for all of them, chosen by controls and kept in the address.

import { finite } from './address.js';
import { check, choice, make } from './dom.js';
import { parameterRow } from './parameters.js';
import { T, same } from './words.js';

const SHADINGS = ['flat', 'gouraud', 'phong'];
const HIGHLIGHTS = ['phong', 'blinn'];
const SHOWS = ['color', 'depth', 'normals', 'barycentric', 'overdraw'];
const SIZES = [[320, 240], [480, 360], [640, 480], [960, 720], [1280, 960]];
const GREATEST_EXPONENT = 4096;
const EXPONENT = { name: 'p', label: T.exponent, default: 64, least: 0, greatest: GREATEST_EXPONENT, whole: false };

/** How far the eye may move: degrees, and multiples of the scene's distance. */
export const ENDS = { elevation: [-180, 180], distance: [0.2, 5] };

const DEFAULT = {
  scene: 'teapot', azimuth: 0, elevation: 0, distance: 1, width: 640, height: 480,
  shading: 'phong', highlight: 'blinn', p: null, shadows: true, level: null, show: 'color',
};

const among = (choices, value, otherwise) => (choices.includes(value) ? value : otherwise);

/** The look that the address asks for. */
export const lookFrom = (values, lecture) => {
  const scenes = lecture.scenes.map((s) => s.name);
  const first = among(scenes, DEFAULT.scene, scenes[0]);
  const [width, height] = (values.get('size') ?? '').split('x').map(Number);
  const size = SIZES.find(([w, h]) => w === width && h === height) ?? [DEFAULT.width, DEFAULT.height];
  const level = finite(values, 'level', null, 0, 5);
  return {
    scene: among(scenes, values.get('scene'), first),
    azimuth: finite(values, 'azimuth', 0) % 360,
    elevation: finite(values, 'elevation', 0, ...ENDS.elevation),
    distance: finite(values, 'distance', 1, ...ENDS.distance),
    width: size[0],
    height: size[1],
    shading: among(SHADINGS, values.get('shading'), DEFAULT.shading),
    highlight: among(HIGHLIGHTS, values.get('highlight'), DEFAULT.highlight),
    p: finite(values, 'p', null, 0, GREATEST_EXPONENT),
    shadows: values.get('shadows') !== 'false',
    level: level === null ? null : Math.round(level),
    show: among(SHOWS, values.get('show'), DEFAULT.show),
  };
};

/** What of a look differs from the first one: for the address. */
export const lookValues = (look) => {
  const { width, height, ...rest } = look;
  const values = { scene: look.scene };
  for (const [key, value] of Object.entries(rest)) {
    if (value !== DEFAULT[key]) values[key] = typeof value === 'number' ? Number(value.toPrecision(5)) : value;
  }
  if (width !== DEFAULT.width || height !== DEFAULT.height) values.size = `${width}x${height}`;
  return values;
};

/** The controls; `onchange(changes, settled)`. */
export const lookControls = (look, lecture, onchange) => {
  const pick = (words, key, choices) => choice(words, choices, look[key], (value) => onchange({ [key]: value }, true), { 'data-look': key });
  const row = parameterRow(EXPONENT, (p, settled) => onchange({ p }, settled));
  if (look.p !== null) row.set(look.p);
  row.element.hidden = look.p === null;
  const own = check(T.ownExponent, look.p !== null, (on) => {
    row.element.hidden = !on;
    onchange({ p: on ? row.value : null }, true);
  }, { 'data-look': 'own-p' });
  const level = choice(T.level, [['', T.ofScene], ...[0, 1, 2, 3, 4, 5].map((n) => [String(n), same(n)])], String(look.level ?? ''),
    (value) => onchange({ level: value === '' ? null : Number(value) }, true), { 'data-look': 'level' });
  const size = choice(T.size, SIZES.map(([w, h]) => [`${w}x${h}`, same(`${w} × ${h}`)]), `${look.width}x${look.height}`, (value) => {
    const [width, height] = value.split('x').map(Number);
    onchange({ width, height }, true);
  }, { 'data-look': 'size' });
  return make('div', { class: 'look' },
    pick(T.scene, 'scene', lecture.scenes.map((s) => [s.name, same(s.name)])),
    pick(T.shading, 'shading', SHADINGS.map((name) => [name, T[name]])),
    pick(T.highlight, 'highlight', [['phong', T.phongHighlight], ['blinn', T.blinn]]),
    pick(T.show, 'show', SHOWS.map((name) => [name, T[name]])),
    level, size,
    make('div', { class: 'checks' }, check(T.shadows, look.shadows, (shadows) => onchange({ shadows }, true), { 'data-look': 'shadows' }), own),
    row.element);
};
