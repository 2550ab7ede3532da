#include "measure/sphere_certificate.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <vector>

#include "geometry/orientation.h"

namespace partwise {
namespace {

/// Per directed edge: the facet on its left.
using EdgeFacets = std::map<std::array<int, 2>, int>;

/// Groups that grow together.
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count), count_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  void join(int a, int b) {
    a = find(a);
    b = find(b);
    if (a == b) return;
    parent_[a] = b;
    --count_;
  }
  std::size_t count() const { return count_; }

 private:
  int find(int a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }
  std::vector<int> parent_;
  std::size_t count_;
};

int corner_of(const Facet& facet, int vertex) {
  return static_cast<int>(std::find(facet.begin(), facet.end(), vertex) - facet.begin());
}

/// Says what keeps the facets from being a closed, connected surface without handles; empty when nothing
/// does.
std::string topology_fault(const Facets& facets, std::size_t vertices, int& euler_characteristic) {
  EdgeFacets left;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    for (int i = 0; i < 3; ++i) {
      const std::array<int, 2> edge{facets[f][i], facets[f][(i + 1) % 3]};
      if (!left.try_emplace(edge, static_cast<int>(f)).second) return "an edge has more than two facets";
    }
  }
  // Corners 3 f + i of facets that share an edge at their vertex belong to one fan.
  Groups fans(3 * facets.size()), components(facets.size());
  for (const auto& [edge, f] : left) {
    const auto opposite = left.find({edge[1], edge[0]});
    if (opposite == left.end()) return "it is not closed";
    const int g = opposite->second;
    components.join(f, g);
    for (const int v : edge) fans.join(3 * f + corner_of(facets[f], v), 3 * g + corner_of(facets[g], v));
  }
  euler_characteristic =
      static_cast<int>(vertices) - static_cast<int>(left.size() / 2) + static_cast<int>(facets.size());
  if (fans.count() != vertices) return "its facets touch at a vertex";
  if (components.count() != 1) return "it has several components";
  if (euler_characteristic != 2) {
    return "it has handles (Euler characteristic " + std::to_string(euler_characteristic) +
           "); cut it into parts without";
  }
  return {};
}

/// Facets, all positively oriented, behind the middle of facet `f`; -1 when an edge or vertex lies there.
int facets_behind_middle(const Facets& facets, const Points& directions, std::size_t f) {
  const Vec3 ray = directions[facets[f][0]].stableNormalized() + directions[facets[f][1]].stableNormalized() +
                   directions[facets[f][2]].stableNormalized();
  int count = 0;
  for (const Facet& facet : facets) {
    int least = 1;
    for (int i = 0; i < 3 && least >= 0; ++i) {
      least = std::min(
          least, orientation_sign(Vec3::Zero(), ray, directions[facet[i]], directions[facet[(i + 1) % 3]]));
    }
    if (least == 0) return -1;
    count += least > 0;
  }
  return count;
}

}  // namespace

SphereCertificate certify_sphere(const Facets& facets, const Points& directions) {
  SphereCertificate result;
  result.facets = static_cast<int>(facets.size());
  for (const Facet& f : facets) {
    const int sign = orientation_sign(Vec3::Zero(), directions[f[0]], directions[f[1]], directions[f[2]]);
    result.folds += sign <= 0;
  }
  result.reason = topology_fault(facets, directions.size(), result.euler_characteristic);
  if (!result.reason.empty()) return result;
  if (result.folds > 0) {
    result.reason = std::to_string(result.folds) + " facets are not positively oriented";
    return result;
  }
  int degree = -1;
  for (std::size_t f = 0; f < facets.size() && degree < 0; ++f) {
    degree = facets_behind_middle(facets, directions, f);
  }
  result.degree = degree;
  if (degree != 1) result.reason = "it covers the sphere " + std::to_string(degree) + " times";
  return result;
}

}  // namespace partwise
