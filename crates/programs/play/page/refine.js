// How does the ray tracer's picture come? Coarse at once, then finer, row by row; any change begins it anew.

import { busy, frame } from './net.js';

/** Each picture has this part of the full one's width and height. */
const COARSE = [8, 4, 2];
/** More rays for each pixel, in a second and a third round. */
const SAMPLES = [1, 2, 3];
/** A band of rows should take so long, in microseconds: a change waits no longer. */
const BAND = 60_000;
/** A band has at least so many rows: what each request costs by itself is not to be paid for every row. */
const LEAST_ROWS = 12;
/** So long after a change the first coarse picture is asked for, in milliseconds. */
const PAUSE = 90;
/** While a hand moves it works one part in so many of the time: the z-buffer goes first. */
const SHARE = 4;

/**
 * Draws looks with the ray tracer. `put(picture, scale)` shows one, `progress({scale, samples, part, elapsed, notes, over})` says how
 * far it is, `failed(error)` what went wrong.
 */
export const refiner = ({ put, progress, failed }) => {
  let generation = 0;
  let interrupt = null;
  let timer = null;
  let look = null;
  let running = Promise.resolve();
  let coarsest = false;
  let took = 0; // The coarsest picture, in milliseconds.

  const run = async (mine, signal) => {
    const began = performance.now();
    const wanted = look;
    const question = (more) => frame({ look: wanted, renderer: 'raytrace', scale: 1, rows: null, samples: 1, ...more }, signal);
    const told = (picture, more) => progress({ notes: picture.notes, elapsed: performance.now() - began, over: false, ...more });
    let perRow = null;
    // Depths, normals and counts have no light in them, and nothing to average: they come at once.
    const plain = wanted.show !== 'color';
    for (const scale of plain ? [COARSE[0], 1] : COARSE) {
      coarsest = scale === COARSE[0];
      const picture = await question({ scale });
      if (coarsest) took = performance.now() - began;
      // The coarsest is shown although the look has changed: so something moves while a hand does.
      if (mine !== generation && !(coarsest && wanted.width === look.width && wanted.height === look.height)) return;
      put(picture, scale);
      if (mine !== generation) return;
      told(picture, { scale, samples: 1, part: 1, over: plain && scale === 1 });
      // A full row has `scale` times as many pixels as a coarse one.
      perRow = (picture.micros / Math.max(1, picture.height)) * scale;
    }
    coarsest = false;
    for (const samples of plain ? [] : SAMPLES) {
      let perBand = Math.max(1, perRow * samples * samples);
      let row = 0;
      while (row < wanted.height) {
        const rows = Math.min(wanted.height - row, Math.max(LEAST_ROWS, Math.round(BAND / perBand)));
        const picture = await question({ rows: [row, row + rows], samples });
        if (mine !== generation) return;
        put(picture, 1);
        row += rows;
        perBand = Math.max(1, picture.micros / rows);
        told(picture, { scale: 1, samples, part: row / wanted.height, over: samples === SAMPLES.at(-1) && row >= wanted.height });
      }
    }
  };

  const begin = async () => {
    timer = null;
    const mine = generation;
    interrupt = new AbortController();
    const done = busy();
    try {
      await run(mine, interrupt.signal);
    } catch (error) {
      if (error.name !== 'AbortError' && mine === generation) failed(error);
    } finally {
      coarsest = false;
      done();
    }
  };

  return {
    /** Draws this look from now on. */
    draw: (next) => {
      generation += 1;
      look = next;
      if (!coarsest) interrupt?.abort();
      timer ??= setTimeout(() => { running = running.then(begin); }, Math.max(PAUSE, (SHARE - 1) * took));
    },
    stop: () => {
      generation += 1;
      interrupt?.abort();
      clearTimeout(timer);
      timer = null;
    },
  };
};
