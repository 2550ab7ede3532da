#include "remeshing/coverage_gaps.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>

#include "geometry/normals.h"
#include "measure/surface_distance.h"
#include "measure/surface_samples.h"
#include "remeshing/chart_source.h"
#include "remeshing/locate.h"

namespace partwise {
namespace {

/// The points of the source that the map takes to points of the target.
class Preimages {
 public:
  explicit Preimages(const CompatibleMesh& mesh) : mesh_(mesh), refined_(refine_source(mesh)) {
    for (const Chart& chart : mesh.charts) {
      targets_.emplace_back(mesh.target, mesh.target_labels, chart);
      sides_.push_back(lay_out(refined_, facets_of(chart, refined_.labels), targets_.back()));
    }
    for (const ChartSource& side : sides_) locators_.emplace_back(side.piece, side.directions, Vec3::Zero());
  }

  /// \return none without charts
  std::optional<SurfacePoint> of(const SurfacePoint& target_point) const {
    for (std::size_t k = 0; k < targets_.size(); ++k) {
      if (!targets_[k].is_inside(target_point.facet)) continue;
      const auto direction = targets_[k].direction(target_point);
      if (!direction) return std::nullopt;
      const SurfacePoint found = locators_[k].locate(*direction).front();
      return refined_.split.on_original(mesh_.source, locators_[k].on_model(found));
    }
    return std::nullopt;
  }

 private:
  const CompatibleMesh& mesh_;
  RefinedSource refined_;
  std::vector<ChartTarget> targets_;
  std::vector<ChartSource> sides_;
  std::vector<DomainLocator> locators_;
};

/// Vertices and points spread over the surface.
Points places_to_look_at(const Points& points, const Facets& facets, int spread, std::uint64_t seed) {
  Points places = points;
  const Points samples = sample_surface(points, facets, spread, seed);
  places.insert(places.end(), samples.begin(), samples.end());
  return places;
}

/// Those of the places from which no point of the surface is within `distance`, ascending.
std::vector<std::size_t> farther_than(double distance, const Points& places, const SurfaceIndex& surface) {
  std::vector<char> is_far(places.size());
  tbb::parallel_for(std::size_t{0}, places.size(),
                    [&](std::size_t i) { is_far[i] = !surface.has_within(distance, places[i]); });
  std::vector<std::size_t> far;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (is_far[i]) far.push_back(i);
  }
  return far;
}

}  // namespace

CoverageSampling as_measured() {
  const SurfaceDistanceOptions measure;
  return {measure.samples, false, measure.seed, measure.seed + 1};
}

CoverageGaps::CoverageGaps(const TriMesh& target, const CoverageSampling& sampling)
    : target_(target), sampling_(sampling), index_(target) {
  for (const double facet : facet_areas(target.points(), target.facets())) area_ += facet;
  places_ =
      places_to_look_at(target.points(), target.facets(), spread_on(target.facets()), sampling.target_seed);
}

int CoverageGaps::spread_on(const Facets& facets) const {
  return sampling_.at_least_facets ? std::max(sampling_.points, static_cast<int>(facets.size()))
                                   : sampling_.points;
}

std::vector<CoverageGap> CoverageGaps::wider_than(double least, const CompatibleMesh& mesh) const {
  const Facets& facets = mesh.source.facets();
  const SurfaceIndex surface(mesh.points, facets);
  std::vector<CoverageGap> gaps;
  const double area = area_ / static_cast<double>(places_.size());
  for (const std::size_t i : farther_than(least, places_, surface)) {
    const SurfaceHit hit = surface.closest(places_[i]);
    gaps.push_back({hit.distance, hit.point, index_.closest(places_[i]).point, area});
  }
  if (!gaps.empty()) {
    const Preimages preimages(mesh);
    tbb::parallel_for(std::size_t{0}, gaps.size(), [&](std::size_t i) {
      if (const auto place = preimages.of(gaps[i].goal)) gaps[i].place = *place;
    });
  }
  Points of_mesh = places_to_look_at(mesh.points, facets, spread_on(facets), sampling_.mesh_seed);
  for (const auto e : mesh.source.half_edges().edges()) {  // where the mesh cuts over a valley
    of_mesh.emplace_back((mesh.points[e.v0().idx()] + mesh.points[e.v1().idx()]) / 2);
  }
  const double mesh_area = area_ / static_cast<double>(of_mesh.size());
  for (const std::size_t i : farther_than(least, of_mesh, index_)) {
    const SurfaceHit hit = index_.closest(of_mesh[i]);
    gaps.push_back({hit.distance, surface.closest(of_mesh[i]).point, hit.point, mesh_area});
  }
  std::stable_sort(gaps.begin(), gaps.end(),
                   [](const CoverageGap& a, const CoverageGap& b) { return a.distance > b.distance; });
  return gaps;
}

}  // namespace partwise
