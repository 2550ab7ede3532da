#include "io/domain_tables.h"

#include <limits>
#include <utility>

#include "error.h"
#include "io/table_builder.h"
#include "io/table_reader.h"
#include "mesh/validation.h"

namespace partwise::io {
namespace {

/// Facets of all parts over the concatenated local vertices.
Facets joined_facets(const std::vector<Part>& parts) {
  Facets facets;
  int first = 0;
  for (const Part& part : parts) {
    for (const Facet& f : part.mesh.facets()) facets.push_back({f[0] + first, f[1] + first, f[2] + first});
    first += part.mesh.vertex_count();
  }
  return facets;
}

/// Column `part` of a table that has `sizes[k]` rows for part k.
std::vector<int> part_column(const std::vector<int>& sizes) {
  std::vector<int> column;
  for (std::size_t k = 0; k < sizes.size(); ++k) column.insert(column.end(), sizes[k], static_cast<int>(k));
  return column;
}

std::vector<int> vertex_counts(const std::vector<Part>& parts) {
  std::vector<int> counts;
  for (const Part& part : parts) counts.push_back(part.mesh.vertex_count());
  return counts;
}

std::vector<int> facet_counts(const std::vector<Part>& parts) {
  std::vector<int> counts;
  for (const Part& part : parts) counts.push_back(part.mesh.facet_count());
  return counts;
}

std::vector<int> joined(const std::vector<Part>& parts, std::vector<int> Part::*column) {
  std::vector<int> result;
  for (const Part& part : parts) result.insert(result.end(), (part.*column).begin(), (part.*column).end());
  return result;
}

void require_closed(const ConvexHull& hull, int part) {
  const std::vector<std::string> defects = find_defects(hull.points, hull.facets);
  const std::string where = "the hull of part " + std::to_string(part);
  if (!defects.empty()) throw InputError(where + ": " + defects.front());
  // Without defects every edge has one or two facets; all have two exactly when 3 F = 2 E.
  if (2 * TriMesh(hull.points, hull.facets).half_edges().n_edges() != 3 * hull.facets.size()) {
    throw InputError(where + " is not closed");
  }
}

void require_on_part(const ElementReader& table, const RowRange& rows, const ConvexHull& hull,
                     const Part& part) {
  const double tolerance = 1e-9 * part.mesh.diagonal();
  for (int i = 0; i < rows.size(); ++i) {
    if ((hull.points[i] - part.mesh.point(hull.part_vertex[i])).norm() <= tolerance) continue;
    table.fail(rows.first + i, "part_vertex", "the part's vertex does not lie where the hull's does");
  }
}

}  // namespace

std::vector<Part> extract_parts(const SegmentedModel& model) {
  std::vector<Part> parts;
  for (int k = 0; k < model.segmentation.part_count(); ++k) parts.push_back(extract_part(model, k));
  return parts;
}

void add_hulls(PlyTables& tables, const std::vector<ConvexHull>& hulls, const std::string& vertex,
               const std::string& face, bool colours) {
  Points points;
  Facets facets;
  std::vector<int> part_vertices, vertex_counts, facet_counts;
  for (const ConvexHull& hull : hulls) {
    const int first = static_cast<int>(points.size());
    for (const Facet& f : hull.facets) facets.push_back({f[0] + first, f[1] + first, f[2] + first});
    points.insert(points.end(), hull.points.begin(), hull.points.end());
    part_vertices.insert(part_vertices.end(), hull.part_vertex.begin(), hull.part_vertex.end());
    vertex_counts.push_back(static_cast<int>(hull.points.size()));
    facet_counts.push_back(static_cast<int>(hull.facets.size()));
  }
  const std::vector<int> vertex_part = part_column(vertex_counts), facet_part = part_column(facet_counts);
  ElementBuilder vertices(vertex, points.size());
  vertices.points(points).integers("part", vertex_part).integers("part_vertex", part_vertices);
  ElementBuilder faces(face, facets.size());
  faces.facets(facets).integers("part", facet_part);
  if (colours) {
    vertices.part_colours(vertex_part);
    faces.part_colours(facet_part);
  }
  tables.elements.push_back(vertices.build());
  tables.elements.push_back(faces.build());
}

std::vector<ConvexHull> read_hulls(const PlyTables& tables, const std::vector<Part>& parts,
                                   const std::string& vertex, const std::string& face) {
  const int part_count = static_cast<int>(parts.size());
  const ElementReader vertices(tables, vertex), faces(tables, face);
  const Points points = vertices.points();
  const Facets facets = faces.facets(vertices.size());
  const std::vector<RowRange> vertex_rows = rows_by_part(vertices, part_count);
  const std::vector<RowRange> face_rows = rows_by_part(faces, part_count);
  const std::vector<int> part_vertices = vertices.integers("part_vertex", 0, std::numeric_limits<int>::max());
  std::vector<ConvexHull> hulls(part_count);
  for (int k = 0; k < part_count; ++k) {
    const RowRange& rows = vertex_rows[k];
    ConvexHull& hull = hulls[k];
    hull.points.assign(points.begin() + rows.first, points.begin() + rows.last);
    for (int row = rows.first; row < rows.last; ++row) {
      if (part_vertices[row] >= parts[k].mesh.vertex_count()) {
        vertices.fail(row, "part_vertex", std::to_string(part_vertices[row]) + " is no vertex of its part");
      }
      hull.part_vertex.push_back(part_vertices[row]);
    }
    for (int row = face_rows[k].first; row < face_rows[k].last; ++row) {
      Facet facet = facets[row];
      for (int& v : facet) {
        if (v < rows.first || v >= rows.last) {
          faces.fail(row, "vertex_indices", std::to_string(v) + " is a vertex of another part's hull");
        }
        v -= rows.first;
      }
      hull.facets.push_back(facet);
    }
    require_closed(hull, k);
    require_on_part(vertices, rows, hull, parts[k]);
  }
  return hulls;
}

void add_images(PlyTables& tables, const std::vector<Part>& parts, const std::vector<Points>& images,
                const std::string& vertex, const std::string& model_column) {
  Points points;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (static_cast<int>(images.at(k).size()) != parts[k].mesh.vertex_count()) {
      throw InputError("part " + std::to_string(k) + " has " + std::to_string(parts[k].mesh.vertex_count()) +
                       " vertices, but " + std::to_string(images[k].size()) + " images");
    }
    points.insert(points.end(), images[k].begin(), images[k].end());
  }
  tables.elements.push_back(ElementBuilder(vertex, points.size())
                                .points(points)
                                .integers("part", part_column(vertex_counts(parts)))
                                .integers(model_column, joined(parts, &Part::model_vertex))
                                .build());
}

