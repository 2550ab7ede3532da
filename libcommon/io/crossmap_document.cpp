#include <algorithm>
#include <set>
#include <utility>

#include "io/domain_tables.h"
#include "io/model_tables.h"
#include "io/stage_documents.h"
#include "io/table_builder.h"
#include "io/table_reader.h"

namespace partwise::io {
namespace {

const ModelElements kSourceElements{"source_vertex", "source_face", "source_curve"};
const ModelElements kTargetElements{"target_vertex", "target_face", "target_curve"};

Element boundary_element(const std::vector<BoundaryPlacement>& boundary) {
  std::vector<int> source_vertices, a, b;
  std::vector<double> fractions;
  for (const BoundaryPlacement& placement : boundary) {
    source_vertices.push_back(placement.source_vertex);
    a.push_back(placement.target_a);
    b.push_back(placement.target_b);
    fractions.push_back(placement.fraction);
  }
  return ElementBuilder("boundary_vertex", boundary.size())
      .integers("source_vertex", source_vertices)
      .integers("target_a", a)
      .integers("target_b", b)
      .numbers("fraction", fractions)
      .build();
}

/// Edges of all boundary curves, and every curve vertex as an edge from itself to itself.
std::set<std::pair<int, int>> curve_edges(const Segmentation& segmentation) {
  std::set<std::pair<int, int>> edges;
  for (const BoundaryCurve& curve : segmentation.curves) {
    const std::size_t count = curve.vertices.size();
    for (std::size_t i = 0; i < count; ++i) {
      const int a = curve.vertices[i];
      edges.insert({a, a});
      if (i + 1 < count || curve.closed) edges.insert(std::minmax(a, curve.vertices[(i + 1) % count]));
    }
  }
  return edges;
}

std::vector<BoundaryPlacement> read_boundary(const PlyTables& tables, const SegmentedModel& source,
                                             const SegmentedModel& target) {
  const ElementReader table(tables, "boundary_vertex");
  const auto source_vertices = table.integers("source_vertex", 0, source.mesh.vertex_count() - 1);
  const auto a = table.integers("target_a", 0, target.mesh.vertex_count() - 1);
  const auto b = table.integers("target_b", 0, target.mesh.vertex_count() - 1);
  const auto fractions = table.numbers("fraction", 0, 1);
  const auto source_edges = curve_edges(source.segmentation), edges = curve_edges(target.segmentation);
  std::vector<BoundaryPlacement> boundary;
  for (int row = 0; row < table.size(); ++row) {
    const int vertex = source_vertices[row];
    if (row > 0 && vertex <= source_vertices[row - 1]) {
      table.fail(row, "source_vertex", "vertices do not ascend");
    }
    if (!source_edges.contains({vertex, vertex})) {
      table.fail(row, "source_vertex", std::to_string(vertex) + " is not on a boundary curve of the source");
    }
    if (!edges.contains(std::minmax(a[row], b[row]))) {
      table.fail(row, "target_b",
                 std::to_string(b[row]) + " and target_a " + std::to_string(a[row]) +
                     " are no edge of a boundary curve of the target");
    }
    boundary.push_back({vertex, a[row], b[row], fractions[row]});
  }
  return boundary;
}

std::vector<Part> read_source_parts(const JsonReader& json, const SegmentedModel& source,
                                    const SegmentedModel& target) {
  std::vector<Part> parts;
  std::set<int> used;
  for (const JsonReader& name : json.items()) {
    const int part = part_index(source.segmentation, name.text());
    if (part < 0) name.fail("the source has no part '" + name.text() + "'");
    if (!used.insert(part).second) name.fail("part '" + name.text() + "' is named twice");
    parts.push_back(extract_part(source, part));
  }
  if (static_cast<int>(parts.size()) != target.segmentation.part_count()) {
    json.fail("one source part for each of the target's " + std::to_string(target.segmentation.part_count()) +
              " parts is expected here");
  }
  return parts;
}

}  // namespace

Document to_document(const CrossMap& map) {
  Document document{{}, new_metadata("crossmap-1")};
  Json& metadata = document.metadata;
  metadata["source"] = model_facts(map.source);
  metadata["target"] = model_facts(map.target.hulled.model);
  metadata["markers"] = to_json(map.markers);
  metadata["source_parts"] = Json::array();
  for (const Part& part : map.source_parts) {
    metadata["source_parts"].push_back(map.source.segmentation.names.at(part.index));
  }
  PlyTables& tables = document.tables;
  add_images(tables, map.source_parts, map.images, "vertex", "source_vertex");
  add_part_facets(tables, map.source_parts, "face", "source_face");
  add_model(tables, map.source, kSourceElements);
  add_model(tables, map.target.hulled.model, kTargetElements);
  add_hulls(tables, map.target.hulled.hulls, "hull_vertex", "hull_face");
  add_images(tables, map.target.hulled.parts, map.target.images, "target_image", "target_vertex");
  tables.elements.push_back(boundary_element(map.boundary));
  return document;
}

CrossMap read_cross_map(const Document& document) {
  const PlyTables& tables = document.tables;
  const JsonReader metadata(document.metadata);
  SegmentedModel source = read_model(tables, metadata["source"], kSourceElements);
  SegmentedModel target = read_model(tables, metadata["target"], kTargetElements);
  std::vector<Part> source_parts = read_source_parts(metadata["source_parts"], source, target);
  std::vector<BoundaryPlacement> boundary = read_boundary(tables, source, target);
  std::vector<MarkerPair> markers = read_marker_pairs(metadata["markers"], source.mesh, target.mesh);
  HulledModel hulled = read_hulls_of(std::move(target), tables, "hull_vertex", "hull_face");
  std::vector<Points> target_images = read_images(tables, hulled.parts, "target_image", "target_vertex");
  std::vector<Points> images = read_images(tables, source_parts, "vertex", "source_vertex");
  require_part_facets(tables, source_parts, "face", "source_face");
  return {std::move(source),       {std::move(hulled), std::move(target_images)},
          std::move(source_parts), std::move(images),
          std::move(boundary),     std::move(markers)};
}

}  // namespace partwise::io
