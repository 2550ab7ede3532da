#include "report/run_surfaces.h"

#include <algorithm>
#include <map>

#include "mapping/alignment.h"
#include "measure/hull_folds.h"
#include "report/display_mesh.h"
#include "report/palette.h"
#include "report/surface_fields.h"
#include "report/view.h"

namespace partwise::report {

using io::Json;

namespace {

constexpr double kLift = 1.02;          // of folded facets, from the hull's centre
constexpr double kUsualShare = 0.99;    // of the values that colour maps span
constexpr double kShownDiagonal = 2.0;  // of every model on the page

using Frame = Eigen::Affine3d;

// A model turned by `rotation`, in the middle of the view.
Frame centred(const Points& points, const Eigen::Matrix3d& rotation) {
  Vec3 low = rotation * points.front();
  Vec3 high = low;
  for (const Vec3& p : points) {
    low = low.cwiseMin(rotation * p);
    high = high.cwiseMax(rotation * p);
  }
  const double diagonal = std::max((high - low).norm(), 1e-300);
  const double scale = kShownDiagonal / diagonal;
  Frame frame = Frame::Identity();
  frame.linear() = scale * rotation;
  frame.translation() = -scale * (low + high) / 2;
  return frame;
}

Eigen::Matrix3d rotation_of(const View& view) {
  Eigen::Matrix3d rotation;
  rotation << view.right.transpose(), view.up.transpose(), view.toward.transpose();
  return rotation;
}

Points moved(const Frame& frame, const Points& points) {
  Points result;
  result.reserve(points.size());
  for (const Vec3& p : points) result.push_back(frame * p);
  return result;
}

template <class T>
std::vector<T> picked(const std::vector<T>& all, const std::vector<int>& indices) {
  std::vector<T> result;
  result.reserve(indices.size());
  for (const int i : indices) result.push_back(all[i]);
  return result;
}

// A model as the page shows it.
struct Shown {
  const SegmentedModel* model = nullptr;
  Frame frame = Frame::Identity();
  DisplayMesh display;
  Points pattern;  // per vertex of the model: the point of the source there, in the source's frame
  Json facets, parts, pattern_array;
};

class Surfaces {
 public:
  Surfaces(const RunDocuments& run, int most, PageArrays& arrays);
  Json page();
  Json thumbnails();

 private:
  void add_bare(const std::string& side, Shown& shown);
  Json part_list() const;
  const CompatibleMesh* best() const;
  void place_models(int most);
  void set_pattern();
  std::vector<std::uint8_t> part_numbers(const std::vector<std::string>& names,
                                         const std::vector<int>& labels) const;
  Json surface_of(const Shown& shown, const std::string& family, const Points& positions);
  void add_model(const std::string& side, Shown& shown, const ModelStages& stages);
  void add_compatible(const std::string& name, const std::optional<CompatibleMesh>& mesh);
  void add_fields(const CompatibleMesh& mesh);
  Json hulls(const std::vector<ConvexHull>& hulls, const std::vector<std::string>& names, const Frame& frame);
  Json images(const Shown& shown, const std::string& family, const std::vector<Part>& parts,
              const std::vector<Points>& images, const std::vector<ConvexHull>& hulls, const Frame& frame);
  Json marks();

