#include "geometry/surface_index.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "error.h"
#include "geometry/triangle_queries.h"

namespace partwise {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Kernel = CGAL::Simple_cartesian<double>;

/// What CGAL's tree stores per facet: its index, and a box by way of its triangle.
struct FacetPrimitive {
  using Id = int;
  using Point = Kernel::Point_3;
  using Datum = Kernel::Triangle_3;

  FacetPrimitive(int index, Datum corners) : facet(index), triangle(corners) {}
  explicit FacetPrimitive(const FacetPrimitive* other) : FacetPrimitive(*other) {}  // how CGAL inserts

  const Id& id() const { return facet; }
  const Datum& datum() const { return triangle; }
  const Point& reference_point() const { return triangle.vertex(0); }

 private:
  Id facet;
  Datum triangle;
};
using CgalTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, FacetPrimitive>>;

double squared_distance_to_box(const Vec3& p, const CGAL::Bbox_3& box) {
  double squared = 0;
  for (int i = 0; i < 3; ++i) {
    const double outside = std::max({box.min(i) - p[i], p[i] - box.max(i), 0.0});
    squared += outside * outside;
  }
  return squared;
}

/// Where a ray enters a box, or infinity; boxes are taken a little larger, so that rounding loses no facet.
double entry_into_box(const TriangleRay& ray, const CGAL::Bbox_3& box) {
  double enters = 0, leaves = kInfinity;
  for (int i = 0; i < 3; ++i) {
    if (ray.direction()[i] == 0) {
      if (ray.origin()[i] < box.min(i) || ray.origin()[i] > box.max(i)) return kInfinity;
      continue;
    }
    const double near = (box.min(i) - ray.origin()[i]) / ray.direction()[i];
    const double far = (box.max(i) - ray.origin()[i]) / ray.direction()[i];
    enters = std::max(enters, std::min(near, far));
    leaves = std::min(leaves, std::max(near, far));
  }
  constexpr double slack = 1 + 1e-14;
  return enters <= leaves * slack ? enters / slack : kInfinity;
}

}  // namespace

/// CGAL's tree carries the boxes; the distances in the leaves are ours, because CGAL's constructions require
/// facets with area and may let a ray slip between two facets.
struct SurfaceIndex::Tree {
  Points points;
  Facets facets;
  CgalTree boxes;

  Tree(const Points& some_points, const Facets& some_facets) : points(some_points), facets(some_facets) {
    std::vector<FacetPrimitive> primitives;
    primitives.reserve(facets.size());
    for (std::size_t f = 0; f < facets.size(); ++f) {
      const auto corner = [&](int i) {
        const Vec3& p = points[facets[f][i]];
        return Kernel::Point_3(p.x(), p.y(), p.z());
      };
      primitives.emplace_back(static_cast<int>(f), Kernel::Triangle_3(corner(0), corner(1), corner(2)));
    }
    const FacetPrimitive* first = primitives.data();
    boxes.insert(first, first + primitives.size());
    boxes.build();  // now, not at the first query: queries may run concurrently
  }

  SurfaceHit hit(int facet, const Vec3& barycentric, const Vec3& from) const {
    const Facet& f = facets[facet];
    SurfaceHit result;
    result.point = {facet, barycentric};
    result.position =
        barycentric[0] * points[f[0]] + barycentric[1] * points[f[1]] + barycentric[2] * points[f[2]];
    result.distance = (result.position - from).norm();
    return result;
  }
};

namespace {

/// Base of the walks through CGAL's tree: nearer boxes first.
template <class BoxDistance>
struct Walk {
  using Priority = double;

  bool go_further() const { return reach >= 0; }
  template <class Query, class Node>
  bool do_intersect(const Query&, const Node& node) const {
    return distance_to(node.bbox()) <= reach;
  }
  template <class Query, class Node>
  std::pair<bool, Priority> do_intersect_with_priority(const Query&, const Node& node) const {
    const double distance = distance_to(node.bbox());
    return {distance <= reach && distance < kInfinity, -distance};
  }

