#include "remeshing/coverage_gaps.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>

#include "geometry/normals.h"
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

std::vector<double> distances(const Points& queries, const SurfaceIndex& surface) {
  std::vector<double> result(queries.size());
  tbb::parallel_for(std::size_t{0}, queries.size(),
                    [&](std::size_t i) { result[i] = surface.closest(queries[i]).distance; });
  return result;
}

Points measured_places(const Points& points, const Facets& facets) {
  constexpr int least = 20'000;
  constexpr std::uint64_t seed = 7;
  Points places = points;
  const Points spread =
      sample_surface(points, facets, std::max(least, static_cast<int>(facets.size())), seed);
  places.insert(places.end(), spread.begin(), spread.end());
  return places;
}

}  // namespace

CoverageGaps::CoverageGaps(const TriMesh& target)
    : target_(target), index_(target), places_(measured_places(target.points(), target.facets())) {
  for (const double facet : facet_areas(target.points(), target.facets())) area_ += facet;
}

std::vector<CoverageGap> CoverageGaps::wider_than(double least, const CompatibleMesh& mesh) const {
  const SurfaceIndex surface(mesh.points, mesh.source.facets());
  std::vector<CoverageGap> gaps;
  const std::vector<double> from_target = distances(places_, surface);
  const double area = area_ / static_cast<double>(places_.size());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (from_target[i] <= least) continue;
    gaps.push_back(
        {from_target[i], surface.closest(places_[i]).point, index_.closest(places_[i]).point, area});
  }
  if (!gaps.empty()) {
    const Preimages preimages(mesh);
    tbb::parallel_for(std::size_t{0}, gaps.size(), [&](std::size_t i) {
      if (const auto place = preimages.of(gaps[i].goal)) gaps[i].place = *place;
    });
  }
  Points of_mesh = measured_places(mesh.points, mesh.source.facets());
  for (const auto e : mesh.source.half_edges().edges()) {  // where the mesh cuts over a valley
    of_mesh.emplace_back((mesh.points[e.v0().idx()] + mesh.points[e.v1().idx()]) / 2);
  }
  const std::vector<double> from_mesh = distances(of_mesh, index_);
  for (std::size_t i = 0; i < of_mesh.size(); ++i) {
    if (from_mesh[i] <= least) continue;
    gaps.push_back({from_mesh[i], surface.closest(of_mesh[i]).point, index_.closest(of_mesh[i]).point,
                    area_ / static_cast<double>(of_mesh.size())});
  }
  std::stable_sort(gaps.begin(), gaps.end(),
                   [](const CoverageGap& a, const CoverageGap& b) { return a.distance > b.distance; });
  return gaps;
}

}  // namespace partwise
