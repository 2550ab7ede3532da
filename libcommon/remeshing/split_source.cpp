#include "remeshing/split_source.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "error.h"
#include "mesh/surface_walk.h"
#include "remeshing/locate.h"

namespace partwise {
namespace {

/// Finds where the map of a compatible mesh takes points of the source's edges.
class EdgeImages {
 public:
  explicit EdgeImages(const CompatibleMesh& mesh) : mesh_(mesh), chart_of_part_(mesh.part_names.size(), -1) {
    for (std::size_t k = 0; k < mesh.charts.size(); ++k) {
      for (const int part : mesh.charts[k].parts) chart_of_part_[part] = static_cast<int>(k);
      targets_.emplace_back(mesh.target, mesh.target_labels, mesh.charts[k]);
    }
    for (const ChartTarget& target : targets_) {
      locators_.emplace_back(target.piece(), target.directions(), Vec3::Zero());
    }
    if (targets_.empty()) walker_.emplace(mesh.target);
  }

  SurfacePoint at(const EdgePoint& place) const {
    const SurfacePoint &a = mesh_.map[place.a], &b = mesh_.map[place.b];
    if (walker_) {
      return walker_->towards(place.fraction < 0.5 ? a : b, (1 - place.fraction) * position(mesh_.target, a) +
                                                                place.fraction * position(mesh_.target, b));
    }
    const HalfEdges& half_edges = mesh_.source.half_edges();
    const auto edge =
        half_edges.find_halfedge(OpenMesh::VertexHandle(place.a), OpenMesh::VertexHandle(place.b));
    const int chart = chart_of_part_[mesh_.source_labels[half_edges.face_handle(edge).idx()]];
    const auto from = targets_[chart].direction(a), to = targets_[chart].direction(b);
    if (!from || !to) throw InputError("a vertex of an edge lies outside its part's image");
    const Vec3 direction = (1 - place.fraction) * *from + place.fraction * *to;
    return locators_[chart].on_model(locators_[chart].locate(direction).front());
  }

 private:
  const CompatibleMesh& mesh_;
  std::vector<int> chart_of_part_;
  std::vector<ChartTarget> targets_;
  std::vector<DomainLocator> locators_;
  std::optional<SurfaceWalker> walker_;
};

/// Points of a mesh as points of the same mesh with vertices added on edges.
class ToPieces {
 public:
  ToPieces(const TriMesh& original, const EdgeSplitMesh& split) : original_(original), split_(split) {
    first_.resize(original.facet_count() + 1, 0);
    for (const int parent : split.parent_facet) ++first_[parent + 1];
    for (std::size_t f = 1; f < first_.size(); ++f) first_[f] += first_[f - 1];
  }

  SurfacePoint operator()(const SurfacePoint& point) const {
    SurfacePoint best;
    double most_inside = -std::numeric_limits<double>::infinity();
    for (int piece = first_[point.facet]; piece < first_[point.facet + 1]; ++piece) {
      Eigen::Matrix3d corners;  // as columns, in the coordinates of the parent
      for (int i = 0; i < 3; ++i) {
        corners.col(i) = split_.on_original(original_, {piece, Vec3::Unit(i)}).barycentric;
      }
      // Exact for corners of the parent: the inverse of a matrix with unit columns keeps them.
      const Vec3 inside = corners.inverse() * point.barycentric;
      if (inside.minCoeff() <= most_inside) continue;
      most_inside = inside.minCoeff();
      best = {piece, inside};
    }
    best.barycentric = best.barycentric.cwiseMax(0);
    best.barycentric /= best.barycentric.sum();
    return best;
  }