  BoxDistance distance_to;
  double reach = kInfinity;
};

template <class BoxDistance, class Visit>
struct VisitingWalk : Walk<BoxDistance> {
  template <class Query>
  void intersection(const Query&, const FacetPrimitive& primitive) {
    this->reach = visit(primitive.id(), this->reach);
  }
  Visit visit;
};

/// Visits the facets in boxes within reach; `visit(facet, reach)` returns the new reach, below 0 to end.
template <class BoxDistance, class Visit>
void walk(const CgalTree& tree, BoxDistance distance, Visit visit, double reach = kInfinity) {
  VisitingWalk<BoxDistance, Visit> traits{{distance, reach}, visit};
  tree.traversal_with_priority(0, traits);
}

}  // namespace

SurfaceIndex::SurfaceIndex(const Points& points, const Facets& facets) {
  if (facets.empty()) throw InputError("a surface without facets cannot be searched");
  tree_ = std::make_unique<Tree>(points, facets);
}

SurfaceIndex::SurfaceIndex(const TriMesh& mesh) : SurfaceIndex(mesh.points(), mesh.facets()) {}
SurfaceIndex::~SurfaceIndex() = default;
SurfaceIndex::SurfaceIndex(SurfaceIndex&&) noexcept = default;
SurfaceIndex& SurfaceIndex::operator=(SurfaceIndex&&) noexcept = default;

SurfaceHit SurfaceIndex::closest(const Vec3& query) const {
  int best = -1;
  Vec3 best_barycentric = Vec3::Zero();
  walk(
      tree_->boxes, [&](const CGAL::Bbox_3& box) { return squared_distance_to_box(query, box); },
      [&](int facet, double reach) {
        const auto& [a, b, c] = tree_->facets[facet];
        const TriangleProximity near =
            closest_on_triangle(query, tree_->points[a], tree_->points[b], tree_->points[c]);
        if (near.squared_distance > reach || (near.squared_distance == reach && facet > best)) return reach;
        best = facet;
        best_barycentric = near.barycentric;
        return near.squared_distance;
      });
  return tree_->hit(best, best_barycentric, query);
}

bool SurfaceIndex::has_within(double distance, const Vec3& query) const {
  bool found = false;
  walk(
      tree_->boxes, [&](const CGAL::Bbox_3& box) { return squared_distance_to_box(query, box); },
      [&](int facet, double reach) {
        const auto& [a, b, c] = tree_->facets[facet];
        const TriangleProximity near =
            closest_on_triangle(query, tree_->points[a], tree_->points[b], tree_->points[c]);
        found = near.squared_distance <= reach;
        return found ? -1 : reach;
      },
      distance * distance);
  return found;
}

std::optional<SurfaceHit> SurfaceIndex::first_hit(const Vec3& origin, const Vec3& direction) const {
  const TriangleRay ray(origin, direction);
  std::optional<TriangleCrossing> best;
  int best_facet = -1;
  walk(
      tree_->boxes, [&](const CGAL::Bbox_3& box) { return entry_into_box(ray, box); },
      [&](int facet, double reach) {
        const auto& [a, b, c] = tree_->facets[facet];
        const auto crossing = ray.crossing(tree_->points[a], tree_->points[b], tree_->points[c]);
        if (!crossing || crossing->parameter > reach || (crossing->parameter == reach && facet > best_facet))
          return reach;
        best = crossing;
        best_facet = facet;
        return crossing->parameter;
      });
  if (!best) return std::nullopt;
  return tree_->hit(best_facet, best->barycentric, origin);
}

std::vector<SurfaceHit> SurfaceIndex::all_hits(const Vec3& origin, const Vec3& direction) const {
  const TriangleRay ray(origin, direction);
  std::vector<SurfaceHit> hits;
  walk(
      tree_->boxes, [&](const CGAL::Bbox_3& box) { return entry_into_box(ray, box); },
      [&](int facet, double reach) {
        const auto& [a, b, c] = tree_->facets[facet];
        const auto crossing = ray.crossing(tree_->points[a], tree_->points[b], tree_->points[c]);
        if (crossing) hits.push_back(tree_->hit(facet, crossing->barycentric, origin));
        return reach;
      });
  std::sort(hits.begin(), hits.end(), [](const SurfaceHit& a, const SurfaceHit& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.point.facet < b.point.facet;
  });
  return hits;
}

}  // namespace partwise
