#include "io/carried_columns.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace partwise::io {

bool is_geometry(const std::string& property) {
  constexpr std::array<std::string_view, 12> kGeometry{
      "x",           "y",        "z",        "nx",      "ny", "nz", "vertex_indices", "vertex_index",
      "target_face", "target_u", "target_v", "target_w"};
  return std::find(kGeometry.begin(), kGeometry.end(), property) != kGeometry.end();
}

void carry_columns(Element& to, const Element& from) {
  for (const Property& property : from.properties) {
    if (!is_geometry(property.name) && !to.find(property.name)) to.properties.push_back(property);
  }
}

}  // namespace partwise::io
