#include <algorithm>
#include <bit>
#include <cstring>
#include <type_traits>
#include <utility>

#include "error.h"
#include "io/ply_codec.h"

namespace partwise::io {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 20;
// Rows to make room for before any has been seen; beyond, room doubles as data arrives.
constexpr std::size_t kTrustedRows = std::size_t{1} << 16;

template <class T, bool swapped>
T value_at(const char* bytes) {
  T value;
  if constexpr (swapped && sizeof(T) > 1) {
    char reversed[sizeof(T)];
    std::reverse_copy(bytes, bytes + sizeof(T), reversed);
    std::memcpy(&value, reversed, sizeof(T));
  } else {
    std::memcpy(&value, bytes, sizeof(T));
  }
  return value;
}

template <bool swapped>
class BinaryRows {
 public:
  BinaryRows(ByteSource& source, PlyTables tables) : source_(source), tables_(std::move(tables)) {}

  PlyTables read() {
    for (Element& element : tables_.elements) {
      const bool any_list = std::any_of(element.properties.begin(), element.properties.end(),
                                        [](const Property& property) { return property.is_list; });
      if (any_list) {
        read_rows_with_lists(element);
      } else {
        read_rows_of_scalars(element);
      }
    }
    if (source_.fill(1) > 0) {
      throw InputError(
          "data follows after the last row that the header names: the header's counts are wrong");
    }
    return std::move(tables_);
  }

 private:
  [[noreturn]] static void truncated(const Element& element, std::size_t row, const Property& property) {
    throw InputError("the file ends in " + place(element, row, property) + " (of " +
                     std::to_string(element.size) + " rows): it is truncated");
  }

  /// Rows of one size: a block at a time, column by column.
  void read_rows_of_scalars(Element& element) {
    std::size_t stride = 0;
    for (const Property& property : element.properties) stride += type_size(property.type());
    for (std::size_t row = 0; row < element.size;) {
      const std::size_t wanted = std::min(element.size - row, std::max<std::size_t>(kBlock / stride, 1));
      const std::size_t rows = std::min(wanted, source_.fill(wanted * stride) / stride);
      std::size_t offset = 0;
      for (Property& property : element.properties) {
        take_column(property, source_.bytes() + offset, stride, rows);
        offset += type_size(property.type());
      }
      source_.skip(rows * stride);
      row += rows;
      if (rows < wanted) truncated(element, row, property_where_data_ends(element));
    }
  }

  static void take_column(Property& property, const char* bytes, std::size_t stride, std::size_t rows) {
    std::visit(
        [&](auto& values) {
          using T = typename std::decay_t<decltype(values)>::value_type;
          const std::size_t before = values.size();
          values.resize(before + rows);
          for (std::size_t i = 0; i < rows; ++i) {
            values[before + i] = value_at<T, swapped>(bytes + i * stride);
          }
        },
        property.values);
  }

  const Property& property_where_data_ends(const Element& element) {
    std::size_t left = source_.fill(1);
    for (const Property& property : element.properties) {
      if (left < type_size(property.type())) return property;
      left -= type_size(property.type());
    }
    return element.properties.back();
  }

  void read_rows_with_lists(Element& element) {
    for (Property& property : element.properties) {
      if (property.is_list) property.offsets.reserve(std::min(element.size, kTrustedRows) + 1);
    }
    if (element.properties.size() == 1) {
      std::visit([&](auto& values) { read_only_list(element, element.properties[0], values, 0); },
                 element.properties[0].values);
      return;
    }
    for (std::size_t row = 0; row < element.size; ++row) {
      for (Property& property : element.properties) {
        std::visit([&](auto& values) { read_value(element, property, values, row); }, property.values);
      }
    }
  }

  template <class T>
  void read_value(const Element& element, Property& property, std::vector<T>& values, std::size_t row) {
    if (property.is_list) {
      take_list(element, property, values, row);
    } else {
      if (source_.fill(sizeof(T)) < sizeof(T)) truncated(element, row, property);
      values.push_back(value_at<T, swapped>(source_.bytes()));
      source_.skip(sizeof(T));
    }
  }

  /// Facets of a mesh, mostly: while lists are as long as the first, they are rows of one size.
  template <class T>
  void read_only_list(const Element& element, Property& property, std::vector<T>& values, std::size_t row) {
    const std::size_t count_size = type_size(property.count_type);
    while (row < element.size) {
      const std::size_t length = take_list(element, property, values, row++);
      const std::size_t stride = count_size + length * sizeof(T);
      const std::size_t wanted = std::min(element.size - row, kBlock / stride);
      const std::size_t rows = std::min(wanted, source_.fill(wanted * stride) / stride);
      const char* bytes = source_.bytes();
      std::size_t equal = 0;
      while (equal < rows &&
             length_at(bytes + equal * stride, property.count_type) == static_cast<std::int64_t>(length)) {
        ++equal;
      }
      const std::size_t before = values.size();
      values.resize(before + equal * length);
      T* to = values.data() + before;
      for (std::size_t i = 0; i < equal; ++i) {
        const char* from = bytes + i * stride + count_size;
        for (std::size_t k = 0; k < length; ++k) *to++ = value_at<T, swapped>(from + k * sizeof(T));
        property.offsets.push_back(before + (i + 1) * length);
      }
      source_.skip(equal * stride);
      row += equal;
    }
  }

  static std::int64_t length_at(const char* bytes, ScalarType type) {
    switch (type) {
      case ScalarType::int8:
        return value_at<std::int8_t, swapped>(bytes);
      case ScalarType::uint8:
        return value_at<std::uint8_t, swapped>(bytes);
      case ScalarType::int16:
        return value_at<std::int16_t, swapped>(bytes);
      case ScalarType::uint16:
        return value_at<std::uint16_t, swapped>(bytes);
      case ScalarType::int32:
        return value_at<std::int32_t, swapped>(bytes);
      default:
        return value_at<std::uint32_t, swapped>(bytes);
    }
  }

  /// Reads one list; its length.
  template <class T>
  std::size_t take_list(const Element& element, Property& property, std::vector<T>& values, std::size_t row) {
    const std::size_t count_size = type_size(property.count_type);
    if (source_.fill(count_size) < count_size) truncated(element, row, property);
    const std::int64_t length = length_at(source_.bytes(), property.count_type);
    source_.skip(count_size);
    if (length < 0) throw InputError(place(element, row, property) + " has a list of negative length");
    for (auto left = static_cast<std::size_t>(length); left > 0;) {
      const std::size_t wanted = std::min(left, kBlock / sizeof(T));
      if (source_.fill(wanted * sizeof(T)) < wanted * sizeof(T)) truncated(element, row, property);
      for (std::size_t k = 0; k < wanted; ++k) {
        values.push_back(value_at<T, swapped>(source_.bytes() + k * sizeof(T)));
      }
      source_.skip(wanted * sizeof(T));
      left -= wanted;
    }
    property.offsets.push_back(values.size());
    return static_cast<std::size_t>(length);
  }

  ByteSource& source_;
  PlyTables tables_;
};

}  // namespace

PlyTables read_binary_rows(ByteSource& source, PlyHeader header) {
  const bool file_is_little = header.format == PlyFormat::binary_little_endian;
  if (file_is_little == (std::endian::native == std::endian::little)) {
    return BinaryRows<false>(source, std::move(header.tables)).read();
  }
  return BinaryRows<true>(source, std::move(header.tables)).read();
}

}  // namespace partwise::io
