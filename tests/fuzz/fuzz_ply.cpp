// Whatever bytes arrive, the reader of PLY returns consistent tables or throws an InputError.
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>

#include "error.h"
#include "io/ply.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  std::istringstream in(std::string(reinterpret_cast<const char*>(bytes), count));
  try {
    const partwise::io::PlyTables tables = partwise::io::read_ply(in);
    for (const auto& element : tables.elements) {
      for (const auto& property : element.properties) {
        const std::size_t values = std::visit([](const auto& list) { return list.size(); }, property.values);
        const bool consistent = property.is_list ? property.offsets.size() == element.size + 1 &&
                                                       property.offsets.back() == values
                                                 : values == element.size;
        if (!consistent) std::abort();
      }
    }
  } catch (const partwise::InputError&) {
  }
  return 0;
}
