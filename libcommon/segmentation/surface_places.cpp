#include "segmentation/surface_places.h"

#include <algorithm>
#include <sstream>

#include "error.h"
#include "segmentation/screen_stroke.h"

namespace partwise {
namespace {

std::string percent(double fraction) {
  std::ostringstream text;
  text.precision(3);
  text << 100 * fraction << " %";
  return text.str();
}

}  // namespace

int nearest_corner(const TriMesh& mesh, const SurfacePoint& point) {
  int corner = 0;
  point.barycentric.maxCoeff(&corner);
  return mesh.facet(point.facet)[corner];
}

const SurfaceIndex& SurfacePlaces::index() {
  if (!index_) index_.emplace(mesh_);
  return *index_;
}

int SurfacePlaces::checked_vertex(int vertex, const std::string& where) const {
  if (vertex < 0 || vertex >= mesh_.vertex_count()) {
    throw InputError(where + ": there is no vertex " + std::to_string(vertex) + "; the mesh has " +
                     std::to_string(mesh_.vertex_count()) + " (0 to " +
                     std::to_string(mesh_.vertex_count() - 1) + "); is this the sketch of another mesh?");
  }
  return vertex;
}

SurfacePoint SurfacePlaces::snapped(const Vec3& point, const std::string& where) {
  const SurfaceHit hit = index().closest(point);
  const double distance = hit.distance / mesh_.diagonal();
  if (distance > snap_limit_) {
    throw InputError(where + ": the point lies " + percent(distance) +
                     " of the mesh's diagonal away from the surface (at most " + percent(snap_limit_) +
                     "); give a point on the surface, in the units of the mesh");
  }
  return hit.point;
}

SurfacePoint SurfacePlaces::locate(const Place& place, const std::string& where) {
  if (const int* vertex = std::get_if<int>(&place)) {
    return vertex_point(mesh_, checked_vertex(*vertex, where));
  }
  if (const Vec3* point = std::get_if<Vec3>(&place)) return snapped(*point, where);
  const SurfacePoint& point = std::get<SurfacePoint>(place);
  if (point.facet < 0 || point.facet >= mesh_.facet_count()) {
    throw InputError(where + ": there is no facet " + std::to_string(point.facet) + "; the mesh has " +
                     std::to_string(mesh_.facet_count()));
  }
  return point;
}

std::vector<int> SurfacePlaces::stroke_vertices(const Stroke& stroke, const std::string& where) {
  std::vector<int> vertices;
  auto entry = [&](std::size_t i) { return where + ", entry " + std::to_string(i); };
  if (const auto* given = std::get_if<VertexStroke>(&stroke)) {
    for (std::size_t i = 0; i < given->vertices.size(); ++i) {
      vertices.push_back(checked_vertex(given->vertices[i], entry(i)));
    }
  } else if (const auto* near = std::get_if<PointStroke>(&stroke)) {
    for (std::size_t i = 0; i < near->points.size(); ++i) {
      vertices.push_back(nearest_corner(mesh_, snapped(near->points[i], entry(i))));
    }
  } else {
    vertices = project_stroke(mesh_, index(), std::get<ScreenStroke>(stroke));
    if (vertices.empty()) {
      throw InputError(where +
                       ": the polyline misses the mesh; check camera, viewport and that pixel rows "
                       "count downwards");
    }
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

std::vector<SeedStroke> seed_strokes(const Sketch& sketch, SurfacePlaces& places) {
  std::vector<SeedStroke> result;
  for (std::size_t part = 0; part < sketch.parts.size(); ++part) {
    const SketchedPart& sketched = sketch.parts[part];
    for (std::size_t i = 0; i < sketched.strokes.size(); ++i) {
      const std::string where = "part '" + sketched.name + "', stroke " + std::to_string(i);
      result.push_back(
          {static_cast<int>(part), static_cast<int>(i), places.stroke_vertices(sketched.strokes[i], where)});
    }
  }
  return result;
}

}  // namespace partwise
