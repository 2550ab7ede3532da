#include "mapping/hull_to_hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "error.h"
#include "mapping/build_hulls.h"
#include "mapping/map_progressively.h"
#include "models.h"

namespace partwise {
namespace {

using tests::octant_model;
using tests::reindexed;

HullMap hull_map(const SegmentedModel& model) {
  HullMap map{build_hulls(model), {}};
  for (const Part& part : map.hulled.parts) {
    map.images.push_back(map_progressively(part, map.hulled.hulls[part.index]).images);
  }
  return map;
}

/// Largest distance of the source's images from where `motion` brings its own hull map, over the diagonal.
double largest_error(const HullMap& source, const HullToHull& result, const Eigen::Affine3d& motion) {
  double largest = 0;
  for (std::size_t k = 0; k < result.map.images.size(); ++k) {
    const Points& own = source.images[result.map.source_parts[k].index];
    EXPECT_EQ(own.size(), result.map.images[k].size());
    for (std::size_t v = 0; v < own.size(); ++v) {
      largest = std::max(largest, (result.map.images[k][v] - motion * own[v]).norm());
    }
  }
  return largest / result.map.target.hulled.model.mesh.diagonal();
}

void expect_one_to_one(const HullToHull& result) {
  for (const PartCrossing& part : result.parts) {
    EXPECT_EQ(part.source_folds, 0) << part.name;
    EXPECT_EQ(part.folds, 0) << part.name;
    EXPECT_NEAR(part.degree, 1, 1e-9) << part.name;
    EXPECT_TRUE(part.one_to_one) << part.name;
  }
}

TEST(HullToHull, AModelFindsItself) {
  for (const int axes : {0, 1, 2}) {
    const HullMap map = hull_map(octant_model(tests::lumpy_sphere(6), axes));
    const HullToHull result = map_hull_to_hull(map, map);
    EXPECT_LT(largest_error(map, result, Eigen::Affine3d::Identity()), 1e-9) << axes;
    expect_one_to_one(result);
  }
}

TEST(HullToHull, ACopyMovedScaledAndRenumberedFindsItself) {
  // The copy's hull map is the moved hull map, so that only this stage is asked.
  const Eigen::Affine3d motion = tests::some_similarity();
  SegmentedModel model = octant_model(tests::lumpy_sphere(6), 2);
  model.markers = {{"m", {0, {1, 0, 0}}}, {"inside", {50, {0.2, 0.3, 0.5}}}};
  const HullMap source = hull_map(model);
  HullMap target{build_hulls(reindexed(model, motion)), {}};
  const int n = model.mesh.vertex_count();
  for (const Part& part : target.hulled.parts) {
    const int other = static_cast<int>(target.hulled.parts.size()) - 1 - part.index;
    const Part& own = source.hulled.parts[other];
    Points images;
    for (const int v : part.model_vertex) {
      if (v < 0) break;
      const auto local = std::find(own.model_vertex.begin(), own.model_vertex.end(), n - 1 - v);
      images.push_back(motion * source.images[other][local - own.model_vertex.begin()]);
    }
    ASSERT_EQ(part.cap_vertices.size(), 1U);
    images.push_back(motion * source.images[other][own.cap_vertices[0]]);
    target.images.push_back(images);
  }
  const HullToHull result = map_hull_to_hull(source, target);
  EXPECT_LT(largest_error(source, result, motion), 1e-9);
  expect_one_to_one(result);
  ASSERT_EQ(result.markers.size(), 2U);
  for (const MarkerDistance& marker : result.markers) EXPECT_LT(marker.distance, 1e-9) << marker.name;
}

TEST(HullToHull, BoundaryVerticesEndAtTheirPlaces) {
  const HullMap source = hull_map(octant_model(tests::lumpy_sphere(7), 2));
  const HullMap target = hull_map(octant_model(tests::cube(6), 2));
  const HullToHull result = map_hull_to_hull(source, target);
  expect_one_to_one(result);
  const CrossMap& map = result.map;
  int checked = 0;
  for (const BoundaryPlacement& p : map.boundary) {
    for (std::size_t k = 0; k < map.images.size(); ++k) {
      auto image = [](const Part& part, const Points& images, int vertex) -> const Vec3* {
        const auto found = std::find(part.model_vertex.begin(), part.model_vertex.end(), vertex);
        return found == part.model_vertex.end() ? nullptr : &images[found - part.model_vertex.begin()];
      };
      const Vec3* own = image(map.source_parts[k], map.images[k], p.source_vertex);
      const Vec3* a = image(target.hulled.parts[k], target.images[k], p.target_a);
      const Vec3* b = image(target.hulled.parts[k], target.images[k], p.target_b);
      if (!own) continue;
      ASSERT_TRUE(a && b);
      // In the direction of the place on the target's edge, seen from the hull's centre.
      const Vec3 centre = hull_centre(target.hulled.hulls[k]);
      const Vec3 place = (1 - p.fraction) * *a + p.fraction * *b;
      EXPECT_LT((*own - centre).normalized().cross((place - centre).normalized()).norm(), 1e-12);
      ++checked;
    }
  }
  EXPECT_GT(checked, 50);
}

TEST(HullToHull, OtherShapesMarkersUnitsAndSizes) {
  SegmentedModel ball = octant_model(tests::sphere(10), 0),
                 bumps = octant_model(tests::bumpy_sphere(8, 0.4), 0);
  auto mark = [](SegmentedModel& model) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-1.0, 1.0}) {
        for (int f = 0; f < model.mesh.facet_count(); ++f) {
          for (int i = 0; i < 3; ++i) {
            const Vec3 p = model.mesh.point(model.mesh.facet(f)[i]).normalized();
            if (side * p[axis] < 1 - 1e-9) continue;
            model.markers.push_back({"xyz"[axis] + std::string(side < 0 ? "-" : "+"), {f, Vec3::Unit(i)}});
            i = 3, f = model.mesh.facet_count();
          }
        }
      }
    }
  };
  mark(ball);
  mark(bumps);
  ASSERT_EQ(ball.markers.size(), 6U);
  auto facet_towards = [](const TriMesh& mesh, const Vec3& direction) {
    int nearest = 0;
    double most = 0;
    for (int f = 0; f < mesh.facet_count(); ++f) {
      const auto& [a, b, c] = mesh.facet(f);
      const double along = (mesh.point(a) + mesh.point(b) + mesh.point(c)).normalized().dot(direction);
      if (along <= most) continue;
      most = along;
      nearest = f;
    }
    return nearest;
  };
  const Vec3 corner = Vec3(1, 0.8, 0.7).normalized();
  ball.markers.push_back({"inside a facet", {facet_towards(ball.mesh, corner), {0.3, 0.3, 0.4}}});
  bumps.markers.push_back({"inside a facet", {facet_towards(bumps.mesh, corner), {0.2, 0.5, 0.3}}});
  Points large = bumps.mesh.points();
  const Eigen::Affine3d motion = tests::some_similarity();
  for (Vec3& p : large) p = motion * p;
  bumps.mesh = bumps.mesh.with_points(large);
  const HullToHull result = map_hull_to_hull(hull_map(ball), hull_map(bumps));
  expect_one_to_one(result);
  ASSERT_EQ(result.markers.size(), 7U);
  for (const MarkerDistance& marker : result.markers) EXPECT_LT(marker.distance, 1e-9) << marker.name;
  EXPECT_LT(result.parts[0].distortion, 1.5);
}

