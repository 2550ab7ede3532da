#pragma once

#include <string>

#include "report/run_documents.h"

namespace partwise::report {

struct RunPageOptions {
  int most_facets = 60'000;  ///< of each model that the page shows; larger models are decimated
};

/// The page of one pair: every stage in a viewer, figures, findings, history and timings, in one HTML file.
/// \throws ComputationError when this build has no pages
std::string run_page(const RunDocuments& run, const RunPageOptions& options = {});

/// What happened to make the last document: per entry of its history, the oldest first, `tool`, `side`
/// ("source", "target" or ""), `version`, `arguments`, `inputs`, and `seconds` and `peak_memory_mb` of tools
/// that ran with --profile.
io::Json run_history(const RunDocuments& run);

/// The figures of a measure document as rows {"pointer", "heading", "meaning", "value"}; none for null.
io::Json page_figures(const io::Json& measure);

/// Rows {"weight", "stage", "text"}.
io::Json page_findings(const RunDocuments& run);

}  // namespace partwise::report
