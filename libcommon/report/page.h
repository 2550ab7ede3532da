#pragma once

#include <string>

#include "report/page_arrays.h"

namespace partwise::report {

/// The pages of tools/report/ and tools/sketch/, each with its own body and script.
enum class Page { run, batch, sketch };

/// A self-contained HTML page: frame, body, style, script, `facts` and `arrays` in one file. The page
/// `sketch` talks to the server that it came from; its policy lets no page ask for anything else. \param
/// title of the browser's window \throws ComputationError when this build has no pages, since npm could not
/// bundle them; says how to get them
std::string html_page(Page page, const std::string& title, const io::Json& facts, const PageArrays& arrays);

}  // namespace partwise::report
