#include <algorithm>
#include <bit>
#include <cstring>
#include <ostream>
#include <stdexcept>
#include <type_traits>

#include "error.h"
#include "io/ply_codec.h"

namespace partwise::io {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 20;

[[noreturn]] void inconsistent(const Element& element, const Property& property, const std::string& what) {
  throw std::invalid_argument("element " + element.name + ", property " + property.name + ": " + what);
}

std::uint64_t longest_list(ScalarType count_type) {
  switch (count_type) {
    case ScalarType::int8:
      return 0x7f;
    case ScalarType::uint8:
      return 0xff;
    case ScalarType::int16:
      return 0x7fff;
    case ScalarType::uint16:
      return 0xffff;
    case ScalarType::int32:
      return 0x7fffffff;
    case ScalarType::uint32:
      return 0xffffffff;
    default:
      return 0;
  }
}

void check_name(const std::string& name) {
  bool good = !name.empty();
  for (const char c : name) good = good && c > ' ' && c < 127;
  if (!good) throw std::invalid_argument("\"" + name + "\" cannot be a name in a PLY file");
}

void check_column(const Element& element, const Property& property) {
  check_name(property.name);
  const std::size_t values = value_count(property.values);
  if (!property.is_list) {
    if (values != element.size) {
      inconsistent(element, property,
                   std::to_string(values) + " values for " + std::to_string(element.size) + " rows");
    }
    return;
  }
  const auto& offsets = property.offsets;
  if (offsets.size() != element.size + 1 || offsets.front() != 0 || offsets.back() != values) {
    inconsistent(element, property, "the offsets of the lists do not fit the rows and values");
  }
  const std::uint64_t longest = longest_list(property.count_type);
  for (std::size_t row = 0; row < element.size; ++row) {
    if (offsets[row] > offsets[row + 1] || offsets[row + 1] - offsets[row] > longest) {
      inconsistent(element, property,
                   "the list in row " + std::to_string(row) + " has no length that " +
                       std::string(type_name(property.count_type)) + " can hold");
    }
  }
}

void check_tables(const PlyTables& tables, const std::vector<std::string>& comments) {
  for (const std::string& comment : comments) {
    if (comment.find_first_of("\r\n") != std::string::npos) {
      throw std::invalid_argument("a PLY comment must be one line");
    }
  }
  for (const Element& element : tables.elements) {
    check_name(element.name);
    if (element.size > 0 && element.properties.empty()) {
      throw std::invalid_argument("element " + element.name + " has rows but no properties");
    }
    for (const Property& property : element.properties) check_column(element, property);
  }
}

std::string header_text(const PlyTables& tables, const std::vector<std::string>& comments) {
  std::string text = "ply\nformat binary_little_endian 1.0\n";
  for (const std::string& comment : comments) text += "comment " + comment + "\n";
  for (const Element& element : tables.elements) {
    text += "element " + element.name + " " + std::to_string(element.size) + "\n";
    for (const Property& property : element.properties) {
      text += "property ";
      if (property.is_list) text += "list " + std::string(type_name(property.count_type)) + " ";
      text += std::string(type_name(property.type())) + " " + property.name + "\n";
    }
  }
  return text + "end_header\n";
}

/// Gathers bytes into big blocks.
class Output {
 public:
  explicit Output(std::ostream& out) : out_(out) { buffer_.reserve(kBlock); }

  template <class T>
  void put(const T* values, std::size_t count) {
    if (buffer_.size() + count * sizeof(T) > kBlock) flush();
    const std::size_t before = buffer_.size();
    buffer_.resize(before + count * sizeof(T));
    std::memcpy(buffer_.data() + before, values, count * sizeof(T));
    if constexpr (std::endian::native == std::endian::big && sizeof(T) > 1) {
      for (std::size_t i = before; i < buffer_.size(); i += sizeof(T)) {
        std::reverse(buffer_.begin() + i, buffer_.begin() + i + sizeof(T));
      }
    }
  }
  void flush() {
    out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    buffer_.clear();
    if (!out_) throw IoError("writing failed: is the disk full, or has the reader of the pipe ended?");
  }

 private:
  std::ostream& out_;
  std::string buffer_;
};

void put_count(Output& out, ScalarType type, std::size_t count) {
  Values one = values_of(type);
  std::visit(
      [&](auto& values) {
        values.push_back(static_cast<typename std::decay_t<decltype(values)>::value_type>(count));
        out.put(values.data(), 1);
      },
      one);
}

void put_row(Output& out, const Property& property, std::size_t row) {
  std::visit(
      [&](const auto& values) {
        if (!property.is_list) {
          out.put(values.data() + row, 1);
          return;
        }
        const std::size_t begin = property.offsets[row];
        const std::size_t count = property.offsets[row + 1] - begin;
        if (property.count_type == ScalarType::uint8) {
          const auto length = static_cast<std::uint8_t>(count);
          out.put(&length, 1);
        } else {
          put_count(out, property.count_type, count);
        }
        out.put(values.data() + begin, count);
      },
      property.values);
}

}  // namespace

void write_ply(std::ostream& out, const PlyTables& tables) {
  write_ply(out, tables, tables.comments);
}

void write_ply(std::ostream& out, const PlyTables& tables, const std::vector<std::string>& comments) {
  check_tables(tables, comments);
  const std::string header = header_text(tables, comments);
  Output output(out);
  output.put(header.data(), header.size());
  for (const Element& element : tables.elements) {
    for (std::size_t row = 0; row < element.size; ++row) {
      for (const Property& property : element.properties) put_row(output, property, row);
    }
  }
  output.flush();
}

}  // namespace partwise::io
