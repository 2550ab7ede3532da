#pragma once

#include <string>
#include <vector>

#include "mapping/domains.h"
#include "remeshing/compatible_mesh.h"
#include "report/view.h"

namespace partwise::report {

/// Red, green, blue, each 0 ... 1.
using Color = std::array<float, 3>;

/// One image of a picture: coloured facets and how to look at them.
struct Panel {
  std::string caption;
  Points points;
  Facets facets;
  std::vector<Color> colors;  ///< one per facet
  View view;
};

/// Panels of the states of the pipeline, seen from automatic_view of their model. Every part has its colour,
/// in bands of two shades along the model's longest extent, which later states carry along: they show where
/// things go. Facets that are folded over are red and stand out a little.
Panel mesh_panel(const TriMesh& mesh);
Panel parts_panel(const SegmentedModel& model);
Panel hulls_panel(const HulledModel& hulled);
Panel hull_map_panel(const HullMap& map);
Panel cross_map_panel(const CrossMap& map);
Panel compatible_panel(const CompatibleMesh& mesh);
Panel source_panel(const CompatibleMesh& mesh);  ///< the source that it was made from
Panel target_panel(const CompatibleMesh& mesh);

}  // namespace partwise::report
