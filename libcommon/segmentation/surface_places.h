#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/surface_index.h"
#include "segmentation/seeds.h"
#include "segmentation/sketch.h"

namespace partwise {

/// Finds what a sketch names on its mesh. The search tree is built when a point or screen stroke first needs
/// it.
class SurfacePlaces {
 public:
  /// \param snap_limit how far from the surface a point may lie, over the mesh's diagonal
  SurfacePlaces(const TriMesh& mesh, double snap_limit) : mesh_(mesh), snap_limit_(snap_limit) {}

  /// Point of the surface that a marker or anchor names; `where` begins the message when there is none.
  /// \throws InputError for an unknown vertex or facet, or a point too far from the surface.
  SurfacePoint locate(const Place& place, const std::string& where);

  /// Vertices of a stroke: as given; the corners nearest to the surface points closest to given points; the
  /// corners nearest to what a screen polyline hits, gaps bridged by shortest edge paths.
  /// \throws InputError as locate(), naming the entry; also for a screen stroke that misses the mesh.
  std::vector<int> stroke_vertices(const Stroke& stroke, const std::string& where);

 private:
  const SurfaceIndex& index();
  int checked_vertex(int vertex, const std::string& where) const;
  SurfacePoint snapped(const Vec3& point, const std::string& where);

  const TriMesh& mesh_;
  double snap_limit_;
  std::optional<SurfaceIndex> index_;
};

/// Resolves the strokes of every part. \throws InputError naming part, stroke and entry.
std::vector<SeedStroke> seed_strokes(const Sketch& sketch, SurfacePlaces& places);

/// The corner of the point's facet that is nearest in barycentric coordinates.
int nearest_corner(const TriMesh& mesh, const SurfacePoint& point);

}  // namespace partwise
