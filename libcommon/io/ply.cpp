#include "io/ply.h"

#include <algorithm>
#include <istream>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "error.h"
#include "io/ply_codec.h"

namespace partwise::io {
namespace {

template <class T>
const T* find_named(const std::vector<T>& items, const std::string& name) {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const T& item) { return item.name == name; });
  return found == items.end() ? nullptr : &*found;
}

template <std::size_t... index>
Values empty_values(ScalarType type, std::index_sequence<index...>) {
  Values values;
  ((static_cast<std::size_t>(type) == index ? (void)values.emplace<index>() : void()), ...);
  return values;
}

/// Whether `to` holds the same number as `from`.
template <class To, class From>
bool converts(From from) {
  if constexpr (std::is_floating_point_v<To>) {
    return true;
  } else if constexpr (std::is_floating_point_v<From>) {
    return from >= static_cast<double>(std::numeric_limits<To>::min()) &&
           from <= static_cast<double>(std::numeric_limits<To>::max()) &&
           static_cast<From>(static_cast<To>(from)) == from;
  } else {
    return std::in_range<To>(from);
  }
}

const Property& find_column(const PlyTables& tables, const std::string& element, const std::string& property,
                            bool is_list) {
  const Element* table = tables.find(element);
  if (!table) throw InputError("element " + element + " is missing: is this the right kind of file?");
  const Property* found = table->find(property);
  if (!found) throw InputError("element " + element + " has no property " + property);
  if (found->is_list != is_list) {
    throw InputError("element " + element + ", property " + property +
                     (is_list ? " must be a list" : " must not be a list"));
  }
  return *found;
}

/// \pre `width` values belong to each row
template <class T>
std::vector<T> converted(const Property& column, const std::string& element, std::size_t width) {
  return std::visit(
      [&](const auto& values) {
        using From = typename std::decay_t<decltype(values)>::value_type;
        std::vector<T> result(values.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
          if (!converts<T, From>(values[i])) {
            throw InputError("element " + element + ", row " + std::to_string(i / width) + ", property " +
                             column.name + " is " + std::to_string(values[i]) +
                             ", which is no integer of 32 bits");
          }
          result[i] = static_cast<T>(values[i]);
        }
        return result;
      },
      column.values);
}

}  // namespace

const Property* Element::find(const std::string& property) const {
  return find_named(properties, property);
}

const Element* PlyTables::find(const std::string& element) const {
  return find_named(elements, element);
}

Values values_of(ScalarType type) {
  return empty_values(type, std::make_index_sequence<std::variant_size_v<Values>>());
}

std::size_t value_count(const Values& values) {
  return std::visit([](const auto& list) { return list.size(); }, values);
}

std::string place(const Element& element, std::size_t row, const Property& property) {
  return "element " + element.name + ", row " + std::to_string(row) + ", property " + property.name;
}

std::vector<double> numbers_of(const Values& values) {
  return std::visit([](const auto& list) { return std::vector<double>(list.begin(), list.end()); }, values);
}

Property scalar_column(std::string name, Values values) {
  return {std::move(name), std::move(values), false, ScalarType::uint8, {}};
}

Property list_column(std::string name, Values values, std::size_t width) {
  const std::size_t count = value_count(values);
  if (width == 0 || width > 255 || count % width != 0) {
    throw std::invalid_argument("property " + name + ": " + std::to_string(count) +
                                " values are no lists of " + std::to_string(width));
  }
  std::vector<std::size_t> offsets(count / width + 1);
  for (std::size_t row = 0; row < offsets.size(); ++row) offsets[row] = row * width;
  return {std::move(name), std::move(values), true, ScalarType::uint8, std::move(offsets)};
}

PlyTables read_ply(std::istream& in) {
  ByteSource source(in);
  PlyHeader header = read_ply_header(source);
  return header.format == PlyFormat::ascii ? read_ascii_rows(source, std::move(header))
                                           : read_binary_rows(source, std::move(header));
}

template <class T>
std::vector<T> column(const PlyTables& tables, const std::string& element, const std::string& property) {
  return converted<T>(find_column(tables, element, property, false), element, 1);
}

template <class T>
std::vector<T> lists(const PlyTables& tables, const std::string& element, const std::string& property,
                     std::size_t width) {
  const Property& column = find_column(tables, element, property, true);
  for (std::size_t row = 0; row + 1 < column.offsets.size(); ++row) {
    const std::size_t length = column.offsets[row + 1] - column.offsets[row];
    if (length != width) {
      throw InputError("element " + element + ", row " + std::to_string(row) + ", property " + property +
                       " has " + std::to_string(length) + " values instead of " + std::to_string(width));
    }
  }
  return converted<T>(column, element, width);
}

template std::vector<int> column(const PlyTables&, const std::string&, const std::string&);
template std::vector<double> column(const PlyTables&, const std::string&, const std::string&);
template std::vector<int> lists(const PlyTables&, const std::string&, const std::string&, std::size_t);
template std::vector<double> lists(const PlyTables&, const std::string&, const std::string&, std::size_t);

}  // namespace partwise::io