TEST(HullToHull, OpenMeshes) {
  SegmentedModel dome = octant_model(tests::hemisphere(8), 1);
  Points points = dome.mesh.points();
  for (Vec3& p : points) p = Vec3(2 * p.x(), p.y() + 0.2 * p.x() * p.x(), 3 * p.z() + 0.1 * p.y());
  const SegmentedModel tall = octant_model(dome.mesh.with_points(points), 1);
  const HullToHull result = map_hull_to_hull(hull_map(dome), hull_map(tall));
  expect_one_to_one(result);
}

/// A limb along x in two halves, straight and round, or bent with an oblong section that is thicker at one
/// end; turned about x.
SegmentedModel limb(int around, bool is_round, double turn) {
  const TriMesh tube = tests::capsule(3, around, 24);
  const Eigen::AngleAxisd about_x(turn, Vec3::UnitX());
  Points points;
  for (const Vec3& p : tube.points()) {
    const Vec3 section =
        is_round ? p : Vec3(2 * p.x() + 0.8 * p.x() * p.x(), p.y() * (1 + 0.6 * p.x()), p.z());
    const double bend = is_round ? 0 : 0.25 * p.z() * p.z();
    points.push_back(about_x * Vec3(section.z(), section.x() + bend, section.y()));
  }
  return octant_model(tube.with_points(points), 1);
}

TEST(HullToHull, TheTurnOfARoundLimbIsUncertain) {
  const HullToHull result = map_hull_to_hull(hull_map(limb(16, true, 0)), hull_map(limb(20, true, 0)));
  expect_one_to_one(result);
  const LoopShift& shift = *result.boundary.curves.at(0).shift;
  EXPECT_NEAR(*shift.rival_strain, *shift.strain, 0.02);
  ASSERT_EQ(result.warnings.size(), 1U);
  EXPECT_NE(result.warnings[0].find("how the boundary between 'p0' and 'p1' is turned is uncertain"),
            std::string::npos);
}

