#pragma once

#include <vector>

#include "mesh/tri_mesh.h"
#include "segmentation/facet_hierarchy.h"

namespace partwise {

/// Per edge (OpenMesh index): how strongly the surface bends inwards across it, dimensionless, >= 0.
///
/// Per vertex the curvature tensor T = sum beta |e| e e^T / area, summed over the 1-rings within 0.014 l,
/// with e the unit edge directions and beta the signed dihedral angles (convex positive); an edge of
/// direction u gets max(0, -l u^T T u), T the mean of its ends. Unchanged by similarities: l is the model's
/// diagonal.
std::vector<double> edge_concavity(const TriMesh& mesh);

/// The same field, nearly, for large meshes: sums over the groups of facets of a level with at most 60,000
/// groups whose centroids lie within 0.014 l, then down the levels, each group's tensor averaged with its
/// neighbours'. Takes time proportional to the number of facets, which the exact sums do not.
std::vector<double> edge_concavity(const TriMesh& mesh, const FacetHierarchy& hierarchy);

/// Per edge: what it costs a part boundary to run along it, (|e| / h)(0.1 + 0.9 / (1 + (c / 20)^2)) with the
/// mean edge length h and concavity c: short curves in creases are cheap.
std::vector<double> boundary_costs(const TriMesh& mesh, const std::vector<double>& concavity);

/// Mean edge length, in units of the model.
double mean_edge_length(const TriMesh& mesh);

/// Length of edge `index` (OpenMesh index), in units of the model.
double edge_length(const TriMesh& mesh, int index);

}  // namespace partwise
