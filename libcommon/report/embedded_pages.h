#pragma once

#include <map>
#include <string>

namespace partwise::report {

/// Text of the files that make a page, by name: "page.html", what all pages share, "page.css", the bodies
/// "run.html" and "batch.html", and the bundled scripts "run.js" and "batch.js"; the scripts are missing when
/// they could not be bundled.
const std::map<std::string, const char*>& embedded_pages();

}  // namespace partwise::report
