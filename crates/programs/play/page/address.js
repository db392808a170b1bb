// How does the address hold what is seen? As `#name?parameter=value`, so that a link brings it back.

const LEAST_PAUSE = 250; // Milliseconds: no browser's limit on changes of the address is reached.

let timer = null;
let wanted = null;

/** The name and the parameters after `#`. */
export const read = (hash = location.hash) => {
  const text = hash.replace(/^#/, '');
  const mark = text.indexOf('?');
  const name = mark < 0 ? text : text.slice(0, mark);
  let plain = name;
  try {
    plain = decodeURIComponent(name);
  } catch {
    // A stray percent sign is a name that nothing has.
  }
  return { name: plain, values: new URLSearchParams(mark < 0 ? '' : text.slice(mark + 1)) };
};

/** `#name?…`; parameters without a value are left out. */
export const format = (name, values = {}) => {
  const query = new URLSearchParams();
  for (const [key, value] of Object.entries(values)) {
    if (value !== undefined && value !== null && value !== '') query.set(key, value);
  }
  const text = query.toString();
  return `#${encodeURIComponent(name)}${text ? `?${text}` : ''}`;
};

/** Changes the address without a new entry in the history, soon. */
export const replace = (name, values) => {
  wanted = format(name, values);
  if (timer === null) timer = setTimeout(flush, LEAST_PAUSE);
};

/** Changes the address now, if a change is due. */
export const flush = () => {
  clearTimeout(timer);
  timer = null;
  if (wanted !== null && wanted !== location.hash) history.replaceState(null, '', wanted);
  wanted = null;
};

/** Forgets a change that is due: the address was changed by somebody else. */
export const forget = () => {
  clearTimeout(timer);
  timer = null;
  wanted = null;
};

/** A finite number among the values, within its ends; otherwise `otherwise`. */
export const finite = (values, key, otherwise, least = -Infinity, greatest = Infinity) => {
  const text = values.get(key);
  const value = text === null || text.trim() === '' ? NaN : Number(text);
  return Number.isFinite(value) ? Math.min(greatest, Math.max(least, value)) : otherwise;
};
