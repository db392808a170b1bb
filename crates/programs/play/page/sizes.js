// How large should a picture be asked for? As sharp as the screen shows it, but no larger than what can follow a hand.

/** A drawing that takes longer than this, in milliseconds, cannot follow a hand: it is asked for smaller. */
const FOLLOWS = 60;
/** A drawing at rest may take so long. */
const RESTS = 1000;
/** The first drawing is so much smaller: it is there at once, and tells how long a larger one takes. */
const FIRST = 0.25;
/** Neither side is smaller or larger than this: the server draws no other. */
const LEAST = 16;
const GREATEST = 1920;

/** Sizes for one figure. `next(resting, width)` gives `[size or null, whether it is as sharp as it will get]`. */
export const sizes = (figure) => {
  const [width, height] = figure.size ?? [];
  let perPixel = null;
  const scaled = (factor) => {
    const fits = Math.min(factor, GREATEST / width, GREATEST / height);
    return [width, height].map((side) => Math.max(LEAST, Math.round(side * fits)));
  };
  return {
    next: (resting, shownWidth) => {
      if (!width) return [null, true];
      if (perPixel === null || !shownWidth) return [scaled(FIRST), false];
      const sharp = Math.max(1, shownWidth / width);
      const affordable = Math.sqrt((resting ? RESTS : FOLLOWS) / (perPixel * width * height));
      const factor = resting ? Math.max(1, Math.min(sharp, affordable)) : Math.max(0.2, Math.min(sharp, affordable));
      return [scaled(factor), resting];
    },
    took: (size, milliseconds) => {
      if (size) perPixel = milliseconds / (size[0] * size[1]);
    },
  };
};
