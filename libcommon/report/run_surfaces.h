#pragma once

#include "report/display_meshes.h"
#include "report/page_arrays.h"
#include "report/run_documents.h"

namespace partwise::report {

/// The surfaces of a run as its page draws them: {"parts", "models", "surfaces", "markers",
/// "critical_points"}; see tools/report/README.md.
///
/// Each model is turned by the same view, centred and scaled to a diagonal of 2; the source is turned as it
/// fits the compatible mesh best. \param most facets per model: larger ones are decimated for display (see
/// DisplayMesh)
io::Json run_surfaces(const RunDocuments& run, int most, PageArrays& arrays);

/// The same of the bare meshes alone: source, target, compatible mesh.
/// \param displays serves all pairs of a batch
io::Json thumbnail_surfaces(const RunDocuments& run, DisplayMeshes& displays, PageArrays& arrays);

}  // namespace partwise::report
