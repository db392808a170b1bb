// How does the page make its elements? With one short function, and texts that know both languages.

import { say } from './words.js';

/**
 * An element with attributes, listeners (`onclick`), words (`words`: its text, `label`: its accessible name) and children.
 * Attributes that are false, null or undefined are left out.
 */
export const make = (name, attributes = {}, ...children) => {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (key === 'words') say(element, value);
    else if (key === 'label') say(element, value, 'aria-label');
    else if (key === 'hint') say(element, value, 'title');
    else if (key.startsWith('on')) element.addEventListener(key.slice(2), value);
    else element.setAttribute(key, value === true ? '' : value);
  }
  element.append(...children.flat(2).filter((child) => child !== null && child !== undefined && child !== false));
  return element;
};

/** A button with words. */
export const button = (words, onclick, attributes = {}) =>
  make('button', { type: 'button', ...attributes, onclick }, make('span', { words }));

/** A button with a sign; its words are its name. */
export const signButton = (sign, words, onclick, attributes = {}) =>
  make('button', { type: 'button', class: 'sign', label: words, hint: words, ...attributes, onclick },
    make('span', { 'aria-hidden': 'true' }, sign));

let names = 0;
/** A name that no other element of the page has. */
export const fresh = (prefix) => `${prefix}-${(names += 1)}`;

/** A list to choose from: `choices` are pairs of value and words. */
export const choice = (words, choices, value, onchange, attributes = {}) => {
  const id = fresh('choice');
  const select = make('select', { id, ...attributes },
    choices.map(([key, text]) => make('option', { value: key, words: text })));
  select.value = value;
  select.addEventListener('change', () => onchange(select.value));
  return make('div', { class: 'choice' }, make('label', { for: id, words }), select);
};

/** Something that is on or off. */
export const check = (words, value, onchange, attributes = {}) => {
  const box = make('input', { type: 'checkbox', ...attributes });
  box.checked = value;
  box.addEventListener('change', () => onchange(box.checked));
  return make('label', { class: 'check' }, box, make('span', { words }));
};

/** Says something to those who listen, without moving anything on the page. */
export const announce = (words) => say(document.getElementById('spoken'), words);

/** The drawing of an SVG text as part of the page: it takes the page's colours and language. */
export const svgElement = (text, alt) => {
  const template = document.createElement('template');
  template.innerHTML = text;
  const svg = template.content.querySelector('svg') ?? document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  svg.querySelectorAll('style').forEach((style) => style.remove());
  svg.classList.add('fig');
  svg.setAttribute('role', 'img');
  if (alt) say(svg, alt, 'aria-label');
  return svg;
};

/** Words of trouble, shown where it happened. */
export const trouble = () => {
  const element = make('p', { class: 'trouble', role: 'status', 'data-test': 'trouble' });
  element.hidden = true;
  return {
    element,
    show: (words) => {
      element.hidden = !words;
      say(element, words ?? { en: '', nl: '' });
    },
  };
};
