#include "measure/certificate.h"

#include <algorithm>
#include <cmath>

#include "error.h"
#include "geometry/convex_hull.h"
#include "remeshing/chart_source.h"

namespace partwise {
namespace {

/// How far a boundary vertex may be from its place on the hull, over the hull's diagonal: rounding.
constexpr double kGap = 1e-9;

SphereCertificate certify_around(const Points& images, const Facets& facets, const Vec3& centre) {
  Points directions;
  for (const Vec3& image : images) directions.push_back(image - centre);
  return certify_sphere(facets, directions);
}

/// Along a loop of the source's side: it stops at every vertex of one of the target's loops, one after the
/// other, and goes around once.
std::string loop_fault(const std::vector<int>& loop, const ChartSource& source, const RefinedSource& refined,
                       const ChartTarget& target) {
  std::vector<ChartTarget::LoopPlace> places;
  for (const int local : loop) {
    const int v = source.piece.model_vertex[local];
    const auto place = target.on_loop(refined.images[v]);
    if (!place || (!places.empty() && place->loop != places[0].loop)) {
      return "vertex " + std::to_string(v) + " of the boundary is not on the target's";
    }
    places.push_back(*place);
  }
  const auto n = static_cast<double>(target.piece().loops[places[0].loop].size());
  int turns = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double here = places[i].position, next = places[(i + 1) % places.size()].position;
    const double end = next < here ? next + n : next;
    turns += next < here;
    if (end == here || end > std::floor(here) + 1) {
      return "the boundary leaves the target's after vertex " +
             std::to_string(source.piece.model_vertex[loop[i]]);
    }
  }
  return turns == 1 ? "" : "the boundary passes the target's " + std::to_string(turns) + " times";
}

std::string joined_names(const std::vector<int>& parts, const std::vector<std::string>& names) {
  std::string joined;
  for (const int part : parts) joined += (joined.empty() ? "" : " + ") + names.at(part);
  return joined;
}

PieceCertificate certify_chart(const CompatibleMesh& mesh, const RefinedSource& refined, const Chart& chart) {
  PieceCertificate piece;
  piece.name = joined_names(chart.parts, mesh.part_names);
  try {
    const ChartTarget target(mesh.target, mesh.target_labels, chart);
    piece.target = certify_sphere(target.piece().mesh.facets(), target.directions());
    const ChartSource source = lay_out(refined, facets_of(chart, refined.labels), target);
    piece.source = certify_sphere(source.piece.mesh.facets(), source.directions);
    for (const std::vector<int>& loop : source.piece.loops) {
      if (piece.boundary.empty()) piece.boundary = loop_fault(loop, source, refined, target);
    }
  } catch (const InputError& error) {
    piece.boundary = error.what();
  }
  return piece;
}

/// Parts that belong to no chart or to several, of those with facets.
std::string partition_fault(const CompatibleMesh& mesh) {
  if (mesh.charts.empty())
    return "the map is not laid out on charts without a fold; see the stages' warnings";
  std::vector<int> charts(mesh.part_names.size(), 0);
  for (const Chart& chart : mesh.charts) {
    for (const int part : chart.parts) ++charts[part];
  }
  for (std::size_t k = 0; k < charts.size(); ++k) {
    if (charts[k] != 1) {
      return "part '" + mesh.part_names[k] + "' is in " + std::to_string(charts[k]) + " charts";
    }
  }
  return {};
}

/// The largest distance of a boundary vertex of the part to its place, over the hull's diagonal.
std::string boundary_fault(const CrossMap& map, std::size_t k) {
  const Part &source = map.source_parts[k], &target = map.target.hulled.parts[k];
  const double near = kGap * bounding_box_diagonal(map.target.hulled.hulls[k].points);
  const Vec3 centre = hull_centre(map.target.hulled.hulls[k]);
  const Points& images = map.target.images[k];
  for (const BoundaryPlacement& place : map.boundary) {
    const int v = source.local_vertex(place.source_vertex);
    if (v < 0) continue;
    const int a = target.local_vertex(place.target_a), b = target.local_vertex(place.target_b);
    const std::string where = "source vertex " + std::to_string(place.source_vertex);
    if (a < 0 || b < 0) return where + " lies on another part's boundary";
    const Vec3 wanted = (1 - place.fraction) * images[a] + place.fraction * images[b] - centre;
    const Vec3 there = map.images[k][v] - centre;
    if (wanted.normalized().cross(there).norm() > near) return where + " is off its place on the boundary";
  }
  return {};
}

}  // namespace

std::string PieceCertificate::reason() const {
  if (!target.one_to_one()) return "on the target, " + target.reason;
  if (!boundary.empty()) return boundary;
  return source.reason;
}

bool Certificate::one_to_one() const {
  return reason.empty() && std::all_of(pieces.begin(), pieces.end(),
                                       [](const PieceCertificate& piece) { return piece.one_to_one(); });
}

std::string Certificate::first_reason() const {
  if (!reason.empty()) return reason;
  for (const PieceCertificate& piece : pieces) {
    if (!piece.one_to_one()) return piece.name + ": " + piece.reason();
  }
  return {};
}

Certificate certify(const CompatibleMesh& mesh) {
  Certificate certificate{{}, partition_fault(mesh)};
  if (mesh.charts.empty()) return certificate;
  try {
    const RefinedSource refined = refine_source(mesh);
    for (const Chart& chart : mesh.charts) certificate.pieces.push_back(certify_chart(mesh, refined, chart));
  } catch (const InputError& error) {
    certificate.reason = error.what();
  }
  return certificate;
}

Certificate certify(const HullMap& map) {
  Certificate certificate;
  for (std::size_t k = 0; k < map.images.size(); ++k) {
    const SphereCertificate side =
        certify_around(map.images[k], map.hulled.parts[k].mesh.facets(), hull_centre(map.hulled.hulls[k]));
    certificate.pieces.push_back({map.hulled.model.segmentation.names[k], side, side, {}});
  }
  return certificate;
}

Certificate certify(const CrossMap& map) {
  Certificate certificate = certify(map.target);
  for (std::size_t k = 0; k < map.images.size(); ++k) {
    certificate.pieces[k].source = certify_around(map.images[k], map.source_parts[k].mesh.facets(),
                                                  hull_centre(map.target.hulled.hulls[k]));
    certificate.pieces[k].boundary = boundary_fault(map, k);
  }
  return certificate;
}

}  // namespace partwise
