// Colours of parts, sRGB, 0 to 1: by their place in the list, so that drawing another part changes none.

const colors = [
  [0.31, 0.47, 0.66], [0.95, 0.56, 0.17], [0.35, 0.63, 0.31], [0.93, 0.79, 0.28], [0.69, 0.48, 0.63],
  [0.46, 0.72, 0.7], [0.61, 0.46, 0.37], [0.55, 0.78, 0.9], [0.75, 0.73, 0.42], [0.24, 0.37, 0.36],
  [0.96, 0.72, 0.62], [0.49, 0.49, 0.76],
];

export function part_color(index) {
  return colors[index % colors.length];
}

/** Of a stroke on its part: darker than it, to be seen there. */
export function stroke_color(index) {
  return part_color(index).map((c) => 0.45 * c);
}
