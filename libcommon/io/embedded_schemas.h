#pragma once

#include <map>
#include <string>

namespace partwise::io {

/// Text of every schema of schemas/, by file name, such as "segment-1.schema.json".
const std::map<std::string, const char*>& embedded_schemas();

}  // namespace partwise::io
