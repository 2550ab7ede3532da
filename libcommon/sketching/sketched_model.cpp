#include "sketching/sketched_model.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <tuple>
#include <utility>

#include "error.h"
#include "io/pending_file.h"
#include "io/sketch.h"
#include "report/page_arrays.h"
#include "segmentation/compatibility.h"
#include "segmentation/concavity.h"
#include "segmentation/cut_proposals.h"
#include "segmentation/surface_places.h"

namespace partwise::sketching {
namespace {

using io::Json;

constexpr int kDeepest = 64;  // levels of JSON; the schema's own are 6

SegmentationOptions live_options() {
  SegmentationOptions options;
  options.propose_anchors = true;
  options.measure_concavity = false;  // no stroke is to wait for it: see hints()
  return options;
}

Vec3 box_center(const Points& points) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : points) box.extend(p);
  return box.center();
}

/// What of a sketch can be cut: parts that have strokes, and anchors between those.
Sketch drawn(const Sketch& sketch) {
  Sketch result = sketch;
  std::set<std::string> names;
  std::erase_if(result.parts, [](const SketchedPart& part) { return part.strokes.empty(); });
  for (const SketchedPart& part : result.parts) names.insert(part.name);
  std::erase_if(result.anchors, [&](const SketchedAnchor& anchor) {
    return !names.contains(anchor.between[0]) || !names.contains(anchor.between[1]);
  });
  return result;
}

Json names_of(const Segmentation& segmentation, int left, int right) {
  const auto name = [&](int part) { return part == kOutside ? Json() : Json(segmentation.names[part]); };
  return {name(left), name(right)};
}

Json curve_facts(const Segmentation& segmentation) {
  Json curves = Json::array();
  for (const BoundaryCurve& curve : segmentation.curves) {
    curves.push_back({{"parts", names_of(segmentation, curve.left, curve.right)},
                      {"closed", curve.closed},
                      {"vertices", curve.vertices}});
  }
  return curves;
}

Json part_facts(const SegmentedModel& model) {
  std::vector<int> facets(model.segmentation.part_count(), 0);
  for (const int label : model.segmentation.labels) ++facets[label];
  Json parts = Json::array();
  for (int k = 0; k < model.segmentation.part_count(); ++k) {
    parts.push_back({{"name", model.segmentation.names[k]}, {"facets", facets[k]}});
  }
  return parts;
}

Json marker_facts(const std::vector<Marker>& markers) {
  Json facts = Json::array();
  for (const auto& [name, point] : markers) {
    const Vec3& b = point.barycentric;
    facts.push_back({{"name", name}, {"face", point.facet}, {"barycentric", {b[0], b[1], b[2]}}});
  }
  return facts;
}

Json anchor_facts(const SegmentedModel& model, bool proposed) {
  Json facts = Json::array();
  for (const Anchor& anchor : model.anchors) {
    if (anchor.proposed != proposed) continue;
    facts.push_back({{"name", anchor.name},
                     {"between", names_of(model.segmentation, anchor.part_a, anchor.part_b)},
                     {"vertex", anchor.vertex}});
  }
  return facts;
}

/// One octet per facet: parts are few (InputError beyond 255).
std::string label_octets(const Segmentation& segmentation) {
  if (segmentation.part_count() > 255) throw InputError("at most 255 parts can be shown; draw fewer");
  std::string octets;
  octets.reserve(segmentation.labels.size());
  for (const int label : segmentation.labels) octets.push_back(static_cast<char>(label));
  return octets;
}

Json facts_of(const SegmentedMesh& segmented) {
  const SegmentedModel& model = segmented.model;
  return {{"labels", report::base64(label_octets(model.segmentation))},
          {"parts", part_facts(model)},
          {"curves", curve_facts(model.segmentation)},
          {"markers", marker_facts(model.markers)},
          {"anchors", anchor_facts(model, false)},
          {"proposed_anchors", anchor_facts(model, true)},
          {"warnings", segmented.warnings}};
}

