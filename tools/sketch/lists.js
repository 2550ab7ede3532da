// The lists beside the views: parts, markers, anchors, and whether the models agree.
import { css } from "../report/colors.js";
import { part_colors } from "./palette.js";
import { names_of, strokes_of } from "./sketches.js";

const by_id = (id) => document.getElementById(id);

function element(tag, properties, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

function button(text, label, action, className) {
  const made = element("button", { type: "button", textContent: text, title: label, className });
  made.setAttribute("aria-label", label);
  made.addEventListener("click", action);
  return made;
}

/** A name that can be edited: Enter or leaving it renames, Escape does not. */
function name_field(name, label, rename) {
  const field = element("input", { value: name, spellcheck: false });
  field.setAttribute("aria-label", label);
  field.addEventListener("change", () => {
    if (!rename(field.value.trim())) field.value = name;
  });
  field.addEventListener("keydown", (event) => {
    if (event.key === "Escape") field.value = name;
    if (event.key === "Enter" || event.key === "Escape") field.blur();
  });
  return field;
}

function empty(text) {
  return element("li", { className: "empty", textContent: text });
}

function part_row(app, name, index, color) {
  const strokes = app.models.map((_, model) => strokes_of(app.state, model, name).length);
  const row = element("li", { className: "row" });
  row.classList.toggle("chosen", name === app.chosen);
  const swatch = button(index < 9 ? String(index + 1) : "", `Draw ${name}`, () => app.choose(name), "swatch");
  swatch.style.background = css(color);
  swatch.setAttribute("aria-pressed", name === app.chosen);
  const field = name_field(name, `Name of ${name}`, (to) => app.rename_part(name, to));
  field.addEventListener("focus", () => app.choose(name));
  const state = element("span", { className: "state", textContent: strokes.join(" · ") });
  state.title = app.models.map((model, i) => `${strokes[i]} strokes on ${model.name}`).join(", ");
  row.append(swatch, field, state, button("×", `Delete ${name}`, () => app.delete_part(name), "delete"));
  return row;
}

function place_row(app, kind, name, number) {
  const where = app.models.map((_, model) => (app.state.sketches[model][kind] ?? []).some((entry) => entry.name === name));
  const row = element("li", { className: "row" });
  const missing = where.indexOf(false);
  row.classList.toggle("chosen", app.asked?.kind === kind && app.asked.name === name);
  const field = name_field(name, `Name of ${name}`, (to) => app.rename_place(kind, name, to));
  row.append(element("span", { className: "state", textContent: number }), field);
  row.append(button("×", `Delete ${name}`, () => app.delete_place(kind, name), "delete"));
  const asked = [];
  if (missing >= 0) asked.push(button(`on ${app.models[missing].name}?`, `Place ${name} on ${app.models[missing].name}`, () => app.ask_for_partner(kind, name), "quiet"));
  const mirrored = kind === "markers" ? app.mirroring.models().filter((model) => app.mirroring.pending(model).of.name === name) : [];
  if (mirrored.length > 0) asked.push(button("+ mirror image", `Add the mirror image of ${name}`, () => app.mirroring.accept(mirrored), "quiet"));
  if (asked.length > 0) row.append(element("div", { className: "asked" }, ...asked));
  return row;
}

export function show_lists(app) {
  const { state } = app;
  const colors = part_colors(state.parts);
  by_id("parts").replaceChildren(...(state.parts.length > 0 ? state.parts.map((name, i) => part_row(app, name, i, colors.get(name))) : [empty("none yet")]));
  for (const kind of ["markers", "anchors"]) {
    const names = names_of(state, kind);
    by_id(kind).replaceChildren(...(names.length > 0
      ? names.map((name, i) => place_row(app, kind, name, kind === "markers" ? `${i + 1}` : "○")) : [empty("none yet")]));
  }
}

/** A sentence of the server's about both models, with their names. */
export function named(app, sentence) {
  return sentence.replace(/the first model/g, app.models[0].name).replace(/the second( model)?/g, app.models[1].name);
}

/** @param check as the server gives it; null while it is not known */
export function show_agreement(app, check) {
  const said = check?.problem ? [check.problem] : [...(check?.differences ?? []), ...(check?.misplaced ?? [])].map((text) => named(app, text));
  const nothing = app.state.parts.length === 0 && names_of(app.state, "markers").length === 0;
  const list = by_id("differences");
  list.className = !check || check.problem || (nothing && said.length === 0) ? "" : (said.length === 0 ? "good" : "warning");
  list.replaceChildren(...(said.length > 0 ? said : [!check ? "…" : nothing ? "Nothing to compare yet." : "Yes: same parts, same neighbours."])
    .map((text) => element("li", { textContent: text })));
}

/** What a result says of a model, below its view. */
export function show_status(box, result) {
  const lines = [];
  const cuts = new Set((result?.proposed_cuts ?? []).map(({ part }) => part));
  const say = (text, className) => lines.push(element("p", { textContent: text, className }));
  if (!result) say("…", "");
  else {
    if (result.problem) say(result.problem, "warning");
    for (const warning of result.warnings ?? []) say(warning, "warning");
    for (const { part: name, concavity } of result.concave ?? []) {
      say(`${name} is far from convex (red dot, ${(100 * concavity).toFixed(0)} % of the diagonal deep)${cuts.has(name) ? ": red lines propose where to cut it" : ""}.`, "");
    }
    if (lines.length === 0) say((result.parts ?? []).length > 1 ? `${result.parts.length} parts.` : "One part: the whole model.", "");
  }
  box.replaceChildren(...lines);
}
