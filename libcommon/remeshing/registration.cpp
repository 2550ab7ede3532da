#include "remeshing/registration.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "energy/affine_deformation.h"
#include "geometry/normals.h"
#include "geometry/point_grid.h"
#include "remeshing/relax_on_surface.h"
#include "solve/least_squares.h"

namespace partwise {
namespace {

constexpr double kLeastWeight = 1e-6;  // of a vertex without a match, and of the affine maps at rest

/// What a place of a surface looks like.
struct Features {
  Points places, normals;
  std::vector<Vec3> reliefs;
};

/// Of the mesh's vertices and of its facets' centres.
Features features_of(const TriMesh& mesh) {
  Features result{mesh.points(), vertex_normals(mesh.points(), mesh.facets()), relief(mesh)};
  for (const Facet& f : mesh.facets()) {
    auto mean = [&](const std::vector<Vec3>& values) -> Vec3 {
      return (values[f[0]] + values[f[1]] + values[f[2]]) / 3;
    };
    result.places.push_back(mean(result.places));
    result.normals.push_back(mean(result.normals).stableNormalized());
    result.reliefs.push_back(mean(result.reliefs));
  }
  return result;
}

/// Finds for the vertices of a deforming source the places of the target that look like them.
class Matcher {
 public:
  Matcher(const MeshOnSurface& mesh, const RegistrationOptions& options)
      : mesh_(mesh),
        target_(features_of(mesh.target())),
        source_reliefs_(relief(mesh.source())),
        grid_(target_.places, options.reach * mesh.target().diagonal()),
        normal_weight_(std::pow(options.normal_weight * mesh.target().diagonal(), 2)),
        relief_weight_(std::pow(options.relief_weight * mesh.target().diagonal(), 2)) {}

  /// \param shape per vertex: where the deformed source has it
  std::vector<VertexTarget> matches(const Points& shape) const {
    const Points normals = vertex_normals(shape, mesh_.source().facets());
    std::vector<VertexTarget> result(shape.size());
    tbb::parallel_for(std::size_t{0}, shape.size(),
                      [&](std::size_t v) { result[v] = match(static_cast<int>(v), shape[v], normals[v]); });
    return result;
  }

 private:
  VertexTarget match(int vertex, const Vec3& place, const Vec3& normal) const {
    const Vec3& image = mesh_.points()[vertex];
    if (mesh_.is_pinned(vertex)) return {vertex, image, 1};
    double least = std::numeric_limits<double>::infinity();
    int best = -1;
    grid_.for_each_within(image, [&](int i) {
      const double difference = (target_.places[i] - place).squaredNorm() +
                                normal_weight_ * (target_.normals[i] - normal).squaredNorm() +
                                relief_weight_ * (target_.reliefs[i] - source_reliefs_[vertex]).squaredNorm();
      if (difference >= least) return;
      least = difference;
      best = i;
    });
    const double agreement = best < 0 ? 0 : std::max(0.0, target_.normals[best].dot(normal));
    if (agreement == 0) return {vertex, image, 0};
    return {vertex, target_.places[best], agreement * agreement};
  }

  const MeshOnSurface& mesh_;
  Features target_;
  std::vector<Vec3> source_reliefs_;
  PointGrid grid_;
  double normal_weight_, relief_weight_;
};

Points scaled(const Points& points, double factor) {
  Points result;
  for (const Vec3& p : points) result.push_back(factor * p);
  return result;
}

double mean_edge(const MeshOnSurface& mesh) {
  double sum = 0;
  const HalfEdges& half_edges = mesh.source().half_edges();
  for (const auto e : half_edges.edges()) {
    sum += (mesh.points()[e.v1().idx()] - mesh.points()[e.v0().idx()]).norm();
  }
  return sum / static_cast<double>(half_edges.n_edges());
}

}  // namespace

std::vector<VertexTarget> register_source(const MeshOnSurface& mesh, const RegistrationOptions& options) {
  const int count = mesh.source().vertex_count();
  const Matcher matcher(mesh, options);
  const Points rest = scaled(mesh.source().points(), mesh.target().diagonal() / mesh.source().diagonal());
  const EnergyTerm deformation = affine_deformation_term(rest, mesh.source().facets());
  const EnergyTerm at_rest = affine_rest_term(rest, mesh.source().facets());
  std::vector<VertexTarget> result;
  std::vector<VertexTarget> fixed;
  for (int v = 0; v < count; ++v) {
    if (mesh.is_pinned(v)) fixed.push_back({4 * v, mesh.points()[v], 1});
  }
  LeastSquares system(4 * count, fixed);
  Points shape = mesh.points();
  for (int step = 0; step < options.steps; ++step) {
    const double share = options.steps > 1 ? step / (options.steps - 1.0) : 1;
    result = matcher.matches(shape);
    std::vector<VertexTarget> wanted;
    for (const VertexTarget& match : result) {
      wanted.push_back({4 * match.vertex, match.target, std::max(match.weight, kLeastWeight)});
    }
    system.clear();
    system.add(options.stiffest * std::pow(options.softest / options.stiffest, share), deformation);
    system.add(kLeastWeight, at_rest);
    system.add(1, point_term(4 * count, wanted));
    const Points solution = system.minimise();
    for (int v = 0; v < count; ++v) shape[v] = solution[4 * v];
  }
  for (VertexTarget& end : result) end.target = shape[end.vertex];
  return result;
}

void relax_towards_registration(MeshOnSurface& mesh, const std::vector<double>& scales,
                                const RegistrationOptions& options) {
  if (options.steps == 0) return;
  const std::vector<VertexTarget> registered = register_source(mesh, options);
  const double edge = mean_edge(mesh);
  for (const double strength : options.pulls) {
    // Against distortion, which counts by area: a strength of 1 makes an edge's length as bad as an isometry.
    const std::vector<double> areas = ring_areas(mesh.points(), mesh.source().facets());
    std::vector<PlacePull> pulls;
    for (const auto& [vertex, place, agreement] : registered) {
      pulls.push_back({vertex_point(mesh.source(), vertex), place,
                       agreement * strength * areas[vertex] / (3 * edge * edge)});
    }
    relax_on_surface(mesh, scales,
                     {.iterations = options.iterations, .least_quality = MeshOnSurface::kLeastQuality},
                     pulls);
  }
}

}  // namespace partwise
