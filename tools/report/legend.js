// What the colours mean.
import { css, fields, folded, gradient } from "./colors.js";

function element(name, text = "", className = "") {
  const result = document.createElement(name);
  result.textContent = text;
  if (className) result.className = className;
  return result;
}

function swatch(color, text) {
  const item = element("li", text);
  const patch = element("i");
  patch.style.background = css(color);
  item.prepend(patch);
  return item;
}

function scale(name, range, most) {
  const field = fields[name];
  const result = element("div", "", "scale");
  result.append(element("p", `${field.title}, ${field.unit}`));
  const bar = element("div", "", "ramp");
  bar.style.background = gradient(name);
  const ticks = element("div", "", "ticks");
  for (const value of field.ticks(range)) ticks.append(element("span", field.text(value)));
  result.append(bar, ticks);
  const beyond = most > range.high ? ` The highest 1 % reach ${field.text(most)}.` : "";
  if (beyond) result.append(element("p", beyond.trim(), "beyond"));
  return result;
}

/**
 * Fills `place` with the legend of what the two views show.
 * @param mode what the surfaces are coloured by
 */
export function show_legend(place, mode, surfaces, parts, marks, folds) {
  place.replaceChildren();
  const list = element("ul");
  if (mode === "parts") parts.forEach((part) => list.append(swatch(part.color, part.name)));
  if (mode === "pattern") place.append(element("p", "Cells of equal size on the source."));
  const ranges = surfaces.map((surface) => surface?.facts.fields?.[mode]).filter(Boolean);
  if (ranges.length > 0) {
    place.append(scale(mode, ranges[0], Math.max(...ranges.map((range) => range.most))));
  }
  if (folds) list.append(swatch(folded, "folded facets"));
  for (const mark of marks) list.append(swatch(mark.color, mark.name));
  if (list.childElementCount > 0) place.append(list);
}
