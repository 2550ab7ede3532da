#pragma once

#include "mesh/surface_walk.h"
#include "remeshing/map_guard.h"

namespace partwise {

/// A compatible mesh whose vertices move over the target without leaving it and without folding its facets.
///
/// A map that is one-to-one stays so (see MapGuard); vertices on the boundaries of its charts are pinned.
///
/// A facet's quality is 4 sqrt(3) times its area, signed by the target's normal at the facet's image, over
/// the sum of its squared edges: 1 for an equilateral facet on the target's outside, negative when it is
/// flipped. The normal at the image is the sum of the target's normals, interpolated from its vertices, at
/// the images of the facet's three corners.
class MeshOnSurface {
 public:
  /// Facets may become this flat by a move.
  static constexpr double kLeastQuality = 0.03;

  explicit MeshOnSurface(const CompatibleMesh& mesh);

  const TriMesh& source() const { return source_; }
  const TriMesh& target() const { return walker_.mesh(); }
  const SurfaceWalker& walker() const { return walker_; }
  const Points& points() const { return points_; }
  const SurfacePoint& image(int vertex) const { return images_[vertex]; }
  const std::vector<SurfacePoint>& images() const { return images_; }

  /// Facets around a source vertex, ascending.
  SurfaceWalker::FacetRange ring(int vertex) const { return source_walker_.facets_around(vertex); }

  /// Unit normal of the target at the image of a vertex; zero where normals cancel.
  const Vec3& normal(int vertex) const { return normals_[vertex]; }
  double quality(int facet) const;
  int flipped_count() const;
  int flipped_around(int vertex) const { return ring_state(vertex).flipped; }

  /// A pinned vertex does not move: markers, the boundary of an open source and those of charts are, from the
  /// start.
  bool is_pinned(int vertex) const { return pinned_[vertex]; }
  void pin(int vertex) { pinned_[vertex] = true; }
  void unpin(int vertex) { pinned_[vertex] = false; }

  /// Moves `vertex` over the target towards `goal`, half way when the whole way would fold a facet, and so on
  /// `halvings` times. Returns whether it moved.
  bool move_towards(int vertex, const Vec3& goal, int halvings = 3);

  /// Moves `vertex` to `image` unless that makes the facets around it worse: more of them flipped, or the
  /// worst of them worse than before and below `least_quality`. Returns whether it moved.
  bool move_to(int vertex, const SurfacePoint& image, double least_quality = kLeastQuality);

  /// Whether the map stays one-to-one with `vertex` at `image`, if it is so now.
  bool allows(int vertex, const SurfacePoint& image) const { return guard_.allows(vertex, image); }

  /// Moves `vertex` unconditionally. \pre allows(vertex, image)
  void place(int vertex, const SurfacePoint& image);

 private:
  struct RingState {
    int flipped = 0;
    double worst = 1;
  };
  RingState ring_state(int vertex) const;
  Vec3 normal_at(const SurfacePoint& image) const;

  TriMesh source_;
  SurfaceWalker source_walker_, walker_;
  Points target_normals_;
  Points points_, normals_;
  std::vector<SurfacePoint> images_;
  std::vector<bool> pinned_;
  MapGuard guard_;
};

}  // namespace partwise
