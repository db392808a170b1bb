// What can be moved in a figure? A row for each of its numbers, as the address or the lecture has them.

import { finite } from './address.js';
import { make } from './dom.js';
import { parameterRow } from './parameters.js';
import { T, join, number, same } from './words.js';

/** The rows of a figure's parameters; `onchange(name, value, settled)`. */
export const parametersOf = (figure, values, onchange) => {
  const rows = figure.parameters.map((parameter) => {
    const row = parameterRow(parameter, (value, settled) => onchange(parameter.name, value, settled));
    const asked = finite(values, parameter.name, parameter.default, parameter.least, parameter.greatest);
    row.set(parameter.whole ? Math.round(asked) : asked);
    return row;
  });
  const hint = make('p', { class: 'hint', words: T.byHand });
  hint.hidden = true;
  const read = () => Object.fromEntries(rows.map((row) => [row.parameter.name, row.value]));
  return {
    element: make('section', { class: 'parameters', label: T.parameters }, rows.map((row) => row.element), hint),
    values: read,
    show: (set) => rows.forEach((row) => row.set(set[row.parameter.name] ?? row.value)),
    reset: () => {
      rows.forEach((row) => row.set(row.parameter.default));
      return read();
    },
    hands: (any) => { hint.hidden = !any; },
    /** `exponent p: 64`, as both languages say it. */
    words: (name) => {
      const row = rows.find((r) => r.parameter.name === name);
      return join([row.parameter.label, same(number(row.value))], ': ');
    },
  };
};
