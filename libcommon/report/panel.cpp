#include "report/panel.h"

#include "geometry/convex_hull.h"
#include "measure/hull_folds.h"
#include "report/palette.h"

namespace partwise::report {

namespace {

constexpr float kLighterBand = 0.4F;
constexpr float kLighterCap = 0.75F;
constexpr double kLift = 1.02;  // of folded facets, from the hull's centre

Color banded(const Color& color, int band) {
  return lighten(color, band == 0 ? 0.0F : kLighterBand);
}

std::string count(int number, const std::string& thing) {
  return std::to_string(number) + " " + thing + (number == 1 ? "" : "s");
}

void append(Panel& panel, const Points& points, const Facets& facets, const std::vector<Color>& colors) {
  const int offset = static_cast<int>(panel.points.size());
  panel.points.insert(panel.points.end(), points.begin(), points.end());
  for (const Facet& f : facets) {
    panel.facets.push_back({f[0] + offset, f[1] + offset, f[2] + offset});
  }
  panel.colors.insert(panel.colors.end(), colors.begin(), colors.end());
}

// The images of one part on `hull`; folded facets once more in red, lifted. Returns how many are folded.
int append_images(Panel& panel, const Part& part, const Points& images, const ConvexHull& hull,
                  const std::vector<int>& band, const Color& color) {
  std::vector<Color> colors;
  for (const int f : part.model_facet) {
    colors.push_back(f < 0 ? lighten(color, kLighterCap) : banded(color, band[f]));
  }
  append(panel, images, part.mesh.facets(), colors);
  const Vec3 centre = hull_centre(hull);
  Points lifted = images;
  for (Vec3& p : lifted) {
    p = centre + kLift * (p - centre);
  }
  Facets folded;
  for (const int f : hull_folds(images, part.mesh.facets(), centre).folded) {
    folded.push_back(part.mesh.facet(f));
  }
  append(panel, lifted, folded, std::vector<Color>(folded.size(), kFolded));
  return static_cast<int>(folded.size());
}

// The facets of `mesh` over `points`, coloured by part in bands along the mesh.
Panel labelled(const Points& points, const TriMesh& mesh, const std::vector<int>& labels,
               const std::vector<std::string>& names) {
  Panel panel;
  panel.view = automatic_view(points);
  const std::vector<Color> of_part = part_colors(names);
  const std::vector<int> band = bands(mesh);
  std::vector<Color> colors(mesh.facet_count());
  for (int f = 0; f < mesh.facet_count(); ++f) {
    colors[f] = banded(of_part[labels[f]], band[f]);
  }
  append(panel, points, mesh.facets(), colors);
  return panel;
}

}  // namespace

Panel mesh_panel(const TriMesh& mesh) {
  Panel panel;
  panel.caption = count(mesh.facet_count(), "facet");
  panel.view = automatic_view(mesh.points());
  append(panel, mesh.points(), mesh.facets(), std::vector<Color>(mesh.facet_count(), kPlain));
  return panel;
}

Panel parts_panel(const SegmentedModel& model) {
  const Segmentation& parts = model.segmentation;
  Panel panel = labelled(model.mesh.points(), model.mesh, parts.labels, parts.names);
  panel.caption = count(parts.part_count(), "part");
  return panel;
}

Panel hulls_panel(const HulledModel& hulled) {
  Panel panel;
  panel.caption = count(static_cast<int>(hulled.hulls.size()), "convex hull");
  panel.view = automatic_view(hulled.model.mesh.points());
  const std::vector<Color> of_part = part_colors(hulled.model.segmentation.names);
  for (std::size_t k = 0; k < hulled.hulls.size(); ++k) {
    const ConvexHull& hull = hulled.hulls[k];
    append(panel, hull.points, hull.facets, std::vector<Color>(hull.facets.size(), of_part[k]));
  }
  return panel;
}

Panel hull_map_panel(const HullMap& map) {
  Panel panel;
  panel.view = automatic_view(map.hulled.model.mesh.points());
  const std::vector<Color> of_part = part_colors(map.hulled.model.segmentation.names);
  const std::vector<int> band = bands(map.hulled.model.mesh);
  int folds = 0;
  for (std::size_t k = 0; k < map.images.size(); ++k) {
    folds += append_images(panel, map.hulled.parts[k], map.images[k], map.hulled.hulls[k], band, of_part[k]);
  }
  panel.caption = "on the hulls: " + count(folds, "fold");
  return panel;
}

Panel cross_map_panel(const CrossMap& map) {
  Panel panel;
  panel.view = automatic_view(map.target.hulled.model.mesh.points());
  const std::vector<Color> of_part = part_colors(map.source.segmentation.names);
  const std::vector<int> band = bands(map.source.mesh);
  int folds = 0;
  for (std::size_t k = 0; k < map.images.size(); ++k) {
    const Part& part = map.source_parts[k];
    folds += append_images(panel, part, map.images[k], map.target.hulled.hulls[k], band, of_part[part.index]);
  }
  panel.caption = "source on the target's hulls: " + count(folds, "fold");
  return panel;
}

Panel compatible_panel(const CompatibleMesh& mesh) {
  Panel panel = labelled(mesh.points, mesh.source, mesh.source_labels, mesh.part_names);
  panel.caption = "compatible mesh";
  panel.view = automatic_view(mesh.target.points());
  return panel;
}

Panel source_panel(const CompatibleMesh& mesh) {
  Panel panel = labelled(mesh.source.points(), mesh.source, mesh.source_labels, mesh.part_names);
  panel.caption = "source";
  return panel;
}

Panel target_panel(const CompatibleMesh& mesh) {
  Panel panel = labelled(mesh.target.points(), mesh.target, mesh.target_labels, mesh.part_names);
  panel.caption = "target";
  return panel;
}

}  // namespace partwise::report
