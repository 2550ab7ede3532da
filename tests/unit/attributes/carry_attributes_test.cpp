#include "attributes/carry_attributes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "attributes/carry_texture.h"
#include "attributes/column_values.h"
#include "builders.h"
#include "deform/facet_correspondence.h"
#include "error.h"
#include "geometry/surface_index.h"
#include "io/stage_documents.h"

namespace partwise {
namespace {

Origins onto_itself(const TriMesh& mesh) {
  Origins origins{std::vector<SurfacePoint>(mesh.vertex_count()), {}};
  for (int f = 0; f < mesh.facet_count(); ++f) {
    std::vector<SurfacePoint>& samples = origins.facets.emplace_back();
    for (const Vec3& sample : facet_samples()) samples.push_back({f, sample});
    for (int i = 0; i < 3; ++i) origins.vertices[mesh.facet(f)[i]] = {f, Vec3::Unit(i)};
  }
  return origins;
}

/// Everything comes from the closest point of the giver.
Origins from_closest(const TriMesh& giver, const TriMesh& receiver) {
  const SurfaceIndex index(giver);
  Origins origins;
  for (const Vec3& point : receiver.points()) origins.vertices.push_back(index.closest(point).point);
  for (int f = 0; f < receiver.facet_count(); ++f) {
    std::vector<SurfacePoint>& samples = origins.facets.emplace_back();
    for (const Vec3& sample : facet_samples()) {
      samples.push_back(index.closest(position(receiver, {f, sample})).point);
    }
  }
  return origins;
}

/// A mesh as tables, to add columns to.
io::PlyTables tables_of(const TriMesh& mesh) {
  return io::to_document(mesh).tables;
}

template <class T, class Function>
io::Property column_of(const std::string& name, int rows, Function value) {
  std::vector<T> values;
  values.reserve(rows);
  for (int row = 0; row < rows; ++row) values.push_back(static_cast<T>(value(row)));
  return io::scalar_column(name, std::move(values));
}

const io::Property* find(const std::vector<io::Property>& columns, const std::string& name) {
  for (const io::Property& column : columns) {
    if (column.name == name) return &column;
  }
  return nullptr;
}

TEST(CarryAttributes, OntoItselfNothingChanges) {
  const TriMesh mesh = tests::bumpy_sphere(4, 0.2);
  const int vertices = mesh.vertex_count(), facets = mesh.facet_count();
  io::PlyTables tables = tables_of(mesh);
  auto& of_vertex = tables.elements[0].properties;
  auto& of_face = tables.elements[1].properties;
  of_vertex.push_back(column_of<float>("heat", vertices, [](int v) { return 0.25 * v; }));
  of_vertex.push_back(column_of<std::uint8_t>("red", vertices, [](int v) { return v; }));
  of_vertex.push_back(column_of<int>("label", vertices, [](int v) { return v % 7; }));
  of_vertex.push_back(io::list_column("tags", std::vector<std::int16_t>(2 * vertices, 3), 2));
  for (int k = 0; k < 2; ++k) {
    of_vertex.push_back(
        column_of<std::uint16_t>("joint_" + std::to_string(k), vertices, [&](int v) { return 2 * v + k; }));
    of_vertex.push_back(
        column_of<float>("weight_" + std::to_string(k), vertices, [&](int) { return k == 0 ? 0.75 : 0.25; }));
  }
  of_vertex.push_back(column_of<float>("nx", vertices, [](int) { return 1; }));
  of_face.push_back(column_of<int>("part", facets, [](int f) { return f / 10; }));
  of_face.push_back(column_of<double>("area", facets, [](int f) { return 0.5 * f; }));
  std::vector<float> places(6 * facets);
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = static_cast<float>(i);
  of_face.push_back(io::list_column("texcoord", places, 6));
  of_face.push_back(column_of<int>("texnumber", facets, [](int f) { return f % 2; }));
  const CarriedAttributes carried = carry_attributes(tables, mesh, mesh, onto_itself(mesh));
  EXPECT_EQ(carried.vertex.size(), 8U);
  EXPECT_EQ(carried.face.size(), 4U);
  for (const auto* columns : {&carried.vertex, &carried.face}) {
    for (const io::Property& column : *columns) {
      const io::Property* given = tables.elements[columns == &carried.face].find(column.name);
      ASSERT_NE(given, nullptr) << column.name;
      EXPECT_EQ(column.type(), given->type()) << column.name;
      EXPECT_EQ(column.offsets, given->offsets) << column.name;
      const auto a = io::numbers_of(column.values), b = io::numbers_of(given->values);
      ASSERT_EQ(a.size(), b.size()) << column.name;
      for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-3) << column.name << " " << i;
    }
  }
}

TEST(CarryAttributes, RealNumbersAreInterpolated) {
  const TriMesh giver = tests::sphere(6), receiver = tests::sphere(9);
  const Origins origins = from_closest(giver, receiver);
  io::PlyTables tables = tables_of(giver);
  const auto value = [](const Vec3& p) { return 1 + 2 * p.x() - 3 * p.y() + p.z(); };
  tables.elements[0].properties.push_back(
      column_of<double>("value", giver.vertex_count(), [&](int v) { return value(giver.point(v)); }));
  const CarriedAttributes carried = carry_attributes(tables, giver, receiver, origins);
  const auto values = io::numbers_of(carried.vertex.at(0).values);
  for (int v = 0; v < receiver.vertex_count(); ++v) {
    EXPECT_NEAR(values[v], value(position(giver, origins.vertices[v])), 1e-12);
  }
}

TEST(CarryAttributes, LabelsAreNeverMixed) {
  const TriMesh giver = tests::sphere(6), receiver = tests::sphere(9);
  io::PlyTables tables = tables_of(giver);
  const auto side = [](double z) { return z > 0.01 ? 9 : 2; };
  tables.elements[0].properties.push_back(
      column_of<int>("label", giver.vertex_count(), [&](int v) { return side(giver.point(v).z()); }));
  tables.elements[1].properties.push_back(column_of<std::int8_t>("part", giver.facet_count(), [&](int f) {
    const auto& [a, b, c] = giver.facet(f);
    return side(giver.point(a).z() + giver.point(b).z() + giver.point(c).z());
  }));
  const CarriedAttributes carried = carry_attributes(tables, giver, receiver, from_closest(giver, receiver));
  for (const double label : io::numbers_of(carried.vertex.at(0).values))
    EXPECT_TRUE(label == 2 || label == 9);
  const auto parts = io::numbers_of(carried.face.at(0).values);
  for (int f = 0; f < receiver.facet_count(); ++f) {
    const double z = position(receiver, {f, Vec3::Constant(1.0 / 3)}).z();
    if (std::abs(z) < 0.1) continue;
    EXPECT_EQ(parts[f], side(z)) << "facet " << f;
  }
}

TEST(CarryAttributes, SkinningWeightsFollowTheirJoints) {
  const TriMesh mesh = tests::tetrahedron();
  io::PlyTables tables = tables_of(mesh);
  auto& columns = tables.elements[0].properties;
  // The same two joints, in other places at vertex 1; a third one at vertex 2.
  columns.push_back(io::scalar_column("joint_0", std::vector<std::uint16_t>{5, 8, 5, 5}));
  columns.push_back(io::scalar_column("weight_0", std::vector<float>{0.75F, 0.5F, 0.5F, 1}));
  columns.push_back(io::scalar_column("joint_1", std::vector<std::uint16_t>{8, 5, 1, 0}));
  columns.push_back(io::scalar_column("weight_1", std::vector<float>{0.25F, 0.5F, 0.5F, 0}));
  Origins origins = onto_itself(mesh);
  SurfacePoint& middle = origins.vertices[0];
  middle = {0, Vec3::Zero()};
  for (int i = 0; i < 3; ++i) {
    const int v = mesh.facet(0)[i];
    middle.barycentric[i] = v < 2 ? 0.5 : 0;  // half-way between vertices 0 and 1
  }
  ASSERT_NEAR(middle.barycentric.sum(), 1, 1e-12);
  const CarriedAttributes carried = carry_attributes(tables, mesh, mesh, origins);
  EXPECT_EQ(io::numbers_of(find(carried.vertex, "joint_0")->values)[0], 5);
  EXPECT_NEAR(io::numbers_of(find(carried.vertex, "weight_0")->values)[0], 0.625, 1e-6);
  EXPECT_EQ(io::numbers_of(find(carried.vertex, "joint_1")->values)[0], 8);
  EXPECT_NEAR(io::numbers_of(find(carried.vertex, "weight_1")->values)[0], 0.375, 1e-6);
}

TEST(CarryAttributes, SkinningListsKeepTheirSum) {
  const TriMesh giver = tests::sphere(4), receiver = tests::sphere(7);
  io::PlyTables tables = tables_of(giver);
  const int count = giver.vertex_count();
  std::vector<int> joints;
  std::vector<double> weights;
  for (int v = 0; v < count; ++v) {
    joints.insert(joints.end(), {v % 5, 5 + v % 3});
    weights.insert(weights.end(), {0.4, 0.6});
  }
  tables.elements[0].properties.push_back(io::list_column("bones", joints, 2));
  tables.elements[0].properties.push_back(io::list_column("weights", weights, 2));
  const CarriedAttributes carried = carry_attributes(tables, giver, receiver, from_closest(giver, receiver));
  const io::Property& found = *find(carried.vertex, "weights");
  const auto values = io::numbers_of(found.values);
  for (int v = 0; v < receiver.vertex_count(); ++v) {
    ASSERT_LE(found.offsets[v + 1] - found.offsets[v], 2U);
    double sum = 0;
    for (std::size_t i = found.offsets[v]; i < found.offsets[v + 1]; ++i) sum += values[i];
    EXPECT_NEAR(sum, 1, 1e-12);
  }
}

TEST(CarryTexture, NoFacetSpreadsOverASeam) {
  const TriMesh giver = tests::sphere(12), receiver = tests::sphere(9);
  const TextureCorners given = tests::cylindrical_texture(giver);
  const TextureCorners carried = carry_texture(given, giver, receiver, from_closest(giver, receiver));
  for (int f = 0; f < receiver.facet_count(); ++f) {
    double least = 9, most = -9;
    bool at_pole = false;
    for (int i = 0; i < 3; ++i) {
      const Vec3& p = receiver.point(receiver.facet(f)[i]);
      at_pole = at_pole || std::hypot(p.x(), p.y()) < 0.3;
      least = std::min(least, carried.places[f][2 * i]);
      most = std::max(most, carried.places[f][2 * i]);
      EXPECT_NEAR(carried.places[f][2 * i + 1], p.z(), 0.05);
    }
    if (at_pole) continue;
    EXPECT_LT(most - least, 0.2) << "facet " << f;
    for (int i = 0; i < 3; ++i) {
      const Vec3& p = receiver.point(receiver.facet(f)[i]);
      const double u = std::atan2(p.y(), p.x()) / (2 * std::numbers::pi) + 0.5;
      // Exact but where the facet lies across the seam: there a corner stops at it.
      EXPECT_LT(std::abs(std::remainder(carried.places[f][2 * i] - u, 1.0)), 0.06) << "facet " << f;
    }
  }
}

TEST(CarryAttributes, OnlyWhatIsAskedFor) {
  const TriMesh mesh = tests::sphere(3);
  io::PlyTables tables = tables_of(mesh);
  tables.elements[0].properties.push_back(
      column_of<float>("heat", mesh.vertex_count(), [](int) { return 1; }));
  tables.elements[1].properties.push_back(column_of<int>("part", mesh.facet_count(), [](int) { return 1; }));
  const CarriedAttributes carried = carry_attributes(tables, mesh, mesh, onto_itself(mesh), {"part"});
  EXPECT_TRUE(carried.vertex.empty());
  EXPECT_EQ(carried.face.size(), 1U);
  for (const char* missing : {"colour", "x"}) {
    try {
      carry_attributes(tables, mesh, mesh, onto_itself(mesh), {missing});
      FAIL() << missing;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("heat, part"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace partwise
