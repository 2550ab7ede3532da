#include "report/page_arrays.h"

#include <bit>

namespace partwise::report {

static_assert(std::endian::native == std::endian::little, "page arrays are little-endian");

io::Json PageArrays::append(const char* type, const void* first, std::size_t count, std::size_t size) {
  bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
  io::Json place{{"type", type}, {"offset", bytes_.size()}, {"count", count}};
  bytes_.append(static_cast<const char*>(first), count * size);
  return place;
}

io::Json PageArrays::add(const Points& points) {
  std::vector<float> values;
  values.reserve(3 * points.size());
  for (const Vec3& p : points) {
    for (int i = 0; i < 3; ++i) values.push_back(static_cast<float>(p[i]));
  }
  return add(values);
}

io::Json PageArrays::add(const Facets& facets) {
  static_assert(sizeof(Facet) == 3 * sizeof(std::uint32_t));
  return append("u32", facets.data(), 3 * facets.size(), sizeof(std::uint32_t));
}

io::Json PageArrays::add(const std::vector<float>& values) {
  return append("f32", values.data(), values.size(), sizeof(float));
}

io::Json PageArrays::add(const std::vector<std::uint8_t>& values) {
  return append("u8", values.data(), values.size(), 1);
}

std::string base64(const std::string& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      group = group << 8 | (j < count ? static_cast<unsigned char>(bytes[i + j]) : 0U);
    }
    for (std::size_t j = 0; j < 4; ++j) {
      text += j <= count ? kDigits[group >> (18 - 6 * j) & 63U] : '=';
    }
  }
  return text;
}

}  // namespace partwise::report
