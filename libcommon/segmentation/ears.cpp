#include "segmentation/ears.h"

#include <vector>

namespace partwise {
namespace {

/// The part that an ear lies in, so to speak: the one across two of its edges, not across all three.
int part_around_ear(const TriMesh& mesh, const std::vector<int>& labels, int facet) {
  std::vector<int> across;
  for (const auto h : mesh.half_edges().fh_range(OpenMesh::FaceHandle(facet))) {
    const auto other = mesh.half_edges().opposite_face_handle(h);
    if (!other.is_valid()) continue;
    if (labels[other.idx()] != labels[facet]) across.push_back(labels[other.idx()]);
  }
  return across.size() == 2 && across[0] == across[1] ? across[0] : kUnseeded;
}

}  // namespace

RepairedLabels remove_ears(const TriMesh& mesh, const Seeds& seeds, RepairedLabels repaired) {
  std::vector<int> waiting(mesh.facet_count());
  for (int f = 0; f < mesh.facet_count(); ++f) waiting[f] = mesh.facet_count() - 1 - f;
  while (!waiting.empty()) {  // every ear given away shortens the boundary, so this ends
    const int f = waiting.back();
    waiting.pop_back();
    const int part = part_around_ear(mesh, repaired.labels, f);
    if (part == kUnseeded || seeds.facet_part[f] == repaired.labels[f]) continue;
    repaired.labels[f] = part;
    ++repaired.changed_facets;
    for (const auto neighbour : mesh.half_edges().ff_range(OpenMesh::FaceHandle(f))) {
      waiting.push_back(neighbour.idx());
    }
  }
  return repaired;
}

}  // namespace partwise
