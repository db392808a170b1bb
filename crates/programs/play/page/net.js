// How does the page ask the server? One question at a time for each picture, and the latest question wins.

import { T, same } from './words.js';

/** Why the server did not give what was asked for, in both languages. */
export class Refused extends Error {
  constructor(words, status) {
    super(words.en);
    this.words = words;
    this.status = status;
  }
}

let held = 0;
/** Marks the page as busy until the function that it returns is called. */
export const busy = () => {
  held += 1;
  document.documentElement.dataset.busy = 'true';
  let over = false;
  return () => {
    if (over) return;
    over = true;
    held -= 1;
    if (held === 0) document.documentElement.dataset.busy = 'false';
  };
};

/** The words for whatever went wrong; none if it was interrupted on purpose. */
export const reason = (error) => {
  if (error?.name === 'AbortError') return null;
  return error instanceof Refused ? error.words : same(error?.message ?? error);
};

/** The server says so when too much is asked of it at once: then it is asked again, after a pause in milliseconds. */
const FULL = 503;
const TRIES = 4;
const PAUSE = 400;

const send = async (path, body, signal) => {
  const asked = body === undefined
    ? { signal }
    : { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify(body), signal };
  let answer;
  for (let tries = 0; tries < TRIES && (!answer || answer.status === FULL); tries += 1) {
    if (answer) await new Promise((resolve) => { setTimeout(resolve, PAUSE); });
    try {
      answer = await fetch(path, asked);
    } catch (error) {
      if (error.name === 'AbortError') throw error;
      throw new Refused(T.gone, 0);
    }
  }
  const isJson = answer.headers.get('Content-Type')?.startsWith('application/json');
  const said = isJson ? await answer.json().catch(() => null) : null;
  if (answer.ok && !said?.error) return { answer, said };
  throw new Refused(said?.error ?? same(`${answer.status} ${answer.statusText}`), answer.status);
};

/** The answer to a question: without a body it is only looked up. */
export const ask = async (path, body, signal) => (await send(path, body, signal)).said;

/** The highest bit of a number says that one pixel stands for so many equal ones; without it so many different ones follow. */
const EQUAL = 0x80000000;

const unpacked = (buffer, length) => {
  const words = new Uint32Array(buffer);
  const pixels = new Uint32Array(length);
  let to = 0;
  for (let at = 0; at < words.length;) {
    const count = words[at] & 0x7fffffff;
    if (words[at] >= EQUAL) {
      pixels.fill(words[at + 1], to, to + count);
      at += 2;
    } else {
      pixels.set(words.subarray(at + 1, at + 1 + count), to);
      at += 1 + count;
    }
    to += count;
  }
  return new Uint8ClampedArray(pixels.buffer);
};

/** A picture of a look, or rows of it: `{width, height, row, notes, micros, data}`. */
export const frame = async (question, signal) => {
  const { answer } = await send('/api/frame', question, signal);
  const header = (name) => Number(answer.headers.get(name) ?? 0);
  const notes = answer.headers.get('X-Notes');
  return {
    width: header('X-Width'),
    height: header('X-Height'),
    row: header('X-Row'),
    micros: header('X-Micros'),
    notes: notes ? JSON.parse(decodeURIComponent(notes)) : [],
    data: unpacked(await answer.arrayBuffer(), header('X-Width') * header('X-Height')),
  };
};

/** A function that does `work` with the latest value it was given: never two at once, and none that is out of date. */
export const latest = (work) => {
  let running = false;
  let waiting = null;
  const run = async () => {
    running = true;
    while (waiting) {
      const [value] = waiting;
      waiting = null;
      await work(value);
    }
    running = false;
  };
  const next = (value) => {
    waiting = [value];
    if (!running) run();
  };
  /** Whether a newer value waits already. */
  next.waits = () => waiting !== null;
  return next;
};
