// What we write must be read alike by the programs people use.
#include <CGAL/IO/PLY.h>
#include <CGAL/Simple_cartesian.h>
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "builders.h"
#include "io/document.h"
#include "io/stage_documents.h"

namespace partwise::io {
namespace {

/// A document with further elements, as stages write it: viewers must see vertex and face and no more.
class OtherReaders : public testing::Test {
 protected:
  void SetUp() override {
    folder = std::filesystem::temp_directory_path() / ("partwise-readers-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    path = (folder / "a.ply").string();
    Document document = to_document(mesh);
    const int count = mesh.facet_count();
    document.tables.elements[1].properties.push_back(scalar_column("part", std::vector<int>(count, 3)));
    document.tables.elements.push_back({"extra", 2, {scalar_column("value", std::vector<double>{1, 2})}});
    document.tables.elements.push_back({"lists", 1, {list_column("items", std::vector<int>{1, 2, 3}, 3)}});
    write_document(path, document, false);
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  TriMesh mesh = tests::bumpy_sphere(5, 0.2);
  std::filesystem::path folder;
  std::string path;
};

TEST_F(OtherReaders, Cgal) {
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  ASSERT_TRUE(CGAL::IO::read_PLY(path, points, polygons));
  ASSERT_EQ(points.size(), mesh.points().size());
  ASSERT_EQ(polygons.size(), mesh.facets().size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    EXPECT_EQ(Vec3(points[v].x(), points[v].y(), points[v].z()), mesh.points()[v]);
  }
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    EXPECT_EQ((Facet{int(polygons[f][0]), int(polygons[f][1]), int(polygons[f][2])}), mesh.facets()[f]);
  }
}

TEST_F(OtherReaders, OpenMesh) {
  OpenMesh::TriMesh_ArrayKernelT<> read;
  ASSERT_TRUE(OpenMesh::IO::read_mesh(read, path));
  ASSERT_EQ(read.n_vertices(), mesh.points().size());
  ASSERT_EQ(read.n_faces(), mesh.facets().size());
  for (const auto vertex : read.vertices()) {
    const auto p = read.point(vertex);
    EXPECT_LT((Vec3(p[0], p[1], p[2]) - mesh.point(vertex.idx())).norm(), 1e-6);
  }
}

TEST_F(OtherReaders, Assimp) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path, 0);
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  ASSERT_EQ(scene->mNumMeshes, 1U);
  ASSERT_EQ(scene->mMeshes[0]->mNumFaces, mesh.facets().size());
  for (unsigned f = 0; f < scene->mMeshes[0]->mNumFaces; ++f) {
    const aiFace& face = scene->mMeshes[0]->mFaces[f];
    ASSERT_EQ(face.mNumIndices, 3U);
    for (unsigned i = 0; i < 3; ++i) {
      const aiVector3D& p = scene->mMeshes[0]->mVertices[face.mIndices[i]];
      EXPECT_LT((Vec3(p.x, p.y, p.z) - mesh.point(mesh.facets()[f][i])).norm(), 1e-6);
    }
  }
}

}  // namespace
}  // namespace partwise::io
