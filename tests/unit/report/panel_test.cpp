#include "report/panel.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "builders.h"
#include "report/palette.h"

namespace partwise::report {
namespace {

// A capsule cut in two at z = 0.
SegmentedModel two_parts(const std::vector<std::string>& names) {
  const TriMesh mesh = tests::capsule(4, 12, 10);
  std::vector<int> labels;
  for (const Facet& f : mesh.facets()) {
    labels.push_back(mesh.point(f[0]).z() + mesh.point(f[1]).z() + mesh.point(f[2]).z() > 0 ? 1 : 0);
  }
  SegmentedModel model{mesh, trace_boundaries(mesh, names, labels), {}, {}, {}};
  return model;
}

// The parts "mapped" onto themselves; enough of a hull to have a centre.
HullMap identity_map(const SegmentedModel& model) {
  HullMap map{{model, {}, {}}, {}};
  for (int k = 0; k < model.segmentation.part_count(); ++k) {
    const Part part = extract_part(model, k);
    map.hulled.hulls.push_back({part.mesh.points(), part.mesh.facets(), {}});
    map.images.push_back(part.mesh.points());
    map.hulled.parts.push_back(part);
  }
  return map;
}

int red_facets(const Panel& panel) {
  return static_cast<int>(std::count(panel.colors.begin(), panel.colors.end(), kFolded));
}

TEST(Panel, PartsOfOneNameHaveOneColor) {
  const Panel a = parts_panel(two_parts({"head", "tail"}));
  const Panel b = parts_panel(two_parts({"tail", "head"}));
  ASSERT_EQ(a.colors.size(), b.colors.size());
  const std::vector<int> labels = two_parts({"head", "tail"}).segmentation.labels;
  const auto of_part = [&](const Panel& panel, int label) {
    std::vector<Color> colors;
    for (std::size_t f = 0; f < labels.size(); ++f) {
      if (labels[f] == label) colors.push_back(panel.colors[f]);
    }
    std::sort(colors.begin(), colors.end());
    colors.erase(std::unique(colors.begin(), colors.end()), colors.end());
    return colors;
  };
  EXPECT_EQ(of_part(a, 0), of_part(b, 1));
  EXPECT_EQ(of_part(a, 0).size(), 2U);  // two bands
  EXPECT_NE(of_part(a, 0), of_part(a, 1));
}

TEST(Panel, ShowsFoldedFacetsOnceMoreInRed) {
  HullMap map = identity_map(two_parts({"head", "tail"}));
  EXPECT_EQ(red_facets(hull_map_panel(map)), 0);
  EXPECT_EQ(hull_map_panel(map).caption, "on the hulls: 0 folds");

  // Pushing a vertex through to the other side turns the facets around it.
  const Part& part = map.hulled.parts[0];
  const int vertex = 5;
  map.images[0][vertex] += 6 * (part.mesh.point(vertex) - part.mesh.point(part.cap_vertices[0])).cwiseAbs();
  const int folds = red_facets(hull_map_panel(map));
  EXPECT_GT(folds, 0);
  EXPECT_EQ(hull_map_panel(map).facets.size(),
            map.hulled.parts[0].mesh.facets().size() + map.hulled.parts[1].mesh.facets().size() + folds);
}

TEST(Panel, HullsAndMeshesShowAllFacets) {
  const HullMap map = identity_map(two_parts({"head", "tail"}));
  const Panel hulls = hulls_panel(map.hulled);
  EXPECT_EQ(hulls.facets.size(), map.hulled.hulls[0].facets.size() + map.hulled.hulls[1].facets.size());
  EXPECT_EQ(hulls.colors.size(), hulls.facets.size());
  EXPECT_EQ(hulls.caption, "2 convex hulls");
  EXPECT_EQ(mesh_panel(map.hulled.model.mesh).facets.size(), map.hulled.model.mesh.facets().size());
}

}  // namespace
}  // namespace partwise::report
