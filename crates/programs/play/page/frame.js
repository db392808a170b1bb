// What stays the same on every view? The bar with the views, the language, light or dark, and the list of keys.

import { button, check, fresh, make, signButton } from './dom.js';
import { T, language, remember, remembered, same, say, speak } from './words.js';

const THEMES = ['auto', 'light', 'dark'];
const SIGNS = { auto: '◐', light: '☀', dark: '☾' };
const NAMES = { auto: T.themeAuto, light: T.themeLight, dark: T.themeDark };

/** Fills the bar at the top of the page. */
export const frameOfPage = (help) => {
  const views = document.getElementById('views');
  say(views, T.views, 'aria-label');
  const links = [['#', T.figures], ['#loops', T.loops], ['#steps', T.steps], ['#claims', T.claims]];
  views.append(...links.map(([href, words]) => make('a', { href, words })));

  const speaker = button(T.toLanguage, () => {
    speak(language() === 'en' ? 'nl' : 'en');
    remember('language', language());
  }, { 'data-test': 'language' });
  say(speaker, T.toLanguageSpoken, 'aria-label');

  let theme = THEMES.includes(remembered('theme')) ? remembered('theme') : 'auto';
  const painter = signButton('', T.theme, () => {
    theme = THEMES[(THEMES.indexOf(theme) + 1) % THEMES.length];
    remember('theme', theme);
    paint();
  }, { 'data-test': 'theme' });
  const paint = () => {
    document.documentElement.dataset.theme = theme;
    painter.firstChild.textContent = SIGNS[theme];
    const words = { en: `${T.theme.en}: ${NAMES[theme].en}`, nl: `${T.theme.nl}: ${NAMES[theme].nl}` };
    say(painter, words, 'aria-label');
    say(painter, words, 'title');
  };
  paint();
  const helper = signButton('?', T.help, () => help.showModal(), { 'data-test': 'help' });
  document.getElementById('tools').append(speaker, painter, helper);
};

const KEYS = [
  ['f', T.keyFull], ['r', T.keyReset], ['← →', T.keyArrows], ['Home End', T.keyEnds], ['m', T.keyMine], ['s', T.keySlide],
  ['Esc', T.keyEscape], ['?', T.keyHelp], ['← → ↑ ↓', T.keyInField], ['← → ↑ ↓ + −', T.keyInPicture],
];

/** The list of keys, over the page. */
export const helpDialog = () => {
  const title = fresh('keys');
  const dialog = make('dialog', { 'aria-labelledby': title, 'data-test': 'keys' },
    make('h2', { id: title, words: T.help }),
    make('dl', { class: 'keys' }, KEYS.flatMap(([keys, words]) => [
      make('dt', {}, keys.split(' ').map((key) => make('kbd', { words: same(key) }))),
      make('dd', { words }),
    ])),
    check(T.letters, remembered('letters') !== 'off', (on) => remember('letters', on ? 'on' : 'off')),
    button(T.close, () => dialog.close(), { class: 'main' }));
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close();
  });
  document.body.append(dialog);
  return dialog;
};
