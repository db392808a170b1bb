// In which language does the page speak? In the reader's, one of two; every text of the interface stands here in both.

/** Texts of the interface: English, Dutch. What the lecture says itself comes from the server. */
const TEXTS = {
  skip: ['Skip to the contents', 'Naar de inhoud'],
  views: ['Views', 'Onderdelen'],
  figures: ['Figures', 'Figuren'],
  loops: ['One scene, three loops', 'Eén scène, drie lussen'],
  steps: ['Step by step', 'Stap voor stap'],
  claims: ['Claims', 'Beweringen'],
  measure: ['Measure speed', 'Meet de snelheid'],
  overview: ['Every figure of the lecture, live', 'Elke figuur van het college, levend'],
  overviewLead: [
    'Choose a figure and move what can be moved: drag in the drawing, or scrub a number. The address keeps what you see.',
    'Kies een figuur en beweeg wat beweegbaar is: sleep in de tekening, of schuif een getal. Het adres onthoudt wat je ziet.',
  ],
  toLanguage: ['Nederlands', 'English'],
  toLanguageSpoken: ['Lees deze pagina in het Nederlands', 'Read this page in English'],
  theme: ['Light or dark', 'Licht of donker'],
  themeAuto: ['as the system', 'zoals het systeem'],
  themeLight: ['light', 'licht'],
  themeDark: ['dark', 'donker'],
  help: ['Keys', 'Toetsen'],
  close: ['Close', 'Sluit'],
  previous: ['Previous', 'Vorige'],
  next: ['Next', 'Volgende'],
  reset: ['Reset', 'Terug naar begin'],
  copy: ['Copy address', 'Kopieer adres'],
  copied: ['The address was copied', 'Het adres is gekopieerd'],
  copiedShort: ['Copied ✓', 'Gekopieerd ✓'],
  notCopied: ['Copy it from the address bar', 'Kopieer het uit de adresbalk'],
  full: ['Full screen', 'Volledig scherm'],
  leave: ['Leave full screen', 'Verlaat volledig scherm'],
  parameters: ['What can be moved', 'Wat kan bewegen'],
  byHand: ['Rings in the drawing can be dragged, or moved with the arrow keys.', 'Ringen in de tekening kun je slepen, of met de pijltjestoetsen bewegen.'],
  alsoSaid: ['What the slides say about it', 'Wat de slides erover zeggen'],
  alsoSteps: ['The same, step by step', 'Hetzelfde, stap voor stap'],
  unknown: ['Nothing here has this name', 'Niets heet hier zo'],
  unknownLead: ['These are the names there are:', 'Deze namen zijn er:'],
  gone: [
    'The server does not answer. Is the command that printed this address still running?',
    'De server antwoordt niet. Loopt de opdracht nog die dit adres gaf?',
  ],
  again: ['Try again', 'Probeer opnieuw'],
  working: ['Working …', 'Bezig …'],
  doorLoops: [
    'Painter, z-buffer and ray tracer with the same camera; click a pixel and read what happened there.',
    'Schilder, z-buffer en raytracer met dezelfde camera; klik op een pixel en lees wat daar gebeurde.',
  ],
  doorSteps: [
    'The depth grids triangle by triangle, the painter’s order, and three ways to solve a 3×3 system.',
    'De dieptetabellen driehoek voor driehoek, de volgorde van de schilder, en drie manieren om een 3×3-stelsel op te lossen.',
  ],
  // One scene, three loops.
  scene: ['Scene', 'Scène'],
  shading: ['Shading', 'Schakering'],
  flat: ['flat', 'vlak'],
  gouraud: ['Gouraud', 'Gouraud'],
  phong: ['Phong', 'Phong'],
  highlight: ['Highlight', 'Glans'],
  phongHighlight: ['Phong: e·r', 'Phong: e·r'],
  blinn: ['Blinn–Phong: n·h', 'Blinn–Phong: n·h'],
  exponent: ['Exponent p', 'Exponent p'],
  ownExponent: ['One p for all materials', 'Eén p voor alle materialen'],
  shadows: ['Shadows', 'Schaduwen'],
  show: ['Show', 'Toon'],
  color: ['colours', 'kleuren'],
  depth: ['depths', 'dieptes'],
  normals: ['normals', 'normalen'],
  barycentric: ['barycentric coordinates', 'barycentrische coördinaten'],
  overdraw: ['overdraw (times written)', 'overdraw (keren beschreven)'],
  level: ['Subdivision', 'Onderverdeling'],
  ofScene: ['the scene’s own', 'die van de scène'],
  size: ['Size', 'Afmeting'],
  painter: ['Painter’s algorithm', 'Schildersalgoritme'],
  zbuffer: ['Z-buffer', 'Z-buffer'],
  raytrace: ['Ray tracer', 'Raytracer'],
  painterLead: ['each triangle, far to near', 'elke driehoek, van ver naar dichtbij'],
  zbufferLead: ['each triangle, in any order: the nearest stays', 'elke driehoek, in willekeurige volgorde: de dichtste blijft'],
  raytraceLead: ['each pixel: what does its ray meet first?', 'elke pixel: wat raakt zijn straal het eerst?'],
  enlarge: ['Enlarge', 'Vergroot'],
  allThree: ['All three', 'Alle drie'],
  refining: ['refining', 'wordt verfijnd'],
  finished: ['finished', 'klaar'],
  orbitHelp: [
    'Drag to walk around, wheel or pinch to come nearer, click a pixel for its story.',
    'Sleep om eromheen te lopen, draai het wiel of knijp om dichterbij te komen, klik op een pixel voor zijn verhaal.',
  ],
  orbitKeys: [
    'Arrow keys walk around, plus and minus come nearer and go away, Enter shows a cross that the arrow keys move; Enter again tells that pixel’s story.',
    'Pijltjestoetsen lopen eromheen, plus en min gaan dichterbij en verder weg, Enter toont een kruis dat de pijltjestoetsen bewegen; nog eens Enter vertelt het verhaal van die pixel.',
  ],
  // The pixel's story.
  story: ['The story of pixel', 'Het verhaal van pixel'],
  storyNone: ['Click a pixel in one of the pictures: here its story is told.', 'Klik op een pixel in een van de beelden: hier komt zijn verhaal.'],
  agree: ['Both loops say the same.', 'Beide lussen zeggen hetzelfde.'],
  differ: ['The two loops differ here:', 'De twee lussen verschillen hier:'],
  outside: ['From outside', 'Van buiten gezien'],
  around: ['Pixels around it', 'Pixels eromheen'],
  tests: ['Triangles tested, in order', 'Geteste driehoeken, op volgorde'],
  order: ['No.', 'Nr.'],
  triangle: ['Triangle', 'Driehoek'],
  edges: ['Edges', 'Randen'],
  inside: ['Inside', 'Binnen'],
  before: ['Before', 'Ervoor'],
  nearer: ['Nearer', 'Dichterbij'],
  what: ['What happened', 'Wat er gebeurde'],
  yes: ['yes', 'ja'],
  no: ['no', 'nee'],
  ray: ['The ray', 'De straal'],
  origin: ['from', 'vanuit'],
  direction: ['along', 'langs'],
  interval: ['t between', 't tussen'],
  system: ['The system of the triangle that is seen', 'Het stelsel van de driehoek die je ziet'],
  solveSteps: ['Solve it step by step', 'Los het stap voor stap op'],
  light: ['Light at that point', 'Licht in dat punt'],
  point: ['point', 'punt'],
  normal: ['normal n', 'normaal n'],
  toEye: ['to the eye', 'naar het oog'],
  term: ['Term', 'Term'],
  formula: ['Formula', 'Formule'],
  numbers: ['Numbers', 'Getallen'],
  value: ['Red, green, blue', 'Rood, groen, blauw'],
  sum: ['Sum', 'Som'],
  corners: ['The corners', 'De hoekpunten'],
  corner: ['Corner', 'Hoekpunt'],
  weight: ['Weight', 'Gewicht'],
  shadowRays: ['Shadow rays', 'Schaduwstralen'],
  lightName: ['Light', 'Lichtbron'],
  met: ['Met', 'Raakte'],
  lit: ['Lit', 'Belicht'],
  // Steps.
  depthKind: ['Depth grids (L17)', 'Dieptetabellen (L17)'],
  painterKind: ['Painter’s order', 'Volgorde van de schilder'],
  solveKind: ['3×3 system (L51)', '3×3-stelsel (L51)'],
  kind: ['What', 'Wat'],
  how: ['Way', 'Manier'],
  cramer: ['Cramer’s rule', 'Regel van Cramer'],
  inverse: ['inverse matrix', 'inverse matrix'],
  elimination: ['elimination', 'eliminatie'],
  first: ['First step', 'Eerste stap'],
  back: ['Step back', 'Stap terug'],
  forward: ['Step forward', 'Stap verder'],
  last: ['Last step', 'Laatste stap'],
  play: ['Play', 'Speel af'],
  pause: ['Pause', 'Pauzeer'],
  step: ['Step', 'Stap'],
  of: ['of', 'van'],
  worked: ['The worked example (L54)', 'Het uitgewerkte voorbeeld (L54)'],
  // Mine.
  mine: ['Mine', 'Van mij'],
  mineLead: ['Draw it with my own function', 'Teken het met mijn eigen functie'],
  exercise: ['Exercise', 'Oefening'],
  noPermission: [
    'To run your own code, open the address that the command printed when it started.',
    'Open het adres dat de opdracht bij het starten gaf om je eigen code te draaien.',
  ],
  compiler: ['What the compiler said', 'Wat de compiler zei'],
  unmoved: ['A picture of the exercise; not moved by:', 'Een beeld van de opgave; niet bewogen door:'],
  redraws: ['Redraws whenever you save', 'Tekent opnieuw zodra je bewaart'],
  // Claims.
  claimsTitle: ['Claims on trial', 'Beweringen op de proef gesteld'],
  claimsLead: [
    'Each sentence of the slides was turned into a test that can fail. It runs here when you look at it.',
    'Elke zin van de slides werd een proef die kan mislukken. Hij draait hier zodra je ernaar kijkt.',
  ],
  allClaims: ['All', 'Alle'],
  errata: ['Only errors in the slides', 'Alleen fouten in de slides'],
  slideVersion: ['As on the slide', 'Zoals op de slide'],
  rightVersion: ['Right', 'Juist'],
  version: ['Version', 'Versie'],
  unexpected: ['unexpected', 'onverwacht'],
  run: ['Put it on trial', 'Stel het op de proef'],
  // Measurement.
  measureTitle: ['How fast does a drag become a picture?', 'Hoe snel wordt een sleep een beeld?'],
  measureLead: [
    'The z-buffer’s picture is dragged for five seconds by pointer events of the same kind as yours.',
    'Het beeld van de z-buffer wordt vijf seconden gesleept met dezelfde soort gebeurtenissen als die van jouw muis.',
  ],
  measuring: ['Measuring …', 'Aan het meten …'],
  shown: ['pictures shown a second', 'getoonde beelden per seconde'],
  latency: ['from drag to picture', 'van sleep tot beeld'],
  median: ['median', 'mediaan'],
  frames: ['pictures', 'beelden'],
  // Keys.
  keyFull: ['full screen', 'volledig scherm'],
  keyReset: ['all numbers back', 'alle getallen terug'],
  keyArrows: ['previous and next figure, or step', 'vorige en volgende figuur, of stap'],
  keyEnds: ['first and last (in full screen)', 'eerste en laatste (in volledig scherm)'],
  keyMine: ['my own function on or off', 'mijn eigen functie aan of uit'],
  keySlide: ['the slide’s version, or the right one', 'de versie van de slide, of de juiste'],
  keyHelp: ['this list', 'deze lijst'],
  keyEscape: ['leave', 'verlaten'],
  keyInField: ['in a number or slider: one step; with Shift ten', 'in een getal of schuif: één stap; met Shift tien'],
  keyInPicture: ['in a picture of a scene: walk around; + and − nearer, farther; Enter for a cross', 'in een beeld van een scène: eromheen lopen; + en − dichterbij, verder; Enter voor een kruis'],
  letters: ['Keys of one letter work', 'Toetsen van één letter werken'],
};

