#include "remeshing/intersection_guard.h"

#include <algorithm>

#include "geometry/facet_intersection.h"

namespace partwise {

IntersectionGuard::IntersectionGuard(const MeshOnSurface& mesh)
    : mesh_(mesh), grid_(mesh.points(), mesh.source().facets()) {}

int IntersectionGuard::count_around(int vertex) const {
  const auto ring = mesh_.ring(vertex);
  return count_of({ring.begin(), ring.end()});
}

int IntersectionGuard::count_of(const std::vector<int>& ring) const {
  const Points& points = mesh_.points();
  const Facets& facets = mesh_.source().facets();
  int count = 0;
  for (const int f : ring) {
    if (!has_area(points, facets[f])) continue;
    auto test = [&](int g) {
      count += has_area(points, facets[g]) && facets_intersect(points, facets[f], facets[g]);
    };
    // The grid may not know yet where these facets themselves have gone.
    for (const int g : ring) {
      if (g > f) test(g);
    }
    for (const int g : grid_.near(points, facets[f])) {
      if (!std::binary_search(ring.begin(), ring.end(), g)) test(g);
    }
  }
  return count;
}

void IntersectionGuard::moved(int vertex) {
  for (const int f : mesh_.ring(vertex)) grid_.update(f, mesh_.points(), mesh_.source().facet(f));
}

}  // namespace partwise
