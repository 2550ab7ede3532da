// The page: what it knows, and how the controls change it.
import { decoded } from "../report/arrays.js";
import { is_dark, theme_button } from "../report/theme.js";
import { listen, modes, set_camera_buttons } from "./gestures.js";
import { History } from "./history.js";
import { Mirroring } from "./mirror.js";
import { show_agreement, show_lists, show_status } from "./lists.js";
import { part_colors, stroke_color } from "./palette.js";
import { Running } from "./running.js";
import * as server from "./server.js";
import * as sketches from "./sketches.js";
import { View } from "./view.js";

const by_id = (id) => document.getElementById(id);
const plain = { light: [0.8, 0.79, 0.76], dark: [0.74, 0.73, 0.7] };
const ink = [0.12, 0.12, 0.11];
const marker_color = [0.4, 0.1, 0.6];
const anchor_color = [0.05, 0.1, 0.2];
const deepest_color = [0.8, 0.1, 0.1];
const pattern_cell = 0.055; // of the model's diagonal
const label_delay = 120; // milliseconds after the last turn
const rest = 1200; // milliseconds after the last change
const turn_step = Math.PI / 24; // of an arrow key

const keys = [
  ["T or Space held", "turn the model (also: right mouse button, button of a pen, two fingers)"],
  ["D, E, M, A", "draw, erase, place markers, place anchors"],
  ["1 … 9", "choose a part"],
  ["N", "add a part"],
  ["Ctrl+Z, Ctrl+Shift+Z", "undo, redo"],
  ["L", "turn both models together"],
  ["Enter", "add the mirrored marker that is suggested"],
  ["Arrow keys, 0", "turn the view that has the focus, reset it"],
  ["Escape", "leave what is being asked for"],
];

class App {
  constructor(models, views, boxes, states) {
    this.models = models;
    this.views = views;
    this.boxes = boxes;
    this.history = new History(sketches.state_of(states));
    this.results = models.map(() => null);
    this.labels = models.map(() => null);
    this.saved = [...this.state.sketches]; // the sketches that the server has
    this.saving = Promise.resolve();
    this.mode = this.state.parts.length > 0 ? "turn" : "draw";
    this.before_space = null;
    this.chosen = this.state.parts[0] ?? null;
    this.asked = null; // {kind, name, between, model}: the place that is asked for
    this.check = null;
    this.told = null;
    this.busy = false; // a result is shown
    this.seeking = models.map(() => 0); // timers
    this.pieces = new WeakMap(); // of strokes
    this.mirroring = new Mirroring(this);
    this.running = null; // the pipeline, with two models
  }

  get state() {
    return this.history.state;
  }

  chosen_color() {
    return stroke_color(part_colors(this.state.parts).get(this.chosen));
  }

  // What changes the sketches.

  commit(state) {
    this.change(() => this.history.push(state));
  }

  change(step) {
    const old = this.state;
    step();
    const { state } = this;
    if (!state.parts.includes(this.chosen)) this.chosen = state.parts.at(-1) ?? null;
    this.refresh_controls();
    this.models.forEach((_, i) => {
      if (state.parts !== old.parts || state.sketches[i] !== old.sketches[i]) this.refresh_view(i);
    });
    this.show_busy(true);
    const saving = this.saving.then(() => this.save());
    this.saving = saving;
    saving.finally(() => this.show_busy(this.saving !== saving));
  }

  async save() {
    const { state } = this;
    const unsaved = this.models.map((_, i) => i).filter((i) => state.sketches[i] !== this.saved[i]);
    if (unsaved.length === 0) return;
    this.show_saved("Saving …");
    try {
      await Promise.all(unsaved.map(async (i) => {
        this.take_result(i, await server.save_sketch(i, state.sketches[i]));
        this.saved[i] = state.sketches[i];
      }));
      this.show_saved("Saved");
    } catch (error) {
      this.show_saved("Not saved", true);
      this.tell(`Not saved: ${error.message}`);
    }
    await this.compare();
  }

  async compare() {
    if (this.models.length < 2) return;
    this.check = await server.check().catch((error) => ({ problem: error.message }));
    show_agreement(this, this.check);
    this.running?.show_obstacle();
    this.show_hint();
  }

  take_result(model, result) {
    this.results[model] = result;
    this.labels[model] = result.labels ? decoded(result.labels) : null;
    this.refresh_view(model);
    show_status(this.boxes[model], result);
    this.seek_hints(model);
    this.show_hint();
    if (performance.getEntriesByName("stroke").length === 0) return;
    this.views[model].draw();
    performance.measure("stroke to parts", "stroke");
    performance.clearMarks("stroke");
  }

