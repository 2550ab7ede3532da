#include "io/mesh_files.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "builders.h"
#include "error.h"
#include "mesh/tri_mesh.h"

namespace partwise::io {
namespace {

template <class Read>
ImportedMesh parsed(Read&& read, const std::string& text) {
  std::istringstream in(text);
  return read(in);
}

template <class Read>
std::string fault(Read&& read, const std::string& text) {
  try {
    parsed(read, text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

class MeshFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder = std::filesystem::temp_directory_path() / ("partwise-meshes-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
  }
  void TearDown() override { std::filesystem::remove_all(folder); }
  std::string path(const std::string& name) const { return (folder / name).string(); }
  std::filesystem::path folder;
};

TEST_F(MeshFiles, TextFormatsAndPlyKeepEveryBitAndTheOrder) {
  const TriMesh mesh = tests::bumpy_sphere(6, 0.3);
  for (const char* name : {"a.obj", "a.off", "a.OFF"}) {
    export_mesh(path(name), mesh.points(), mesh.facets(), true);
    const ImportedMesh back = import_mesh(path(name));
    EXPECT_EQ(back.points, mesh.points()) << name;
    EXPECT_EQ(back.facets, mesh.facets()) << name;
    EXPECT_EQ(back.polygons, 0);
    EXPECT_TRUE(back.ignored.empty());
  }
  export_mesh(path("a.ply"), mesh.points(), mesh.facets(), false);
  std::ifstream in(path("a.ply"), std::ios::binary);
  const ImportedMesh back = import_ply(read_ply(in));
  EXPECT_EQ(back.points, mesh.points());
  EXPECT_EQ(back.facets, mesh.facets());
  EXPECT_THROW(export_mesh(path("a.ply"), mesh.points(), mesh.facets(), false), IoError);
  EXPECT_THROW(export_mesh(path("a.doc"), mesh.points(), mesh.facets(), false), UsageError);
}

TEST_F(MeshFiles, StlComesBackAsTheSameSurface) {
  const TriMesh mesh = tests::torus(2, 1, 12, 8);
  export_mesh(path("a.stl"), mesh.points(), mesh.facets(), false);
  const ImportedMesh back = import_mesh(path("a.stl"));
  ASSERT_EQ(back.points.size(), mesh.points().size());
  ASSERT_EQ(back.facets.size(), mesh.facets().size());
  EXPECT_EQ(back.merged_vertices, static_cast<long>(3 * mesh.facets().size() - mesh.points().size()));
  for (int f = 0; f < mesh.facet_count(); ++f) {
    for (int corner = 0; corner < 3; ++corner) {
      EXPECT_LT((back.points[back.facets[f][corner]] - mesh.point(mesh.facet(f)[corner])).norm(), 1e-6);
    }
  }
  EXPECT_NO_THROW(TriMesh(back.points, back.facets));
}

TEST(Obj, ReadsWhatOthersWrite) {
  const ImportedMesh mesh = parsed(read_obj,
                                   "# comment\r\nmtllib a.mtl\r\nv 0 0 0 1.0\r\nv 1 0 0\r\nv +1. 1e0 0\r\n"
                                   "vt 0 0\nvn 0 0 1\ng group\nusemtl x\nf 1/1/1 2/1 3//1\nv 0 1 0 # late\n"
                                   "f -4 -2 \\\n -1\n");
  EXPECT_EQ(mesh.points, (Points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  EXPECT_EQ(mesh.facets, (Facets{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(mesh.ignored.size(), 3U);
  EXPECT_EQ(mesh.bare_facets, 2);
}

TEST(Obj, TextureCoordinatesStayWithTheirCorners) {
  // A quadrilateral that is cut, and a triangle on another image with places of its own: a seam.
  const ImportedMesh mesh = parsed(read_obj,
                                   "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nusemtl fur\n"
                                   "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.5 0.25 0\n"
                                   "f 1/1 2/2 3/3 4/4\nusemtl nose\nf 2/6 5/5 3/-1\nvt 0.75\n");
  EXPECT_EQ(mesh.bare_facets, 0);
  ASSERT_TRUE(mesh.texture);
  ASSERT_EQ(mesh.facets.size(), 3U);
  for (int f = 0; f < 2; ++f) {
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(mesh.texture->place(f, i), mesh.points[mesh.facets[f][i]].head<2>());
    }
  }
  EXPECT_EQ(mesh.texture->place(2, 0), Eigen::Vector2d(0.75, 0));
  EXPECT_EQ(mesh.texture->place(2, 1), Eigen::Vector2d(0.5, 0.25));
  EXPECT_EQ(mesh.texture->place(2, 2), Eigen::Vector2d(0.5, 0.25));
  EXPECT_EQ(mesh.texture->images, (std::vector<int>{0, 0, 1}));
  EXPECT_FALSE(parsed(read_obj, "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nf 1 2 3\n").texture);
}

TEST_F(MeshFiles, ObjAndPlyKeepTheTexture) {
  const TriMesh mesh = tests::bumpy_sphere(6, 0.3);
  const TextureCorners texture = tests::cylindrical_texture(mesh);
  for (const std::string name : {"t.obj", "t.ply"}) {
    export_mesh(path(name), mesh.points(), mesh.facets(), true, texture);
    std::ifstream file(path(name), std::ios::binary);
    const ImportedMesh back = name == "t.ply" ? import_ply(read_ply(file)) : import_mesh(path(name));
    EXPECT_EQ(back.facets, mesh.facets());
    EXPECT_EQ(back.ignored, std::vector<std::string>{});
    ASSERT_TRUE(back.texture) << name;
    EXPECT_TRUE(back.texture->images.empty());
    for (int f = 0; f < mesh.facet_count(); ++f) {
      for (int i = 0; i < 6; ++i) EXPECT_NEAR(back.texture->places[f][i], texture.places[f][i], kTextureJump);
    }
  }
}

TEST(Obj, NamesFaultyTextureCoordinates) {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
  EXPECT_NE(fault(read_obj, "vt x 1\n").find("line 1: vt needs a number"), std::string::npos);
  EXPECT_NE(fault(read_obj, "vt 1 x\n").find("line 1"), std::string::npos);
  EXPECT_NE(fault(read_obj, "vt nan 0\n").find("line 1"), std::string::npos);
  EXPECT_NE(fault(read_obj, three + "f 1/0 2 3\n").find("line 4: \"0\" is no texture coordinate"),
            std::string::npos);
  EXPECT_NE(
      fault(read_obj, three + "vt 0 0\nf 1/1 2/1 3/2\n").find("facet 0 names texture coordinate 2 of 1"),
      std::string::npos);
}

TEST(Obj, NamesTheFaultyLine) {
  EXPECT_NE(fault(read_obj, "v 0 0\n").find("line 1"), std::string::npos);
  EXPECT_NE(fault(read_obj, "v 0 0 0\nf 0 1 1\n").find("line 2"), std::string::npos);
  EXPECT_NE(fault(read_obj, "v 0 0 0\n\nf 1 x 1\n").find("line 3: \"x\""), std::string::npos);
  EXPECT_NE(fault(read_obj, "v 0 0 0\nf -2 1 1\n").find("before the first"), std::string::npos);
  EXPECT_NE(fault(read_obj, "v 0 0 0\nf 1 1\n").find("three corners"), std::string::npos);
  EXPECT_NE(fault(read_obj, "v 0 0 0\nf 1 1 1 9\n").find("line 2: names vertex 8"), std::string::npos);
}

TEST(Off, ReadsVariants) {
  const std::string body = "0 0 0\n1 0 0\n\n0 1 0 # corner\n3 0 1 2 255 0 0\n";
  for (const std::string head :
       {"OFF\n3 1 0\n", "OFF 3 1 0\n", "# first\nOFF\n# second\n3 1\n", "OFF\r\n3 1 3\r\n"}) {
    const ImportedMesh mesh = parsed(read_off, head + body);
    EXPECT_EQ(mesh.points.size(), 3U);
    EXPECT_EQ(mesh.facets, (Facets{{0, 1, 2}}));
  }
  EXPECT_EQ(parsed(read_off, "COFF\n3 1 0\n0 0 0 9 9 9\n1 0 0 9 9 9\n0 1 0 9 9 9\n3 0 1 2\n").points.size(),
            3U);
}

TEST(Off, NamesTheFault) {
  EXPECT_NE(fault(read_off, "").find("no data"), std::string::npos);
  EXPECT_NE(fault(read_off, "ply\n").find("line 1"), std::string::npos);
  EXPECT_NE(fault(read_off, "OFF\n3 x 0\n").find("line 2"), std::string::npos);
  EXPECT_NE(fault(read_off, "OFF\n-3 1 0\n").find("line 2"), std::string::npos);
  EXPECT_NE(fault(read_off, "OFF\n999999999999 1 0\n0 0 0\n").find("vertex 1 of 999999999999"),
            std::string::npos);
  EXPECT_NE(fault(read_off, "OFF\n1 1 0\n0 0 0\n3 0 0\n").find("line 4"), std::string::npos);
  EXPECT_NE(fault(read_off, "OFF\n1 0 0\n0 0 0\n3 0 0 0\n").find("line 4: follows"), std::string::npos);
}

TEST(Stl, ReadsTextAndRefusesDamage) {
  std::string text = "solid a b\n";
  for (const char* corners :
       {"vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n", "vertex 1 0 0\nvertex 1 1 0\nvertex -0 1 0\n"}) {
    text += std::string(" facet normal 0 0 1\n  outer loop\n") + corners + "  endloop\n endfacet\n";
  }
  const ImportedMesh mesh = parsed(read_stl, text + "endsolid a b\n");
  EXPECT_EQ(mesh.facets, (Facets{{0, 1, 2}, {1, 3, 2}}));
  EXPECT_EQ(mesh.merged_vertices, 2);
  EXPECT_NE(fault(read_stl, text).find("truncated"), std::string::npos);
  EXPECT_NE(fault(read_stl, "solid\nvertex 1 2\n").find("line 2"), std::string::npos);
  EXPECT_NE(fault(read_stl, std::string(80, ' ') + "\x01").find("truncated"), std::string::npos);
  EXPECT_NE(fault(read_stl, std::string(80, ' ') + std::string("\xff\xff\xff\xff", 4)).find("facet 0"),
            std::string::npos);
}

TEST(MeshReaders, RandomDamageNeverCrashes) {
  std::mt19937 random(77);
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 -1 2\n";
  const std::string off = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 0 1 2\n";
  std::string stl(84 + 50, '\1');
  stl[80] = 1;
  stl[81] = stl[82] = stl[83] = 0;
  const auto damage = [&](std::string text, auto&& read) {
    for (int round = 0; round < 3000; ++round) {
      std::string damaged = text.substr(0, 1 + random() % text.size());
      for (unsigned flips = random() % 4; flips > 0; --flips) {
        damaged[random() % damaged.size()] ^= static_cast<char>(1U << (random() % 8));
      }
      fault(read, damaged);
    }
  };
  damage(obj, read_obj);
  damage(off, read_off);
  damage(stl, read_stl);
}

TEST(ForeignPly, PolygonsKeepTheirTexture) {
  PlyTables tables;
  tables.elements = {{"vertex",
                      4,
                      {scalar_column("x", std::vector<float>{0, 1, 1, 0}),
                       scalar_column("y", std::vector<float>{0, 0, 1, 1}),
                       scalar_column("z", std::vector<float>{0, 0, 0, 0})}},
                     {"face",
                      1,
                      {list_column("vertex_indices", std::vector<int>{0, 1, 2, 3}, 4),
                       list_column("texcoord", std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1}, 8),
                       scalar_column("texnumber", std::vector<std::uint8_t>{2})}}};
  const ImportedMesh mesh = import_ply(tables);
  ASSERT_TRUE(mesh.texture);
  EXPECT_TRUE(mesh.ignored.empty());
  EXPECT_EQ(mesh.texture->images, (std::vector<int>{2, 2}));
  for (int f = 0; f < 2; ++f) {
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(mesh.texture->place(f, i), mesh.points[mesh.facets[f][i]].head<2>());
    }
  }
  tables.elements[1].properties[1] = list_column("texcoord", std::vector<float>{0, 0, 1, 0, 1, 1}, 6);
  EXPECT_THROW(import_ply(tables), InputError);
}

TEST(ForeignPly, TakesFloatsPolygonsAndNamesWhatItIgnores) {
  PlyTables tables;
  tables.elements = {{"vertex",
                      4,
                      {scalar_column("x", std::vector<float>{0, 1, 1, 0}),
                       scalar_column("y", std::vector<float>{0, 0, 1, 1}),
                       scalar_column("z", std::vector<std::int16_t>{0, 0, 0, 0}),
                       scalar_column("red", std::vector<std::uint8_t>{1, 2, 3, 4})}},
                     {"face", 1, {list_column("vertex_index", std::vector<std::uint32_t>{0, 1, 2, 3}, 4)}},
                     {"edge", 1, {scalar_column("length", std::vector<double>{1})}}};
  const ImportedMesh mesh = import_ply(tables);
  EXPECT_EQ(mesh.polygons, 1);
  EXPECT_EQ(mesh.facets.size(), 2U);
  EXPECT_EQ(mesh.ignored, (std::vector<std::string>{"vertex property red", "edge property length"}));
  tables.elements[1].properties[0].name = "corners";
  EXPECT_THROW(import_ply(tables), InputError);
  tables.elements.resize(1);
  EXPECT_THROW(import_ply(tables), InputError);
}

}  // namespace
}  // namespace partwise::io
