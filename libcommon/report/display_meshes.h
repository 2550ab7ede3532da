#pragma once

#include <map>
#include <string>
#include <vector>

#include "report/display_mesh.h"

namespace partwise::report {

/// The display meshes of models that come again and again, as those of a batch do in all their pairs: each is
/// decimated once.
class DisplayMeshes {
 public:
  /// \param most facets of each, see display_mesh \pre 0 < most
  explicit DisplayMeshes(int most) : most_(most) {}

  /// display_mesh(mesh, labels, most); stays where it is as long as this lives.
  const DisplayMesh& of(const TriMesh& mesh, const std::vector<int>& labels);

  /// Number of different models so far.
  std::size_t size() const { return known_.size(); }

 private:
  int most_;
  std::map<std::string, DisplayMesh> known_;  // by the digest of vertices, facets and labels
};

}  // namespace partwise::report
