#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "error.h"
#include "io/ply_codec.h"

namespace partwise::io {
namespace {

constexpr std::size_t kLongestLine = std::size_t{1} << 20;
constexpr std::size_t kLongestHeader = std::size_t{1} << 28;

struct TypeNames {
  std::string_view classic;
  std::string_view sized;
  std::size_t bytes;
};
constexpr std::array<TypeNames, 8> kTypes{{{"char", "int8", 1},
                                           {"uchar", "uint8", 1},
                                           {"short", "int16", 2},
                                           {"ushort", "uint16", 2},
                                           {"int", "int32", 4},
                                           {"uint", "uint32", 4},
                                           {"float", "float32", 4},
                                           {"double", "float64", 8}}};

/// Takes the next word off `line`; empty at its end.
std::string_view next_word(std::string_view& line) {
  const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
  const std::size_t end = std::min(line.find_first_of(" \t", begin), line.size());
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

/// The header, line by line.
class HeaderReader {
 public:
  explicit HeaderReader(ByteSource& source) : source_(source) {}

  PlyHeader read() {
    std::string_view line;
    if (!next(line)) throw InputError("there is no data: is the file empty, or did the program before fail?");
    if (line != "ply") fault("is not \"ply\": give a PLY file");
    while (next(line)) {
      if (line == "end_header") return finished();
      read_line(line);
    }
    throw InputError("the header ends in line " + std::to_string(source_.line_number()) +
                     " without \"end_header\": the file is truncated or no PLY");
  }

 private:
  [[noreturn]] void fault(const std::string& what) const {
    throw InputError("line " + std::to_string(source_.line_number()) + " " + what);
  }

  bool next(std::string_view& line) {
    if (!source_.next_line(line, kLongestLine)) return false;
    length_ += line.size();
    if (length_ > kLongestHeader) fault("and the header still has no end: the file is no PLY or damaged");
    return true;
  }

  void read_line(std::string_view line) {
    std::string_view rest = line;
    const std::string_view keyword = next_word(rest);
    if (keyword == "comment") {
      if (!rest.empty()) rest.remove_prefix(1);
      header_.tables.comments.emplace_back(rest);
    } else if (keyword == "format") {
      read_format(rest);
    } else if (keyword == "element") {
      read_element(rest);
    } else if (keyword == "property") {
      read_property(rest);
    } else if (keyword != "obj_info" && !keyword.empty()) {
      fault("begins with the unknown word \"" + std::string(keyword.substr(0, 40)) +
            "\": a PLY header has format, comment, element, property and end_header lines");
    }
  }

  void read_format(std::string_view rest) {
    const std::string_view name = next_word(rest);
    const std::string_view version = next_word(rest);
    constexpr std::array<std::string_view, 3> kFormats{"ascii", "binary_little_endian", "binary_big_endian"};
    const auto found = std::find(kFormats.begin(), kFormats.end(), name);
    if (found == kFormats.end() || version != "1.0" || !next_word(rest).empty()) {
      fault("must name the format ascii, binary_little_endian or binary_big_endian and version 1.0");
    }
    if (has_format_) fault("names a format for the second time");
    has_format_ = true;
    header_.format = static_cast<PlyFormat>(found - kFormats.begin());
  }

  void read_element(std::string_view rest) {
    const std::string_view name = next_word(rest);
    const std::string_view count = next_word(rest);
    Element element;
    element.name = name;
    const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), element.size);
    if (name.empty() || error != std::errc() || end != count.data() + count.size() ||
        !next_word(rest).empty()) {
      fault("must have the form \"element <name> <count>\"");
    }
    if (header_.tables.find(element.name)) fault("names the element " + element.name + " again");
    header_.tables.elements.push_back(std::move(element));
  }

  ScalarType read_type(std::string_view& rest) const {
    const std::string_view name = next_word(rest);
    const std::optional<ScalarType> type = type_called(name);
    if (!type) fault("names the unknown type \"" + std::string(name.substr(0, 40)) + "\"");
    return *type;
  }

  void read_property(std::string_view rest) {
    if (header_.tables.elements.empty()) fault("names a property before any element");
    Element& element = header_.tables.elements.back();
    Property property;
    std::string_view after = rest;
    if (next_word(after) == "list") {
      rest = after;
      property.is_list = true;
      property.count_type = read_type(rest);
      if (property.count_type >= ScalarType::float32)
        fault("counts a list's values in a type with fractions");
      property.offsets = {0};
    }
    property.values = values_of(read_type(rest));
    property.name = next_word(rest);
    if (property.name.empty() || !next_word(rest).empty()) {
      fault("must have the form \"property <type> <name>\" or \"property list <type> <type> <name>\"");
    }
    if (element.find(property.name)) {
      fault("names the property " + property.name + " of element " + element.name + " again");
    }
    element.properties.push_back(std::move(property));
  }

  PlyHeader finished() {
    if (!has_format_) fault("ends a header without a format line");
    for (const Element& element : header_.tables.elements) {
      if (element.size > 0 && element.properties.empty()) {
        fault("ends a header whose element " + element.name + " has rows but no properties");
      }
    }
    return std::move(header_);
  }

  ByteSource& source_;
  PlyHeader header_;
  std::size_t length_ = 0;
  bool has_format_ = false;
};

}  // namespace

std::string_view type_name(ScalarType type) {
  return kTypes[static_cast<std::size_t>(type)].classic;
}

std::optional<ScalarType> type_called(std::string_view name) {
  for (std::size_t i = 0; i < kTypes.size(); ++i) {
    if (name == kTypes[i].classic || name == kTypes[i].sized) return static_cast<ScalarType>(i);
  }
  return std::nullopt;
}

std::size_t type_size(ScalarType type) {
  return kTypes[static_cast<std::size_t>(type)].bytes;
}

PlyHeader read_ply_header(ByteSource& source) {
  return HeaderReader(source).read();
}

}  // namespace partwise::io
