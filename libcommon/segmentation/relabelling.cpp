#include "segmentation/relabelling.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_set>
#include <utility>

#include "geometry/normals.h"
#include "segmentation/crease_field.h"
#include "segmentation/label_topology.h"

namespace partwise {
namespace {

constexpr std::size_t kLargestCrumb = 64;  // facets that may be cut off and go along with a move
constexpr double kSeedCost = 10;           // of a seeded facet, per sqrt(area) / edge length
constexpr double kAreaCost = 0.1;          // of any facet

}  // namespace

/// Relabels facets while it lives; restores them afterwards.
class Relabelling::Trial {
 public:
  Trial(const Relabelling& relabelling, int label) : owner_(relabelling), label_(label) {}
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;
  ~Trial() {
    for (const auto& [facet, label] : previous_) owner_.labels_[facet] = label;
  }

  void add(int facet) {
    if (owner_.labels_[facet] == label_) return;
    previous_.emplace_back(facet, owner_.labels_[facet]);
    owner_.labels_[facet] = label_;
  }

  /// Takes along what the move cuts off; false when a part would vanish or fall into large pieces.
  bool absorb_crumbs();

  std::vector<int> facets() const {
    std::vector<int> result;
    for (const auto& [facet, label] : previous_) result.push_back(facet);
    std::sort(result.begin(), result.end());
    return result;
  }
  std::set<int> vertices() const {
    std::set<int> result;
    for (const auto& [facet, label] : previous_) {
      result.insert(owner_.mesh_.facet(facet).begin(), owner_.mesh_.facet(facet).end());
    }
    return result;
  }
  /// Price of the facets given away, without their boundary.
  double surrender() const;

 private:
  std::vector<int> rim(int label) const;
  std::vector<std::vector<int>> pieces(const std::vector<int>& rim, int label) const;

  const Relabelling& owner_;
  int label_;
  std::vector<std::pair<int, int>> previous_;  // facet, label before
};

/// Facets of `label` beside the relabelled ones.
std::vector<int> Relabelling::Trial::rim(int label) const {
  std::set<int> result;
  for (const auto& entry : previous_) {
    for (const OpenMesh::FaceHandle f :
         owner_.mesh_.half_edges().ff_range(OpenMesh::FaceHandle(entry.first))) {
      if (owner_.labels_[f.idx()] == label) result.insert(f.idx());
    }
  }
  return {result.begin(), result.end()};
}

/// The connected pieces of `label` that the rim belongs to; a single one is not followed to its end.
std::vector<std::vector<int>> Relabelling::Trial::pieces(const std::vector<int>& rim, int label) const {
  std::vector<std::vector<int>> result;
  std::unordered_set<int> visited, missing(rim.begin(), rim.end());
  for (const int start : rim) {
    if (visited.contains(start)) continue;
    std::vector<int> piece{start};
    visited.insert(start);
    missing.erase(start);
    for (std::size_t i = 0; i < piece.size(); ++i) {
      if (result.empty() && missing.empty()) break;  // the rim is one piece
      for (const OpenMesh::FaceHandle f :
           owner_.mesh_.half_edges().ff_range(OpenMesh::FaceHandle(piece[i]))) {
        if (owner_.labels_[f.idx()] != label || !visited.insert(f.idx()).second) continue;
        missing.erase(f.idx());
        piece.push_back(f.idx());
      }
    }
    result.push_back(std::move(piece));
  }
  return result;
}

bool Relabelling::Trial::absorb_crumbs() {
  std::set<int> losing;
  for (const auto& entry : previous_) losing.insert(entry.second);
  for (const int label : losing) {
    std::vector<std::vector<int>> parts = pieces(rim(label), label);
    if (parts.empty()) return false;
    const auto main = std::max_element(parts.begin(), parts.end(), [&](const auto& a, const auto& b) {
      return owner_.area(a) < owner_.area(b);
    });
    std::iter_swap(parts.begin(), main);
    for (std::size_t i = 1; i < parts.size(); ++i) {
      if (parts[i].size() > kLargestCrumb) return false;
      for (const int f : parts[i]) add(f);
    }
  }
  return true;
}

double Relabelling::Trial::surrender() const {
  double cost = 0;
  for (const auto& [facet, label] : previous_) {
    const double rate = owner_.seeds_.facet_part[facet] == label ? kSeedCost : kAreaCost;
    cost += rate * std::sqrt(owner_.areas_[facet]) / owner_.edge_length_;
  }
  return cost;
}

Relabelling::Relabelling(const TriMesh& mesh, const Seeds& seeds, std::vector<int> labels,
                         const std::vector<double>& boundary_costs)
    : mesh_(mesh),
      seeds_(seeds),
      boundary_costs_(boundary_costs),
      areas_(facet_areas(mesh.points(), mesh.facets())),
      edge_length_(mean_edge_length(mesh)),
      labels_(std::move(labels)) {}

void Relabelling::relabel(const std::vector<int>& facets, int label) {
  for (const int f : facets) labels_[f] = label;
}

double Relabelling::area(const std::vector<int>& facets) const {
  double sum = 0;
  for (const int f : facets) sum += areas_[f];
  return sum;
}

double Relabelling::seeded_area(const std::vector<int>& facets, int part) const {
  double sum = 0;
  for (const int f : facets) sum += seeds_.facet_part[f] == part ? areas_[f] : 0;
  return sum;
}

double Relabelling::boundary_cost(OpenMesh::HalfedgeHandle h) const {
  return boundary_costs_[mesh_.half_edges().edge_handle(h).idx()];
}

std::optional<Relabelling::Move> Relabelling::evaluate(const std::vector<int>& facets, int label) const {
  // Boundary cost and extra fans of what the move touches, under the labels of the moment.
  auto boundary = [&](const std::vector<int>& touched) {
    double cost = 0;
    for (const int f : touched) {
      for (const OpenMesh::HalfedgeHandle h : mesh_.half_edges().fh_range(OpenMesh::FaceHandle(f))) {
        const int g = mesh_.half_edges().face_handle(mesh_.half_edges().opposite_halfedge_handle(h)).idx();
        if (g < 0 || labels_[g] == labels_[f]) continue;
        // Edges within the set are met from both sides.
        cost += boundary_cost(h) * (std::binary_search(touched.begin(), touched.end(), g) ? 0.5 : 1);
      }
    }
    return cost;
  };
  auto fans = [&](const std::set<int>& vertices) {
    int sum = 0;
    for (const int v : vertices) sum += extra_fans(mesh_, labels_, v);
    return sum;
  };
  Move move{{}, label, 0};
  std::set<int> vertices;
  int fans_after = 0;
  {
    Trial trial(*this, label);
    for (const int f : facets) trial.add(f);
    if (!trial.absorb_crumbs()) return std::nullopt;
    move.facets = trial.facets();
    vertices = trial.vertices();
    fans_after = fans(vertices);
    move.cost = boundary(move.facets) + trial.surrender();
  }
  if (fans_after >= fans(vertices)) return std::nullopt;
  move.cost -= boundary(move.facets);
  return move;
}

}  // namespace partwise
