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
 * A state is {parts: names, sketches: one per model}. Parts that a sketch read from a file does not name have no stroke
 * there; what is written names them all, in the order of the list, so that no part is lost before it is drawn.
 */
export function state_of(sketches) {
  return { parts: part_names(sketches), sketches };
}

/** A sketch's entries for these parts, in this order. */
function all_parts(sketch, names) {
  const named = new Map((sketch.parts ?? []).map((part) => [part.name, part]));
  return names.map((name) => named.get(name) ?? { name, strokes: [] });
}

function with_sketch(state, model, changes) {
  return { ...state, sketches: state.sketches.map((sketch, i) => (i === model ? { ...sketch, ...changes } : sketch)) };
}

export function add_part(state, name) {
  const parts = [...state.parts, name];
  return { parts, sketches: state.sketches.map((sketch) => ({ ...sketch, parts: all_parts(sketch, parts) })) };
}

export function strokes_of(state, model, part) {
  return (state.sketches[model].parts ?? []).find(({ name }) => name === part)?.strokes ?? [];
}

function with_strokes(state, model, part, strokes) {
  const parts = all_parts(state.sketches[model], state.parts);
  return with_sketch(state, model, { parts: parts.map((entry) => (entry.name === part ? { ...entry, strokes } : entry)) });
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
