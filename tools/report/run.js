// The page of one pair.
import { facts, numbers } from "./arrays.js";
import { show_legend } from "./legend.js";
import { counterpart } from "./link.js";
import { extents, Panes } from "./panes.js";
import { captions, stages } from "./stages.js";
import { Surface } from "./surface.js";
import { show_figures, show_findings, show_history } from "./tables.js";
import { is_dark, theme_button } from "./theme.js";

const by_id = (id) => document.getElementById(id);
const plain = { light: [0.8, 0.79, 0.76], dark: [0.74, 0.73, 0.7] };
const pattern_cell = 0.11; // models have a diagonal of 2
const mark_kinds = {
  markers: { name: "markers", color: [0.4, 0.1, 0.6], size: 0.014 },
  critical: { name: "critical points", color: [0.05, 0.35, 0.75], size: 0.009 },
};
const color_titles = {
  plain: "plain", parts: "parts", pattern: "checker pattern",
  distance: "distance", distortion: "distortion", area: "change of area",
};

const surfaces = {};
for (const [name, surface] of Object.entries(facts.surfaces)) surfaces[name] = new Surface(surface, facts.parts);
if (surfaces.source && surfaces.compatible) {
  // A surface of its own: it moves.
  surfaces.morph = new Surface({ ...facts.surfaces.source }, facts.parts);
}

const panes = new Panes(by_id("canvas"), extents([surfaces.source, surfaces.target].filter(Boolean)));
let stage = stages[0];
let color = stage.color;

const shown_surfaces = () => stage.panes.map((name) => surfaces[name]);

function marks_for(side) {
  const marks = [];
  const name = stage.panes[side];
  const where = { source: "source", morph: null, target: "target" };
  if (by_id("markers").checked && facts.markers.length > 0) {
    const key = name in where ? where[name] : ["compatible", "critical", "reconstructed"].includes(name) ? "target" : null;
    if (key) marks.push({ ...mark_kinds.markers, positions: facts.markers.flatMap((marker) => marker[key]) });
  }
  if (stage.critical && facts.critical_points) {
    marks.push({ ...mark_kinds.critical, positions: numbers(facts.critical_points.positions) });
  }
  return marks.map((mark) => ({ ...mark, color: mark.color.reduce((hex, c) => hex * 256 + Math.round(255 * c), 0), rgb: mark.color }));
}

function caption_of(name) {
  const surface = surfaces[name];
  if (!surface) return captions[name];
  const total = surface.facts.total;
  const drawn = surface.linked_facets;
  const count = total.toLocaleString("en");
  return `${captions[name]}: ${count} facets` + (drawn < total ? `, drawn with ${drawn.toLocaleString("en")}` : "");
}

function trouble_of(side) {
  const tool = stage.tools[side];
  const state = facts.stages.find(({ title }) => title === tool);
  const why = state?.trouble ? `: ${state.trouble}` : "";
  return `Nothing to show of ${tool}${why}.`;
}

function show_morph() {
  const t = Number(by_id("morph").value);
  const text = `${Math.round(100 * t)} %`;
  by_id("morph-value").textContent = text;
  by_id("morph").setAttribute("aria-valuetext", `${text} of the way`);
  if (!surfaces.morph) return;
  const a = surfaces.source.positions;
  const b = surfaces.compatible.positions;
  surfaces.morph.place(Float32Array.from(a, (value, i) => value + t * (b[i] - value)));
  panes.request();
}

/** Brings everything on the page in line with the stage and the controls. */
function refresh() {
  const theme = is_dark() ? "dark" : "light";
  const shown = shown_surfaces();
  const marks = [0, 1].map(marks_for);
  shown.forEach((surface, side) => {
    const mode = surface?.paint(color, plain[theme]);
    panes.panes[side].material.uniforms.cell.value = mode === "pattern" ? pattern_cell : 0;
    panes.panes[side].material.uniforms.contrast.value = surface?.facts.fields?.[mode] ? 0.45 : 1;
    panes.panes[side].show(surface, surface ? marks[side] : [], by_id("edges").checked);
    const empty = by_id(side === 0 ? "left-empty" : "right-empty");
    empty.hidden = Boolean(surface);
    empty.textContent = surface ? "" : trouble_of(side);
    by_id(side === 0 ? "left-caption" : "right-caption").textContent = caption_of(stage.panes[side]);
  });
  const folds = stage.folds && shown.some((surface) => surface?.facts.folds > 0);
  const kinds = [...new Map(marks.flat().map((mark) => [mark.name, { name: mark.name, color: mark.rgb }])).values()];
  show_legend(by_id("legend"), color, shown, facts.parts, kinds, folds);
  panes.request();
}