  /** Parts that are far from convex, and where to cut them: looked for once the hand rests, since it takes long. */
  seek_hints(model) {
    clearTimeout(this.seeking[model]);
    const result = this.results[model];
    this.boxes[model].setAttribute("aria-busy", !result.problem);
    if (result.problem) return;
    this.seeking[model] = setTimeout(async () => {
      const hints = await server.hints(model).catch(() => ({}));
      if (this.results[model] !== result) return;
      Object.assign(result, hints);
      this.refresh_view(model);
      show_status(this.boxes[model], result);
      this.boxes[model].setAttribute("aria-busy", false);
    }, rest);
  }

  add_part() {
    const name = sketches.free_name("part", this.state.parts);
    this.chosen = name;
    this.set_mode("draw");
    this.commit(sketches.add_part(this.state, name));
    const field = [...document.querySelectorAll("#parts input")].at(-1);
    field.focus();
    field.select();
  }

  rename_part(from, to) {
    if (to === "" || (to !== from && this.state.parts.includes(to))) return false;
    if (this.chosen === from) this.chosen = to;
    if (to !== from) this.commit(sketches.rename_part(this.state, from, to));
    return true;
  }

  delete_part(name) {
    this.commit(sketches.delete_part(this.state, name));
  }

  rename_place(kind, from, to) {
    if (to === "" || (to !== from && sketches.names_of(this.state, kind).includes(to))) return false;
    if (to !== from) this.commit(sketches.rename(this.state, kind, from, to));
    return true;
  }

  delete_place(kind, name) {
    if (this.asked?.name === name) this.asked = null;
    this.commit(sketches.remove(this.state, kind, name));
  }

  /** Asks for a marker or an anchor where it is missing; for nothing when it is on all models. */
  ask_for_partner(kind, name) {
    const entries = this.state.sketches.map((sketch) => (sketch[kind] ?? []).find((entry) => entry.name === name));
    const model = entries.findIndex((entry) => !entry);
    this.asked = model < 0 ? null : { kind, name, between: entries.find(Boolean)?.between, model };
    if (this.asked) this.set_mode(kind === "markers" ? "marker" : "anchor");
    this.refresh_controls();
  }

  undo() {
    this.asked = null;
    this.change(() => this.history.undo());
  }

  redo() {
    this.change(() => this.history.redo());
  }

  // What shows them.

  choose(name) {
    if (this.chosen === name) return;
    this.chosen = name;
    document.querySelectorAll("#parts .row").forEach((row, i) => row.classList.toggle("chosen", this.state.parts[i] === name));
    this.show_hint();
  }

  set_mode(mode) {
    this.mode = mode;
    for (const button of by_id("modes").children) button.setAttribute("aria-checked", button.dataset.mode === mode);
    for (const view of this.views) {
      view.canvas.dataset.mode = mode;
      set_camera_buttons(view.controls, mode);
    }
    this.show_hint();
  }

  drawn_strokes(model) {
    return [...part_colors(this.state.parts)].flatMap(([part, color]) => sketches.strokes_of(this.state, model, part).map((stroke) => {
      if (!this.pieces.has(stroke)) this.pieces.set(stroke, this.views[model].stroke_pieces(stroke));
      return { stroke, pieces: this.pieces.get(stroke), color: stroke_color(color) };
    }));
  }

  /** @param without strokes to leave out; @param instead {kind, entry} to show where it is being dragged */
  refresh_view(model, without = new Set(), instead = null) {
    const view = this.views[model];
    const result = this.results[model];
    const none = plain[is_dark() ? "dark" : "light"];
    const of_parts = part_colors(this.state.parts);
    const colors = (result?.parts ?? []).map(({ name }) => of_parts.get(name) ?? none);
    const labelled = colors.length > 0 && this.labels[model] ? this.labels[model] : null;
    view.paint(labelled, colors, none);
    view.material.uniforms.cell.value = this.busy && model === 0 ? pattern_cell : 0;
    if (this.busy) {
      view.cover([], []);
      view.texts = [];
      view.name([]);
      return;
    }
    const curves = this.drawn_strokes(model)
      .filter(({ stroke }) => !without.has(stroke))
      .flatMap(({ pieces, color }) => pieces.map((points) => ({ points, closed: false, color, width: 0.003 })));
    for (const { vertices, closed } of result?.curves ?? []) {
      curves.push({ points: vertices.map((v) => view.vertex(v)), closed, color: ink, width: 0.0016 });
    }
    for (const cut of result?.proposed_cuts ?? []) {
      for (const { vertices, closed } of cut.curves) {
        curves.push({ points: vertices.map((v) => view.vertex(v)), closed, color: deepest_color, width: 0.0012 });
      }
    }
    const placed = (kind) => (this.state.sketches[model][kind] ?? [])
      .filter((entry) => !(instead?.kind === kind && instead.entry.name === entry.name))
      .concat(instead?.kind === kind ? [instead.entry] : []);
    const dots = [
      ...placed("markers").map((entry) => ({ point: view.place_of(entry), color: marker_color })),
      ...placed("anchors").map((entry) => ({ point: view.place_of(entry), color: anchor_color })),
      ...[this.mirroring.pending(model)].filter(Boolean).map(({ put }) => ({ point: view.place_of(put), color: marker_color, hollow: true })),
      ...(result?.proposed_anchors ?? []).map(({ vertex }) => ({ point: view.vertex(vertex), color: anchor_color, hollow: true })),
      ...(result?.concave ?? []).map(({ deepest }) => ({ point: view.vertex(deepest), color: deepest_color })),
    ];
    view.cover(curves, dots);
    const numbers = sketches.names_of(this.state, "markers");
    view.texts = placed("markers").map((entry) => ({ point: view.place_of(entry), text: String(numbers.indexOf(entry.name) + 1 || numbers.length + 1) }));
    this.label_soon(model);
  }

