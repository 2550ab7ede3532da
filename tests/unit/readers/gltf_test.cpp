// Animations that we write, as other programs read them.
#include "io/gltf.h"

#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <sstream>

#include "builders.h"

namespace partwise::io {
namespace {

class Gltf : public testing::Test {
 protected:
  const aiScene* read(const ShapeAnimation& animation) {
    std::ostringstream out;
    write_glb(out, animation);
    const std::string bytes = out.str();
    return importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, "glb");
  }

  /// The shape at one moment as a viewer makes it: weights between keys are interpolated, targets mixed.
  static Points shape_at(const aiScene& scene, double time) {
    const aiMesh& mesh = *scene.mMeshes[0];
    const aiMeshMorphAnim& channel = *scene.mAnimations[0]->mMorphMeshChannels[0];
    unsigned key = 0;
    while (key + 2 < channel.mNumKeys && channel.mKeys[key + 1].mTime <= time) ++key;
    const aiMeshMorphKey &from = channel.mKeys[key], &to = channel.mKeys[key + 1];
    const double share = (time - from.mTime) / (to.mTime - from.mTime);
    Points points;
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const auto vector = [](const aiVector3D& a) { return Vec3(a.x, a.y, a.z); };
      const Vec3 rest = vector(mesh.mVertices[v]);
      points.push_back(rest);
      for (unsigned i = 0; i < mesh.mNumAnimMeshes; ++i) {
        const double weight = (1 - share) * from.mWeights[i] + share * to.mWeights[i];
        points.back() += weight * (vector(mesh.mAnimMeshes[i]->mVertices[v]) - rest);
      }
    }
    return points;
  }

  static void expect_equal(const Points& found, const Points& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t v = 0; v < found.size(); ++v) EXPECT_LT((found[v] - expected[v]).norm(), 1e-6);
  }

  const TriMesh mesh = tests::bumpy_sphere(4, 0.2);
  Assimp::Importer importer;
};

TEST_F(Gltf, PlaysTheFramesInTurn) {
  ShapeAnimation animation{"bumps", mesh.facets(), {}, {"a", "b", "c"}};
  animation.frames = {mesh.points(), tests::sphere(4).points(), tests::bumpy_sphere(4, 0.4).points()};
  animation.seconds = 3;
  const aiScene* scene = read(animation);
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  ASSERT_EQ(scene->mNumMeshes, 1U);
  ASSERT_EQ(scene->mMeshes[0]->mNumAnimMeshes, 2U);
  ASSERT_EQ(scene->mMeshes[0]->mNumFaces, mesh.facets().size());
  for (unsigned f = 0; f < scene->mMeshes[0]->mNumFaces; ++f) {
    const aiFace& face = scene->mMeshes[0]->mFaces[f];
    for (int i = 0; i < 3; ++i) EXPECT_EQ(face.mIndices[i], unsigned(mesh.facets()[f][i]));
  }
  ASSERT_EQ(scene->mNumAnimations, 1U);
  ASSERT_EQ(scene->mAnimations[0]->mNumMorphMeshChannels, 1U);
  const double last = scene->mAnimations[0]->mMorphMeshChannels[0]->mKeys[2].mTime;
  EXPECT_NEAR(last / scene->mAnimations[0]->mTicksPerSecond, 3, 1e-6);
  expect_equal(shape_at(*scene, 0), animation.frames[0]);
  expect_equal(shape_at(*scene, last / 2), animation.frames[1]);
  expect_equal(shape_at(*scene, last), animation.frames[2]);
  Points between = animation.frames[1];
  for (std::size_t v = 0; v < between.size(); ++v) between[v] = (between[v] + animation.frames[2][v]) / 2;
  expect_equal(shape_at(*scene, 0.75 * last), between);
}

