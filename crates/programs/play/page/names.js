// What are the drawings of a figure called? Their names belong to the figures' files; here they are words of both languages.

import { same } from './words.js';

const NAMES = {
  '1-world': ['1. world', '1. wereld'],
  '2-camera': ['2. camera', '2. camera'],
  '3-perspective': ['3. after P: a box', '3. na P: een doos'],
  '4-canonical': ['4. canonical', '4. canoniek'],
  '5-screen': ['5. screen', '5. scherm'],
  '6-table': ['the point in each space', 'het punt in elke ruimte'],
  'red-green-blue': ['red, green, blue', 'rood, groen, blauw'],
  'green-blue-red': ['green, blue, red', 'groen, blauw, rood'],
  'blue-red-green': ['blue, red, green', 'blauw, rood, groen'],
  cut: ['one of them cut', 'één ervan doorgesneden'],
  'without-depth': ['without depths', 'zonder dieptes'],
  'with-depth': ['with depths', 'met dieptes'],
  'object-order': ['z-buffer: object order', 'z-buffer: per object'],
  'image-order': ['ray tracer: image order', 'raytracer: per pixel'],
  difference: ['difference', 'verschil'],
  'white-light': ['white light', 'wit licht'],
  'yellow-light': ['yellow light', 'geel licht'],
  attempt: ['first attempt', 'eerste poging'],
  phong: ['Phong', 'Phong'],
  gouraud: ['Gouraud', 'Gouraud'],
  flat: ['flat', 'vlak'],
  ambient: ['ambient', 'omgevingslicht'],
  diffuse: ['diffuse', 'diffuus'],
  specular: ['specular', 'spiegelend'],
  total: ['total', 'totaal'],
  'with-shadow': ['with shadows', 'met schaduwen'],
  'without-shadow': ['without shadows', 'zonder schaduwen'],
  'bin-with-shadow': ['bin, with its shadow', 'bak, met schaduw'],
  'bin-without-shadow': ['bin, without a shadow', 'bak, zonder schaduw'],
  'ice-with-shadow': ['ice, with its shadow', 'ijs, met schaduw'],
  'ice-without-shadow': ['ice, without a shadow', 'ijs, zonder schaduw'],
  'noon-with-shadow': ['noon, with its shadow', 'middag, met schaduw'],
  'noon-without-shadow': ['noon, without a shadow', 'middag, zonder schaduw'],
  vectors: ['vectors', 'vectoren'],
  ball: ['ball', 'bol'],
  'lamp-alone': ['the lamp alone', 'alleen de lamp'],
  'without-max': ['without max', 'zonder max'],
  'with-max': ['with max', 'met max'],
  'from-outside': ['from outside', 'van buiten gezien'],
  yours: ['yours', 'de jouwe'],
  right: ['right', 'juist'],
};

/** Names with a number in them. */
const COUNTED = [
  [/^(\d+)-bits$/, ['$1 bits', '$1 bits']],
  [/^depth-(\d+)$/, ['recursion to depth $1', 'recursie tot diepte $1']],
];

/** What stands under a drawing; nothing if it has no name. */
export const nameOf = ({ label, name }) => {
  if (label) return label;
  if (!name) return null;
  const known = NAMES[name];
  if (known) return { en: known[0], nl: known[1] };
  const [pattern, words] = COUNTED.find(([its]) => its.test(name)) ?? [];
  if (pattern) return { en: name.replace(pattern, words[0]), nl: name.replace(pattern, words[1]) };
  return same(name.replaceAll('-', ' '));
};
