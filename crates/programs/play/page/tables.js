// How do numbers stand in rows and columns? As tables with headings, and as matrices with brackets.

import { make } from './dom.js';
import { number } from './words.js';

/** A table: `columns` are words, `rows` lists of cells (text, words or elements), each with a class if it needs one. */
export const table = (caption, columns, rows) => make('div', { class: 'scroll', tabindex: 0, role: 'region', label: caption },
  make('table', {},
    make('caption', { class: 'unseen', words: caption }),
    make('thead', {}, make('tr', {}, columns.map((words) => make('th', { scope: 'col', words })))),
    make('tbody', {}, rows.map(({ cells, kind }) => make('tr', { class: kind }, cells.map(cell))))));

const cell = (content) => {
  if (content instanceof Node) return make('td', {}, content);
  if (content && typeof content === 'object' && 'en' in content) return make('td', { words: content });
  return make('td', { class: 'figures' }, content ?? '–');
};

/** Whether a cell is marked: `[row, column]` or `{row, column}`; the right-hand side is the column after the last. */
const isMarked = (marked, row, column) => (marked ?? []).some((m) =>
  (Array.isArray(m) ? m[0] === row && m[1] === column : m.row === row && m.column === column));

const shown = (entry) => (typeof entry === 'number' ? number(entry) : entry && typeof entry === 'object' && 'en' in entry ? make('span', { words: entry }) : String(entry ?? ''));

/** A matrix, with a right-hand side if there is one, and marked cells. */
export const matrix = (rows, right, marked) => make('table', { class: `matrix${right ? ' augmented' : ''}` },
  make('tbody', {}, rows.map((entries, row) => make('tr', {},
    [...entries, ...(right ? [right[row]].flat() : [])].map((entry, column) => make('td', {
      class: [column === entries.length ? 'right' : '', isMarked(marked, row, column) ? 'marked' : ''].join(' ').trim() || null,
    }, shown(entry)))))));

/** A colour as a small square beside its numbers; `bytes` are 8-bit sRGB. */
export const swatch = (bytes) => {
  const element = make('span', { class: 'swatch', 'aria-hidden': 'true' });
  element.style.backgroundColor = `rgb(${bytes.join(' ')})`;
  return make('span', { class: 'colour' }, element, ` ${bytes.join(', ')}`);
};
