// Colours of parts, sRGB, 0 to 1.
import { facts } from "../report/arrays.js";

/** By name, for all parts of the list: the report's rule (libcommon/report/palette.h). */
export function part_colors(names) {
  const places = [...names].sort().map((name, place) => [name, facts.part_colors[place % facts.part_colors.length]]);
  return new Map(places);
}

/** Of a stroke on its part: darker than it, to be seen there. */
export function stroke_color(part_color) {
  return part_color.map((c) => 0.45 * c);
}
