#include "deform/facet_correspondence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "mapping/parallel_parts.h"

namespace partwise {
namespace {

constexpr int kFacetsAtOnce = 256;

/// Centroids of the facets of one part on its hull, caps left out.
struct HullFacets {
  std::vector<int> facets;  // of the model
  Points centroids;

  HullFacets(const Part& part, const Points& images) {
    for (int local = 0; local < part.mesh.facet_count(); ++local) {
      if (part.is_cap_facet(local)) continue;
      const auto& [a, b, c] = part.mesh.facet(local);
      facets.push_back(part.model_facet[local]);
      centroids.push_back((images[a] + images[b] + images[c]) / 3);
    }
  }
};

/// Points in the cells of a grid; finds those near a place.
class PointGrid {
 public:
  PointGrid(const Points& points, double cell) : points_(points), cell_(cell) {
    for (std::size_t i = 0; i < points.size(); ++i) cells_[key(points[i])].push_back(static_cast<int>(i));
  }

  /// Ascending indices of the points within the size of a cell.
  std::vector<int> within_cell_size(const Vec3& place) const {
    std::vector<int> found;
    const auto [x, y, z] = key(place);
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dz = -1; dz <= 1; ++dz) {
          const auto cell = cells_.find({x + dx, y + dy, z + dz});
          if (cell == cells_.end()) continue;
          for (const int i : cell->second) {
            if ((points_[i] - place).norm() <= cell_) found.push_back(i);
          }
        }
      }
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  int nearest(const Vec3& place) const {
    int best = 0;
    for (std::size_t i = 1; i < points_.size(); ++i) {
      if ((points_[i] - place).squaredNorm() < (points_[best] - place).squaredNorm()) {
        best = static_cast<int>(i);
      }
    }
    return best;
  }

 private:
  using Key = std::tuple<long, long, long>;
  Key key(const Vec3& place) const {
    return {static_cast<long>(std::floor(place.x() / cell_)),
            static_cast<long>(std::floor(place.y() / cell_)),
            static_cast<long>(std::floor(place.z() / cell_))};
  }

  const Points& points_;
  double cell_;
  std::map<Key, std::vector<int>> cells_;
};

}  // namespace

std::vector<Vec3> facet_samples() {
  // Centroids of the nine triangles that a facet is cut into by thirds.
  std::vector<Vec3> samples;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; i + j < 3; ++j) {
      samples.emplace_back((3 * i + 1) / 9.0, (3 * j + 1) / 9.0, (3 * (2 - i - j) + 1) / 9.0);
      if (i + j < 2) samples.emplace_back((3 * i + 2) / 9.0, (3 * j + 2) / 9.0, (3 * (1 - i - j) + 2) / 9.0);
    }
  }
  return samples;
}

std::vector<std::vector<SurfacePoint>> sample_origins(const CompatibleMesh& mesh, const TwoWayMap& map,
                                                      Direction direction) {
  const bool to_target = direction == Direction::to_target;
  const int count = to_target ? mesh.target.facet_count() : mesh.source.facet_count();
  const std::vector<Vec3> samples = facet_samples();
  std::vector<std::vector<SurfacePoint>> origins(count);
  for_each_part((count + kFacetsAtOnce - 1) / kFacetsAtOnce, [&](int block) {
    for (int f = block * kFacetsAtOnce; f < std::min(count, (block + 1) * kFacetsAtOnce); ++f) {
      for (const Vec3& sample : samples) {
        const SurfacePoint point{f, sample};
        origins[f].push_back(to_target ? map.to_source(point) : map.to_target(point));
      }
    }
  });
  return origins;
}

FacetCorrespondence exact_correspondence(const std::vector<std::vector<SurfacePoint>>& sample_origins) {
  FacetCorrespondence correspondence;
  for (const std::vector<SurfacePoint>& origins : sample_origins) {
    std::map<int, double> shares;
    for (const SurfacePoint& origin : origins)
      shares[origin.facet] += 1.0 / static_cast<double>(origins.size());
    std::vector<FacetShare>& list = correspondence.emplace_back();
    for (const auto& [facet, share] : shares) list.push_back({facet, share});
  }
  return correspondence;
}

FacetCorrespondence hull_correspondence(const CrossMap& map, double threshold, Direction direction) {
  const bool to_target = direction == Direction::to_target;
  const TriMesh& receiver = to_target ? map.target.hulled.model.mesh : map.source.mesh;
  FacetCorrespondence correspondence(receiver.facet_count());
  for_each_part(static_cast<int>(map.source_parts.size()), [&](int k) {
    const HullFacets source(map.source_parts[k], map.images[k]);
    const HullFacets target(map.target.hulled.parts[k], map.target.images[k]);
    const HullFacets &giving = to_target ? source : target, &receiving = to_target ? target : source;
    const double reach = threshold * bounding_box_diagonal(map.target.images[k]);
    const PointGrid grid(giving.centroids, std::max(reach, std::numeric_limits<double>::min()));
    for (std::size_t i = 0; i < receiving.facets.size(); ++i) {
      std::vector<int> near = grid.within_cell_size(receiving.centroids[i]);
      if (near.empty()) near = {grid.nearest(receiving.centroids[i])};
      std::vector<FacetShare>& list = correspondence[receiving.facets[i]];
      for (const int j : near) list.push_back({giving.facets[j], 1.0 / static_cast<double>(near.size())});
    }
  });
  return correspondence;
}

}  // namespace partwise
