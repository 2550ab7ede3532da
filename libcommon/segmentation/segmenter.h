#pragma once

#include <optional>

#include "segmentation/contacts.h"
#include "segmentation/segment_mesh.h"
#include "segmentation/walk_labeller.h"

namespace partwise {

/// segment_mesh for one sketch of the same mesh after another, as while a person draws.
///
/// Keeps what sketches do not change, from when it is first needed: the mesh's components, boundary costs and
/// graphs of facets (see WalkLabeller), and the search tree for points and screen strokes; also the labels of
/// the last sketch, for one that differs by markers and anchors alone. Results are those of segment_mesh,
/// whatever was segmented before. One thread at a time may use it.
class Segmenter {
 public:
  explicit Segmenter(const TriMesh& mesh, const SegmentationOptions& options = {});
  Segmenter(const Segmenter&) = delete;  // the search tree's owner knows where the mesh lies
  Segmenter& operator=(const Segmenter&) = delete;

  const TriMesh& mesh() const { return mesh_; }

  /// Makes what is kept now, so that no sketch waits for it.
  void prepare();

  /// \throws as segment_mesh; the segmenter stays usable
  SegmentedMesh segment(const Sketch& sketch);

 private:
  void make_kept(bool needs_labeller);
  const SeparatedLabels& labels_for(const std::vector<std::string>& names, std::vector<SeedStroke> strokes,
                                    const Seeds& seeds);
  SeparatedLabels label_facets(const std::vector<std::string>& names, const Seeds& seeds);
  SegmentedMesh split(const Sketch& sketch, const std::vector<std::string>& names, const Seeds& seeds,
                      RepairedLabels repaired);
  void require_one_component() const;

  TriMesh mesh_;
  SegmentationOptions options_;
  std::vector<int> components_;  // per facet
  SurfacePlaces places_;
  std::optional<WalkLabeller> labeller_;

  struct Labelled {
    std::vector<std::string> names;
    std::vector<SeedStroke> strokes;
    SeparatedLabels labels;
  };
  std::optional<Labelled> last_;
};

}  // namespace partwise