  label_soon(model) {
    const view = this.views[model];
    view.name([]);
    clearTimeout(view.label_timer);
    view.label_timer = setTimeout(() => view.name((view.texts ?? []).filter(({ point }) => view.is_visible(point))), label_delay);
  }

  preview(model, kind, entry) {
    this.refresh_view(model, undefined, { kind, entry });
  }

  refresh() {
    this.refresh_controls();
    this.views.forEach((_, model) => this.refresh_view(model));
  }

  refresh_controls() {
    show_lists(this);
    by_id("undo").disabled = !this.history.can_undo;
    by_id("redo").disabled = !this.history.can_redo;
    this.running?.show_obstacle();
    this.show_hint();
  }

  /** Shows or leaves the result of a run. */
  show_result(shown) {
    this.busy = shown;
    if (shown) this.set_mode("turn");
    this.refresh();
  }

  /** Says that answers are awaited that change what the views show. */
  show_busy(busy) {
    by_id("views").setAttribute("aria-busy", busy);
  }

  show_saved(text, failed) {
    by_id("saved").textContent = text;
    by_id("saved").className = failed ? "failure" : "";
  }

  /** Says something until the next action; null says nothing. */
  tell(text) {
    this.told = text;
    this.show_hint();
  }

  show_hint() {
    by_id("hint").textContent = this.told ?? this.next_step();
  }

  next_step() {
    const { parts } = this.state;
    const two = this.models.length > 1;
    if (this.busy) return "Move the slider: the first model becomes the second. Each square of the pattern shows where a piece of it went.";
    const mirrored = this.mirroring.models().map((i) => `${this.mirroring.pending(i).of.name} on ${this.models[i].name}`);
    const offer = mirrored.length > 0 ? `Enter adds the mirror image of ${mirrored.join(" and of ")}.` : "";
    if (this.asked) return `Now click at the place of ${this.asked.name} on ${this.models[this.asked.model].name} (Escape: later). ${offer}`;
    if (offer) return `${offer} Escape: no.`;
    if (this.mode === "turn" || this.mode === "erase") return modes[this.mode].text + (this.before_space ? "" : " D: draw again.");
    if (this.mode !== "draw") return modes[this.mode].text;
    if (parts.length === 0) return "Add the parts to tell apart, such as head and body (+ Add a part, or N).";
    const bare = this.models.findIndex((_, model) => sketches.strokes_of(this.state, model, this.chosen).length === 0);
    if (bare >= 0) return `Draw a stroke along ${this.chosen} on ${this.models[bare].name}. Space held, the right button or two fingers turn the model.`;
    const other = parts.find((part) => this.models.some((_, model) => sketches.strokes_of(this.state, model, part).length === 0));
    if (other) return `${this.chosen} is drawn. Next: ${other} (choose it by its number).`;
    if (parts.length === 1) return "Add another part (N).";
    if (two && sketches.names_of(this.state, "markers").length === 0) return "Every part is drawn. Correct boundaries by more strokes, or go on to markers (M).";
    if (two && this.check && !this.check.problem && [...this.check.differences, ...(this.check.misplaced ?? [])].length === 0) return "The models agree. Add markers (M) and anchors (A) where the fit matters, then run.";
    return "Draw more strokes where a boundary is wrong.";
  }
}

function make_modes(app) {
  for (const [mode, { title, key, text }] of Object.entries(modes)) {
    const button = Object.assign(document.createElement("button"), { type: "button", role: "radio", title: text });
    button.dataset.mode = mode;
    button.append(title, Object.assign(document.createElement("kbd"), { textContent: key.toUpperCase() }));
    button.addEventListener("click", () => app.set_mode(mode));
    by_id("modes").append(button);
  }
}

