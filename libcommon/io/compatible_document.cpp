#include <limits>
#include <utility>

#include "error.h"
#include "io/chart_tables.h"
#include "io/model_tables.h"
#include "io/refinement_tables.h"
#include "io/stage_documents.h"
#include "io/table_builder.h"
#include "io/table_reader.h"

namespace partwise::io {
namespace {

Json part_facts(const CompatibleMesh& mesh) {
  std::vector<int> source_faces(mesh.part_names.size(), 0), target_faces(mesh.part_names.size(), 0);
  for (const int part : mesh.source_labels) ++source_faces.at(part);
  for (const int part : mesh.target_labels) ++target_faces.at(part);
  Json parts = Json::array();
  for (std::size_t k = 0; k < mesh.part_names.size(); ++k) {
    parts.push_back(
        {{"name", mesh.part_names[k]}, {"source_faces", source_faces[k]}, {"target_faces", target_faces[k]}});
  }
  return parts;
}

Element vertex_element(const CompatibleMesh& mesh) {
  ElementBuilder builder("vertex", mesh.points.size());
  builder.points(mesh.points);
  return add_surface_points(builder, "target", mesh.map.images()).build();
}

Element target_vertex_element(const CompatibleMesh& mesh) {
  ElementBuilder builder("target_vertex", mesh.target.vertex_count());
  builder.points(mesh.target.points());
  if (!mesh.inverse.empty()) add_surface_points(builder, "source", mesh.inverse);
  return builder.build();
}

std::vector<CriticalPoint> read_critical_points(const PlyTables& tables, const TriMesh& target) {
  const ElementReader table(tables, "critical_point");
  const auto vertices = table.integers("target_vertex", 0, target.vertex_count() - 1);
  const auto curvatures = table.numbers("curvature");
  const auto radii = table.numbers("radius", 0, std::numeric_limits<double>::max());
  std::vector<std::vector<int>> regions = table.lists("region", 0, target.vertex_count() - 1);
  std::vector<CriticalPoint> points;
  for (std::size_t row = 0; row < vertices.size(); ++row) {
    points.push_back({vertices[row], curvatures[row], radii[row], std::move(regions[row])});
  }
  return points;
}

void require_size(std::size_t size, int expected, const std::string& what) {
  if (size == static_cast<std::size_t>(expected)) return;
  throw InputError("expected " + std::to_string(expected) + " " + what + ", got " + std::to_string(size));
}

}  // namespace

Element critical_point_element(const std::string& vertex, const std::vector<CriticalPoint>& points) {
  std::vector<int> vertices;
  std::vector<double> curvatures, radii;
  std::vector<std::vector<int>> regions;
  for (const CriticalPoint& point : points) {
    vertices.push_back(point.vertex);
    curvatures.push_back(point.curvature);
    radii.push_back(point.radius);
    regions.push_back(point.region);
  }
  return ElementBuilder("critical_point", points.size())
      .integers(vertex, vertices)
      .numbers("curvature", curvatures)
      .numbers("radius", radii)
      .lists("region", regions)
      .build();
}

Document to_document(const CompatibleMesh& mesh) {
  require_size(mesh.points.size(), mesh.source.vertex_count(), "positions");
  require_size(mesh.source_labels.size(), mesh.source.facet_count(), "source labels");
  require_size(mesh.target_labels.size(), mesh.target.facet_count(), "target labels");
  Document document{{}, new_metadata("compatible-1")};
  document.metadata["parts"] = part_facts(mesh);
  document.metadata["markers"] = to_json(mesh.markers);
  document.tables.elements = {
      vertex_element(mesh),
      ElementBuilder("face", mesh.source.facet_count())
          .facets(mesh.source.facets())
          .integers("part", mesh.source_labels)
          .part_colours(mesh.source_labels)
          .build(),
      ElementBuilder("source_vertex", mesh.source.vertex_count()).points(mesh.source.points()).build(),
      target_vertex_element(mesh),
      ElementBuilder("target_face", mesh.target.facet_count())
          .facets(mesh.target.facets())
          .integers("part", mesh.target_labels)
          .build(),
      critical_point_element("target_vertex", mesh.critical_points)};
  add_charts(document, mesh);
  add_refinement(document, mesh);
  return document;
}

CompatibleMesh read_compatible_mesh(const Document& document) {
  const PlyTables& tables = document.tables;
  const JsonReader metadata(document.metadata);
  std::vector<std::string> names = read_names(metadata["parts"]);
  const int last_part = static_cast<int>(names.size()) - 1;
  const ElementReader vertices(tables, "vertex"), source_vertices(tables, "source_vertex");
  if (source_vertices.size() != vertices.size()) {
    throw InputError("elements 'vertex' and 'source_vertex' differ in size");
  }
  TriMesh source = read_mesh(tables, "source_vertex", "face");
  TriMesh target = read_mesh(tables, "target_vertex", "target_face");
  SurfaceMap map(source, target, read_surface_points(vertices, "target", target));
  std::vector<MarkerPair> markers = read_marker_pairs(metadata["markers"], source, target);
  std::vector<CriticalPoint> critical_points = read_critical_points(tables, target);
  CompatibleMesh mesh{std::move(source),
                      std::move(target),
                      vertices.points(),
                      std::move(map),
                      ElementReader(tables, "face").integers("part", 0, last_part),
                      ElementReader(tables, "target_face").integers("part", 0, last_part),
                      std::move(names),
                      std::move(markers),
                      std::move(critical_points)};
  read_charts(document, mesh);
  read_refinement(document, mesh);
  metadata["parts"].require_consistent(part_facts(mesh));
  return mesh;
}

}  // namespace partwise::io
