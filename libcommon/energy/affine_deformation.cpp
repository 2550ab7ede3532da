#include "energy/affine_deformation.h"

#include <algorithm>
#include <array>

namespace partwise {
namespace {

std::vector<std::array<int, 2>> edges_of(const Facets& facets) {
  std::vector<std::array<int, 2>> edges;
  edges.reserve(3 * facets.size());
  for (const Facet& f : facets) {
    for (int i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(f[i], f[(i + 1) % 3]);
      edges.push_back({a, b});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

double mean_length(const Points& points, const std::vector<std::array<int, 2>>& edges) {
  double sum = 0;
  for (const auto& [a, b] : edges) sum += (points[b] - points[a]).norm();
  return sum / static_cast<double>(edges.size());
}

}  // namespace

EnergyTerm affine_deformation_term(const Points& rest, const Facets& facets) {
  const std::vector<std::array<int, 2>> edges = edges_of(facets);
  const double h = mean_length(rest, edges);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(16 * edges.size());
  int row = 0;
  for (const auto& edge : edges) {
    for (int end = 0; end < 2; ++end, ++row) {
      const int i = edge[end], j = edge[1 - end];
      entries.emplace_back(row, 4 * j, 1);
      entries.emplace_back(row, 4 * i, -1);
      for (int k = 0; k < 3; ++k) entries.emplace_back(row, 4 * i + 1 + k, -(rest[j] - rest[i])[k] / h);
    }
    for (int k = 1; k < 4; ++k, ++row) {
      entries.emplace_back(row, 4 * edge[0] + k, 1);
      entries.emplace_back(row, 4 * edge[1] + k, -1);
    }
  }
  EnergyTerm term{{row, static_cast<Eigen::Index>(4 * rest.size())},
                  Eigen::MatrixX3d::Zero(row, 3),
                  Eigen::VectorXd::Ones(row)};
  term.rows.setFromTriplets(entries.begin(), entries.end());
  return term;
}

EnergyTerm affine_rest_term(const Points& rest, const Facets& facets) {
  const double h = mean_length(rest, edges_of(facets));
  std::vector<VertexTarget> columns;
  for (int v = 0; v < static_cast<int>(rest.size()); ++v) {
    for (int k = 0; k < 3; ++k) columns.push_back({4 * v + 1 + k, h * Vec3::Unit(k)});
  }
  return point_term(4 * static_cast<int>(rest.size()), columns);
}

}  // namespace partwise
