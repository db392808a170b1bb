// How is a number moved? By a slider, by typing, by dragging it sideways, or by arrow keys: all four are one control.

import { fresh, make } from './dom.js';
import { now, number } from './words.js';

const SLIDER_STEPS = 1000;
/** So many pixels of a sideways drag go from one end to the other. */
const FULL_DRAG = 400;
/** A drag begins after so many pixels: less is a click. */
const DRAG_BEGINS = 4;

/** 1, 2 or 5 times a power of ten, not above `x`. */
const roundStep = (x) => {
  const power = 10 ** Math.floor(Math.log10(x));
  return power * [5, 2, 1].find((factor) => factor * power <= x * (1 + 1e-9));
};

/** Between the slider's 0 … 1 and the parameter's values: wide ranges that begin at 0 or above have small numbers larger. */
const scaleOf = ({ least, greatest }) => {
  const span = greatest - least;
  if (least < 0 || greatest < 200) return { to: (v) => (v - least) / span, from: (u) => least + u * span, wide: false };
  const unit = span / 1000;
  const whole = Math.log1p(span / unit);
  return { to: (v) => Math.log1p((v - least) / unit) / whole, from: (u) => least + unit * Math.expm1(u * whole), wide: true };
};

/** One step of an arrow key at a value. */
const stepAt = ({ whole, least, greatest }, scale, value) => {
  const fine = scale.wide ? roundStep(Math.max(Math.abs(value), (greatest - least) / 2000) / 20) : roundStep((greatest - least) / 100);
  return whole ? Math.max(1, Math.round(fine)) : fine;
};

/**
 * A row with label, slider and number field for `parameter`. `onchange(value, settled)` is called at each change; `settled` is
 * false while a hand still drags. `set(value)` shows a value without calling it.
 */
export const parameterRow = (parameter, onchange) => {
  const { least, greatest, whole } = parameter;
  const scale = scaleOf(parameter);
  const id = fresh('number');
  let value = parameter.default;

  const label = make('label', { for: id, class: 'scrub', words: parameter.label });
  const field = make('input', {
    id, type: 'number', min: least, max: greatest, step: 'any', class: 'scrub', inputmode: 'decimal', autocomplete: 'off',
    'data-parameter': parameter.name,
  });
  const slider = make('input', {
    type: 'range', min: 0, max: SLIDER_STEPS, step: 'any', label: parameter.label, 'data-slider': parameter.name,
  });
  const element = make('div', { class: 'parameter' }, label, field, slider);

  const paint = () => {
    if (document.activeElement !== field || Number(field.value) !== value) field.value = Number(value.toPrecision(6));
    slider.value = SLIDER_STEPS * scale.to(value);
    slider.setAttribute('aria-valuetext', number(value, 6));
    slider.style.setProperty('--part', `${100 * scale.to(value)}%`);
  };
  const nice = (v) => {
    if (whole) return Math.round(v);
    const step = stepAt(parameter, scale, v) / 10;
    return Number((Math.round(v / step) * step).toPrecision(6));
  };
  const change = (v, settled) => {
    const next = Math.min(greatest, Math.max(least, whole ? Math.round(v) : v));
    if (!Number.isFinite(next) || (next === value && !settled)) return;
    value = next;
    paint();
    onchange(value, settled);
  };

  slider.addEventListener('input', () => change(nice(scale.from(slider.value / SLIDER_STEPS)), false));
  slider.addEventListener('change', () => change(value, true));
  field.addEventListener('input', () => {
    const typed = field.valueAsNumber;
    if (Number.isFinite(typed) && typed >= least && typed <= greatest) change(typed, true);
  });
  field.addEventListener('change', () => {
    if (Number.isFinite(field.valueAsNumber)) change(field.valueAsNumber, true);
    field.value = Number(value.toPrecision(6));
  });

  const onKey = (event) => {
    const step = stepAt(parameter, scale, value) * (event.shiftKey ? 10 : 1);
    const to = {
      ArrowUp: value + step, ArrowDown: value - step, PageUp: value + 10 * step, PageDown: value - 10 * step,
      ...(event.currentTarget === slider && { ArrowRight: value + step, ArrowLeft: value - step, Home: least, End: greatest }),
    }[event.key];
    if (to === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    change(Number(to.toPrecision(6)), true);
  };
  slider.addEventListener('keydown', onKey);
  field.addEventListener('keydown', onKey);

  for (const grip of [label, field]) scrub(grip, () => scale.to(value), (u, settled) => change(nice(scale.from(Math.min(1, Math.max(0, u)))), settled));
  paint();
  return {
    element,
    get value() { return value; },
    set: (v) => {
      value = v;
      paint();
    },
    /** `θ: 40`, for what moves it from elsewhere. */
    words: () => `${now(parameter.label)}: ${number(value, 4)}`,
    parameter,
  };
};

/** Dragging `grip` sideways moves a number of 0 … 1. */
const scrub = (grip, get, set) => {
  let start = null;
  let moved = false;
  grip.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    start = { x: event.clientX, at: get() };
    moved = false;
  });
  grip.addEventListener('pointermove', (event) => {
    if (!start || event.buttons === 0) return;
    const dx = event.clientX - start.x;
    if (!moved && Math.abs(dx) < DRAG_BEGINS) return;
    if (!moved) {
      moved = true;
      capture(grip, event.pointerId);
      grip.classList.add('scrubbing');
    }
    event.preventDefault();
    set(start.at + (dx * (event.shiftKey ? 0.1 : 1)) / FULL_DRAG, false);
  });
  const end = () => {
    if (moved) set(get(), true);
    start = null;
    grip.classList.remove('scrubbing');
  };
  grip.addEventListener('pointerup', end);
  grip.addEventListener('pointercancel', end);
  grip.addEventListener('click', (event) => {
    if (moved) event.preventDefault();
    moved = false;
  });
};

/** Keeps a pointer's events coming, also outside of the element; a made pointer cannot be captured, and needs it not. */
export const capture = (element, pointer) => {
  try {
    element.setPointerCapture(pointer);
  } catch {
    // No such pointer: its events are sent to the element by whoever made it.
  }
};

