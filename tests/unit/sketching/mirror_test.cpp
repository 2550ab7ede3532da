#include "sketching/mirror.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

#include "builders.h"
#include "error.h"
#include "segmentation/sketches.h"

namespace partwise::sketching {
namespace {

constexpr double kTolerance = 1e-9;  // of the diagonal

/// Symmetric about x = 0 and no other plane; so are its facets.
TriMesh symmetric_body() {
  const TriMesh sphere = tests::sphere(8);
  Points points;
  for (const Vec3& p : sphere.points()) {
    points.emplace_back(p.x() * (1 + 0.3 * p.z()), 1.4 * p.y() + 0.3 * p.z() * p.z() + 0.2 * p.z(),
                        2 * p.z() - 0.3 * p.y() * p.y());
  }
  return sphere.with_points(points);
}

template <class Change>
TriMesh changed(const TriMesh& mesh, Change change) {
  Points points;
  for (const Vec3& p : mesh.points()) points.push_back(change(p));
  return mesh.with_points(points);
}

/// Off the plane, and inside a facet.
SurfacePoint place_on_side(const TriMesh& mesh) {
  for (int f = 0;; ++f) {
    const SurfacePoint point{f, Vec3(0.2, 0.3, 0.5)};
    if (position(mesh, point).x() > 0.5) return point;
  }
}

TEST(Mirror, GivesExactlyTheOtherSide) {
  const TriMesh body = symmetric_body();
  const Mirror mirror(body);
  EXPECT_LT(mirror.facts().at("error"), kTolerance);
  EXPECT_FALSE(mirror.facts().contains("problem"));
  const SurfacePoint place = place_on_side(body);
  const auto image = mirror.image(place);
  ASSERT_TRUE(image);
  const Vec3 p = position(body, place);
  EXPECT_LT((position(body, *image) - Vec3(-p.x(), p.y(), p.z())).norm(), kTolerance * body.diagonal());
  const auto back = mirror.image(*image);
  ASSERT_TRUE(back);
  EXPECT_LT((position(body, *back) - p).norm(), kTolerance * body.diagonal());
}

TEST(Mirror, DoesNotDependOnPoseScaleAndNumbers) {
  const TriMesh body = symmetric_body();
  const SurfacePoint place = place_on_side(body);
  const Vec3 p = position(body, place);
  for (const double scale : {1e-4, 1.0, 3e5}) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(0.3 + scale, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
    const auto moved = [&](const Vec3& q) -> Vec3 { return scale * (turn * q + Vec3(3, -1, 7)); };
    const tests::Renumbered other = tests::renumbered(changed(body, moved), 5);
    const SurfaceIndex surface(other.mesh);
    const auto image = Mirror(other.mesh).image(surface.closest(moved(p)).point);
    ASSERT_TRUE(image) << scale;
    EXPECT_LT((position(other.mesh, *image) - moved(Vec3(-p.x(), p.y(), p.z()))).norm(),
              kTolerance * other.mesh.diagonal())
        << scale;
  }
}

TEST(Mirror, FindsAPlaneWhereThereAreMany) {
  for (const TriMesh& mesh : {tests::sphere(8), tests::cube(6), tests::torus(2, 0.7, 32, 16)}) {
    const MirrorPlane plane = find_mirror_plane(mesh, SurfaceIndex(mesh));
    EXPECT_NEAR(plane.normal.norm(), 1, 1e-12);
    EXPECT_LT(plane.error, 1e-3);
  }
}

TEST(Mirror, LooksPastALimbInAnotherPose) {
  const TriMesh body = symmetric_body();
  const TriMesh posed = changed(body, [](const Vec3& p) -> Vec3 {
    const double near = std::exp(-(p - Vec3(0.7, 0, 1.2)).squaredNorm() / 0.05);
    return p + 0.5 * near * Vec3(1, 0.3, 0.2);
  });
  const MirrorPlane plane = find_mirror_plane(posed, SurfaceIndex(posed));
  EXPECT_GT(plane.error, 1e-3);
  EXPECT_GT(std::abs(plane.normal.x()), std::cos(0.01));
  EXPECT_LT(std::abs(plane.offset), 0.005 * posed.diagonal());
}

TEST(Mirror, SuggestsNothingOnThePlane) {
  const TriMesh body = symmetric_body();
  const int vertex = tests::vertex_near(body, Vec3(0, 1.4, 0));
  ASSERT_NEAR(body.point(vertex).x(), 0, 1e-12);
  EXPECT_FALSE(Mirror(body).image(vertex_point(body, vertex)));
}

TEST(Mirror, RefusesWhatIsNotSymmetric) {
  const TriMesh body = changed(tests::irregular_body(), [](const Vec3& p) -> Vec3 {
    return {p.x() + 0.5 * p.z() * p.z(), p.y() + 0.4 * p.x() * p.x() - 0.3 * p.z(),
            p.z() + 0.5 * p.x() * p.y()};
  });
  const Mirror mirror(body);
  ASSERT_TRUE(mirror.facts().contains("problem")) << mirror.facts();
  EXPECT_NE(mirror.facts()["problem"].get<std::string>().find("not symmetric enough"), std::string::npos);
  EXPECT_THROW(mirror.image({0, Vec3(1, 0, 0)}), InputError);
}

}  // namespace
}  // namespace partwise::sketching