  const RunDocuments& run_;
  PageArrays& arrays_;
  Shown source_, target_;
  std::vector<std::string> part_names_;
  Json surfaces_ = Json::object();
};

Surfaces::Surfaces(const RunDocuments& run, int most, PageArrays& arrays) : run_(run), arrays_(arrays) {
  if (run.source.model) source_.model = &*run.source.model;
  if (run.target.model) target_.model = &*run.target.model;
  for (const Shown* shown : {&source_, &target_}) {
    if (!shown->model) continue;
    for (const std::string& name : shown->model->segmentation.names) {
      if (std::find(part_names_.begin(), part_names_.end(), name) == part_names_.end()) {
        part_names_.push_back(name);
      }
    }
  }
  place_models(most);
  set_pattern();
}

const CompatibleMesh* Surfaces::best() const {
  for (const auto* mesh : {&run_.compatible, &run_.critical, &run_.reconstructed}) {
    if (*mesh) return &**mesh;
  }
  return nullptr;
}

void Surfaces::place_models(int most) {
  for (Shown* shown : {&source_, &target_}) {
    if (!shown->model) continue;
    const TriMesh& mesh = shown->model->mesh;
    shown->frame = centred(mesh.points(), rotation_of(automatic_view(mesh.points())));
    shown->display = display_mesh(mesh, shown->model->segmentation.labels, most);
  }
  if (const CompatibleMesh* mesh = best()) {
    MatchedPoints matched;
    for (int v = 0; v < mesh->source.vertex_count(); ++v) {
      matched.add(mesh->source.point(v), target_.frame * mesh->points[v]);
    }
    const Eigen::Matrix3d rotation = fit_similarity(matched, Frame::Identity()).rotation();
    source_.frame = centred(mesh->source.points(), rotation);
  }
}

void Surfaces::set_pattern() {
  if (source_.model) source_.pattern = moved(source_.frame, source_.model->mesh.points());
  const CompatibleMesh* mesh = best();
  if (!mesh || mesh->inverse.empty()) return;
  for (const SurfacePoint& point : mesh->inverse) {
    target_.pattern.push_back(source_.frame * position(mesh->source, point));
  }
}

std::vector<std::uint8_t> Surfaces::part_numbers(const std::vector<std::string>& names,
                                                 const std::vector<int>& labels) const {
  std::vector<std::uint8_t> numbers;
  for (const std::string& name : names) {
    const auto place = std::find(part_names_.begin(), part_names_.end(), name) - part_names_.begin();
    numbers.push_back(static_cast<std::uint8_t>(place));
  }
  return picked(numbers, labels);
}

// Any state of a model that has a position for each of its vertices.
Json Surfaces::surface_of(const Shown& shown, const std::string& family, const Points& positions) {
  Json surface{{"family", family},
               {"positions", arrays_.add(picked(positions, shown.display.vertices))},
               {"facets", shown.facets},
               {"parts", shown.parts},
               {"total", shown.model->mesh.facet_count()}};
  if (!shown.pattern_array.is_null()) surface["pattern"] = shown.pattern_array;
  return surface;
}

void Surfaces::add_bare(const std::string& side, Shown& shown) {
  const Segmentation& segmentation = shown.model->segmentation;
  shown.facets = arrays_.add(shown.display.facets);
  shown.parts =
      arrays_.add(part_numbers(segmentation.names, picked(segmentation.labels, shown.display.origin)));
  surfaces_[side] = surface_of(shown, side, moved(shown.frame, shown.model->mesh.points()));
}

void Surfaces::add_model(const std::string& side, Shown& shown, const ModelStages& stages) {
  const Segmentation& segmentation = shown.model->segmentation;
  if (!shown.pattern.empty()) {
    shown.pattern_array = arrays_.add(picked(shown.pattern, shown.display.vertices));
  }
  add_bare(side, shown);
  if (!stages.hulls.empty()) {
    surfaces_[side + "_hulls"] = hulls(stages.hulls, segmentation.names, shown.frame);
  }
  if (!stages.images.empty()) {
    surfaces_[side + "_hullmap"] =
        images(shown, side, stages.parts, stages.images, stages.hulls, shown.frame);
  }
}

Json Surfaces::hulls(const std::vector<ConvexHull>& hulls, const std::vector<std::string>& names,
                     const Frame& frame) {
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
          {"positions", arrays_.add(points)},
          {"facets", arrays_.add(facets)},
          {"parts", arrays_.add(part_numbers(names, labels))},
          {"total", facets.size()}};
}

// Shown corners of maps onto hulls: one per part and local vertex.
class LocalVertices {
 public:
  int number(int part, int local) {
    const auto [entry, added] = numbers_.try_emplace({part, local}, static_cast<int>(order.size()));
    if (added) order.emplace_back(part, local);
    return entry->second;
  }
  std::vector<std::pair<int, int>> order;