TEST(HullToHull, AnOblongLimbIsTurnedAsItDistortsLeast) {
  // Two centroids leave the turn about the line through them open: how the models lie says nothing of it.
  const SegmentedModel model = limb(16, false, 0), turned = limb(16, false, M_PI / 2);
  const HullToHull result = map_hull_to_hull(hull_map(model), hull_map(turned));
  expect_one_to_one(result);
  const LoopShift& shift = *result.boundary.curves.at(0).shift;
  EXPECT_GT(*shift.rival_strain, *shift.strain + 0.05);  // uncertain below 0.02
  EXPECT_TRUE(result.warnings.empty());
  for (const BoundaryPlacement& p : result.map.boundary) {
    const Vec3 place =
        (1 - p.fraction) * turned.mesh.point(p.target_a) + p.fraction * turned.mesh.point(p.target_b);
    EXPECT_LT((place - turned.mesh.point(p.source_vertex)).norm(), 0.05 * turned.mesh.diagonal());
  }
}

TEST(HullToHull, SliversAndTinyOpeningsAreOneToOneOrNamed) {
  constexpr double kTiny = 1e-6;
  const Vec3 aside(1, 0.2, 0.3);
  const HullMap round = hull_map(octant_model(tests::with_opening(tests::lumpy_sphere(5), aside, 0.5), 1));
  for (const TriMesh& mesh : {tests::with_flat_slivers(tests::cube(4), 3, kTiny),
                              tests::with_needles(tests::bumpy_sphere(4, 0.5), 4, kTiny)}) {
    const HullMap thin = hull_map(octant_model(tests::with_opening(mesh, aside, kTiny), 1));
    for (const HullToHull& result : {map_hull_to_hull(thin, round), map_hull_to_hull(round, thin)}) {
      for (const PartCrossing& part : result.parts) {
        EXPECT_NEAR(part.degree, 1, 1e-9);
        // Only a facet that has all its corners on the boundary can keep a fold.
        EXPECT_EQ(part.folds, part.locked_folds) << part.name;
        EXPECT_EQ(part.one_to_one, part.folds == 0) << part.name;
      }
    }
  }
}

TEST(HullToHull, ThePapersEnergyEndsOnTheHullWithItsBoundaryInPlace) {
  const HullMap source = hull_map(octant_model(tests::lumpy_sphere(7), 2));
  const HullMap target = hull_map(octant_model(tests::cube(6), 2));
  HullToHullOptions options;
  options.method = CrossMethod::energy;
  const HullToHull energy = map_hull_to_hull(source, target, options);
  const HullToHull pull = map_hull_to_hull(source, target);
  for (std::size_t k = 0; k < energy.map.images.size(); ++k) {
    const Points& images = energy.map.images[k];
    const double l = target.hulled.parts[k].mesh.diagonal();
    for (const double d : distances_to_hull(target.hulled.hulls[k], images)) EXPECT_LT(d, 1e-9 * l);
    for (const std::vector<int>& loop : energy.map.source_parts[k].loops) {
      for (const int v : loop) EXPECT_LT((images[v] - pull.map.images[k][v]).norm(), 1e-12 * l);
    }
    EXPECT_NEAR(energy.parts[k].degree, 1, 1e-9);
    EXPECT_LT(energy.parts[k].folds, 5);
  }
}

TEST(HullToHull, AFoldedHullMapIsRepaired) {
  const HullMap good = hull_map(octant_model(tests::lumpy_sphere(8), 1));
  HullMap folded = good;
  // A vertex far from the loop is thrown over its neighbours.
  const Part& part = folded.hulled.parts[0];
  int inner = 0;
  for (int v = 0; v < part.mesh.vertex_count(); ++v) {
    if (part.mesh.point(v).x() > part.mesh.point(inner).x()) inner = v;
  }
  const auto around = part.mesh.half_edges().cvv_begin(OpenMesh::VertexHandle(inner));
  Points& images = folded.images[0];
  images[inner] += 1.7 * (images[around->idx()] - images[inner]);
  const HullToHull result = map_hull_to_hull(folded, good);
  EXPECT_GT(result.parts[0].source_folds, 0);
  EXPECT_EQ(result.parts[0].folds, 0);
  EXPECT_NEAR(result.parts[0].degree, 1, 1e-9);
}

}  // namespace
}  // namespace partwise