/** `T.reset` is `{en, nl}`. */
export const T = Object.fromEntries(Object.entries(TEXTS).map(([key, [en, nl]]) => [key, { en, nl }]));

/** The same text in both languages: a name, a number. */
export const same = (text) => ({ en: String(text), nl: String(text) });

/** Texts of both languages, one after the other. */
export const join = (words, between = ' ') => ({
  en: words.map((w) => w.en).join(between),
  nl: words.map((w) => w.nl).join(between),
});

const root = document.documentElement;
const spoken = new Map([['text', 'data-say'], ['aria-label', 'data-label'], ['alt', 'data-alt'], ['aria-valuetext', 'data-value'], ['title', 'data-title']]);
const listeners = new Set();

/** 'en' or 'nl'. */
export const language = () => root.lang;

/** What `words` say in the language of now. */
export const now = (words) => words?.[root.lang] ?? words?.en ?? '';

/** Puts words into an element, or one of its attributes, and keeps them in the page's language. */
export const say = (element, words, attribute = 'text') => {
  const mark = spoken.get(attribute);
  element.setAttribute(`${mark}-en`, words.en);
  element.setAttribute(`${mark}-nl`, words.nl);
  put(element, attribute, now(words));
};

const put = (element, attribute, text) => {
  if (attribute !== 'text') element.setAttribute(attribute, text);
  else if (element.textContent !== text) element.textContent = text;
};

