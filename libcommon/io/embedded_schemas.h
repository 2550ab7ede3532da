#pragma once

#include <map>
#include <string>

namespace partwise::io {

/// Text of every file of schemas/, by name without ".schema.json", such as "segment-1".
const std::map<std::string, const char*>& embedded_schemas();

}  // namespace partwise::io
