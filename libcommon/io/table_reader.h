#pragma once

#include <string>
#include <vector>

#include "io/ply.h"
#include "mesh/types.h"

namespace partwise::io {

/// Reads the columns of one element, checking every value. Every fault is an InputError that names element,
/// row and property.
class ElementReader {
 public:
  /// \throws InputError when the element is missing.
  ElementReader(const PlyTables& tables, std::string element);

  int size() const { return size_; }

  /// Columns x, y, z; finite.
  Points points() const;
  /// Column vertex_indices (or vertex_index, as some programs write): triangles over `vertex_count` vertices.
  Facets facets(int vertex_count) const;
  /// Integers in lowest .. highest.
  std::vector<int> integers(const std::string& property, int lowest, int highest) const;
  /// Finite numbers.
  std::vector<double> numbers(const std::string& property) const;
  /// Numbers in lowest .. highest.
  std::vector<double> numbers(const std::string& property, double lowest, double highest) const;
  /// A list of integers in lowest .. highest per row.
  std::vector<std::vector<int>> lists(const std::string& property, int lowest, int highest) const;

  /// \throws InputError naming element, row, property and `problem`.
  [[noreturn]] void fail(std::size_t row, const std::string& property, const std::string& problem) const;

  /// \throws InputError naming the first row where the column differs from `expected`.
  void require_equal(const std::string& property, const std::vector<int>& expected) const;

 private:
  const Property& list_property(const std::string& property) const;
  std::vector<int> list_values(const Property& column, int lowest, int highest) const;

  const PlyTables& tables_;
  std::string name_;
  const Element* element_;
  int size_;
};

/// Rows of a table that belong to one part: first .. last - 1.
struct RowRange {
  int first = 0;
  int last = 0;
  int size() const { return last - first; }
};

/// The rows of each part in a table sorted by its column `part`. \throws InputError when it is not sorted or
/// a part has no row.
std::vector<RowRange> rows_by_part(const ElementReader& table, int part_count);

}  // namespace partwise::io
