#include "report/display_meshes.h"

#include "io/sha256.h"

namespace partwise::report {

namespace {

template <class T>
void update(io::Sha256& digest, const std::vector<T>& rows) {
  digest.update(reinterpret_cast<const char*>(rows.data()), rows.size() * sizeof(T));
}

std::string digest_of(const TriMesh& mesh, const std::vector<int>& labels) {
  io::Sha256 digest;
  update(digest, mesh.points());
  update(digest, mesh.facets());
  update(digest, labels);
  return digest.hex();
}

}  // namespace

const DisplayMesh& DisplayMeshes::of(const TriMesh& mesh, const std::vector<int>& labels) {
  const auto [place, is_new] = known_.try_emplace(digest_of(mesh, labels));
  if (is_new) place->second = display_mesh(mesh, labels, most_);
  return place->second;
}

}  // namespace partwise::report
