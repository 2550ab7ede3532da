#include "deform/rotation_logarithms.h"

#include <cmath>
#include <numbers>
#include <queue>
#include <tuple>

#include "segmentation/seeds.h"

namespace partwise {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

double angle_between(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return rotation_logarithm(a.transpose() * b).norm();
}

/// Calls f(neighbour) for the facets across the three edges.
template <class Function>
void for_each_neighbour(const TriMesh& mesh, int facet, Function f) {
  for (const auto neighbour : mesh.half_edges().ff_range(OpenMesh::FaceHandle(facet))) f(neighbour.idx());
}

/// Per component: the facet turned least, the first of equals.
std::vector<int> seeds(const TriMesh& mesh, const Points& logarithms, const std::vector<bool>& known) {
  const std::vector<int> component = facet_components(mesh);
  std::vector<int> best;
  for (int f = 0; f < mesh.facet_count(); ++f) {
    if (component[f] >= static_cast<int>(best.size())) best.resize(component[f] + 1, -1);
    int& seed = best[component[f]];
    const bool better =
        seed < 0 || (known[f] && (!known[seed] || logarithms[f].norm() < logarithms[seed].norm()));
    if (better) seed = f;
  }
  return best;
}

}  // namespace

Vec3 rotation_logarithm(const Eigen::Matrix3d& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

Eigen::Matrix3d rotation_exponential(const Vec3& logarithm) {
  const double angle = logarithm.norm();
  if (angle == 0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, logarithm / angle).toRotationMatrix();
}

Vec3 nearest_logarithm(const Vec3& logarithm, const Vec3& near) {
  const double angle = logarithm.norm();
  // No turn at all has every axis: the nearest is along `near` itself.
  const Vec3 axis = angle > 1e-12 ? Vec3(logarithm / angle) : Vec3(near.stableNormalized());
  return (angle + kTurn * std::round((axis.dot(near) - angle) / kTurn)) * axis;
}

Points rotation_logarithms(const TriMesh& mesh, const std::vector<Eigen::Matrix3d>& rotations,
                           const std::vector<bool>& known, double certain) {
  Points logarithms(mesh.facet_count());
  for (int f = 0; f < mesh.facet_count(); ++f) logarithms[f] = rotation_logarithm(rotations[f]);
  using Step = std::tuple<double, int, int>;  // change of rotation, facet, facet it is reached from
  std::priority_queue<Step, std::vector<Step>, std::greater<>> steps;
  std::vector<bool> reached(mesh.facet_count(), false);
  for (const int seed : seeds(mesh, logarithms, known)) steps.emplace(0.0, seed, seed);
  for (int f = 0; f < mesh.facet_count(); ++f) {
    if (known[f] && logarithms[f].norm() < certain) steps.emplace(0.0, f, f);
  }
  while (!steps.empty()) {
    const int facet = std::get<1>(steps.top()), from = std::get<2>(steps.top());
    steps.pop();
    if (reached[facet]) continue;
    reached[facet] = true;
    logarithms[facet] =
        known[facet] ? nearest_logarithm(logarithms[facet], logarithms[from]) : logarithms[from];
    for_each_neighbour(mesh, facet, [&](int next) {
      if (reached[next]) return;
      // Beyond every angle between rotations: these come when nothing else is left.
      const bool sure = known[facet] && known[next];
      steps.emplace(sure ? angle_between(rotations[facet], rotations[next]) : 4.0, next, facet);
    });
  }
  return logarithms;
}

}  // namespace partwise
