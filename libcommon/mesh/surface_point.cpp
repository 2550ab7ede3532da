#include "mesh/surface_point.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "error.h"

namespace partwise {

std::optional<int> vertex_at(const TriMesh& mesh, const SurfacePoint& point) {
  int corner = 0;
  if (point.barycentric.maxCoeff(&corner) < 1 - 1e-12) return {};
  return mesh.facet(point.facet)[corner];
}

SurfacePoint vertex_point(const TriMesh& mesh, int vertex) {
  int facet = mesh.facet_count();
  for (const OpenMesh::FaceHandle f : mesh.half_edges().vf_range(OpenMesh::VertexHandle(vertex))) {
    facet = std::min(facet, f.idx());
  }
  SurfacePoint point{facet, Vec3::Zero()};
  const Facet& corners = mesh.facet(facet);
  point.barycentric[std::find(corners.begin(), corners.end(), vertex) - corners.begin()] = 1;
  return point;
}

SurfaceMap::SurfaceMap(const TriMesh& source, const TriMesh& target, std::vector<SurfacePoint> images)
    : target_key_(target.key()), images_(std::move(images)) {
  if (static_cast<int>(images_.size()) != source.vertex_count()) {
    throw InputError("the map has " + std::to_string(images_.size()) + " images, the source " +
                     std::to_string(source.vertex_count()) + " vertices");
  }
  for (std::size_t v = 0; v < images_.size(); ++v) {
    const SurfacePoint& image = images_[v];
    const bool fits = image.facet >= 0 && image.facet < target.facet_count() &&
                      image.barycentric.minCoeff() >= -1e-12 && std::abs(image.barycentric.sum() - 1) <= 1e-9;
    if (!fits) {
      throw InputError("the image of source vertex " + std::to_string(v) +
                       " is no point of the target: facet " + std::to_string(image.facet) + " of " +
                       std::to_string(target.facet_count()));
    }
  }
}

Points SurfaceMap::positions(const TriMesh& target) const {
  if (target.key() != target_key_) throw InputError("this map leads to another mesh than the one given");
  Points result;
  result.reserve(images_.size());
  for (const SurfacePoint& image : images_) result.push_back(position(target, image));
  return result;
}

}  // namespace partwise
