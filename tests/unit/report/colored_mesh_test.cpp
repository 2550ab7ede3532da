#include "report/colored_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "builders.h"
#include "convex_pairs.h"
#include "remeshing/reconstruct.h"
#include "report/color_map.h"

namespace partwise::report {
namespace {

CompatibleMesh sphere_on_bumps() {
  return reconstruct(tests::projected_pair(tests::whole(tests::sphere(6)),
                                           tests::whole(tests::bumpy_sphere(12, 0.4))))
      .mesh;
}

double lightness(const Rgb& color) {
  return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
}

TEST(Viridis, GetsLighterAllTheWay) {
  for (int i = 0; i < 100; ++i) EXPECT_LT(lightness(viridis(i / 100.0)), lightness(viridis((i + 2) / 100.0)));
  EXPECT_EQ(viridis(-3), viridis(0));
  EXPECT_EQ(viridis(7), viridis(1));
}

TEST(ColoredMesh, SaysWhichColoursStandForWhichNumbers) {
  const CompatibleMesh mesh = sphere_on_bumps();
  const io::PlyTables tables = colored_mesh(distortion_field(mesh));
  EXPECT_NE(tables.comments[1].find("at 4 and below"), std::string::npos);
  EXPECT_NE(tables.comments[1].find("at 40 and above, logarithmic"), std::string::npos);
  const auto quality = io::column<double>(tables, "vertex", "quality");
  const auto green = io::column<int>(tables, "vertex", "green");
  ASSERT_EQ(quality.size(), mesh.points.size());
  for (std::size_t v = 1; v < quality.size(); ++v) {
    EXPECT_GE(quality[v], 4 - 1e-9);
    if (quality[v] >= quality[v - 1]) {
      EXPECT_GE(green[v], green[v - 1]);
    }
  }
}

TEST(ColoredMesh, IsDrawnInItsColours) {
  SurfaceField field{"height", -1, 1, false, tests::sphere(4).points(), tests::sphere(4).facets(), {}};
  for (const Vec3& p : field.points) field.values.push_back(p.z());
  const Panel panel = colored_panel(colored_mesh(field));
  ASSERT_EQ(panel.colors.size(), field.facets.size());
  for (std::size_t f = 0; f < panel.facets.size(); ++f) {
    const auto& [a, b, c] = panel.facets[f];
    const double z = (field.values[a] + field.values[b] + field.values[c]) / 3;
    if (z > 0.8) {
      EXPECT_GT(panel.colors[f][0], 0.6F);
    }
    if (z < 0.5) {
      EXPECT_LT(panel.colors[f][0], 0.4F);
    }
  }
}

TEST(SurfaceField, DistancesAreLargestWhereTheMeshMissesTheTarget) {
  CompatibleMesh mesh = sphere_on_bumps();
  const SurfaceField before = distance_field(mesh);
  EXPECT_EQ(before.facets, mesh.target.facets());
  for (Vec3& p : mesh.points) p += Vec3(0, 0, 2);
  const SurfaceField after = distance_field(mesh);
  const auto lowest = std::min_element(mesh.target.points().begin(), mesh.target.points().end(),
                                       [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
  const auto v = lowest - mesh.target.points().begin();
  EXPECT_LT(before.values[v], 0.02);
  EXPECT_GT(after.values[v] * mesh.target.diagonal(), 1);
}

TEST(SurfaceField, AnIsometryHasNoDistortionAndNoFolds) {
  const TriMesh cube = tests::cube(3);
  CompatibleMesh mesh = reconstruct(tests::projected_pair(tests::whole(cube), tests::whole(cube))).mesh;
  for (const double value : distortion_field(mesh).values) EXPECT_NEAR(value, 4, 1e-9);
  for (const double value : fold_field(mesh).values) EXPECT_EQ(value, 0);
  std::swap(mesh.points[0], mesh.points[40]);
  const std::vector<double> folds = fold_field(mesh).values;
  EXPECT_GE(*std::max_element(folds.begin(), folds.end()), 1);
}

}  // namespace
}  // namespace partwise::report