function fill_colors() {
  const options = Object.keys(color_titles).filter((mode) => shown_surfaces().some((s) => s?.can_paint(mode)));
  by_id("color").replaceChildren(...options.map((mode) => new Option(color_titles[mode], mode, false, mode === color)));
}

function choose(next, focus) {
  stage = next;
  color = stage.color;
  for (const tab of by_id("stages").children) {
    const chosen = tab.dataset.stage === stage.id;
    tab.setAttribute("aria-selected", chosen);
    tab.tabIndex = chosen ? 0 : -1;
    if (chosen && focus) tab.focus();
    if (chosen) tab.scrollIntoView({ block: "nearest", inline: "nearest" });
  }
  by_id("stage-title").textContent = stage.title;
  by_id("stage-text").textContent = stage.text(facts);
  by_id("morph-row").hidden = stage.id !== "morph" || !surfaces.morph;
  by_id("place").textContent = "";
  [0, 1].forEach((side) => panes.mark(side, null));
  fill_colors();
  refresh();
}

function fill_stages() {
  stages.forEach((entry, i) => {
    const tab = document.createElement("button");
    tab.type = "button";
    tab.role = "tab";
    tab.dataset.stage = entry.id;
    tab.setAttribute("aria-controls", "stage");
    tab.textContent = entry.title;
    if (entry.panes.some((name) => !surfaces[name])) {
      tab.classList.add("missing");
      tab.append(Object.assign(document.createElement("span"), { textContent: "missing" }));
    }
    tab.addEventListener("click", () => choose(entry, false));
    tab.addEventListener("keydown", (event) => {
      const moves = { ArrowDown: i + 1, ArrowRight: i + 1, ArrowUp: i - 1, ArrowLeft: i - 1, Home: 0, End: stages.length - 1 };
      const to = stages[moves[event.key]];
      if (!to) return;
      event.preventDefault();
      choose(to, true);
    });
    by_id("stages").append(tab);
  });
}

// The same place on both views, under the pointer.
function point_at(event) {
  if (event.buttons !== 0) return;
  const picked = panes.pick(event);
  const [here, there] = picked ? [picked.pane, 1 - picked.pane] : [0, 1];
  const from = panes.panes[here].surface;
  const to = panes.panes[there].surface;
  if (!picked) {
    panes.mark(0, null);
    panes.mark(1, null);
    by_id("place").textContent = "";
    return;
  }
  const other = counterpart(surfaces, from, to, picked.facet, picked.barycentric);
  panes.mark(here, from.point(picked.facet, picked.barycentric));
  panes.mark(there, other);
  by_id("place").textContent = facts.parts[from.labels[picked.facet]].name + (other ? "" : " (no counterpart known)");
}

function show_verdict() {
  const failures = facts.findings.filter(({ weight }) => weight === "failure").length;
  const warnings = facts.findings.filter(({ weight }) => weight === "warning").length;
  const [text, className] = failures > 0 ? ["incomplete", "failure"]
    : facts.one_to_one ? ["certified one-to-one", "good"] : ["not certified one-to-one", "warning"];
  Object.assign(by_id("verdict"), { textContent: text, className });
  by_id("finding-count").textContent = failures + warnings > 0 ? `(${failures + warnings})` : "";
}

by_id("name").textContent = facts.name;
show_verdict();
show_figures(document.querySelector("#figures .table"), facts);
show_findings(document.querySelector("#findings .list"), facts.findings);
show_history(document.querySelector("#history .table"), facts.history);
by_id("colophon").textContent =
  `Made by partwise ${facts.version}. Both models are turned to one view and scaled to equal size.` +
  (Object.values(facts.models ?? {}).some(({ shown, facets }) => shown < facets)
    ? " Large models are drawn with fewer facets than they have; figures are of the whole models, and folded facets are all drawn."
    : "");
fill_stages();
by_id("color").addEventListener("change", (event) => {
  color = event.target.value;
  refresh();
});
for (const id of ["edges", "markers"]) by_id(id).addEventListener("change", refresh);
by_id("reset").addEventListener("click", () => panes.reset());
by_id("morph").addEventListener("input", show_morph);
let last_move = null;
by_id("canvas").addEventListener("pointermove", (event) => {
  if (!last_move) requestAnimationFrame(() => {
    point_at(last_move);
    last_move = null;
  });
  last_move = event;
});
by_id("canvas").addEventListener("pointerleave", () => [0, 1].forEach((side) => panes.mark(side, null)));
choose(stages.find(({ id, panes: names }) => id === "compatible" && surfaces[names[0]]) ?? stages[0], false);
show_morph();
theme_button(by_id("theme"), refresh);
