// What the pointer does on a view in each mode. Mouse, pen and one finger act; the right button, the button of a pen and
// two fingers turn; the other end of a pen erases.
import * as THREE from "three";
import { add_stroke, erase_strokes, names_of, free_name, place } from "./sketches.js";

const reach = 12; // pixels within which something is meant
const pen_eraser = 5; // PointerEvent.button
const spacing = 2; // pixels between the points of a stroke

export const modes = {
  turn: { title: "Turn", key: "t", text: "Drag to turn the model; the wheel zooms." },
  draw: { title: "Draw", key: "d", text: "Draw a stroke over the chosen part." },
  erase: { title: "Erase", key: "e", text: "Drag over strokes to remove them." },
  marker: { title: "Marker", key: "m", text: "Click on a model, then at the same place on the other. Drag a marker to move it; Shift snaps to vertices." },
  anchor: { title: "Anchor", key: "a", text: "Click on a hollow dot to accept it, or on a boundary to add an anchor there." },
};

function distance([ax, ay], [bx, by]) {
  return Math.hypot(ax - bx, ay - by);
}

/** Lets the camera follow the buttons and fingers that the mode leaves to it. */
export function set_camera_buttons(controls, mode) {
  const turns = mode === "turn";
  controls.mouseButtons = {
    LEFT: turns ? THREE.MOUSE.ROTATE : null,
    MIDDLE: THREE.MOUSE.DOLLY,
    RIGHT: turns ? THREE.MOUSE.PAN : THREE.MOUSE.ROTATE,
  };
  controls.touches = turns
    ? { ONE: THREE.TOUCH.ROTATE, TWO: THREE.TOUCH.DOLLY_PAN }
    : { ONE: null, TWO: THREE.TOUCH.DOLLY_ROTATE };
}

/** The member of `candidates` ({point, ...}) that is seen nearest to a pixel, within reach. */
function nearest(view, pixel, candidates) {
  let best = null;
  let least = reach;
  for (const candidate of candidates) {
    const seen = view.project(candidate.point);
    const d = distance(pixel, seen);
    if (d <= least && view.is_visible(candidate.point)) {
      least = d;
      best = candidate;
    }
  }
  return best;
}

function facet_place({ facet, barycentric }) {
  const inside = barycentric.map((b) => Math.min(Math.max(b, 0), 1));
  const sum = inside[0] + inside[1] + inside[2];
  return { face: facet, barycentric: inside.map((b) => b / sum) };
}

class Stroke {
  constructor(app, model) {
    Object.assign(this, { app, model, view: app.views[model], pixels: [] });
  }
  move(pixel) {
    if (this.pixels.length > 0 && distance(pixel, this.pixels.at(-1)) < spacing) return;
    this.pixels.push(pixel);
    this.view.trail(this.pixels, this.app.chosen_color());
  }
  end() {
    this.cancel();
    if (!this.pixels.some((pixel) => this.view.pick(pixel))) {
      this.app.tell("That stroke missed the model: draw on it.");
      return;
    }
    performance.mark("stroke");
    const stroke = { screen: this.pixels, camera: this.view.stroke_camera() };
    this.app.commit(add_stroke(this.app.state, this.model, this.app.chosen, stroke));
  }
  cancel() {
    this.view.trail([], [0, 0, 0]);
  }
}

class Erasing {
  constructor(app, model) {
    Object.assign(this, { app, model, view: app.views[model], touched: new Set() });
    this.seen = app.drawn_strokes(model).map(({ stroke, pieces }) => ({
      stroke,
      pixels: pieces.flat().filter((p) => this.view.is_visible(p)).map((p) => this.view.project(p)),
    }));
  }
  move(pixel) {
    const before = this.touched.size;
    for (const { stroke, pixels } of this.seen) {
      if (pixels.some((p) => distance(p, pixel) < reach)) this.touched.add(stroke);
    }
    if (this.touched.size > before) this.app.refresh_view(this.model, this.touched);
  }
  end() {
    if (this.touched.size > 0) this.app.commit(erase_strokes(this.app.state, this.model, this.touched));
  }
  cancel() {
    this.app.refresh_view(this.model);
  }
}

/** Sets or moves a marker or an anchor; `found` says where a pixel would put it, null for nowhere. */
class Placing {
  constructor(app, model, kind, entry, found) {
    Object.assign(this, { app, model, kind, entry, found, put: null });
  }
  move(pixel, event) {
    this.put = this.found(pixel, event) ?? this.put;
    if (this.put) this.app.preview(this.model, this.kind, { ...this.entry, ...this.put });
  }
  end() {
    if (!this.put) {
      this.app.tell(this.kind === "anchors" ? "Anchors lie on the boundary between two parts: click on one." : "Click on the model.");
      return;
    }
    const entry = { ...this.entry, ...this.put };
    this.app.commit(place(this.app.state, this.model, this.kind, entry));
    this.app.ask_for_partner(this.kind, this.entry.name);
    if (this.kind === "markers") this.app.mirroring.suggest(this.model, entry);
  }
  cancel() {
    this.app.refresh_view(this.model);
  }
}