Json empty_sketch() {
  return {{"schema", "partwise/sketch-1"},
          {"parts", Json::array()},
          {"markers", Json::array()},
          {"anchors", Json::array()}};
}

// Bounds the depth, too: whatever walks deeply nested JSON needs as deep a stack.
Json parsed(const std::string& text) {
  const auto check_depth = [](int depth, Json::parse_event_t, const Json&) {
    if (depth > kDeepest) throw InputError("the document is nested too deeply to be a sketch");
    return true;
  };
  try {
    return Json::parse(text, check_depth);
  } catch (const Json::parse_error& error) {
    throw InputError(std::string("this is not JSON: ") + error.what());
  }
}

// A link would be replaced by the file.
std::string file_behind(std::string path) {
  std::error_code error;
  return std::filesystem::is_symlink(path, error) ? std::filesystem::weakly_canonical(path).string() : path;
}

template <class Number>
void append(std::string& octets, Number value) {
  const std::size_t at = octets.size();
  octets.resize(at + sizeof value);
  std::memcpy(octets.data() + at, &value, sizeof value);
}

}  // namespace

SketchedModel::SketchedModel(std::string mesh_path, const TriMesh& mesh, std::string sketch_path)
    : name_(std::filesystem::path(mesh_path).stem().string()),
      mesh_path_(std::move(mesh_path)),
      sketch_path_(file_behind(std::move(sketch_path))),
      center_(box_center(mesh.points())),
      diagonal_(mesh.diagonal()),
      segmenter_(mesh, live_options()),
      sketch_(empty_sketch()) {
  Sketch sketch;
  if (has_saved_sketch()) {
    sketch = io::read_sketch(sketch_path_);
    try {
      require_drawn_for(mesh, sketch);
    } catch (const InputError& error) {
      throw InputError(sketch_path_ + ": " + error.what());
    }
    std::ifstream in(sketch_path_, std::ios::binary);
    sketch_ = Json::parse(in);
    for (const char* list : {"parts", "markers", "anchors"}) {
      if (!sketch_.contains(list)) sketch_[list] = Json::array();
    }
  }
  segmenter_.prepare();
  segment(sketch);
}

bool SketchedModel::has_saved_sketch() const {
  return std::filesystem::exists(sketch_path_);
}

io::Json SketchedModel::facts() const {
  const TriMesh& mesh = segmenter_.mesh();
  const auto file = [](const std::string& path) { return std::filesystem::path(path).filename().string(); };
  return {{"name", name_},
          {"file", file(mesh_path_)},
          {"vertices", mesh.vertex_count()},
          {"facets", mesh.facet_count()},
          {"center", {center_[0], center_[1], center_[2]}},
          {"diagonal", diagonal_},
          {"sketch", file(sketch_path_)}};
}

std::string SketchedModel::normalized(const Points& points) const {
  std::string octets;
  octets.reserve(points.size() * 3 * sizeof(float));
  for (const Vec3& point : points) {
    const Vec3 p = (point - center_) / diagonal_;
    for (int i = 0; i < 3; ++i) append(octets, static_cast<float>(p[i]));
  }
  return octets;
}

std::string SketchedModel::geometry() const {
  std::string octets = normalized(segmenter_.mesh().points());
  for (const Facet& facet : segmenter_.mesh().facets()) {
    for (const int v : facet) append(octets, static_cast<std::uint32_t>(v));
  }
  return octets;
}

void SketchedModel::put(const std::string& text) {
  Json document = parsed(text);
  if (document.is_object()) {
    document["mesh"] = {{"vertices", segmenter_.mesh().vertex_count()},
                        {"faces", segmenter_.mesh().facet_count()}};
  }
  const Sketch sketch = io::parse_sketch(document);
  save(document);
  sketch_ = std::move(document);
  segment(sketch);
}