std::vector<Points> read_images(const PlyTables& tables, const std::vector<Part>& parts,
                                const std::string& vertex, const std::string& model_column) {
  const ElementReader table(tables, vertex);
  table.require_equal("part", part_column(vertex_counts(parts)));
  table.require_equal(model_column, joined(parts, &Part::model_vertex));
  const Points points = table.points();
  std::vector<Points> images;
  auto next = points.begin();
  for (const Part& part : parts) {
    images.emplace_back(next, next + part.mesh.vertex_count());
    next += part.mesh.vertex_count();
  }
  return images;
}

void add_part_facets(PlyTables& tables, const std::vector<Part>& parts, const std::string& face,
                     const std::string& model_column) {
  const Facets facets = joined_facets(parts);
  const std::vector<int> part = part_column(facet_counts(parts));
  tables.elements.push_back(ElementBuilder(face, facets.size())
                                .facets(facets)
                                .integers("part", part)
                                .integers(model_column, joined(parts, &Part::model_facet))
                                .part_colours(part)
                                .build());
}

void require_part_facets(const PlyTables& tables, const std::vector<Part>& parts, const std::string& face,
                         const std::string& model_column) {
  const ElementReader table(tables, face);
  const Facets expected = joined_facets(parts);
  table.require_equal("part", part_column(facet_counts(parts)));
  table.require_equal(model_column, joined(parts, &Part::model_facet));
  int vertex_count = 0;
  for (const Part& part : parts) vertex_count += part.mesh.vertex_count();
  const Facets facets = table.facets(vertex_count);
  for (std::size_t row = 0; row < facets.size(); ++row) {
    if (facets[row] != expected[row]) {
      table.fail(row, "vertex_indices", "the facet contradicts the part it belongs to");
    }
  }
}

HulledModel read_hulls_of(SegmentedModel model, const PlyTables& tables, const std::string& vertex,
                          const std::string& face) {
  std::vector<Part> parts = extract_parts(model);
  std::vector<ConvexHull> hulls = read_hulls(tables, parts, vertex, face);
  return {std::move(model), std::move(parts), std::move(hulls)};
}

}  // namespace partwise::io