 private:
  std::map<std::pair<int, int>, int> numbers_;
};

// Where a local vertex of a part has its pattern; the centre of a cap in the middle of its loop.
Vec3 pattern_at(const Part& part, int local, const Points& pattern) {
  if (!part.is_cap_vertex(local)) return pattern[part.model_vertex[local]];
  const auto cap =
      std::find(part.cap_vertices.begin(), part.cap_vertices.end(), local) - part.cap_vertices.begin();
  Vec3 sum = Vec3::Zero();
  for (const int v : part.loops[cap]) sum += pattern[part.model_vertex[v]];
  return sum / static_cast<double>(part.loops[cap].size());
}

// A model's parts on hulls: its shown facets in their order, then the caps, then all folded facets.
Json Surfaces::images(const Shown& shown, const std::string& family, const std::vector<Part>& parts,
                      const std::vector<Points>& images, const std::vector<ConvexHull>& hulls,
                      const Frame& frame) {
  const std::vector<int>& labels = shown.model->segmentation.labels;
  std::vector<int> place(parts.size());  // of the part with an index
  for (std::size_t k = 0; k < parts.size(); ++k) place[parts[k].index] = static_cast<int>(k);
  LocalVertices local;
  Facets facets;
  std::vector<int> facet_labels;
  for (std::size_t i = 0; i < shown.display.facets.size(); ++i) {
    const int label = labels[shown.display.origin[i]];
    const int k = place[label];
    Facet corners{};
    for (int j = 0; j < 3; ++j) {
      const int vertex = shown.display.vertices[shown.display.facets[i][j]];
      corners[j] = local.number(k, parts[k].local_vertex(vertex));
    }
    facets.push_back(corners);
    facet_labels.push_back(label);
  }
  const std::size_t caps_from = facets.size();
  Points lifted;
  Facets folded;
  int folds = 0;
  for (int k = 0; k < static_cast<int>(parts.size()); ++k) {
    const Part& part = parts[k];
    for (int f = 0; f < part.mesh.facet_count(); ++f) {
      if (!part.is_cap_facet(f)) continue;
      const Facet& c = part.mesh.facet(f);
      facets.push_back({local.number(k, c[0]), local.number(k, c[1]), local.number(k, c[2])});
      facet_labels.push_back(part.index);
    }
    const Vec3 centre = hull_centre(hulls[k]);
    for (const int f : hull_folds(images[k], part.mesh.facets(), centre).folded) {
      const int first = static_cast<int>(lifted.size());
      for (const int v : part.mesh.facet(f)) {
        lifted.push_back(frame * (centre + kLift * (images[k][v] - centre)));
      }
      folded.push_back({first, first + 1, first + 2});
      ++folds;
    }
  }
  Points positions, pattern;
  for (const auto& [k, v] : local.order) {
    positions.push_back(frame * images[k][v]);
    if (!shown.pattern.empty()) pattern.push_back(pattern_at(parts[k], v, shown.pattern));
  }
  Json surface{{"family", family},
               {"flat", true},
               {"positions", arrays_.add(positions)},
               {"facets", arrays_.add(facets)},
               {"parts", arrays_.add(part_numbers(shown.model->segmentation.names, facet_labels))},
               {"total", shown.model->mesh.facet_count()},
               {"caps_from", caps_from},
               {"folds", folds}};
  if (!pattern.empty()) surface["pattern"] = arrays_.add(pattern);
  if (folds > 0) surface["folded"] = {{"positions", arrays_.add(lifted)}, {"facets", arrays_.add(folded)}};
  return surface;
}

void Surfaces::add_compatible(const std::string& name, const std::optional<CompatibleMesh>& mesh) {
  if (mesh) surfaces_[name] = surface_of(source_, "source", moved(target_.frame, mesh->points));
}

void Surfaces::add_fields(const CompatibleMesh& mesh) {
  const std::vector<float> to_target = distances_to_target(mesh, source_.display.origin);
  const std::vector<float> to_compatible = distances_to_compatible(mesh, target_.display.vertices);
  const FacetDistortion distortion = facet_distortion(mesh, source_.display.origin);
  std::vector<float> distances = to_target;
  distances.insert(distances.end(), to_compatible.begin(), to_compatible.end());
  std::vector<float> changes = distortion.area;
  for (float& change : changes) change = std::abs(change);
  const double distance = quantile(distances, kUsualShare);
  const double change = quantile(changes, kUsualShare);
  const auto field = [&](const std::vector<float>& values, const char* per, double low, double high) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return Json{{"values", arrays_.add(values)},
                {"per", per},
                {"low", low},
                {"high", high},
                {"least", *least},
                {"most", *most}};
  };
  const Json dirichlet = field(distortion.dirichlet, "facet", 4, quantile(distortion.dirichlet, kUsualShare));
  const Json area = field(distortion.area, "facet", -change, change);
  surfaces_["compatible"]["fields"] = {
      {"distance", field(to_target, "facet", 0, distance)}, {"distortion", dirichlet}, {"area", area}};
  surfaces_["source"]["fields"] = {{"distortion", dirichlet}, {"area", area}};
  surfaces_["target"]["fields"] = {{"distance", field(to_compatible, "vertex", 0, distance)}};
}