function placing_marker(app, model, pixel) {
  const view = app.views[model];
  const suggestion = app.mirroring.pending(model);
  if (suggestion && nearest(view, pixel, [{ point: view.place_of(suggestion.put) }])) {
    return { move() {}, end: () => app.mirroring.accept([model]), cancel() {} };
  }
  const known = (app.state.sketches[model].markers ?? []).map((entry) => ({ entry, point: view.place_of(entry) }));
  const moved = nearest(view, pixel, known)?.entry;
  const name = moved?.name ?? (app.asked?.kind === "markers" && app.asked.model === model
    ? app.asked.name : free_name("marker", names_of(app.state, "markers")));
  return new Placing(app, model, "markers", { name }, (at, event) => {
    const hit = view.pick(at);
    if (!hit) return null;
    return event.shiftKey ? { vertex: view.corner(hit) } : facet_place(hit);
  });
}

function accepted_name(proposed) {
  return proposed.replace(/ \(proposed\)$/, "");
}

function placing_anchor(app, model, pixel) {
  const view = app.views[model];
  const result = app.results[model];
  const proposals = (result?.proposed_anchors ?? []).map((entry) => ({ entry, point: view.vertex(entry.vertex) }));
  const known = (app.state.sketches[model].anchors ?? []).map((entry) => ({ entry, point: view.place_of(entry) }));
  const moved = nearest(view, pixel, known)?.entry;
  const asked = app.asked?.kind === "anchors" && app.asked.model === model ? app.asked : null;
  const wanted = moved ?? asked;
  const accepted = moved ? null : nearest(view, pixel, proposals)?.entry;
  if (accepted) {
    const { vertex, between } = accepted;
    // The partner of another's anchor takes its name.
    const partner = asked && asked.between.every((part) => between.includes(part));
    return new Placing(app, model, "anchors", { name: partner ? asked.name : accepted_name(accepted.name), between }, () => ({ vertex }));
  }
  const name = wanted?.name ?? free_name("anchor", names_of(app.state, "anchors"));
  const boundary = (result?.curves ?? [])
    .filter(({ parts }) => !wanted || parts.every((part) => wanted.between.includes(part)))
    .flatMap(({ parts, vertices }) => vertices.map((vertex) => ({ vertex, between: parts, point: view.vertex(vertex) })));
  return new Placing(app, model, "anchors", { name }, (at) => {
    const found = nearest(view, at, boundary);
    return found && { vertex: found.vertex, between: found.between };
  });
}

function begin(app, model, pixel, mode) {
  switch (mode) {
    case "draw":
      if (app.chosen) return new Stroke(app, model);
      app.tell("Add a part first (N), and draw what belongs to it.");
      return null;
    case "erase": return new Erasing(app, model);
    case "marker": return placing_marker(app, model, pixel);
    case "anchor": return placing_anchor(app, model, pixel);
    default: return null;
  }
}

/** Sets up the pointer on a view. */
export function listen(app, model) {
  const view = app.views[model];
  const { canvas } = view;
  const down = new Set(); // fingers and pens
  let gesture = null;
  let pen = null; // the pen that draws
  canvas.addEventListener("pointerdown", (event) => {
    if (pen !== null) return; // the palm of the hand that holds it
    down.add(event.pointerId);
    if (down.size > 1) {
      // A second finger: the hand turns the model.
      gesture?.cancel();
      gesture = null;
      return;
    }
    const erases = event.pointerType === "pen" && event.button === pen_eraser;
    if ((event.button !== 0 && !erases) || app.busy) return;
    app.tell(null);
    const pixel = view.pixel(event);
    gesture = begin(app, model, pixel, erases ? "erase" : app.mode);
    gesture?.move(pixel, event);
    if (!gesture || event.pointerType !== "pen") return;
    pen = event.pointerId;
    view.controls.enabled = false;
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!gesture || !down.has(event.pointerId)) return;
    for (const step of event.getCoalescedEvents?.() ?? []) gesture.move(view.pixel(step), event);
    gesture.move(view.pixel(event), event);
  });
  const lift = (event, ended) => {
    if (!down.delete(event.pointerId)) return;
    if (event.pointerId === pen) {
      pen = null;
      view.controls.enabled = true;
    }
    const finished = gesture;
    gesture = null;
    if (ended) finished?.end();
    else finished?.cancel();
  };
  canvas.addEventListener("pointerup", (event) => lift(event, true));
  canvas.addEventListener("pointercancel", (event) => lift(event, false));
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
}
