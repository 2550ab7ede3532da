// What the user says of the models: one list of parts for all of them, and for each model a sketch (partwise/sketch-1).
// States are never changed in place, so that history can keep them whole.

/** Names of the parts, in the order of their first appearance in the sketches. */
export function part_names(sketches) {
  return [...new Set(sketches.flatMap((sketch) => (sketch.parts ?? []).map(({ name }) => name)))];
}

/** A name that is not taken yet: "part 3". */
export function free_name(kind, taken) {
  let number = taken.length + 1;
  while (taken.includes(`${kind} ${number}`)) ++number;
  return `${kind} ${number}`;
}

/**
 * A state is {parts: names, sketches: one per model}. Parts that a sketch does not name are parts without a stroke
 * there; the order of a sketch's parts is that of the list.
 */
export function state_of(sketches) {
  return { parts: part_names(sketches), sketches };
}

function with_sketch(state, model, changes) {
  return { ...state, sketches: state.sketches.map((sketch, i) => (i === model ? { ...sketch, ...changes } : sketch)) };
}

export function add_part(state, name) {
  return { ...state, parts: [...state.parts, name] };
}

export function strokes_of(state, model, part) {
  return (state.sketches[model].parts ?? []).find(({ name }) => name === part)?.strokes ?? [];
}

function with_strokes(state, model, part, strokes) {
  const old = state.sketches[model].parts ?? [];
  const entry = { ...(old.find(({ name }) => name === part) ?? { name: part }), strokes };
  const named = new Map(old.map((other) => [other.name, other])).set(part, entry);
  const parts = state.parts.map((name) => named.get(name)).filter((other) => other?.strokes?.length > 0);
  return with_sketch(state, model, { parts });
}

export function add_stroke(state, model, part, stroke) {
  return with_strokes(state, model, part, [...strokes_of(state, model, part), stroke]);
}

/** Leaves out these strokes, given as the objects that the state holds. */
export function erase_strokes(state, model, erased) {
  return state.parts.reduce((next, part) => {
    const strokes = strokes_of(next, model, part);
    const kept = strokes.filter((stroke) => !erased.has(stroke));
    return kept.length < strokes.length ? with_strokes(next, model, part, kept) : next;
  }, state);
}

/** Applies `change` to the sketches that name a part, and leaves the others the objects that they are. */
function where_named(state, part, change) {
  return state.sketches.map((sketch) => {
    const named = (sketch.parts ?? []).some(({ name }) => name === part) ||
      (sketch.anchors ?? []).some(({ between }) => between.includes(part));
    return named ? { ...sketch, ...change(sketch.parts ?? [], sketch.anchors ?? []) } : sketch;
  });
}

export function rename_part(state, from, to) {
  const renamed = (name) => (name === from ? to : name);
  return {
    parts: state.parts.map(renamed),
    sketches: where_named(state, from, (parts, anchors) => ({
      parts: parts.map((part) => ({ ...part, name: renamed(part.name) })),
      anchors: anchors.map((anchor) => ({ ...anchor, between: anchor.between.map(renamed) })),
    })),
  };
}

export function delete_part(state, gone) {
  return {
    parts: state.parts.filter((name) => name !== gone),
    sketches: where_named(state, gone, (parts, anchors) => ({
      parts: parts.filter(({ name }) => name !== gone),
      anchors: anchors.filter(({ between }) => !between.includes(gone)),
    })),
  };
}

/** Names of a kind ("markers" or "anchors") over all models. */
export function names_of(state, kind) {
  return [...new Set(state.sketches.flatMap((sketch) => (sketch[kind] ?? []).map(({ name }) => name)))];
}

/** Sets the entry of that name, or moves it. */
export function place(state, model, kind, entry) {
  const old = state.sketches[model][kind] ?? [];
  const known = old.some(({ name }) => name === entry.name);
  return with_sketch(state, model, {
    [kind]: known ? old.map((other) => (other.name === entry.name ? entry : other)) : [...old, entry],
  });
}

export function rename(state, kind, from, to) {
  return {
    ...state,
    sketches: state.sketches.map((sketch) => ({
      ...sketch,
      [kind]: (sketch[kind] ?? []).map((entry) => (entry.name === from ? { ...entry, name: to } : entry)),
    })),
  };
}

/** Deletes the entries of that name on all models. */
export function remove(state, kind, gone) {
  return {
    ...state,
    sketches: state.sketches.map((sketch) => ({
      ...sketch,
      [kind]: (sketch[kind] ?? []).filter(({ name }) => name !== gone),
    })),
  };
}
