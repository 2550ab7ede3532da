// The server that this page came from. All paths are relative to the page's own address.

async function answered(response) {
  if (response.ok) return response;
  const { error } = await response.json().catch(() => ({}));
  throw new Error(error ?? `the server answered ${response.status} ${response.statusText}`);
}

async function get(path) {
  return answered(await fetch(path, { cache: "no-store" }));
}

async function send(method, path, body) {
  const headers = { "Content-Type": "application/json" };
  return answered(await fetch(path, { method, headers, body: JSON.stringify(body) }));
}

const json = async (response) => (await response).json();

export const models = () => json(get("models"));
export const saved_sketch = (model) => json(get(`models/${model}/sketch`));
export const last_result = (model) => json(get(`models/${model}/result`));

/** Which parts are far from convex, and where to cut them: {concave, proposed_cuts}. Takes longer than a stroke. */
export const hints = (model) => json(get(`models/${model}/hints`));

/** How symmetric a model is: {error, problem}. */
export const symmetry = (model) => json(get(`models/${model}/mirror`));

/** The mirror image of a place of a model: {face, barycentric}, or {} when that is the place itself. */
export const mirrored = (model, place) => json(send("POST", `models/${model}/mirror`, place));

export const check = () => json(get("check"));

/** Saves a sketch, and answers with what it makes of the model. */
export const save_sketch = (model, sketch) => json(send("PUT", `models/${model}/sketch`, sketch));

/** Positions (3 per vertex, in the page's frame) and facets (3 vertices each) of a model. */
export async function mesh({ vertices, facets }, model) {
  const bytes = await (await get(`models/${model}/mesh`)).arrayBuffer();
  return {
    positions: new Float32Array(bytes, 0, 3 * vertices),
    facets: new Uint32Array(bytes, 12 * vertices, 3 * facets),
  };
}

export const start_run = () => send("POST", "run", {});
export const run_state = () => json(get("run"));
export const cancel_run = () => send("DELETE", "run", {});
export const measured = () => json(get("run/measure"));

/** Positions of the compatible mesh, in the frame of the second model. */
export async function compatible_positions() {
  return new Float32Array(await (await get("run/mesh")).arrayBuffer());
}
