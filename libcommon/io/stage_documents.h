#pragma once

#include "io/document.h"
#include "mapping/domains.h"
#include "mesh/segmentation.h"
#include "remeshing/compatible_mesh.h"

/// The states of the pipeline as documents and back. Each kind's tables are described in schemas/README.md.
///
/// `to_document` fills schema, tables and the facts of the kind; history and metrics are added by the tool.
/// Readers throw InputError naming element, row and property when a table does not fit.
namespace partwise::io {

Document to_document(const TriMesh& mesh);          // partwise/mesh-1
Document to_document(const SegmentedModel& model);  // partwise/segment-1
Document to_document(const HulledModel& hulled);    // partwise/hull-1
Document to_document(const HullMap& map);           // partwise/hullmap-1
Document to_document(const CrossMap& map);          // partwise/crossmap-1
Document to_document(const CompatibleMesh& mesh);   // partwise/compatible-1

TriMesh read_mesh(const Document& document);  ///< from any kind: its `vertex` and `face`
SegmentedModel read_segmented_model(const Document& document);
HulledModel read_hulled_model(const Document& document);
HullMap read_hull_map(const Document& document);
CrossMap read_cross_map(const Document& document);
CompatibleMesh read_compatible_mesh(const Document& document);

/// Table `critical_point`. \param vertex name of the column that says which vertex a point is
Element critical_point_element(const std::string& vertex, const std::vector<CriticalPoint>& points);

}  // namespace partwise::io