TEST_F(Gltf, NormalsAreThoseOfTheShape) {
  ShapeAnimation animation{"ball", mesh.facets(), {tests::sphere(4).points()}, {"a"}};
  const aiScene* scene = read(animation);
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  ASSERT_TRUE(scene->mMeshes[0]->HasNormals());
  for (unsigned v = 0; v < scene->mMeshes[0]->mNumVertices; ++v) {
    const aiVector3D n = scene->mMeshes[0]->mNormals[v];
    EXPECT_GT(Vec3(n.x, n.y, n.z).dot(animation.frames[0][v]), 0.95);
  }
  EXPECT_EQ(scene->mNumAnimations, 0U);
}

TEST_F(Gltf, HasColoursAndTextureCoordinates) {
  ShapeAnimation animation{"ball", mesh.facets(), {mesh.points()}, {"a"}};
  animation.colours.assign(mesh.vertex_count(), {255, 0, 128});
  animation.texture.emplace().places.assign(mesh.facet_count(), {0.25, 0.75, 0.25, 0.75, 0.25, 0.75});
  const aiScene* scene = read(animation);
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  ASSERT_TRUE(scene->mMeshes[0]->HasVertexColors(0));
  const aiColor4D colour = scene->mMeshes[0]->mColors[0][5];
  EXPECT_NEAR(colour.r, 1, 1e-6);
  EXPECT_NEAR(colour.g, 0, 1e-6);
  EXPECT_NEAR(colour.b, 0.2158605, 1e-5);  // linear light of sRGB 128
  ASSERT_TRUE(scene->mMeshes[0]->HasTextureCoords(0));
  EXPECT_NEAR(scene->mMeshes[0]->mTextureCoords[0][5].x, 0.25, 1e-6);
  EXPECT_NEAR(scene->mMeshes[0]->mTextureCoords[0][5].y, 0.75, 1e-6);  // assimp turns v upward again
}

TEST_F(Gltf, SeamsAreCutWithoutATrace) {
  ShapeAnimation animation{"ball", mesh.facets(), {mesh.points(), tests::sphere(4).points()}, {"a", "b"}};
  animation.texture = tests::cylindrical_texture(mesh);
  animation.seconds = 1;
  const aiScene* scene = read(animation);
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  const aiMesh& found = *scene->mMeshes[0];
  ASSERT_EQ(found.mNumFaces, mesh.facets().size());
  EXPECT_GT(found.mNumVertices, mesh.points().size());
  const Points end = shape_at(*scene, scene->mAnimations[0]->mDuration);
  for (int f = 0; f < mesh.facet_count(); ++f) {
    for (int i = 0; i < 3; ++i) {
      const unsigned v = found.mFaces[f].mIndices[i];
      const Eigen::Vector2d place(found.mTextureCoords[0][v].x, found.mTextureCoords[0][v].y);
      EXPECT_LT((place - animation.texture->place(f, i)).norm(), 2e-6);
      const int own = mesh.facet(f)[i];
      EXPECT_LT((end[v] - animation.frames[1][own]).norm(), 1e-6) << "the seam opens";
      const auto normal = [&](unsigned vertex) {
        return Vec3(found.mNormals[vertex].x, found.mNormals[vertex].y, found.mNormals[vertex].z);
      };
      EXPECT_EQ(normal(v), normal(own)) << "the seam shows in the light";
    }
  }
}

TEST_F(Gltf, TheUpwardAxisTurns) {
  ShapeAnimation animation{"ball", mesh.facets(), {mesh.points()}, {"a"}};
  animation.z_is_up = true;
  const aiScene* scene = read(animation);
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  const aiNode* node = scene->mRootNode;
  aiVector3D up(0, 0, 1);
  up *= node->mTransformation;
  for (const aiNode* child = node; child->mNumChildren > 0 && up.z > 0.5F;) {
    child = child->mChildren[0];
    up *= child->mTransformation;
  }
  EXPECT_NEAR(up.y, 1, 1e-6);
}

}  // namespace
}  // namespace partwise::io
