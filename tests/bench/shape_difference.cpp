// How far two shapes of one connectivity are from each other: shape_difference A.ply B.ply
//
// One line: mean vertex distance over the diagonal of B as they lie, after the best translation, after the
// best rigid motion; facets of A and of B that face against their surroundings.
#include <cstdio>
#include <exception>

#include "deform/facet_transform.h"
#include "io/stage_documents.h"
#include "measure/inverted_facets.h"

using namespace partwise;

namespace {

Vec3 mean(const Points& points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

double mean_distance(const Points& a, const Points& b, const Eigen::Matrix3d& turn, const Vec3& from,
                     const Vec3& to) {
  double sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v) sum += (turn * (a[v] - from) + to - b[v]).norm();
  return sum / static_cast<double>(a.size());
}

int compare(const char* path_a, const char* path_b) {
  const TriMesh a = io::read_mesh(io::read_document(path_a)), b = io::read_mesh(io::read_document(path_b));
  if (a.key() != b.key()) {
    std::fprintf(stderr, "shape_difference: %s and %s have different connectivity\n", path_a, path_b);
    return 3;
  }
  const Vec3 from = mean(a.points()), to = mean(b.points());
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  for (int v = 0; v < a.vertex_count(); ++v) products += (b.point(v) - to) * (a.point(v) - from).transpose();
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  const double l = b.diagonal();
  std::printf(
      "%.4f %.4f %.4f %zu %zu\n",
      mean_distance(a.points(), b.points(), identity, Vec3::Zero(), Vec3::Zero()) / l,
      mean_distance(a.points(), b.points(), identity, from, to) / l,
      mean_distance(a.points(), b.points(), nearest_rotation(products).value_or(identity), from, to) / l,
      inverted_facets(a.points(), a.facets()).size(), inverted_facets(b.points(), b.facets()).size());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  try {
    return compare(argv[1], argv[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "shape_difference: %s\n", error.what());
    return 1;
  }
}
