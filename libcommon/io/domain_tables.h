#pragma once

#include <string>
#include <vector>

#include "io/document.h"
#include "mapping/domains.h"

/// Parts, hulls and maps as tables. All parts of a kind share one element, sorted by its column `part`.
///
/// Capped parts are not stored: reading extracts them from the model once more, because only that yields
/// their caps' geometry, and compares the result with what the tables say of them. A table whose rows belong
/// to other vertices than the reader believes is thus refused instead of silently misread.
namespace partwise::io {

/// All parts of a model, in its order.
std::vector<Part> extract_parts(const SegmentedModel& model);

/// Appends the hulls: positions with `part_vertex`, facets; with `colours`, viewers tell parts apart.
void add_hulls(PlyTables& tables, const std::vector<ConvexHull>& hulls, const std::string& vertex,
               const std::string& face, bool colours = false);

/// \throws InputError also when a hull is no closed mesh or its vertices do not lie where the part's do.
std::vector<ConvexHull> read_hulls(const PlyTables& tables, const std::vector<Part>& parts,
                                   const std::string& vertex, const std::string& face);

/// Appends one position per local vertex of each part; the column `model_column` names the model's vertex.
void add_images(PlyTables& tables, const std::vector<Part>& parts, const std::vector<Points>& images,
                const std::string& vertex, const std::string& model_column);

std::vector<Points> read_images(const PlyTables& tables, const std::vector<Part>& parts,
                                const std::string& vertex, const std::string& model_column);

/// Appends the parts' facets over the rows of add_images; `model_column` names the model's facet.
void add_part_facets(PlyTables& tables, const std::vector<Part>& parts, const std::string& face,
                     const std::string& model_column);

/// \throws InputError when the element does not hold the facets of `parts`.
void require_part_facets(const PlyTables& tables, const std::vector<Part>& parts, const std::string& face,
                         const std::string& model_column);

/// A model with its hulls behind the elements of a stage's own geometry (see kMeshElements).
HulledModel read_hulls_of(SegmentedModel model, const PlyTables& tables, const std::string& vertex,
                          const std::string& face);

}  // namespace partwise::io
