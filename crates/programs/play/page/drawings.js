// How do drawings come onto the page without a flicker? The old one stays until the new one can be shown at once.

import { make, svgElement } from './dom.js';
import { handleLayer } from './handles.js';
import { nameOf } from './names.js';
import { isOn } from './show.js';
import { say } from './words.js';

/** Under this width a drawing is not put beside another. */
const LEAST_WIDTH = 250;
const GAP = 16;
const CAPTION = 30;

/** An element that can be shown at once: `{element, aspect, width}`. */
const ready = async (drawing) => {
  if (drawing.svg) {
    const element = svgElement(drawing.svg, drawing.alt);
    const { width, height } = element.viewBox.baseVal;
    return { element, aspect: width && height ? width / height : 4 / 3, width: width || 640 };
  }
  const element = make('img', { draggable: 'false' });
  element.src = drawing.png;
  say(element, drawing.alt, 'alt');
  await element.decode().catch(() => {});
  return { element, aspect: element.naturalWidth / element.naturalHeight || 4 / 3, width: element.naturalWidth || 640 };
};

/**
 * A row or grid of drawings. `onmove(drawing, handle, to, settled)` is called when a handle is moved; without it there are no
 * handles. `room()` says how high all of it may be; without `captions` nothing stands under a drawing.
 */
export const drawingGrid = ({ onmove, valueOf, room, test, captions = true } = {}) => {
  const element = make('div', { class: 'drawings', 'data-test': test ?? 'drawings' });
  let cells = [];
  let turn = 0;

  const cell = (at) => {
    const layer = onmove ? handleLayer((handle, to, settled) => onmove(at, handle, to, settled), valueOf) : null;
    const stage = make('div', { class: 'stage' }, layer?.element);
    const caption = make('figcaption');
    return { figure: make('figure', { class: 'drawing' }, stage, caption), stage, caption, layer, shown: null, aspect: 4 / 3, width: 640 };
  };

  /** As many columns as make the drawings largest. */
  const layout = () => {
    const width = element.clientWidth;
    if (!width || cells.length === 0) return;
    const height = room ? room(element) : Infinity;
    let best = { size: -1 };
    for (let columns = 1; columns <= cells.length; columns += 1) {
      const rows = Math.ceil(cells.length / columns);
      const across = (width - GAP * (columns - 1)) / columns;
      if (columns > 1 && across < LEAST_WIDTH && !isOn()) break;
      const down = (height - GAP * (rows - 1)) / rows - (cells.some((c) => c.caption.textContent) ? CAPTION : 0);
      const sizes = cells.map((c) => Math.min(across, Math.max(down, 120) * c.aspect));
      const size = sizes.reduce((sum, w, k) => sum + w * w / cells[k].aspect, 0);
      if (size > best.size * 1.02) best = { size, columns, sizes };
    }
    element.style.setProperty('--columns', best.columns);
    cells.forEach((c, k) => c.stage.style.setProperty('width', `${Math.floor(best.sizes[k])}px`));
  };
  const observer = new ResizeObserver(layout);
  observer.observe(element);
  window.addEventListener('resize', layout);

  return {
    element,
    layout,
    leave: () => {
      observer.disconnect();
      window.removeEventListener('resize', layout);
    },
    held: () => cells.some((c) => c.layer?.held()),
    /** So wide is the first drawing on the screen, in its pixels. */
    pixelWidth: () => (cells.length ? cells[0].stage.clientWidth * window.devicePixelRatio : 0),
    /** Shows these drawings, all at once, as soon as all of them can be shown. */
    show: async (drawings) => {
      turn += 1;
      const mine = turn;
      const next = await Promise.all(drawings.map(ready));
      if (mine !== turn) return;
      if (cells.length !== drawings.length) {
        cells = drawings.map((_, at) => cell(at));
        element.replaceChildren(...cells.map((c) => c.figure));
      }
      let changed = false;
      cells.forEach((c, at) => {
        const { element: shown, aspect, width } = next[at];
        if (c.shown) c.shown.replaceWith(shown);
        else c.stage.prepend(shown);
        changed ||= Math.abs(c.aspect - aspect) > 1e-3 || !c.shown;
        Object.assign(c, { shown, aspect, width });
        c.stage.style.setProperty('aspect-ratio', aspect);
        const name = captions ? nameOf(drawings[at]) : null;
        c.caption.hidden = !name;
        if (name) say(c.caption, name);
        c.layer?.show(drawings[at].handles ?? []);
      });
      if (changed) layout();
    },
  };
};
