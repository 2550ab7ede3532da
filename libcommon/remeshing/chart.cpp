#include "remeshing/chart.h"

#include <algorithm>
#include <string>
#include <utility>

#include "error.h"

namespace partwise {

std::vector<bool> facets_of(const Chart& chart, const std::vector<int>& labels) {
  std::vector<bool> inside;
  inside.reserve(labels.size());
  for (const int label : labels) {
    inside.push_back(std::binary_search(chart.parts.begin(), chart.parts.end(), label));
  }
  return inside;
}

ChartTarget::ChartTarget(const TriMesh& target, const std::vector<int>& labels, const Chart& chart)
    : piece_(extract_piece(target, facets_of(chart, labels))),
      directions_(chart.directions),
      inside_(facets_of(chart, labels)),
      target_(&target),
      loop_places_(piece_.mesh.vertex_count(), LoopPlace{0, -1}) {
  if (static_cast<int>(directions_.size()) != piece_.mesh.vertex_count()) {
    throw InputError("a chart has " + std::to_string(directions_.size()) + " directions for " +
                     std::to_string(piece_.mesh.vertex_count()) + " vertices of its parts and caps");
  }
  for (std::size_t i = 0; i < piece_.loops.size(); ++i) {
    for (std::size_t k = 0; k < piece_.loops[i].size(); ++k) {
      loop_places_[piece_.loops[i][k]] = {static_cast<int>(i), static_cast<double>(k)};
    }
  }
}

std::optional<Vec3> ChartTarget::direction(const SurfacePoint& point) const {
  const Facet& f = target_->facet(point.facet);
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    if (point.barycentric[i] == 0) continue;
    const int local = piece_.local_vertex(f[i]);
    if (local < 0) return std::nullopt;
    sum += point.barycentric[i] * directions_[local];
  }
  if (!inside_[point.facet] && !on_loop(point)) return std::nullopt;
  return sum;
}

std::optional<ChartTarget::LoopPlace> ChartTarget::on_loop(const SurfacePoint& point) const {
  const Facet& f = target_->facet(point.facet);
  std::vector<std::pair<LoopPlace, double>> ends;
  for (int i = 0; i < 3; ++i) {
    if (point.barycentric[i] == 0) continue;
    const int local = piece_.local_vertex(f[i]);
    if (local < 0 || loop_places_[local].position < 0) return std::nullopt;
    ends.emplace_back(loop_places_[local], point.barycentric[i]);
  }
  if (ends.size() == 1) return ends[0].first;
  if (ends.size() != 2 || ends[0].first.loop != ends[1].first.loop) return std::nullopt;
  const auto n = static_cast<double>(piece_.loops[ends[0].first.loop].size());
  for (int i = 0; i < 2; ++i) {
    const auto& [from, weight_from] = ends[i];
    const auto& [to, weight_to] = ends[1 - i];
    const bool is_next = to.position == from.position + 1 || (to.position == 0 && from.position == n - 1);
    if (is_next) return LoopPlace{from.loop, from.position + weight_to};
  }
  return std::nullopt;
}

}  // namespace partwise