 private:
  const TriMesh& original_;
  const EdgeSplitMesh& split_;
  std::vector<int> first_;  // pieces of a facet follow one another
};

SourceRefinement refinement_after(const CompatibleMesh& mesh, const EdgeSplitMesh& split) {
  SourceRefinement result = mesh.refinement;
  if (result.is_empty()) {
    result.original_facets = mesh.source.facets();
    for (int f = 0; f < mesh.source.facet_count(); ++f) result.parent_facet.push_back(f);
  }
  const int originals = mesh.source.vertex_count() - static_cast<int>(result.vertices.size());
  // A point of mesh.source as a point of the source before any refinement.
  auto on_first = [&](const SurfacePoint& point) {
    SurfacePoint there{result.parent_facet[point.facet], Vec3::Zero()};
    const Facet& parent = result.original_facets[there.facet];
    for (int i = 0; i < 3; ++i) {
      if (point.barycentric[i] == 0) continue;
      const int v = mesh.source.facet(point.facet)[i];
      if (v < originals) {
        there.barycentric[std::find(parent.begin(), parent.end(), v) - parent.begin()] +=
            point.barycentric[i];
        continue;
      }
      const SurfacePoint& place = mesh.refinement.vertices[v - originals];
      const Facet& of_place = result.original_facets[place.facet];
      for (int j = 0; j < 3; ++j) {  // an added vertex on an edge may be known by the facet across
        if (place.barycentric[j] == 0) continue;
        there.barycentric[std::find(parent.begin(), parent.end(), of_place[j]) - parent.begin()] +=
            point.barycentric[i] * place.barycentric[j];
      }
    }
    return there;
  };
  const HalfEdges& half_edges = mesh.source.half_edges();
  for (const EdgePoint& place : split.points) {
    const auto edge =
        half_edges.find_halfedge(OpenMesh::VertexHandle(place.a), OpenMesh::VertexHandle(place.b));
    SurfacePoint point{half_edges.face_handle(edge).idx(), Vec3::Zero()};
    for (int i = 0; i < 3; ++i) {
      const int v = mesh.source.facet(point.facet)[i];
      if (v == place.a) point.barycentric[i] = 1 - place.fraction;
      if (v == place.b) point.barycentric[i] = place.fraction;
    }
    result.vertices.push_back(on_first(point));
  }
  std::vector<int> parents;
  for (const int parent : split.parent_facet) parents.push_back(result.parent_facet[parent]);
  result.parent_facet = std::move(parents);
  return result;
}

void require_splittable(const CompatibleMesh& mesh, const std::vector<EdgePoint>& places) {
  const std::vector<bool> splittable = splittable_edges(mesh);
  const HalfEdges& half_edges = mesh.source.half_edges();
  for (const EdgePoint& place : places) {
    const auto edge =
        half_edges.find_halfedge(OpenMesh::VertexHandle(place.a), OpenMesh::VertexHandle(place.b));
    if (edge.is_valid() && splittable[half_edges.edge_handle(edge).idx()]) continue;
    throw InputError("vertices " + std::to_string(place.a) + " and " + std::to_string(place.b) +
                     " of the source have no edge that can be split");
  }
}

}  // namespace

std::vector<bool> splittable_edges(const CompatibleMesh& mesh) {
  const HalfEdges& half_edges = mesh.source.half_edges();
  std::vector<bool> splittable(half_edges.n_edges(), true);
  std::vector<int> chart_of_part(mesh.part_names.size(), -1);
  for (std::size_t k = 0; k < mesh.charts.size(); ++k) {
    for (const int part : mesh.charts[k].parts) chart_of_part[part] = static_cast<int>(k);
  }
  for (const auto e : half_edges.edges()) {
    const auto h = half_edges.halfedge_handle(e, 0);
    const auto here = half_edges.face_handle(h), across = half_edges.opposite_face_handle(h);
    splittable[e.idx()] =
        here.is_valid() && across.is_valid() &&
        chart_of_part[mesh.source_labels[here.idx()]] == chart_of_part[mesh.source_labels[across.idx()]];
  }
  for (const AddedVertex& added : mesh.added_vertices) {
    const auto edge = half_edges.find_halfedge(OpenMesh::VertexHandle(added.place.a),
                                               OpenMesh::VertexHandle(added.place.b));
    for (const auto h : {edge, half_edges.opposite_halfedge_handle(edge)}) {
      const auto facet = half_edges.face_handle(h);
      if (!facet.is_valid()) continue;
      for (const auto e : half_edges.fe_range(facet)) splittable[e.idx()] = false;
    }
  }
  return splittable;
}

CompatibleMesh split_source(const CompatibleMesh& mesh, const std::vector<EdgePoint>& places) {
  require_splittable(mesh, places);
  const EdgeSplitMesh split = split_edges(mesh.source, places);
  const ToPieces to_pieces(mesh.source, split);
  std::vector<SurfacePoint> images = mesh.map.images();
  const EdgeImages edge_images(mesh);
  for (const EdgePoint& place : places) images.push_back(edge_images.at(place));

  CompatibleMesh result = mesh;
  result.source = split.mesh;
  result.map = SurfaceMap(result.source, result.target, std::move(images));
  result.points = result.map.positions(result.target);
  result.source_labels.clear();
  for (const int parent : split.parent_facet) result.source_labels.push_back(mesh.source_labels[parent]);
  for (MarkerPair& marker : result.markers) marker.source = to_pieces(marker.source);
  result.inverse.clear();
  result.refinement = refinement_after(mesh, split);
  return result;
}

TriMesh original_source(const CompatibleMesh& mesh) {
  if (mesh.refinement.is_empty()) return mesh.source;
  const auto count =
      mesh.source.points().end() - static_cast<std::ptrdiff_t>(mesh.refinement.vertices.size());
  return {Points(mesh.source.points().begin(), count), mesh.refinement.original_facets};
}

}  // namespace partwise
