// From a place on one surface to the same place on another.
//
// States of one model have the same facets, so a facet and barycentric coordinates say it. Between the models: the
// compatible mesh says where the source's facets lie on the target, the target's pattern where its vertices come from.

function nearest_vertex(positions, [x, y, z]) {
  let best = -1;
  let least = Infinity;
  for (let i = 0; i < positions.length; i += 3) {
    const d = (positions[i] - x) ** 2 + (positions[i + 1] - y) ** 2 + (positions[i + 2] - z) ** 2;
    if (d < least) {
      least = d;
      best = i / 3;
    }
  }
  return best;
}

/** Position on `state`, a surface with the facets of `model`, of the model's vertex nearest to a point. */
function on_state(state, model, point) {
  const vertex = nearest_vertex(model.positions, point);
  const corner = model.facets.indexOf(vertex);
  if (corner < 0) return null;
  const there = 3 * state.facets[corner];
  return Array.from(state.positions.subarray(there, there + 3));
}

function blended(values, facets, facet, barycentric) {
  return [0, 1, 2].map((c) =>
    barycentric.reduce((sum, weight, j) => sum + weight * values[3 * facets[3 * facet + j] + c], 0));
}

/**
 * The point of surface `to` that corresponds to a place on `from`; null where none is known.
 * @param surfaces all surfaces by name
 */
export function counterpart(surfaces, from, to, facet, barycentric) {
  if (!from || !to || facet >= from.linked_facets) return null;
  if (from.family === "hulls" || to.family === "hulls") return null;
  if (from.family === to.family) return to.point(facet, barycentric);
  if (from.family === "source") {
    const landed = surfaces.compatible ?? surfaces.critical ?? surfaces.reconstructed;
    if (!landed) return null;
    const point = landed.point(facet, barycentric);
    return to === surfaces.target ? point : on_state(to, surfaces.target, point);
  }
  const pattern = surfaces.target.pattern;
  if (!pattern) return null;
  const point = blended(pattern, surfaces.target.facets, facet, barycentric);
  return to === surfaces.source ? point : on_state(to, surfaces.source, point);
}
