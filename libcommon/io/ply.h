#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <variant>
#include <vector>

namespace partwise::io {

/// Values of one PLY scalar type. The order is that of ScalarType.
using Values = std::variant<std::vector<std::int8_t>, std::vector<std::uint8_t>, std::vector<std::int16_t>,
                            std::vector<std::uint16_t>, std::vector<std::int32_t>, std::vector<std::uint32_t>,
                            std::vector<float>, std::vector<double>>;
enum class ScalarType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// One column of an element: a scalar per row, or a list per row.
struct Property {
  std::string name;
  Values values;  ///< scalars by row, or the rows' lists one after the other
  bool is_list = false;
  ScalarType count_type = ScalarType::uint8;  ///< of a list's length in the file
  std::vector<std::size_t> offsets;           ///< lists only: row i is values[offsets[i] .. offsets[i + 1])

  ScalarType type() const { return static_cast<ScalarType>(values.index()); }
};

/// A table: `size` rows of named columns.
struct Element {
  std::string name;
  std::size_t size = 0;
  std::vector<Property> properties;

  const Property* find(const std::string& property) const;
};

/// A PLY file in memory, any elements and properties, in the order of the file.
struct PlyTables {
  std::vector<std::string> comments;
  std::vector<Element> elements;

  const Element* find(const std::string& element) const;
};

/// The values as double, which holds all of PLY's types exactly.
std::vector<double> numbers_of(const Values& values);

/// A column of scalars.
Property scalar_column(std::string name, Values values);

/// A column of lists that all have `width` values. \pre values.size() is a multiple of width, 0 < width < 256
Property list_column(std::string name, Values values, std::size_t width);

/// Reads ASCII and binary PLY of both byte orders, front to back without seeking (pipes), up to the end.
///
/// Memory grows with the data that is there, whatever counts the file claims. `obj_info` lines are skipped.
/// \throws InputError naming line (header, ASCII) or element, row and property of the first fault: unknown
///         types, truncated or surplus data, lists of negative length, numbers that do not parse or do not
///         fit; IoError when the stream fails.
PlyTables read_ply(std::istream& in);

/// Writes binary little-endian PLY. \throws IoError when the stream fails; std::invalid_argument naming
/// element and property when the tables are not consistent or a name cannot be written.
void write_ply(std::ostream& out, const PlyTables& tables);

/// The same with other comments than the tables'.
void write_ply(std::ostream& out, const PlyTables& tables, const std::vector<std::string>& comments);

/// A scalar column converted to T. \throws InputError when the element or column is missing, a list, or does
/// not fit into T without loss (float64 -> int only for whole numbers).
template <class T>
std::vector<T> column(const PlyTables& tables, const std::string& element, const std::string& property);

/// A list column whose rows all have `width` values, one row after the other, converted to T.
/// \throws InputError as `column`, and naming the first row of another length.
template <class T>
std::vector<T> lists(const PlyTables& tables, const std::string& element, const std::string& property,
                     std::size_t width);

extern template std::vector<int> column(const PlyTables&, const std::string&, const std::string&);
extern template std::vector<double> column(const PlyTables&, const std::string&, const std::string&);
extern template std::vector<int> lists(const PlyTables&, const std::string&, const std::string&, std::size_t);
extern template std::vector<double> lists(const PlyTables&, const std::string&, const std::string&,
                                          std::size_t);

}  // namespace partwise::io
