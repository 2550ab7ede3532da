#include "mapping/alignment.h"

#include <gtest/gtest.h>

#include "models.h"

namespace partwise {
namespace {

MatchedPoints moved(const Points& points, const Eigen::Affine3d& motion) {
  MatchedPoints matched;
  for (const Vec3& p : points) matched.add(p, motion * p);
  return matched;
}

TEST(Alignment, FindsASimilarityExactly) {
  const Eigen::Affine3d motion = tests::some_similarity();
  const Points points{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0.3, 0.1, 3}};
  const Eigen::Affine3d found = fit_similarity(moved(points, motion), Eigen::Affine3d::Identity());
  EXPECT_LT((found.matrix() - motion.matrix()).norm(), 1e-9 * motion.matrix().norm());
}

TEST(Alignment, ThePriorDecidesWhatPointsLeaveOpen) {
  const Eigen::Affine3d prior(Eigen::AngleAxisd(0.7, Vec3::UnitX()) * Eigen::Scaling(2.0));
  EXPECT_EQ(fit_similarity({}, prior).matrix(), prior.matrix());
  MatchedPoints one;
  one.add({1, 2, 3}, {4, 5, 6});
  const Eigen::Affine3d moved_prior = fit_similarity(one, prior);
  EXPECT_LT((moved_prior * Vec3(1, 2, 3) - Vec3(4, 5, 6)).norm(), 1e-12);
  EXPECT_LT((moved_prior.linear() - prior.linear()).norm(), 1e-12);
  // Points along x, kept along x: the turn about x is the prior's.
  const Points line{{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}};
  const Eigen::Affine3d along = fit_similarity(moved(line, Eigen::Affine3d(Eigen::Scaling(5.0))), prior);
  EXPECT_LT((along.linear() - 2.5 * prior.linear()).norm(), 1e-9);
}

TEST(Alignment, NeverReflects) {
  const Points points{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, -1, -1}};
  const Eigen::Affine3d mirror(Eigen::Scaling(1.0, 1.0, -1.0));
  EXPECT_GT(fit_similarity(moved(points, mirror), Eigen::Affine3d::Identity()).linear().determinant(), 0);
}

TEST(Alignment, ALinearMapAboutCentresFollowsManyPointsAndThePriorWithoutAny) {
  Eigen::Matrix3d shear;
  shear << 2, 0.5, 0, 0, 1, 0.2, 0, 0, 3;
  MatchedPoints matched;
  const TriMesh ball = tests::sphere(4);
  for (const Vec3& p : ball.points()) matched.add(Vec3(1, 1, 1) + p, Vec3(5, 0, 0) + shear * p);
  const Eigen::Matrix3d prior = Eigen::Matrix3d::Identity();
  EXPECT_LT((fit_linear(matched, {1, 1, 1}, {5, 0, 0}, prior, 1e-6) - shear).norm(), 1e-5);
  EXPECT_LT((fit_linear(matched, {1, 1, 1}, {5, 0, 0}, shear, 1) - shear).norm(), 1e-12);
  EXPECT_EQ(fit_linear({}, {1, 1, 1}, {5, 0, 0}, prior, 1), prior);
}

TEST(Alignment, ExtentsAreMatchedAlongTheAxes) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.2, Vec3(1, 1, 0).normalized()).toRotationMatrix();
  Points source, target;
  const TriMesh box = tests::cube(2);
  for (const Vec3& p : box.points()) {
    source.push_back(p.cwiseProduct(Vec3(1, 2, 5)));
    target.push_back(turn * p.cwiseProduct(Vec3(3, 4, 7)));
  }
  const Eigen::Matrix3d found = match_extents(source, target, turn, turn);
  for (std::size_t i = 0; i < source.size(); ++i) EXPECT_LT((found * source[i] - target[i]).norm(), 1e-9);
}

}  // namespace
}  // namespace partwise
