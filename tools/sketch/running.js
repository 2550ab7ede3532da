// The pipeline, run on the saved sketches, and its result: the first model on its way to the second.
import { named } from "./lists.js";
import * as server from "./server.js";
import { names_of, strokes_of } from "./sketches.js";

const by_id = (id) => document.getElementById(id);
const patience = 400; // milliseconds between questions to the server

function percent(value) {
  return `${(100 * value).toPrecision(2)} %`;
}

function measures_text({ rms_distance: rms, max_distance: most, flipped_faces: flipped, one_to_one: certified }) {
  return `Distance between the surfaces: RMS ${percent(rms)}, at most ${percent(most)} of the target's diagonal. ` +
    `${flipped} flipped facets. ` + (certified ? "Certified one-to-one." : "Not certified one-to-one.");
}

/** What a run would fail for, as a sentence: the first obstacle in the order in which a user would remove them; or null. */
function run_obstacle(app) {
  const { parts } = app.state;
  const undrawn = app.models.flatMap(({ name }, model) => {
    const missing = parts.filter((part) => strokes_of(app.state, model, part).length === 0);
    return missing.length > 0 && parts.length > 1 ? [`${missing.join(", ")} on ${name}`] : [];
  });
  if (undrawn.length > 0) return `To be drawn before a run: ${undrawn.join("; ")}.`;
  const problem = app.models.map(({ name }, model) => app.results[model]?.problem && `${name}: ${app.results[model].problem}`).find(Boolean);
  if (problem) return `To be put right before a run: ${problem}`;
  const [difference] = app.check?.differences ?? [];
  if (difference) return `To be put right before a run: ${named(app, difference)}.`;
  return parts.length < 2 && names_of(app.state, "markers").length === 0 ? "Before a run: parts, or markers on both models." : null;
}

export class Running {
  constructor(app) {
    this.app = app;
    by_id("run").addEventListener("click", () => this.guarded(() => this.start()));
    by_id("cancel").addEventListener("click", () => this.guarded(() => server.cancel_run()));
    by_id("close-result").addEventListener("click", () => this.close());
    by_id("morph").addEventListener("input", () => this.show_morph());
    by_id("run-bar").hidden = app.models.length < 2;
    this.start_positions = app.views[0].surface.positions;
    this.end_positions = null;
    this.runs = false;
    this.show_obstacle();
  }

  say(text, failed) {
    by_id("run-text").textContent = text;
    by_id("run-text").className = failed ? "failure" : "";
  }

  async guarded(action) {
    try {
      await action();
    } catch (error) {
      this.say(error.message, true);
      this.runs = false;
      this.show_obstacle();
    }
  }

  /** Says what would make a run fail, before it is started. */
  show_obstacle() {
    const obstacle = this.runs ? null : run_obstacle(this.app);
    by_id("run").disabled = this.runs || obstacle !== null;
    by_id("obstacle").hidden = obstacle === null || this.app.busy;
    by_id("obstacle").textContent = obstacle ?? "";
  }

  async start() {
    this.close();
    this.runs = true;
    this.show_obstacle();
    await this.app.saving;
    const obstacle = run_obstacle(this.app); // by what the server has now
    if (obstacle) throw new Error(obstacle);
    await server.start_run();
    await this.follow();
  }

  /** Shows a run's progress until it ends. */
  async follow() {
    for (;;) {
      const run = await server.run_state();
      this.show(run);
      if (run.state !== "running") return run.state === "done" ? this.open() : undefined;
      await new Promise((done) => setTimeout(done, patience));
    }
  }

  show({ state, stages, log }) {
    const runs = state === "running";
    this.runs = runs;
    this.show_obstacle();
    by_id("cancel").hidden = !runs;
    by_id("progress").replaceChildren(...(stages ?? []).map((stage) =>
      Object.assign(document.createElement("li"), { className: stage.state, title: `${stage.name}: ${stage.state}` })));
    const current = (stages ?? []).find((stage) => stage.state === "running");
    if (runs) this.say(current ? `${current.name} …` : "Starting …");
    else if (state === "failed") this.say(log || "The run failed.", true);
    else if (state === "cancelled") this.say("Cancelled.");
  }

  async open() {
    const [positions, measured] = await Promise.all([server.compatible_positions(), server.measured().catch(() => null)]);
    this.end_positions = this.app.views[0].turned_from(this.app.views[1], positions);
    by_id("morph-row").hidden = false;
    by_id("progress").replaceChildren();
    by_id("morph").value = 1;
    this.say(measured ? measures_text(measured) : "Done.");
    this.app.views[0].make_room(this.end_positions);
    this.app.show_result(true);
    this.show_morph();
  }

  show_morph() {
    if (!this.end_positions) return;
    const t = Number(by_id("morph").value);
    const [a, b] = [this.start_positions, this.end_positions];
    this.app.views[0].move_vertices(Float32Array.from(a, (value, i) => value + t * (b[i] - value)));
  }

  close() {
    by_id("morph-row").hidden = true;
    if (!this.end_positions) return;
    this.end_positions = null;
    this.app.views[0].move_vertices(this.start_positions);
    this.app.views[0].make_room(null);
    this.app.show_result(false);
    this.say("");
  }
}
