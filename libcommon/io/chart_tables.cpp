#include "io/chart_tables.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "error.h"
#include "io/json_reader.h"

namespace partwise::io {
namespace {

std::vector<AddedVertex> read_added_vertices(const PlyTables& tables, const CompatibleMesh& mesh) {
  const ElementReader table(tables, "added_vertex");
  const int last = mesh.source.vertex_count() - 1;
  const auto a = table.integers("source_a", 0, last), b = table.integers("source_b", 0, last);
  const auto fraction = table.numbers("fraction", 0, 1);
  const auto images = read_surface_points(table, "target", mesh.target);
  std::vector<AddedVertex> added;
  for (std::size_t i = 0; i < images.size(); ++i) added.push_back({{a[i], b[i], fraction[i]}, images[i]});
  return added;
}

std::vector<int> read_parts(const JsonReader& names, const CompatibleMesh& mesh) {
  std::vector<int> parts;
  for (const JsonReader& entry : names.items()) {
    const std::string name = entry.text();
    const auto found = std::find(mesh.part_names.begin(), mesh.part_names.end(), name);
    if (found == mesh.part_names.end()) entry.fail("no part is called '" + name + "'");
    parts.push_back(static_cast<int>(found - mesh.part_names.begin()));
  }
  std::sort(parts.begin(), parts.end());
  return parts;
}

Json part_names_of(const std::vector<int>& parts, const std::vector<std::string>& names) {
  Json result = Json::array();
  for (const int part : parts) result.push_back(names.at(part));
  return result;
}

Json chart_facts(const CompatibleMesh& mesh) {
  Json charts = Json::array();
  for (const Chart& chart : mesh.charts) {
    charts.push_back({{"parts", part_names_of(chart.parts, mesh.part_names)}});
  }
  return charts;
}

Element chart_vertex_element(const CompatibleMesh& mesh) {
  std::vector<int> charts, vertices;
  Points directions;
  for (std::size_t k = 0; k < mesh.charts.size(); ++k) {
    const ChartTarget target(mesh.target, mesh.target_labels, mesh.charts[k]);
    const std::vector<int>& of_target = target.piece().model_vertex;
    charts.resize(charts.size() + of_target.size(), static_cast<int>(k));
    vertices.insert(vertices.end(), of_target.begin(), of_target.end());
    directions.insert(directions.end(), target.directions().begin(), target.directions().end());
  }
  return ElementBuilder("chart_vertex", charts.size())
      .points(directions)
      .integers("chart", charts)
      .integers("target_vertex", vertices)
      .build();
}

Element added_vertex_element(const std::vector<AddedVertex>& vertices) {
  std::vector<int> a, b;
  std::vector<double> fractions;
  std::vector<SurfacePoint> images;
  for (const AddedVertex& added : vertices) {
    a.push_back(added.place.a);
    b.push_back(added.place.b);
    fractions.push_back(added.place.fraction);
    images.push_back(added.image);
  }
  ElementBuilder builder("added_vertex", vertices.size());
  builder.integers("source_a", a).integers("source_b", b).numbers("fraction", fractions);
  return add_surface_points(builder, "target", images).build();
}

}  // namespace

ElementBuilder& add_surface_points(ElementBuilder& builder, const std::string& mesh,
                                   const std::vector<SurfacePoint>& points) {
  std::vector<int> facets;
  std::vector<double> coordinates[3];
  for (const SurfacePoint& point : points) {
    facets.push_back(point.facet);
    for (int i = 0; i < 3; ++i) coordinates[i].push_back(point.barycentric[i]);
  }
  return builder.integers(mesh + "_face", facets)
      .numbers(mesh + "_u", coordinates[0])
      .numbers(mesh + "_v", coordinates[1])
      .numbers(mesh + "_w", coordinates[2]);
}

std::vector<SurfacePoint> read_surface_points(const ElementReader& table, const std::string& name,
                                              const TriMesh& mesh) {
  const auto facets = table.integers(name + "_face", 0, mesh.facet_count() - 1);
  const auto u = table.numbers(name + "_u", -1e-12, 2), v = table.numbers(name + "_v", -1e-12, 2),
             w = table.numbers(name + "_w", -1e-12, 2);
  std::vector<SurfacePoint> points;
  for (std::size_t row = 0; row < facets.size(); ++row) {
    points.push_back({facets[row], Vec3(u[row], v[row], w[row])});
    if (!(std::abs(points.back().barycentric.sum() - 1) <= 1e-9)) {
      table.fail(row, name + "_w", "the barycentric coordinates do not add to 1");
    }
  }
  return points;
}

void add_charts(Document& document, const CompatibleMesh& mesh) {
  document.metadata["charts"] = chart_facts(mesh);
  document.metadata["added_vertices"] = mesh.added_vertices.size();
  if (mesh.charts.empty()) return;
  document.tables.elements.push_back(chart_vertex_element(mesh));
  document.tables.elements.push_back(added_vertex_element(mesh.added_vertices));
}

void read_charts(const Document& document, CompatibleMesh& mesh) {
  const JsonReader metadata(document.metadata);
  const std::vector<JsonReader> charts = metadata["charts"].items();
  const int added_count = metadata["added_vertices"].integer(0, std::numeric_limits<int>::max());
  if (charts.empty()) return;
  const ElementReader rows(document.tables, "chart_vertex");
  const std::vector<int> of_chart = rows.integers("chart", 0, static_cast<int>(charts.size()) - 1);
  const std::vector<int> of_target = rows.integers("target_vertex", -1, mesh.target.vertex_count() - 1);
  const Points directions = rows.points();
  std::vector<int> expected;
  for (std::size_t k = 0; k < charts.size(); ++k) {
    Chart chart{read_parts(charts[k]["parts"], mesh), {}};
    for (std::size_t row = 0; row < of_chart.size(); ++row) {
      if (of_chart[row] == static_cast<int>(k)) chart.directions.push_back(directions[row]);
    }
    const ChartTarget target(mesh.target, mesh.target_labels, chart);
    expected.insert(expected.end(), target.piece().model_vertex.begin(), target.piece().model_vertex.end());
    mesh.charts.push_back(std::move(chart));
  }
  rows.require_equal("target_vertex", expected);
  mesh.added_vertices = read_added_vertices(document.tables, mesh);
  if (added_count != static_cast<int>(mesh.added_vertices.size())) {
    metadata["added_vertices"].fail("differs from the rows of element 'added_vertex'");
  }
  const ElementReader target_vertices(document.tables, "target_vertex");
  mesh.inverse = read_surface_points(target_vertices, "source", mesh.source);
}

Json chart_metrics(const std::vector<ChartFigures>& charts, const std::vector<std::string>& part_names) {
  bool one_to_one = !charts.empty();
  Json entries = Json::array();
  for (const ChartFigures& chart : charts) {
    Json entry{{"parts", part_names_of(chart.parts, part_names)},
               {"folds_before", chart.folds_before},
               {"folds", chart.folds},
               {"degree", chart.degree},
               {"one_to_one", chart.one_to_one}};
    if (!chart.one_to_one) entry["reason"] = chart.reason;
    one_to_one = one_to_one && chart.one_to_one;
    entries.push_back(std::move(entry));
  }
  return {{"one_to_one", one_to_one}, {"charts", std::move(entries)}};
}

std::string uncertified(const std::vector<ChartFigures>& charts, const std::vector<std::string>& part_names) {
  std::string text;
  for (const ChartFigures& chart : charts) {
    if (chart.one_to_one) continue;
    text += text.empty() ? "" : "; ";
    text += chart.parts.size() == 1 ? "part '" + part_names.at(chart.parts[0]) + "'" : "the whole surface";
    text += ": " + chart.reason;
  }
  return text;
}

}  // namespace partwise::io
