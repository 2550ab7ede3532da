#include "io/model_tables.h"

#include <algorithm>
#include <map>
#include <utility>

#include "error.h"
#include "geometry/normals.h"
#include "io/table_builder.h"
#include "io/table_reader.h"
#include "mesh/curve_roughness.h"

namespace partwise::io {
namespace {

Json part_name(const Segmentation& segmentation, int part) {
  return part == kOutside ? Json() : Json(segmentation.names.at(part));
}

int read_part_name(const JsonReader& json, const Segmentation& segmentation) {
  if (json.is_null()) return kOutside;
  const int part = part_index(segmentation, json.text());
  if (part < 0) json.fail("there is no part '" + json.text() + "'");
  return part;
}

/// Per vertex, the smallest part among its facets.
std::vector<int> vertex_parts(const TriMesh& mesh, const std::vector<int>& labels) {
  std::vector<int> parts(mesh.vertex_count(), -1);
  for (int f = 0; f < mesh.facet_count(); ++f) {
    for (const int v : mesh.facet(f)) {
      if (parts[v] < 0 || labels[f] < parts[v]) parts[v] = labels[f];
    }
  }
  return parts;
}

Json part_facts(const SegmentedModel& model) {
  const Segmentation& segmentation = model.segmentation;
  const std::vector<double> areas = facet_areas(model.mesh.points(), model.mesh.facets());
  std::vector<int> face_counts(segmentation.names.size(), 0);
  std::vector<double> part_areas(segmentation.names.size(), 0);
  for (std::size_t f = 0; f < areas.size(); ++f) {
    ++face_counts[segmentation.labels[f]];
    part_areas[segmentation.labels[f]] += areas[f];
  }
  Json parts = Json::array();
  for (std::size_t k = 0; k < segmentation.names.size(); ++k) {
    Json part{{"name", segmentation.names[k]}, {"faces", face_counts[k]}, {"area", part_areas[k]}};
    if (!model.concavity.empty()) {
      const Concavity& concavity = model.concavity.at(k);
      part["concavity"] = {
          {"largest", concavity.largest}, {"mean", concavity.mean}, {"vertex", concavity.vertex}};
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

Json curve_facts(const TriMesh& mesh, const Segmentation& segmentation) {
  Json curves = Json::array();
  for (const BoundaryCurve& curve : segmentation.curves) {
    curves.push_back({{"left", part_name(segmentation, curve.left)},
                      {"right", part_name(segmentation, curve.right)},
                      {"closed", curve.closed},
                      {"length", curve.length},
                      {"roughness", curve_roughness(mesh, curve)}});
  }
  return curves;
}

Json cross_point_facts(const Segmentation& segmentation) {
  Json points = Json::array();
  for (const CrossPoint& point : segmentation.cross_points) {
    Json parts = Json::array();
    for (const int part : point.parts) parts.push_back(part_name(segmentation, part));
    points.push_back({{"vertex", point.vertex}, {"parts", std::move(parts)}});
  }
  return points;
}

Json adjacency_facts(const Segmentation& segmentation) {
  std::map<std::pair<int, int>, int> counts;
  for (const BoundaryCurve& curve : segmentation.curves) {
    if (curve.right != kOutside) ++counts[{curve.left, curve.right}];
  }
  Json adjacency = Json::array();
  for (const auto& [parts, count] : counts) {
    adjacency.push_back(
        {{"parts", {part_name(segmentation, parts.first), part_name(segmentation, parts.second)}},
         {"curves", count}});
  }
  return adjacency;
}

/// What follows from mesh, names and labels alone.
Json derived_facts(const SegmentedModel& model) {
  return {{"parts", part_facts(model)},
          {"curves", curve_facts(model.mesh, model.segmentation)},
          {"cross_points", cross_point_facts(model.segmentation)},
          {"adjacency", adjacency_facts(model.segmentation)}};
}

std::vector<Concavity> read_concavity(const JsonReader& parts, const TriMesh& mesh) {
  std::vector<Concavity> result;
  const std::vector<JsonReader> items = parts.items();
  for (const JsonReader& part : items) {
    if (!part.has("concavity")) continue;
    const JsonReader json = part["concavity"];
    result.push_back({json["largest"].number(), json["mean"].number(),
                      json["vertex"].integer(-1, mesh.vertex_count() - 1)});
  }
  if (!result.empty() && result.size() != items.size()) {
    parts.fail("every part or none must have a 'concavity'");
  }
  return result;
}

std::vector<Anchor> read_anchors(const JsonReader& json, const SegmentedModel& model) {
  std::vector<Anchor> anchors;
  for (const JsonReader& item : json.items()) {
    const std::vector<JsonReader> between = item["between"].items();
    if (between.size() != 2) item["between"].fail("two parts are expected here");
    const Anchor anchor{item["name"].text(),
                        read_part_name(between[0], model.segmentation),
                        read_part_name(between[1], model.segmentation),
                        item["vertex"].integer(0, model.mesh.vertex_count() - 1),
                        item["snap_distance"].number(),
                        item["proposed"].boolean()};
    auto holds_anchor = [&](const BoundaryCurve& curve) {
      return std::minmax(curve.left, curve.right) == std::minmax(anchor.part_a, anchor.part_b) &&
             std::count(curve.vertices.begin(), curve.vertices.end(), anchor.vertex) > 0;
    };
    const std::vector<BoundaryCurve>& curves = model.segmentation.curves;
    if (std::none_of(curves.begin(), curves.end(), holds_anchor)) {
      item["vertex"].fail("vertex " + std::to_string(anchor.vertex) +
                          " is not on a boundary curve between the anchor's parts");
    }
    anchors.push_back(anchor);
  }
  return anchors;
}

void require_curves(const ElementReader& table, const SegmentedModel& model) {
  const std::vector<std::vector<int>> stored = table.lists("vertices", 0, model.mesh.vertex_count() - 1);
  const std::vector<BoundaryCurve>& curves = model.segmentation.curves;
  for (std::size_t row = 0; row < stored.size(); ++row) {
    if (row >= curves.size() || stored[row] != curves[row].vertices) {
      table.fail(row, "vertices", "the curve contradicts the parts of the facets");
    }
  }
  if (stored.size() != curves.size()) {
    table.fail(stored.size(), "vertices", "a boundary curve of the parts is missing");
  }
}

}  // namespace

Json new_metadata(const std::string& kind) {
  return {{"schema", "partwise/" + kind}, {"history", Json::array()}, {"metrics", Json::object()}};
}

TriMesh read_mesh(const PlyTables& tables, const std::string& vertex, const std::string& face) {
  Points points = ElementReader(tables, vertex).points();
  Facets facets = ElementReader(tables, face).facets(static_cast<int>(points.size()));
  try {
    return TriMesh(std::move(points), std::move(facets));
  } catch (const InputError& error) {
    throw InputError("elements '" + vertex + "' and '" + face + "': " + error.what());
  }
}

void add_model(PlyTables& tables, const SegmentedModel& model, const ModelElements& elements, bool colours) {
  const TriMesh& mesh = model.mesh;
  const std::vector<int>& labels = model.segmentation.labels;
  ElementBuilder vertices(elements.vertex, mesh.vertex_count());
  vertices.points(mesh.points());
  ElementBuilder faces(elements.face, mesh.facet_count());
  faces.facets(mesh.facets()).integers("part", labels);
  if (colours) {
    vertices.part_colours(vertex_parts(mesh, labels));
    faces.part_colours(labels);
  }
  std::vector<std::vector<int>> curves;
  for (const BoundaryCurve& curve : model.segmentation.curves) curves.push_back(curve.vertices);
  tables.elements.push_back(vertices.build());
  tables.elements.push_back(faces.build());
  tables.elements.push_back(ElementBuilder(elements.curve, curves.size()).lists("vertices", curves).build());
}

Json model_facts(const SegmentedModel& model) {
  Json facts = derived_facts(model);
  facts["markers"] = Json::array();
  for (const Marker& marker : model.markers) {
    Json json = to_json(marker.point);
    json["name"] = marker.name;
    facts["markers"].push_back(std::move(json));
  }
  facts["anchors"] = Json::array();
  for (const Anchor& anchor : model.anchors) {
    facts["anchors"].push_back(
        {{"name", anchor.name},
         {"between",
          {part_name(model.segmentation, anchor.part_a), part_name(model.segmentation, anchor.part_b)}},
         {"vertex", anchor.vertex},
         {"snap_distance", anchor.snap_distance},
         {"proposed", anchor.proposed}});
  }
  return facts;
}

SegmentedModel read_model(const PlyTables& tables, const JsonReader& facts, const ModelElements& elements) {
  TriMesh mesh = read_mesh(tables, elements.vertex, elements.face);
  std::vector<std::string> names = read_names(facts["parts"]);
  std::vector<int> labels =
      ElementReader(tables, elements.face).integers("part", 0, static_cast<int>(names.size()) - 1);
  SegmentedModel model{mesh, trace_boundaries(mesh, std::move(names), std::move(labels)), {}, {}, {}};
  model.concavity = read_concavity(facts["parts"], mesh);
  facts.require_consistent(derived_facts(model));
  require_curves(ElementReader(tables, elements.curve), model);
  for (const JsonReader& item : facts["markers"].items()) {
    model.markers.push_back({item["name"].text(), read_surface_point(item, mesh)});
  }
  model.anchors = read_anchors(facts["anchors"], model);
  return model;
}

}  // namespace partwise::io
