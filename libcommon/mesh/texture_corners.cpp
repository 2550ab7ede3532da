#include "mesh/texture_corners.h"

#include <numeric>

namespace partwise {

SeamVertices split_at_seams(int vertex_count, const Facets& facets, const TextureCorners& texture) {
  SeamVertices split{std::vector<int>(vertex_count), {}, facets};
  std::iota(split.origins.begin(), split.origins.end(), 0);
  split.places.assign(vertex_count, Eigen::Vector2d::Zero());
  std::vector<std::vector<int>> copies(
      vertex_count);  // per vertex: itself once it has a place, and its doubles
  for (std::size_t f = 0; f < facets.size(); ++f) {
    for (int i = 0; i < 3; ++i) {
      const int vertex = facets[f][i];
      const Eigen::Vector2d place = texture.place(static_cast<int>(f), i);
      int found = -1;
      for (const int copy : copies[vertex]) {
        if ((split.places[copy] - place).norm() <= kTextureJump) found = copy;
      }
      if (found < 0 && copies[vertex].empty()) {
        found = vertex;
        split.places[vertex] = place;
        copies[vertex].push_back(vertex);
      } else if (found < 0) {
        found = static_cast<int>(split.origins.size());
        split.origins.push_back(vertex);
        split.places.push_back(place);
        copies[vertex].push_back(found);
      }
      split.facets[f][i] = found;
    }
  }
  return split;
}

}  // namespace partwise
