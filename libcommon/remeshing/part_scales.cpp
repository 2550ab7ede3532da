#include "remeshing/part_scales.h"

#include <cmath>

#include "geometry/normals.h"

namespace partwise {

std::vector<double> part_scales(const CompatibleMesh& mesh) {
  std::vector<double> source(mesh.part_names.size(), 0.0), target(mesh.part_names.size(), 0.0);
  const std::vector<double> source_areas = facet_areas(mesh.source.points(), mesh.source.facets());
  const std::vector<double> target_areas = facet_areas(mesh.target.points(), mesh.target.facets());
  for (std::size_t f = 0; f < source_areas.size(); ++f) source[mesh.source_labels[f]] += source_areas[f];
  for (std::size_t f = 0; f < target_areas.size(); ++f) target[mesh.target_labels[f]] += target_areas[f];
  std::vector<double> scales;
  for (const int part : mesh.source_labels) {
    scales.push_back(source[part] > 0 ? std::sqrt(target[part] / source[part]) : 1);
  }
  return scales;
}

}  // namespace partwise
