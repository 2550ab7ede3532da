#pragma once

#include <string>

#include "io/document.h"
#include "io/table_builder.h"
#include "io/table_reader.h"
#include "remeshing/one_to_one_map.h"

/// What compatible-1 says of the map between two surfaces: points of one on the other, and charts.
namespace partwise::io {

/// Columns X_face, X_u, X_v, X_w for X = `mesh`: a point of that mesh per row. They are not called u, v, w
/// alone: viewers would take them for texture coordinates.
ElementBuilder& add_surface_points(ElementBuilder& builder, const std::string& mesh,
                                   const std::vector<SurfacePoint>& points);
std::vector<SurfacePoint> read_surface_points(const ElementReader& table, const std::string& name,
                                              const TriMesh& mesh);

/// Adds the members `charts` and `added_vertices` and, with charts, the elements `chart_vertex` and
/// `added_vertex`.
void add_charts(Document& document, const CompatibleMesh& mesh);

/// Fills charts, added vertices and inverse of `mesh`, whose other members are there; a document without
/// charts leaves them empty.
/// \throws InputError when rows are missing or do not fit the meshes
void read_charts(const Document& document, CompatibleMesh& mesh);

/// What a stage says of its charts in its metrics: `one_to_one`, and `charts`, each with `parts`,
/// `folds_before`, `folds`, `degree`, `one_to_one` and, without a certificate, the `reason`.
Json chart_metrics(const std::vector<ChartFigures>& charts, const std::vector<std::string>& part_names);

/// For people: which parts have no certificate and why, one clause each; empty when all have.
std::string uncertified(const std::vector<ChartFigures>& charts, const std::vector<std::string>& part_names);

}  // namespace partwise::io