/** Called after each change of language. */
export const onLanguage = (listener) => listeners.add(listener);

/** Speaks this language from now on. */
export const speak = (to) => {
  root.lang = to;
  for (const [attribute, mark] of spoken) {
    for (const element of document.querySelectorAll(`[${mark}-${to}]`)) {
      put(element, attribute, element.getAttribute(`${mark}-${to}`));
    }
  }
  listeners.forEach((listener) => listener(to));
};

/** What this browser was told before, or prefers. */
export const firstLanguage = () => {
  const kept = remembered('language');
  if (kept === 'en' || kept === 'nl') return kept;
  return navigator.language.toLowerCase().startsWith('nl') ? 'nl' : 'en';
};

/** A choice kept by this browser; none where it keeps nothing. */
export const remembered = (name) => {
  try {
    return localStorage.getItem(`lightlab-${name}`);
  } catch {
    return null;
  }
};

/** Keeps a choice in this browser, where it can. */
export const remember = (name, value) => {
  try {
    localStorage.setItem(`lightlab-${name}`, value);
  } catch {
    // A browser that keeps nothing asks again next time.
  }
};

/** A number as it is read: at most `digits` that count, with a real minus sign. */
export const number = (x, digits = 4) => {
  if (x === null || x === undefined) return '–';
  if (!Number.isFinite(Number(x))) return Number(x) < 0 ? '−∞' : '∞';
  return String(Number(Number(x).toPrecision(digits))).replace('-', '−');
};

/** A point or vector as it is read. */
export const vector = (values, digits = 3) => `(${(values ?? []).map((x) => number(x, digits)).join(', ')})`;
