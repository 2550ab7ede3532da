#include "remeshing/compatible_mesh.h"

namespace partwise {

CompatibleMesh with_images(const CompatibleMesh& mesh, const std::vector<SurfacePoint>& images) {
  CompatibleMesh result = mesh;
  result.map = SurfaceMap(mesh.source, mesh.target, images);
  result.points = result.map.positions(mesh.target);
  return result;
}

}  // namespace partwise
