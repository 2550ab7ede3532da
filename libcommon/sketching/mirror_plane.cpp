#include "sketching/mirror_plane.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/normals.h"
#include "measure/surface_samples.h"

namespace partwise::sketching {
namespace {

constexpr int kDirections = 120;  // half a sphere, about 13 degrees apart
constexpr int kFewSamples = 200;  // that compare directions, and improve the best
constexpr int kSamples = 2000;    // that improve the best of those, and measure them
constexpr std::size_t kImproved = 6, kBest = 2;
constexpr int kMostSteps = 30;
constexpr double kSmallStep = 1e-13;  // radians, and diagonals
constexpr double kPosed = 0.02;       // diagonals: what is farther from its mirror image counts less
constexpr std::uint64_t kSeed = 1;

/// Where the surface's area lies.
struct Mass {
  Vec3 centroid = Vec3::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // columns: principal directions
};

Mass mass_of(const TriMesh& mesh) {
  const std::vector<double> areas = facet_areas(mesh.points(), mesh.facets());
  const auto sum_over = [&](auto initial, auto of_corners) {
    for (int f = 0; f < mesh.facet_count(); ++f) {
      const auto& [a, b, c] = mesh.facet(f);
      initial += areas[f] * of_corners(mesh.point(a), mesh.point(b), mesh.point(c));
    }
    return initial;
  };
  double area = 0;
  for (const double facet_area : areas) area += facet_area;
  Mass mass;
  mass.centroid =
      sum_over(Vec3(0, 0, 0),
               [](const Vec3& a, const Vec3& b, const Vec3& c) -> Vec3 { return (a + b + c) / 3; }) /
      area;
  // The mean of x x^T over a triangle is (a a^T + b b^T + c c^T + (a + b + c) (a + b + c)^T) / 12.
  const Eigen::Matrix3d second =
      sum_over(Eigen::Matrix3d::Zero().eval(),
               [&](Vec3 a, Vec3 b, Vec3 c) -> Eigen::Matrix3d {
                 for (Vec3* corner : {&a, &b, &c}) *corner -= mass.centroid;
                 const Vec3 sum = a + b + c;
                 return (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose()) /
                        12;
               }) /
      area;
  mass.axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(second).eigenvectors();
  return mass;
}

/// Unit, spread evenly over half a sphere along a spiral.
Points half_sphere(int count) {
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  Points directions;
  for (int i = 0; i < count; ++i) {
    const double z = (i + 0.5) / count, r = std::sqrt(1 - z * z);
    directions.emplace_back(r * std::cos(i * golden), r * std::sin(i * golden), z);
  }
  return directions;
}

/// Measures and improves planes by some samples of the surface.
class Improvement {
 public:
  Improvement(const TriMesh& mesh, const SurfaceIndex& surface, const Vec3& centroid, int samples)
      : surface_(surface),
        centroid_(centroid),
        diagonal_(mesh.diagonal()),
        normals_(facet_normals(mesh.points(), mesh.facets())),
        samples_(sample_surface(mesh.points(), mesh.facets(), samples, kSeed)) {}

  MirrorPlane measured(MirrorPlane plane) const {
    double sum = 0;
    for (const Vec3& sample : samples_) {
      const double distance = surface_.closest(plane.mirrored(sample)).distance;
      sum += distance * distance;
    }
    plane.error = std::sqrt(sum / static_cast<double>(samples_.size())) / diagonal_;
    return plane;
  }

  MirrorPlane improved(MirrorPlane plane) const {
    for (int step = 0; step < kMostSteps; ++step) {
      if (take_step(plane) < kSmallStep) break;
    }
    return measured(plane);
  }

 private:
  /// Size of the step. Unknown are turns of the normal towards two directions beside it, in radians, and the
  /// offset from the centroid, in diagonals.
  double take_step(MirrorPlane& plane) const {
    const Vec3 u = plane.normal.unitOrthogonal(), v = plane.normal.cross(u);
    const double from_centroid = plane.offset - plane.normal.dot(centroid_);
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    Vec3 right = Vec3::Zero();
    for (const Vec3& sample : samples_) {
      const SurfaceHit hit = surface_.closest(plane.mirrored(sample));
      const Vec3& facing = normals_[hit.point.facet];
      const Vec3 x = (sample - centroid_) / diagonal_;
      const double height = plane.normal.dot(x) - from_centroid / diagonal_;
      const double residual = facing.dot(plane.mirrored(sample) - hit.position) / diagonal_;
      const auto turned = [&](const Vec3& to) {
        return -2 * (to.dot(x) * facing.dot(plane.normal) + height * facing.dot(to));
      };
      const Vec3 row(turned(u), turned(v), 2 * facing.dot(plane.normal));
      const double far = hit.distance / (kPosed * diagonal_);
      const double weight = 1 / ((1 + far * far) * (1 + far * far));
      squares += weight * row * row.transpose();
      right -= weight * residual * row;
    }
    // Surfaces of revolution leave a turn open.
    squares.diagonal().array() += 1e-9 * squares.trace();
    const Vec3 change = squares.ldlt().solve(right);
    plane.normal = (plane.normal + change[0] * u + change[1] * v).normalized();
    plane.offset = plane.normal.dot(centroid_) + from_centroid + diagonal_ * change[2];
    return change.norm();
  }

  const SurfaceIndex& surface_;
  Vec3 centroid_;
  double diagonal_;
  Points normals_;
  Points samples_;
};

}  // namespace

MirrorPlane find_mirror_plane(const TriMesh& mesh, const SurfaceIndex& surface) {
  const Mass mass = mass_of(mesh);
  const Improvement few(mesh, surface, mass.centroid, kFewSamples);
  const Improvement many(mesh, surface, mass.centroid, kSamples);
  Points normals = half_sphere(kDirections);
  for (int axis = 0; axis < 3; ++axis) normals.push_back(Vec3::Unit(axis));
  std::vector<MirrorPlane> planes;
  planes.reserve(normals.size());
  for (const Vec3& normal : normals) {
    MirrorPlane plane;
    plane.normal = mass.axes * normal;
    plane.offset = plane.normal.dot(mass.centroid);
    planes.push_back(few.measured(plane));
  }
  const auto keep_best = [&](std::size_t count) {
    std::stable_sort(planes.begin(), planes.end(),
                     [](const MirrorPlane& a, const MirrorPlane& b) { return a.error < b.error; });
    planes.resize(count);
  };
  keep_best(kImproved);
  for (MirrorPlane& plane : planes) plane = few.improved(plane);
  keep_best(kBest);
  for (MirrorPlane& plane : planes) plane = many.improved(plane);
  keep_best(1);
  return planes.front();
}

}  // namespace partwise::sketching