void SketchedModel::save(const io::Json& document) {
  if (!changed_ && has_saved_sketch()) {
    std::error_code error;
    std::filesystem::copy_file(sketch_path_, sketch_path_ + "~",
                               std::filesystem::copy_options::overwrite_existing, error);
    if (error) throw IoError(sketch_path_ + "~: cannot keep the sketch as it was: " + error.message());
  }
  io::write_file(sketch_path_, true, [&](std::ostream& out) { out << document.dump(1) << '\n'; });
  changed_ = true;
}

void SketchedModel::segment(const Sketch& sketch) {
  const auto start = std::chrono::steady_clock::now();
  try {
    SegmentedMesh segmented = segmenter_.segment(drawn(sketch));
    result_ = facts_of(segmented);
    segmented_ = std::make_shared<const SegmentedModel>(std::move(segmented.model));
  } catch (const Error& error) {
    result_ = facts_of_strokes(sketch);
    result_["problem"] = error.what();
    segmented_.reset();
  }
  result_["seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

const Mirror& SketchedModel::mirror() {
  std::call_once(mirror_made_, [&] { mirror_ = std::make_unique<const Mirror>(segmenter_.mesh()); });
  return *mirror_;
}

io::Json SketchedModel::mirrored(const std::string& place) {
  Json marker = parsed(place);
  if (!marker.is_object()) throw InputError("a place must be an object");
  marker["name"] = "marker";
  const Sketch sketch =
      io::parse_sketch(Json{{"schema", "partwise/sketch-1"}, {"markers", Json::array({marker})}});
  SurfacePlaces places(segmenter_.mesh(), SegmentationOptions().snap_limit);
  const auto image = mirror().image(places.locate(sketch.markers[0].place, "marker"));
  if (!image) return Json::object();
  const Vec3& b = image->barycentric;
  return {{"face", image->facet}, {"barycentric", {b[0], b[1], b[2]}}};
}

// What the strokes make of the mesh when it is a marker or an anchor that does not fit.
io::Json SketchedModel::facts_of_strokes(const Sketch& sketch) {
  if (sketch.markers.empty() && sketch.anchors.empty()) return Json::object();
  Sketch strokes = drawn(sketch);
  strokes.markers.clear();
  strokes.anchors.clear();
  try {
    return facts_of(segmenter_.segment(strokes));
  } catch (const Error&) {
    return Json::object();
  }
}

io::Json hints(const SegmentedModel& model) {
  const double tau = SegmentationOptions().tau;
  const auto& [names, labels] = std::tie(model.segmentation.names, model.segmentation.labels);
  const std::vector<Concavity> concavity =
      measure_concavity(model.mesh, labels, static_cast<int>(names.size()));
  Json concave = Json::array(), cuts = Json::array();
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto& [largest, mean, vertex] = concavity[k];
    if (largest > tau) concave.push_back({{"part", names[k]}, {"concavity", largest}, {"deepest", vertex}});
  }
  for (const CutProposal& proposal : propose_cuts(model.mesh, model.segmentation, concavity, tau)) {
    Json curves = Json::array();
    for (const BoundaryCurve& curve : proposal.curves) {
      curves.push_back({{"closed", curve.closed}, {"vertices", curve.vertices}});
    }
    cuts.push_back({{"part", names[proposal.part]}, {"curves", curves}});
  }
  return {{"concave", concave}, {"proposed_cuts", cuts}};
}

io::Json compare(const SketchedModel& a, const SketchedModel& b) {
  for (const SketchedModel* model : {&a, &b}) {
    if (!model->segmented()) {
      return {{"problem", model->name() + ": " + model->result().at("problem").get<std::string>()}};
    }
  }
  return {{"differences", compare_segmentations(*a.segmented(), *b.segmented())},
          {"misplaced", misplaced_markers(*a.segmented(), *b.segmented())}};
}

}  // namespace partwise::sketching
