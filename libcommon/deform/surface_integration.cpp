#include "deform/surface_integration.h"

#include <algorithm>

#include "error.h"
#include "geometry/edge_cotangent.h"
#include "mapping/parallel_parts.h"
#include "segmentation/seeds.h"
#include "solve/sparse_cholesky.h"

namespace partwise {
namespace {

constexpr int kFramesAtOnce = 32;  ///< so that memory does not grow with the number of frames

std::array<double, 3> edge_weights(const std::vector<Points>& shapes, const Facet& facet) {
  std::array<double, 3> weights{};
  for (const Points& points : shapes) {
    for (int i = 0; i < 3; ++i) {
      const Vec3& apex = points[facet[(i + 2) % 3]];
      weights[i] += bounded_half_cotangent(points[facet[i]] - apex, points[facet[(i + 1) % 3]] - apex) /
                    static_cast<double>(shapes.size());
    }
  }
  return weights;
}

}  // namespace

FacetEdges facet_edges(const Points& points, const Facet& facet) {
  FacetEdges edges;
  for (int i = 0; i < 3; ++i) edges[i] = points[facet[(i + 1) % 3]] - points[facet[i]];
  return edges;
}

struct SurfaceIntegration::System {
  Facets facets;
  std::vector<std::array<double, 3>> weights;  // per facet and edge
  std::vector<int> component;                  // per vertex
  int component_count = 0;
  std::vector<int> unknown;  // per vertex, -1 for the first of each component, which stays at the origin
  int unknown_count = 0;
  SparseCholesky factor;

  void number_unknowns(const TriMesh& mesh) {
    const std::vector<int> of_facet = facet_components(mesh);
    component.assign(mesh.vertex_count(), -1);
    for (int f = 0; f < mesh.facet_count(); ++f) {
      for (const int v : mesh.facet(f)) component[v] = of_facet[f];
    }
    component_count = 1 + *std::max_element(of_facet.begin(), of_facet.end());
    std::vector<bool> begun(component_count, false);
    unknown.assign(mesh.vertex_count(), -1);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      if (begun[component[v]]) unknown[v] = unknown_count++;
      begun[component[v]] = true;
    }
  }

  void factorize() {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t f = 0; f < facets.size(); ++f) {
      for (int i = 0; i < 3; ++i) {
        const int a = unknown[facets[f][i]], b = unknown[facets[f][(i + 1) % 3]];
        const double w = weights[f][i];
        if (a >= 0) entries.emplace_back(a, a, w);
        if (b >= 0) entries.emplace_back(b, b, w);
        if (a >= 0 && b >= 0) entries.emplace_back(std::max(a, b), std::min(a, b), -w);
      }
    }
    Eigen::SparseMatrix<double> lower(unknown_count, unknown_count);
    lower.setFromTriplets(entries.begin(), entries.end());
    if (!factor.factorize(lower)) {
      throw ComputationError("the positions are not determined: the models have coordinates out of range");
    }
  }

  Points centres(const Points& points) const {
    Points sums(component_count, Vec3::Zero());
    std::vector<double> counts(component_count, 0);
    for (std::size_t v = 0; v < points.size(); ++v) {
      sums[component[v]] += points[v];
      ++counts[component[v]];
    }
    for (int k = 0; k < component_count; ++k) sums[k] /= counts[k];
    return sums;
  }
};

SurfaceIntegration::SurfaceIntegration(const TriMesh& mesh, const std::vector<Points>& shapes)
    : system_(std::make_unique<System>()) {
  system_->facets = mesh.facets();
  for (const Facet& facet : mesh.facets()) system_->weights.push_back(edge_weights(shapes, facet));
  system_->number_unknowns(mesh);
  system_->factorize();
}

SurfaceIntegration::~SurfaceIntegration() = default;
SurfaceIntegration::SurfaceIntegration(SurfaceIntegration&&) noexcept = default;
SurfaceIntegration& SurfaceIntegration::operator=(SurfaceIntegration&&) noexcept = default;

int SurfaceIntegration::component_count() const {
  return system_->component_count;
}

const std::vector<int>& SurfaceIntegration::components() const {
  return system_->component;
}

Points SurfaceIntegration::centres(const Points& points) const {
  return system_->centres(points);
}

Eigen::MatrixXd SurfaceIntegration::solve(const Eigen::MatrixXd& right) const {
  const System& system = *system_;
  Eigen::MatrixXd reduced(system.unknown_count, right.cols());
  Eigen::MatrixXd fields = Eigen::MatrixXd::Zero(right.rows(), right.cols());
  for (std::size_t v = 0; v < system.unknown.size(); ++v) {
    if (system.unknown[v] >= 0) reduced.row(system.unknown[v]) = right.row(static_cast<Eigen::Index>(v));
  }
  const Eigen::MatrixXd solution = system.factor.solve(reduced);
  for (std::size_t v = 0; v < system.unknown.size(); ++v) {
    if (system.unknown[v] >= 0) fields.row(static_cast<Eigen::Index>(v)) = solution.row(system.unknown[v]);
  }
  return fields;
}

std::vector<Points> SurfaceIntegration::integrate(const std::function<FacetEdges(int, int)>& edges,
                                                  const std::vector<Points>& centres) const {
  const System& system = *system_;
  const int count = static_cast<int>(centres.size());
  std::vector<Points> frames(count);
  for (int first = 0; first < count; first += kFramesAtOnce) {
    const int size = std::min(kFramesAtOnce, count - first);
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(system.unknown_count, 3 * size);
    for_each_part(size, [&](int k) {
      auto divergence = right.middleCols<3>(3 * k);
      for (std::size_t f = 0; f < system.facets.size(); ++f) {
        const FacetEdges wanted = edges(first + k, static_cast<int>(f));
        for (int i = 0; i < 3; ++i) {
          const int a = system.unknown[system.facets[f][i]];
          const int b = system.unknown[system.facets[f][(i + 1) % 3]];
          const Eigen::RowVector3d pull = system.weights[f][i] * wanted[i].transpose();
          if (a >= 0) divergence.row(a) -= pull;
          if (b >= 0) divergence.row(b) += pull;
        }
      }
    });
    // One by one, so that a frame has the same bytes whatever the others are.
    for (int k = 0; k < size; ++k) {
      const Eigen::MatrixXd solution = system.factor.solve(right.middleCols<3>(3 * k));
      right.middleCols<3>(3 * k) = solution;
    }
    for_each_part(size, [&](int k) {
      Points points(system.unknown.size(), Vec3::Zero());
      for (std::size_t v = 0; v < points.size(); ++v) {
        if (system.unknown[v] >= 0) points[v] = right.block<1, 3>(system.unknown[v], 3 * k).transpose();
      }
      const Points found = system.centres(points);
      for (std::size_t v = 0; v < points.size(); ++v) {
        points[v] += centres[first + k][system.component[v]] - found[system.component[v]];
      }
      frames[first + k] = std::move(points);
    });
  }
  return frames;
}

}  // namespace partwise
