#pragma once

#include <string>
#include <vector>

#include "report/run_documents.h"

namespace partwise::report {

/// Something about a run that a reader should know.
struct Finding {
  enum class Weight { failure, warning, note };
  Weight weight = Weight::note;
  std::string stage;  ///< the tool, with the side in brackets where there are two
  std::string text;   ///< one sentence
};

/// What the documents of a run say against it, the gravest first: stages that are missing or unreadable,
/// documents that were not made from one another, maps without certificate, folds, flipped facets, released
/// markers, curves whose turn is open.
std::vector<Finding> findings(const RunDocuments& run);

/// "failure", "warning" or "note".
const char* name_of(Finding::Weight weight);

}  // namespace partwise::report
