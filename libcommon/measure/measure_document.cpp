#include "measure/measure_document.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "measure/certificate_document.h"

namespace partwise {
namespace {

using io::Json;

/// A document under construction whose undefined figures carry their reasons.
class Figures {
 public:
  void set(const std::string& name, Json value) { document_[name] = std::move(value); }

  void undefined(const std::string& name, const std::string& reason) {
    document_[name] = nullptr;
    reasons_[name] = reason;
  }

  Json finished() && {
    if (!reasons_.empty()) document_["undefined"] = reasons_;
    return std::move(document_);
  }

 private:
  Json document_ = Json::object();
  Json reasons_ = Json::object();
};

Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json one_sided(const OneSidedDistance& distance, double diagonal) {
  return {{"rms", distance.rms / diagonal}, {"max", distance.max / diagonal}};
}

void add_distances(const Measurement& m, Figures& figures) {
  const double l = m.target_diagonal;
  figures.set("rms_distance", m.distance.rms / l);
  figures.set("max_distance", m.distance.max / l);
  figures.set("distances", {{"compatible_to_target", one_sided(m.distance.forward, l)},
                            {"target_to_compatible", one_sided(m.distance.backward, l)}});
  figures.set("on_surface_max", m.distance.forward.max_at_vertices / l);
  figures.set("map_gap_max", m.map_gap / l);
}

void add_facets(const Measurement& m, Figures& figures) {
  figures.set("flipped_faces", m.flipped_facets);
  figures.set("degenerate_faces", m.degenerate_facets);
  figures.set("self_intersections", {{"compatible", m.self_intersections.compatible},
                                     {"source", m.self_intersections.source},
                                     {"target", m.self_intersections.target}});
}

void add_distortion(const Measurement& m, Figures& figures) {
  if (m.distortion) {
    figures.set("l2_stretch_efficiency", m.distortion->l2_stretch_efficiency);
    figures.set("symmetric_dirichlet", m.distortion->symmetric_dirichlet);
    figures.set("symmetric_dirichlet_median", m.distortion->symmetric_dirichlet_median);
    figures.set("angle_error_deg", m.distortion->angle_error_degrees);
    figures.set("clamped_faces", m.distortion->clamped_facets);
    return;
  }
  for (const char* name :
       {"l2_stretch_efficiency", "symmetric_dirichlet", "symmetric_dirichlet_median", "angle_error_deg"}) {
    figures.undefined(name, "the source or the compatible mesh has no area");
  }
}

void add_markers(const Measurement& m, Figures& figures) {
  figures.set("markers", m.marker_errors.size());
  if (m.marker_errors.empty()) {
    figures.undefined("marker_error_max", "there are no markers");
    return;
  }
  const auto worst =
      std::max_element(m.marker_errors.begin(), m.marker_errors.end(),
                       [](const MarkerError& a, const MarkerError& b) { return a.error < b.error; });
  figures.set("marker_error_max", worst->error);
  figures.set("marker_worst", worst->name);
  Json errors = Json::object();
  for (const MarkerError& marker : m.marker_errors) errors[marker.name] = marker.error;
  figures.set("marker_errors", errors);
}

void add_stages(const StageFigures& stages, Figures& figures) {
  if (stages.hull_folds) {
    figures.set("hull_folds", {{"total", stages.hull_folds->total},
                               {"parts", stages.hull_folds->parts},
                               {"certified", stages.hull_folds->certified}});
  } else {
    figures.undefined("hull_folds", "the document lacks the folds that map-to-hull and hull-to-hull count");
  }
  if (stages.boundary_gap_max) {
    figures.set("boundary_gap_max", *stages.boundary_gap_max);
  } else {
    figures.undefined("boundary_gap_max", "the document lacks what reconstruct measures");
  }
}

Json truth_figures(const GroundTruthErrors& errors) {
  return {{"vertices", errors.vertices},
          {"unreachable", errors.unreachable},
          {"mean", number_or_null(errors.mean)},
          {"median", number_or_null(errors.median)},
          {"quantile_90", number_or_null(errors.quantile_90)},
          {"quantile_99", number_or_null(errors.quantile_99)},
          {"max", number_or_null(errors.max)},
          {"share_below_05", errors.share_below_05},
          {"share_below_10", errors.share_below_10},
          {"share_below_25", errors.share_below_25}};
}

}  // namespace

Json measure_document(const Measurement& measurement, const StageFigures& stages) {
  Figures figures;
  figures.set("schema", "partwise/measure-1");
  figures.set("source_faces", measurement.source_facets);
  figures.set("target_faces", measurement.target_facets);
  figures.set("parts", measurement.parts);
  add_distances(measurement, figures);
  add_facets(measurement, figures);
  add_distortion(measurement, figures);
  add_markers(measurement, figures);
  add_stages(stages, figures);
  figures.set("one_to_one", measurement.certificate.one_to_one());
  figures.set("certificate", certificate_json(measurement.certificate));
  if (measurement.truth) figures.set("truth", truth_figures(*measurement.truth));
  return std::move(figures).finished();
}

}  // namespace partwise
