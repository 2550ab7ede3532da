#pragma once

#include <string>
#include <vector>

#include "mesh/segmentation.h"
#include "report/display_mesh.h"
#include "report/page_arrays.h"
#include "report/view.h"

namespace partwise::report {

/// From a model's coordinates to those of the page: x to the right, y up, z towards the eye.
using Frame = Eigen::Affine3d;

/// Turns a model, then brings the middle of its bounding box to the origin and its diagonal to 2.
/// \pre points is not empty
Frame centred_frame(const Points& points, const Eigen::Matrix3d& rotation);

/// The rotation after which x is to the right, y up, and z towards the eye.
Eigen::Matrix3d rotation_of(const View& view);

Points moved(const Frame& frame, const Points& points);

/// A model as the page shows it, whatever its state.
struct ShownModel {
  const SegmentedModel* model = nullptr;  ///< none when no document knows it
  Frame frame = Frame::Identity();
  DisplayMesh display;
  Points pattern;  ///< per vertex of the model: the point of the source there, on the page; or empty
  // Places of arrays that all its states share.
  io::Json facets, parts, pattern_array;
};

/// The entries at `indices`, in their order.
template <class T>
std::vector<T> picked(const std::vector<T>& all, const std::vector<int>& indices) {
  std::vector<T> result;
  result.reserve(indices.size());
  for (const int i : indices) result.push_back(all[i]);
  return result;
}

/// Numbers the parts of both models by name: models with the same names have the same numbers.
class PartNumbers {
 public:
  void add(const std::vector<std::string>& names);
  const std::vector<std::string>& names() const { return names_; }

  /// Per entry of `labels`, an index into `names`: the number of the part. \pre all names have been added
  std::vector<std::uint8_t> of(const std::vector<std::string>& names, const std::vector<int>& labels) const;

 private:
  std::vector<std::string> names_;
};

}  // namespace partwise::report
