#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/document.h"
#include "mesh/types.h"

namespace partwise::report {

/// The numbers of a page, one after the other in one block of bytes; the page finds each by what `add`
/// returned: {"type": "f32" | "u32" | "u8", "offset": bytes, "count": numbers}. Little-endian, every array
/// begins at a multiple of 4 bytes.
class PageArrays {
 public:
  io::Json add(const Points& points);  ///< three numbers per point, rounded to float
  io::Json add(const Facets& facets);  ///< three numbers per facet
  io::Json add(const std::vector<float>& values);
  io::Json add(const std::vector<std::uint8_t>& values);

  const std::string& bytes() const { return bytes_; }

 private:
  io::Json append(const char* type, const void* first, std::size_t count, std::size_t size);

  std::string bytes_;
};

/// RFC 4648, with padding, in one line.
std::string base64(const std::string& bytes);

}  // namespace partwise::report
