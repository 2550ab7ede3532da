#include "measure/flipped_facets.h"

#include "geometry/normals.h"

namespace partwise {

std::vector<int> flipped_facets(const Points& points, const Facets& facets, const SurfaceMap& map,
                                const TriMesh& target) {
  const Points target_normals = vertex_normals(target.points(), target.facets());
  auto normal_at = [&](const SurfacePoint& image) -> Vec3 {
    const Facet& f = target.facet(image.facet);
    const Vec3 normal = image.barycentric[0] * target_normals[f[0]] +
                        image.barycentric[1] * target_normals[f[1]] +
                        image.barycentric[2] * target_normals[f[2]];
    return normal.stableNormalized();
  };
  const Points normals = facet_normals(points, facets);
  std::vector<int> flipped;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const auto& [a, b, c] = facets[f];
    const Vec3 expected = normal_at(map[a]) + normal_at(map[b]) + normal_at(map[c]);
    if (normals[f].dot(expected) < -1e-12) flipped.push_back(static_cast<int>(f));
  }
  return flipped;
}

}  // namespace partwise
