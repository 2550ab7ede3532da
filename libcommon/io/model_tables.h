#pragma once

#include <string>
#include <vector>

#include "io/document.h"
#include "io/json_reader.h"
#include "io/landmark_facts.h"
#include "mesh/segmentation.h"

/// A segmented model as tables and facts, which every document from `segment` to `crossmap` contains.
namespace partwise::io {

/// Elements that hold a model; several models, or the geometry of a stage, share one document.
struct ModelElements {
  std::string vertex;
  std::string face;
  std::string curve;
};

/// Where the model lies when a document's own geometry is something else.
inline const ModelElements kMeshElements{"mesh_vertex", "mesh_face", "curve"};

/// Appends positions, facets with their parts, and boundary curves. With `colours`, viewers tell parts apart.
void add_model(PlyTables& tables, const SegmentedModel& model, const ModelElements& elements,
               bool colours = false);

/// Parts, curves, cross points, adjacency, markers and anchors, by name.
Json model_facts(const SegmentedModel& model);

/// Reads what add_model and model_facts wrote.
///
/// Labels, names, markers, anchors and concavity are read; curves, cross points and whatever else follows
/// from them is traced anew and compared with the document, so that a damaged document is noticed.
/// \throws InputError
SegmentedModel read_model(const PlyTables& tables, const JsonReader& facts, const ModelElements& elements);

/// A mesh from two elements. \throws InputError, also for a mesh that is no oriented 2-manifold.
TriMesh read_mesh(const PlyTables& tables, const std::string& vertex, const std::string& face);

/// Metadata that every document has, for a kind such as "segment-1".
Json new_metadata(const std::string& kind);

}  // namespace partwise::io