// Landmarks of both models, and the target's critical points.
Json Surfaces::marks() {
  Json marks{{"markers", Json::array()}, {"critical_points", nullptr}};
  const CompatibleMesh* mesh = best();
  if (!mesh) return marks;
  const auto three = [](const Vec3& p) { return Json{p[0], p[1], p[2]}; };
  for (const MarkerPair& marker : mesh->markers) {
    const Facet& f = mesh->source.facet(marker.source.facet);
    const Vec3& b = marker.source.barycentric;
    const Vec3 carried = b[0] * mesh->points[f[0]] + b[1] * mesh->points[f[1]] + b[2] * mesh->points[f[2]];
    marks["markers"].push_back({{"name", marker.name},
                                {"source", three(source_.frame * position(mesh->source, marker.source))},
                                {"compatible", three(target_.frame * carried)},
                                {"target", three(target_.frame * position(mesh->target, marker.target))}});
  }
  Points critical;
  std::vector<float> curvature;
  for (const CriticalPoint& point : mesh->critical_points) {
    critical.push_back(target_.frame * mesh->target.point(point.vertex));
    curvature.push_back(static_cast<float>(point.curvature));
  }
  if (!critical.empty()) {
    marks["critical_points"] = {{"positions", arrays_.add(critical)}, {"curvature", arrays_.add(curvature)}};
  }
  return marks;
}

Json Surfaces::part_list() const {
  Json parts = Json::array();
  const std::vector<Color> colors = part_colors(part_names_);
  for (std::size_t i = 0; i < part_names_.size(); ++i) {
    parts.push_back({{"name", part_names_[i]}, {"color", colors[i]}});
  }
  return parts;
}

Json Surfaces::thumbnails() {
  if (source_.model) add_bare("source", source_);
  if (target_.model) add_bare("target", target_);
  add_compatible("compatible", run_.compatible);
  return {{"parts", part_list()}, {"surfaces", surfaces_}};
}

Json Surfaces::page() {
  Json page = marks();
  page["parts"] = part_list();
  for (const auto& [side, shown, stages] :
       {std::tuple("source", &source_, &run_.source), {"target", &target_, &run_.target}}) {
    if (!shown->model) continue;
    add_model(side, *shown, *stages);
    page["models"][side] = {{"vertices", shown->model->mesh.vertex_count()},
                            {"facets", shown->model->mesh.facet_count()},
                            {"shown", shown->display.facets.size()},
                            {"diagonal", shown->model->mesh.diagonal()}};
  }
  if (run_.cross_map) {
    const CrossMap& map = *run_.cross_map;
    surfaces_["crossmap"] =
        images(source_, "source", map.source_parts, map.images, map.target.hulled.hulls, target_.frame);
  }
  add_compatible("reconstructed", run_.reconstructed);
  add_compatible("critical", run_.critical);
  add_compatible("compatible", run_.compatible);
  if (run_.compatible) add_fields(*run_.compatible);
  page["surfaces"] = surfaces_;
  return page;
}

}  // namespace

Json run_surfaces(const RunDocuments& run, int most, PageArrays& arrays) {
  return Surfaces(run, most, arrays).page();
}

Json thumbnail_surfaces(const RunDocuments& run, int most, PageArrays& arrays) {
  return Surfaces(run, most, arrays).thumbnails();
}

}  // namespace partwise::report
