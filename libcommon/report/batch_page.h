#pragma once

#include <string>
#include <vector>

namespace partwise::report {

struct BatchPageOptions {
  int thumbnail_facets = 1'500;  ///< of each model in a thumbnail
};

/// The folders of all pairs in `folder`, by name. \throws IoError when it is no folder
std::vector<std::string> run_folders(const std::string& folder);

/// The page of a batch: a line per pair with thumbnails of source, compatible mesh and target, the main
/// figures, what went wrong, and a link to the pair's own page FOLDER/NAME/report.html where there is one.
/// \throws InputError when there is no pair; ComputationError when this build has no pages
std::string batch_page(const std::string& folder, const BatchPageOptions& options = {});

}  // namespace partwise::report