function make_keys(app) {
  by_id("keys").replaceChildren(...keys.map(([key, text]) => {
    const row = document.createElement("tr");
    row.append(Object.assign(document.createElement("th"), { textContent: key }), Object.assign(document.createElement("td"), { textContent: text }));
    return row;
  }));
  const view_keys = {
    ArrowLeft: (view) => view.turn(-turn_step, 0),
    ArrowRight: (view) => view.turn(turn_step, 0),
    ArrowUp: (view) => view.turn(0, -turn_step),
    ArrowDown: (view) => view.turn(0, turn_step),
    0: (view) => view.reset(),
  };
  const page_keys = {
    n: () => app.add_part(),
    l: () => by_id("link").click(),
    "?": () => by_id("help").showModal(),
    Escape: () => {
      app.asked = null;
      app.tell(null);
      app.mirroring.dismiss();
    },
    " ": () => {
      if (app.mode === "turn") return;
      app.before_space = app.mode;
      app.set_mode("turn");
    },
  };
  const enter = () => app.mirroring.accept(app.mirroring.models());
  for (const [mode, { key }] of Object.entries(modes)) page_keys[key] = () => app.set_mode(mode);
  addEventListener("keydown", (event) => {
    if (event.target.closest("input:not([type]), dialog")) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if ((event.ctrlKey || event.metaKey) && (key === "z" || key === "y")) {
      event.preventDefault();
      if (app.busy) return;
      if (key === "y" || event.shiftKey) app.redo();
      else app.undo();
      return;
    }
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const view = app.views.find(({ canvas }) => canvas === event.target);
    const part = app.state.parts[Number(key) - 1];
    const offers = key === "Enter" && !app.busy && app.mirroring.models().length > 0;
    const action = (view && view_keys[key] && (() => view_keys[key](view))) ?? (offers ? enter : page_keys[key]) ?? (part && (() => {
      app.choose(part);
      app.set_mode("draw");
    }));
    if (!action || ([" ", "Enter"].includes(key) && event.target.closest("button, input")) || (event.target.type === "range" && key.startsWith("Arrow"))) return;
    event.preventDefault();
    action();
  });
  addEventListener("keyup", (event) => {
    if (event.key !== " " || !app.before_space) return;
    const mode = app.before_space;
    app.before_space = null;
    app.set_mode(mode);
  });
}

function make_view(facts, mesh) {
  const box = document.createElement("figure");
  box.className = "view";
  box.style.margin = 0;
  box.innerHTML = `<div class="stage"><canvas tabindex="0" role="img"></canvas><svg aria-hidden="true"></svg><figcaption></figcaption></div><div class="status" aria-live="polite"></div>`;
  box.querySelector("figcaption").textContent = `${facts.name}: ${facts.facets.toLocaleString("en")} facets`;
  box.querySelector("canvas").setAttribute("aria-label", `${facts.name}. Arrow keys turn it, 0 resets.`);
  by_id("views").append(box);
  return { view: new View(box.querySelector("canvas"), box.querySelector("svg"), facts, mesh), status: box.querySelector(".status") };
}

function link_views(app) {
  const link = by_id("link");
  by_id("link-row").hidden = app.views.length < 2;
  app.views.forEach((view, i) => {
    view.turned = () => {
      if (!app.busy) app.label_soon(i);
      const other = app.views[1 - i];
      if (!other || !link.checked) return;
      other.follow(view);
      if (!app.busy) app.label_soon(1 - i);
    };
  });
  link.addEventListener("change", () => {
    if (link.checked && app.views[1]) app.views[1].follow(app.views[0]);
  });
}

async function start() {
  const { models } = await server.models();
  const [meshes, states, results] = await Promise.all([
    Promise.all(models.map(server.mesh)),
    Promise.all(models.map((_, i) => server.saved_sketch(i))),
    Promise.all(models.map((_, i) => server.last_result(i))),
  ]);
  const made = models.map((facts, i) => make_view(facts, meshes[i]));
  const app = new App(models, made.map(({ view }) => view), made.map(({ status }) => status), states);
  make_modes(app);
  make_keys(app);
  link_views(app);
  models.forEach((_, i) => listen(app, i));
  by_id("agreement").hidden = models.length < 2;
  by_id("undo").addEventListener("click", () => app.undo());
  by_id("redo").addEventListener("click", () => app.redo());
  by_id("add-part").addEventListener("click", () => app.add_part());
  by_id("help-button").addEventListener("click", () => by_id("help").showModal());
  theme_button(by_id("theme"), () => app.refresh());
  app.set_mode(app.mode);
  results.forEach((result, i) => app.take_result(i, result));
  app.show_saved(states.some((sketch) => (sketch.parts ?? []).length > 0) ? "Saved" : "");
  await app.compare();
  app.running = new Running(app);
  if (models.length > 1) await app.running.guarded(() => app.running.follow());
  app.show_busy(false);
}

start().catch((error) => {
  by_id("hint").textContent = `The page cannot go on: ${error.message}`;
  by_id("hint").className = "failure";
});
