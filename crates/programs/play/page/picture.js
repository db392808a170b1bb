// How do pixels from the server come onto a canvas, and what is at a pixel? Each of the three pictures is one of these.

/** What shows pictures on `canvas`. */
export const picture = (canvas) => {
  const context = canvas.getContext('2d', { alpha: false });
  let whole = null; // All pixels of the full size, as they are shown.

  const fit = (width, height) => {
    if (canvas.width === width && canvas.height === height && whole) return;
    canvas.width = width;
    canvas.height = height;
    whole = new ImageData(width, height);
  };

  return {
    /** Shows a whole picture, or rows of one, of a look of this size; a coarse one is spread out. */
    put: ({ width, height, row, data }, scale, size) => {
      fit(size.width, size.height);
      if (scale === 1 && row === 0 && width === size.width && height === size.height) {
        whole = new ImageData(data, width, height);
        context.putImageData(whole, 0, 0);
        return;
      }
      if (scale === 1) {
        whole.data.set(data, 4 * row * size.width);
        context.putImageData(new ImageData(data, width, height), 0, row);
        return;
      }
      const from = new Uint32Array(data.buffer);
      const to = new Uint32Array(whole.data.buffer);
      for (let y = 0; y < size.height; y += 1) {
        const begin = Math.min(height - 1, Math.floor(y / scale)) * width;
        for (let x = 0; x < size.width; x += 1) to[y * size.width + x] = from[begin + Math.min(width - 1, Math.floor(x / scale))];
      }
      context.putImageData(whole, 0, 0);
    },
    /** The colours around a pixel (`row` from the top), `side` × `side`, black beyond the edge. */
    around: (i, row, side) => {
      const part = new ImageData(side, side);
      const to = new Uint32Array(part.data.buffer);
      to.fill(0xff000000);
      if (!whole) return part;
      const from = new Uint32Array(whole.data.buffer);
      const half = (side - 1) / 2;
      for (let y = 0; y < side; y += 1) {
        for (let x = 0; x < side; x += 1) {
          const [column, line] = [i + x - half, row + y - half];
          if (column >= 0 && column < whole.width && line >= 0 && line < whole.height) to[y * side + x] = from[line * whole.width + column];
        }
      }
      return part;
    },
  };
};
