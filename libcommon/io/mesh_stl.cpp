#include <array>
#include <bit>
#include <cstring>
#include <map>
#include <unordered_map>

#include "error.h"
#include "io/byte_source.h"
#include "io/polygon_builder.h"

namespace partwise::io {
namespace {

constexpr std::size_t kLongestLine = std::size_t{1} << 20;
constexpr std::size_t kHeader = 84;
constexpr std::size_t kFacet = 50;

/// Joins corners with equal coordinates; vertices come in the order of their first corner.
class CornerMerger {
 public:
  int vertex(const Vec3& position) {
    const Vec3 zeroed = position + Vec3::Zero();  // -0 and 0 are the same place
    const auto [entry, is_new] =
        index_.try_emplace({zeroed[0], zeroed[1], zeroed[2]}, builder_.vertex_count());
    if (is_new) {
      builder_.vertex(zeroed);
    } else {
      ++merged_;
    }
    return static_cast<int>(entry->second);
  }
  void triangle(const Facet& facet) { builder_.triangle(facet); }
  ImportedMesh finished() {
    ImportedMesh mesh = builder_.finished();
    mesh.merged_vertices = merged_;
    return mesh;
  }

 private:
  struct Hash {
    std::size_t operator()(const std::array<double, 3>& position) const {
      std::size_t hash = 0;
      for (const double c : position) hash = (hash ^ std::bit_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15ULL;
      return hash ^ (hash >> 29);
    }
  };
  std::unordered_map<std::array<double, 3>, std::size_t, Hash> index_;
  PolygonBuilder builder_;
  long merged_ = 0;
};

template <class T>
T little_endian(const char* bytes) {
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), bytes, sizeof(T));
  if (std::endian::native == std::endian::big) raw = {raw[3], raw[2], raw[1], raw[0]};
  return std::bit_cast<T>(raw);
}

ImportedMesh read_binary_stl(ByteSource& source) {
  const auto count = little_endian<std::uint32_t>(source.bytes() + 80);
  source.skip(kHeader);
  CornerMerger merger;
  for (std::uint32_t f = 0; f < count; ++f) {
    if (source.fill(kFacet) < kFacet) {
      throw InputError("the file ends in facet " + std::to_string(f) + " of " + std::to_string(count) +
                       ": it is truncated");
    }
    Facet facet{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Vec3 position;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        position[static_cast<long>(axis)] =
            little_endian<float>(source.bytes() + 12 + 12 * corner + 4 * axis);
      }
      facet[corner] = merger.vertex(position);
    }
    merger.triangle(facet);
    source.skip(kFacet);
  }
  if (source.fill(1) > 0) throw InputError("data follows after the last facet: the count of facets is wrong");
  return merger.finished();
}

ImportedMesh read_ascii_stl(ByteSource& source) {
  CornerMerger merger;
  std::vector<int> corners;
  std::string_view line;
  bool ended = false;
  while (source.next_line(line, kLongestLine)) {
    Words words(line);
    const std::string_view keyword = words.next();
    const std::string place = "line " + std::to_string(source.line_number()) + ": ";
    if (keyword == "vertex") {
      Vec3 position;
      for (double& coordinate : position) {
        if (!words.number(coordinate)) throw InputError(place + "a vertex needs three numbers");
      }
      corners.push_back(merger.vertex(position));
    } else if (keyword == "endloop") {
      if (corners.size() != 3) throw InputError(place + "a facet of STL has three corners");
      merger.triangle({corners[0], corners[1], corners[2]});
      corners.clear();
    } else if (keyword == "endsolid") {
      ended = true;
    } else if (keyword != "facet" && keyword != "outer" && keyword != "endfacet" && keyword != "solid" &&
               !keyword.empty()) {
      throw InputError(place + "\"" + std::string(keyword.substr(0, 40)) + "\" is no word of STL");
    }
  }
  if (!ended) throw InputError("the file ends without \"endsolid\": it is truncated");
  return merger.finished();
}

}  // namespace

ImportedMesh read_stl(std::istream& in) {
  ByteSource source(in);
  // Binary files may begin with "solid" as well; their facets are no text.
  const std::size_t available = source.fill(1024);
  const std::string_view start(source.bytes(), std::min<std::size_t>(available, 1024));
  if (available == 0) throw InputError("there is no data: is the file empty?");
  const bool text = start.rfind("solid", 0) == 0 && start.find('\0') == std::string_view::npos;
  if (text) return read_ascii_stl(source);
  if (available < kHeader) throw InputError("the file is shorter than the header of STL: it is truncated");
  return read_binary_stl(source);
}

}  // namespace partwise::io
