// What each stage shows on the left and on the right, and in which colours.

const hull_text = (facts, names) => {
  const folds = names.map((name) => facts.surfaces[name]?.folds ?? 0).reduce((a, b) => a + b, 0);
  return folds === 0 ? "No facet is folded over." : `${folds} folded facets are red.`;
};

/** Stages in the order of the pipeline; `needs` are the surfaces without which there is nothing to see. */
export const stages = [
  {
    id: "models", title: "Source and target", panes: ["source", "target"], color: "plain",
    tools: ["segment (source)", "segment (target)"],
    text: () => "The two meshes as they came. Point at one to see the same place on the other.",
  },
  {
    id: "parts", title: "Parts", panes: ["source", "target"], color: "parts",
    tools: ["segment (source)", "segment (target)"],
    text: () => "The parts that the sketches name; equal colours correspond.",
  },
  {
    id: "hulls", title: "Convex hulls", panes: ["source_hulls", "target_hulls"], color: "parts",
    tools: ["hull (source)", "hull (target)"],
    text: () => "The convex hull around every part.",
  },
  {
    id: "hullmaps", title: "Parts on their hulls", panes: ["source_hullmap", "target_hullmap"], color: "parts",
    tools: ["map-to-hull (source)", "map-to-hull (target)"], folds: true,
    text: (facts) => "Every part mapped onto its own hull; caps over its openings are pale. " +
      hull_text(facts, ["source_hullmap", "target_hullmap"]),
  },
  {
    id: "crossmap", title: "Common domain", panes: ["crossmap", "target_hullmap"], color: "parts",
    tools: ["hull-to-hull", "map-to-hull (target)"], folds: true,
    text: (facts) => "The source's parts mapped onto the target's hulls, beside the target's own. " +
      hull_text(facts, ["crossmap", "target_hullmap"]),
  },
  {
    id: "reconstructed", title: "Reconstructed", panes: ["reconstructed", "target"], color: "parts",
    tools: ["reconstruct", "segment (target)"],
    text: () => "The source's vertices carried down from the hulls to the target's surface.",
  },
  {
    id: "critical", title: "Critical points", panes: ["critical", "target"], color: "plain", critical: true,
    tools: ["critical-points", "critical-points"],
    text: (facts) => facts.critical_points
      ? `${facts.critical_points.curvature.count} features of the target that vertices are pulled to, as dots.`
      : "Features of the target that vertices are pulled to.",
  },
  {
    id: "compatible", title: "Compatible mesh", panes: ["compatible", "target"], color: "plain",
    tools: ["relocate", "segment (target)"],
    text: () => "The result: the source's facets in the target's shape, every vertex on the target's surface.",
  },
  {
    id: "morph", title: "Morph", panes: ["morph", "target"], color: "parts",
    tools: ["relocate", "segment (target)"],
    text: () => "The source turning into the compatible mesh: every vertex moves in a straight line.",
  },
  {
    id: "pattern", title: "Carried pattern", panes: ["source", "target"], color: "pattern",
    tools: ["segment (source)", "relocate"],
    text: (facts) => facts.surfaces.target?.pattern
      ? "A checker pattern of the source, carried by the one-to-one map to the target's own facets."
      : "A checker pattern of the source. Without a certified map it cannot be carried to the target's own facets.",
  },
  {
    id: "distance", title: "Distance", panes: ["compatible", "target"], color: "distance",
    tools: ["relocate", "relocate"],
    text: () => "From the middle of each facet, and from each of the target's vertices, to the other surface.",
  },
  {
    id: "distortion", title: "Distortion", panes: ["source", "compatible"], color: "distortion",
    tools: ["relocate", "relocate"],
    text: () => "How far each facet of the source is from keeping its shape on the compatible mesh.",
  },
];

export const captions = {
  source: "Source", target: "Target", source_hulls: "Source: hulls", target_hulls: "Target: hulls",
  source_hullmap: "Source on its hulls", target_hullmap: "Target on its hulls",
  crossmap: "Source on the target's hulls", reconstructed: "Reconstructed", critical: "Compatible mesh so far",
  compatible: "Compatible mesh", morph: "Morph",
};
