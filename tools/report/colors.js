// Colour maps and what they are called. Colours are sRGB, 0 to 1. Red is kept for folds.

const yellow_blue = [
  [0.97, 0.97, 0.84], [0.89, 0.94, 0.7], [0.73, 0.88, 0.69], [0.5, 0.8, 0.72], [0.28, 0.7, 0.76], [0.16, 0.56, 0.74],
  [0.15, 0.4, 0.65], [0.15, 0.24, 0.54], [0.08, 0.13, 0.36],
];
const blue_orange = [
  [0.13, 0.32, 0.58], [0.33, 0.55, 0.76], [0.62, 0.77, 0.88], [0.9, 0.9, 0.88], [0.96, 0.76, 0.52], [0.87, 0.52, 0.2],
  [0.62, 0.31, 0.05],
];

/** The colour of a map at `t`, clamped to 0 ... 1. */
function at(map, t) {
  const place = Math.min(Math.max(t, 0), 1) * (map.length - 1);
  const i = Math.min(Math.floor(place), map.length - 2);
  const f = place - i;
  return [0, 1, 2].map((c) => map[i][c] * (1 - f) + map[i + 1][c] * f);
}

export const folded = [0.86, 0.05, 0.05];

export function lightened(color, amount) {
  return color.map((c) => c + (1 - c) * amount);
}

export function css(color) {
  return `rgb(${color.map((c) => Math.round(255 * c)).join(" ")})`;
}

function short(value) {
  return Number(value.toPrecision(2)).toString();
}

/**
 * The fields that surfaces may have: `title`, `unit`, the place of a value on the colour map (0 ... 1), the values
 * that its legend names, and how a value is written.
 */
export const fields = {
  distance: {
    title: "Distance to the other surface",
    unit: "% of the target's diagonal",
    map: yellow_blue,
    place: (value, range) => value / range.high,
    ticks: (range) => [0, range.high / 2, range.high],
    text: (value) => short(100 * value),
  },
  distortion: {
    title: "Distortion",
    unit: "symmetric Dirichlet energy (4: isometry)",
    map: yellow_blue,
    place: (value, range) => Math.log(value / 4) / Math.log(range.high / 4),
    ticks: (range) => [4, 4 * Math.sqrt(range.high / 4), range.high],
    text: short,
  },
  area: {
    title: "Change of area",
    unit: "compatible mesh over source, at equal total area",
    map: blue_orange,
    place: (value, range) => (value - range.low) / (range.high - range.low),
    ticks: (range) => [range.low, 0, range.high],
    text: (value) => "×" + short(2 ** value),
  },
};

export function field_color(name, value, range) {
  const field = fields[name];
  const place = field.place(value, range);
  return at(field.map, Number.isFinite(place) ? place : 0);
}

/** A CSS gradient from left to right. */
export function gradient(name) {
  const map = fields[name].map;
  return `linear-gradient(to right, ${map.map(css).join(", ")})`;
}
