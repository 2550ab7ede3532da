// Suggests the other one of a pair of markers, where the model is symmetric: the mirrored place of a marker just placed.
import * as server from "./server.js";
import { free_name, names_of, place } from "./sketches.js";

const by_id = (id) => document.getElementById(id);
const near = 0.02; // of the diagonal: a marker there is the other one

const sides = { left: "right", right: "left", Left: "Right", Right: "Left" };

/** The name with left and right exchanged. */
function other_side(name) {
  return name.replace(/\b(left|right|Left|Right)\b/g, (side) => sides[side]);
}

export class Mirroring {
  constructor(app) {
    this.app = app;
    this.symmetric = app.models.map(() => false); // unless asked for, and so found
    this.suggested = app.models.map(() => null); // {of: entry of a marker, put: its mirrored place}
    this.search = null; // for the planes of symmetry
    this.mates = new Map(); // name of a marker to that of its mirror image
    by_id("mirror").addEventListener("change", (event) => {
      this.search = this.switch_to(event.target.checked);
    });
  }

  async switch_to(wanted) {
    const { app } = this;
    this.symmetric.fill(false);
    this.dismiss();
    app.tell(wanted ? "Looking for the plane of symmetry …" : null);
    if (!wanted) return;
    try {
      const found = await Promise.all(app.models.map((_, i) => server.symmetry(i)));
      if (!by_id("mirror").checked) return;
      const problems = found.flatMap(({ problem }, i) => (problem ? [`${app.models[i].name}: ${problem}.`] : []));
      this.symmetric = found.map(({ problem }) => !problem);
      by_id("mirror").checked = this.symmetric.includes(true);
      app.tell(problems.join(" ") || null);
    } catch (error) {
      by_id("mirror").checked = false;
      app.tell(`No mirrored markers: ${error.message}`);
    }
  }

  /** The suggestion for a model, as long as the marker is where it was. */
  pending(model) {
    const suggestion = this.suggested[model];
    return suggestion && (this.app.state.sketches[model].markers ?? []).includes(suggestion.of) ? suggestion : null;
  }

  /** The models that have a suggestion. */
  models() {
    return this.app.models.map((_, i) => i).filter((i) => this.pending(i));
  }

  /** Asks the server for the mirrored place of a marker that the state holds. */
  async suggest(model, entry) {
    const { app } = this;
    this.suggested[model] = null;
    await this.search;
    if (!this.symmetric[model]) return;
    const { name, ...at } = entry;
    const put = await server.mirrored(model, at).catch((error) => app.tell(`No mirror image of ${name}: ${error.message}`));
    if (!put || put.face === undefined || !this.symmetric[model]) return;
    const view = app.views[model];
    const [x, y, z] = view.place_of(put);
    const taken = (app.state.sketches[model].markers ?? []).some((other) => {
      const [a, b, c] = view.place_of(other);
      return Math.hypot(a - x, b - y, c - z) < near;
    });
    if (taken) return;
    this.suggested[model] = { of: entry, put };
    app.refresh_controls();
    app.refresh_view(model);
  }

  /** Places the markers that are suggested on these models. */
  accept(models) {
    const { app } = this;
    let { state } = app;
    let made = null;
    for (const model of models) {
      const { of, put } = this.pending(model);
      made = this.name_beside(state, model, of.name);
      this.mates.set(of.name, made).set(made, of.name);
      state = place(state, model, "markers", { name: made, ...put });
      this.suggested[model] = null;
    }
    if (!made) return;
    app.commit(state);
    if (!app.asked) app.ask_for_partner("markers", made);
  }

  dismiss() {
    this.suggested.fill(null);
    this.app.refresh();
  }

  name_beside(state, model, name) {
    const names = names_of(state, "markers");
    const free_here = (other) => !(state.sketches[model].markers ?? []).some((entry) => entry.name === other);
    const mate = this.mates.get(name);
    if (names.includes(mate) && free_here(mate)) return mate;
    const other = other_side(name);
    return other !== name && free_here(other) ? other : free_name("marker", names);
  }
}
