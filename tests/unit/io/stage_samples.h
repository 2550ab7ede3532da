#pragma once

#include "mapping/domains.h"
#include "remeshing/compatible_mesh.h"

/// Small states of every stage, valid as documents but otherwise arbitrary: the geometry means nothing.
namespace partwise::tests {

/// Sphere in three parts that meet at two cross points, with markers, anchors and concavities.
SegmentedModel sample_segmented_model(int n = 4);

/// Upper half of a sphere in two parts: the outside borders both.
SegmentedModel sample_open_model();

HulledModel sample_hulled_model();
HullMap sample_hull_map();

/// The source has the target's parts in another order.
CrossMap sample_cross_map();
CompatibleMesh sample_compatible_mesh();

/// The same without charts, with vertices added to the source in two rounds.
CompatibleMesh sample_refined_mesh();

}  // namespace partwise::tests
