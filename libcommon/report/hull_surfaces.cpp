#include "report/hull_surfaces.h"

#include <algorithm>
#include <map>

#include "measure/hull_folds.h"

namespace partwise::report {

using io::Json;

namespace {

constexpr double kLift = 1.02;  // of folded facets, from the hull's centre

// Corners of shown facets: one per part and local vertex.
class Corners {
 public:
  int number(int part, int local) {
    const auto [entry, added] = numbers_.try_emplace({part, local}, static_cast<int>(order_.size()));
    if (added) order_.emplace_back(part, local);
    return entry->second;
  }
  const std::vector<std::pair<int, int>>& order() const { return order_; }

 private:
  std::map<std::pair<int, int>, int> numbers_;
  std::vector<std::pair<int, int>> order_;
};

// Facets over corners, each with the label of its part.
struct LabelledFacets {
  Corners corners;
  Facets facets;
  std::vector<int> labels;
};

void add_shown(LabelledFacets& shown_facets, const ShownModel& shown, const std::vector<Part>& parts) {
  std::vector<int> place(parts.size());  // of the part with an index
  for (std::size_t k = 0; k < parts.size(); ++k) place[parts[k].index] = static_cast<int>(k);
  for (std::size_t i = 0; i < shown.display.facets.size(); ++i) {
    const int label = shown.model->segmentation.labels[shown.display.origin[i]];
    const int k = place[label];
    Facet facet{};
    for (int j = 0; j < 3; ++j) {
      const int vertex = shown.display.vertices[shown.display.facets[i][j]];
      facet[j] = shown_facets.corners.number(k, parts[k].local_vertex(vertex));
    }
    shown_facets.facets.push_back(facet);
    shown_facets.labels.push_back(label);
  }
}

void add_caps(LabelledFacets& shown_facets, const std::vector<Part>& parts) {
  Corners& corners = shown_facets.corners;
  for (int k = 0; k < static_cast<int>(parts.size()); ++k) {
    for (int f = 0; f < parts[k].mesh.facet_count(); ++f) {
      if (!parts[k].is_cap_facet(f)) continue;
      const auto& [a, b, c] = parts[k].mesh.facet(f);
      shown_facets.facets.push_back({corners.number(k, a), corners.number(k, b), corners.number(k, c)});
      shown_facets.labels.push_back(parts[k].index);
    }
  }
}

// Three lifted points for each folded facet.
Points folded_corners(const PartImages& on_hulls, const Frame& frame) {
  Points corners;
  for (std::size_t k = 0; k < on_hulls.parts.size(); ++k) {
    const TriMesh& mesh = on_hulls.parts[k].mesh;
    const Points& images = on_hulls.images[k];
    const Vec3 centre = hull_centre(on_hulls.hulls[k]);
    for (const int f : hull_folds(images, mesh.facets(), centre).folded) {
      for (const int v : mesh.facet(f)) corners.push_back(frame * (centre + kLift * (images[v] - centre)));
    }
  }
  return corners;
}

// Where a local vertex of a part has its pattern; the centre of a cap in the middle of its loop.
Vec3 pattern_at(const Part& part, int local, const Points& pattern) {
  if (!part.is_cap_vertex(local)) return pattern[part.model_vertex[local]];
  const auto cap =
      std::find(part.cap_vertices.begin(), part.cap_vertices.end(), local) - part.cap_vertices.begin();
  Vec3 sum = Vec3::Zero();
  for (const int v : part.loops[cap]) sum += pattern[part.model_vertex[v]];
  return sum / static_cast<double>(part.loops[cap].size());
}

}  // namespace

Json hulls_surface(const std::vector<ConvexHull>& hulls, const std::vector<std::string>& names,
                   const Frame& frame, const PartNumbers& numbers, PageArrays& arrays) {
  Points points;
  Facets facets;
  std::vector<int> labels;
  for (std::size_t k = 0; k < hulls.size(); ++k) {
    const int offset = static_cast<int>(points.size());
    for (const Vec3& p : hulls[k].points) points.push_back(frame * p);
    for (const Facet& f : hulls[k].facets) facets.push_back({f[0] + offset, f[1] + offset, f[2] + offset});
    labels.insert(labels.end(), hulls[k].facets.size(), static_cast<int>(k));
  }
  return {{"family", "hulls"},
          {"flat", true},
          {"positions", arrays.add(points)},
          {"facets", arrays.add(facets)},
          {"parts", arrays.add(numbers.of(names, labels))},
          {"total", facets.size()}};
}

Json images_surface(const ShownModel& shown, const PartImages& on_hulls, const Frame& frame,
                    const PartNumbers& numbers, PageArrays& arrays) {
  LabelledFacets all;
  add_shown(all, shown, on_hulls.parts);
  const std::size_t caps_from = all.facets.size();
  add_caps(all, on_hulls.parts);
  Points positions, pattern;
  for (const auto& [k, v] : all.corners.order()) {
    positions.push_back(frame * on_hulls.images[k][v]);
    if (!shown.pattern.empty()) pattern.push_back(pattern_at(on_hulls.parts[k], v, shown.pattern));
  }
  const Points folded = folded_corners(on_hulls, frame);
  Json surface{{"flat", true},
               {"positions", arrays.add(positions)},
               {"facets", arrays.add(all.facets)},
               {"parts", arrays.add(numbers.of(shown.model->segmentation.names, all.labels))},
               {"total", shown.model->mesh.facet_count()},
               {"caps_from", caps_from},
               {"folds", folded.size() / 3}};
  if (!pattern.empty()) surface["pattern"] = arrays.add(pattern);
  if (!folded.empty()) surface["folded"] = {{"positions", arrays.add(folded)}};
  return surface;
}

}  // namespace partwise::report
