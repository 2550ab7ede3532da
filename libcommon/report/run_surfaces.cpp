#include "report/run_surfaces.h"

#include <algorithm>
#include <cmath>

#include "mapping/alignment.h"
#include "report/hull_surfaces.h"
#include "report/palette.h"
#include "report/shown_model.h"
#include "report/surface_fields.h"

namespace partwise::report {

using io::Json;

namespace {

constexpr double kUsualShare = 0.99;  // of the values that colour maps span

class Surfaces {
 public:
  Surfaces(const RunDocuments& run, DisplayMeshes& displays, PageArrays& arrays);
  Json page();
  Json thumbnails();

 private:
  void add_bare(const std::string& side, ShownModel& shown);
  Json part_list() const;
  const CompatibleMesh* best() const;
  void place_models(DisplayMeshes& displays);
  void set_pattern();
  Json surface_of(const ShownModel& shown, const std::string& family, const Points& positions);
  void add_model(const std::string& side, ShownModel& shown, const ModelStages& stages);
  void add_compatible(const std::string& name, const std::optional<CompatibleMesh>& mesh);
  void add_fields(const CompatibleMesh& mesh);
  Json marks();

  const RunDocuments& run_;
  PageArrays& arrays_;
  ShownModel source_, target_;
  PartNumbers numbers_;
  Json surfaces_ = Json::object();
};

Surfaces::Surfaces(const RunDocuments& run, DisplayMeshes& displays, PageArrays& arrays)
    : run_(run), arrays_(arrays) {
  if (run.source.model) source_.model = &*run.source.model;
  if (run.target.model) target_.model = &*run.target.model;
  for (const ShownModel* shown : {&source_, &target_}) {
    if (shown->model) numbers_.add(shown->model->segmentation.names);
  }
  place_models(displays);
  set_pattern();
}

const CompatibleMesh* Surfaces::best() const {
  for (const auto* mesh : {&run_.compatible, &run_.critical, &run_.reconstructed}) {
    if (*mesh) return &**mesh;
  }
  return nullptr;
}

void Surfaces::place_models(DisplayMeshes& displays) {
  for (ShownModel* shown : {&source_, &target_}) {
    if (!shown->model) continue;
    const TriMesh& mesh = shown->model->mesh;
    shown->frame = centred_frame(mesh.points(), rotation_of(automatic_view(mesh.points())));
    shown->display = displays.of(mesh, shown->model->segmentation.labels);
  }
  if (const CompatibleMesh* mesh = best()) {
    MatchedPoints matched;
    for (int v = 0; v < mesh->source.vertex_count(); ++v) {
      matched.add(mesh->source.point(v), target_.frame * mesh->points[v]);
    }
    const Eigen::Matrix3d rotation = fit_similarity(matched, Frame::Identity()).rotation();
    source_.frame = centred_frame(mesh->source.points(), rotation);
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

// Any state of a model that has a position for each of its vertices.
Json Surfaces::surface_of(const ShownModel& shown, const std::string& family, const Points& positions) {
  Json surface{{"family", family},
               {"positions", arrays_.add(picked(positions, shown.display.vertices))},
               {"facets", shown.facets},
               {"parts", shown.parts},
               {"total", shown.model->mesh.facet_count()}};
  if (!shown.pattern_array.is_null()) surface["pattern"] = shown.pattern_array;
  return surface;
}

void Surfaces::add_bare(const std::string& side, ShownModel& shown) {
  const Segmentation& segmentation = shown.model->segmentation;
  shown.facets = arrays_.add(shown.display.facets);
  shown.parts =
      arrays_.add(numbers_.of(segmentation.names, picked(segmentation.labels, shown.display.origin)));
  surfaces_[side] = surface_of(shown, side, moved(shown.frame, shown.model->mesh.points()));
}

void Surfaces::add_model(const std::string& side, ShownModel& shown, const ModelStages& stages) {
  const Segmentation& segmentation = shown.model->segmentation;
  if (!shown.pattern.empty()) {
    shown.pattern_array = arrays_.add(picked(shown.pattern, shown.display.vertices));
  }
  add_bare(side, shown);
  if (!stages.hulls.empty()) {
    surfaces_[side + "_hulls"] =
        hulls_surface(stages.hulls, segmentation.names, shown.frame, numbers_, arrays_);
  }
  if (!stages.images.empty()) {
    Json& surface = surfaces_[side + "_hullmap"];
    surface =
        images_surface(shown, {stages.parts, stages.images, stages.hulls}, shown.frame, numbers_, arrays_);
    surface["family"] = side;
  }
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
  const std::vector<Color> colors = part_colors(numbers_.names());
  for (std::size_t i = 0; i < numbers_.names().size(); ++i) {
    parts.push_back({{"name", numbers_.names()[i]}, {"color", colors[i]}});
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
    Json& surface = surfaces_["crossmap"];
    surface = images_surface(source_, {map.source_parts, map.images, map.target.hulled.hulls}, target_.frame,
                             numbers_, arrays_);
    surface["family"] = "source";
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
  DisplayMeshes displays(most);
  return Surfaces(run, displays, arrays).page();
}

Json thumbnail_surfaces(const RunDocuments& run, DisplayMeshes& displays, PageArrays& arrays) {
  return Surfaces(run, displays, arrays).thumbnails();
}

}  // namespace partwise::report
