#include "report/pov_scene.h"

#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "builders.h"
#include "error.h"

namespace partwise::report {
namespace {

// All "<x,y,z>" between `begin` and `end`.
Points vectors_between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin);
  const std::string section = text.substr(from, text.find(end, from) - from);
  Points result;
  const std::regex triple("<([^,>]+),([^,>]+),([^,>]+)>");
  for (auto m = std::sregex_iterator(section.begin(), section.end(), triple); m != std::sregex_iterator();
       ++m) {
    result.emplace_back(std::stod((*m)[1]), std::stod((*m)[2]), std::stod((*m)[3]));
  }
  return result;
}

TEST(PovScene, FitsEveryPanelIntoItsCell) {
  const Panel panel = mesh_panel(tests::capsule(40, 12, 10));
  const std::string scene = pov_scene({panel, panel, panel}, {2, 400});
  const std::string last = scene.substr(scene.rfind("mesh2"));
  const Points points = vectors_between(last, "vertex_vectors", "texture_list");
  ASSERT_EQ(points.size(), panel.points.size());
  for (const Vec3& p : points) {  // third panel: second row, first column
    EXPECT_GT(p.x(), 0);
    EXPECT_LT(p.x(), 1);
    EXPECT_LT(p.y(), -0.86);
    EXPECT_GT(p.y(), -2 * 0.86);
  }
}

TEST(PovScene, SaysTheSizeOfThePicture) {
  const Panel panel = mesh_panel(tests::sphere(4));
  EXPECT_EQ(pov_scene({panel, panel, panel}, {2, 400}).substr(0, 15), "// +W400 +H344\n");
}

TEST(PovScene, KeepsQuotesOfCaptions) {
  Panel panel = mesh_panel(tests::tetrahedron());
  panel.caption = "a \"b\" \\ \n";
  EXPECT_NE(pov_scene({panel}, {}).find(R"(Caption("a \"b\" \\ ?",)"), std::string::npos);
}

TEST(PovScene, RefusesNothing) {
  EXPECT_THROW(pov_scene({}, {}), UsageError);
  EXPECT_THROW(pov_scene({mesh_panel(tests::tetrahedron())}, {0, 100}), UsageError);
  EXPECT_THROW(pov_scene({Panel{}}, {}), InputError);
}

}  // namespace
}  // namespace partwise::report
