#include "io/table_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

#include "error.h"

namespace partwise::io {
namespace {

std::string not_in_range(const std::string& value, const std::string& lowest, const std::string& highest) {
  return value + " is not in " + lowest + " .. " + highest;
}

}  // namespace

ElementReader::ElementReader(const PlyTables& tables, std::string element)
    : tables_(tables), name_(std::move(element)), element_(tables.find(name_)), size_(0) {
  if (element_ == nullptr) {
    throw InputError("element '" + name_ + "' is missing: this is no document of the expected kind");
  }
  if (!std::in_range<int>(element_->size)) throw InputError("element '" + name_ + "' has too many rows");
  size_ = static_cast<int>(element_->size);
}

void ElementReader::fail(std::size_t row, const std::string& property, const std::string& problem) const {
  throw InputError("element '" + name_ + "', row " + std::to_string(row) + ", property '" + property +
                   "': " + problem);
}

std::vector<double> ElementReader::numbers(const std::string& property) const {
  std::vector<double> values = column<double>(tables_, name_, property);
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (!std::isfinite(values[row])) fail(row, property, "the value is not finite");
  }
  return values;
}

std::vector<double> ElementReader::numbers(const std::string& property, double lowest, double highest) const {
  std::vector<double> values = numbers(property);
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (values[row] >= lowest && values[row] <= highest) continue;
    fail(row, property,
         not_in_range(std::to_string(values[row]), std::to_string(lowest), std::to_string(highest)));
  }
  return values;
}

std::vector<int> ElementReader::integers(const std::string& property, int lowest, int highest) const {
  std::vector<int> values = column<int>(tables_, name_, property);
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (values[row] >= lowest && values[row] <= highest) continue;
    fail(row, property,
         not_in_range(std::to_string(values[row]), std::to_string(lowest), std::to_string(highest)));
  }
  return values;
}

Points ElementReader::points() const {
  const std::vector<double> x = numbers("x"), y = numbers("y"), z = numbers("z");
  Points points;
  points.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) points.emplace_back(x[i], y[i], z[i]);
  return points;
}

const Property& ElementReader::list_property(const std::string& property) const {
  const Property* found = element_->find(property);
  if (found == nullptr || !found->is_list) {
    throw InputError("element '" + name_ + "' has no list property '" + property + "'");
  }
  const std::size_t value_count = std::visit([](const auto& values) { return values.size(); }, found->values);
  bool sound = found->offsets.size() == element_->size + 1 && found->offsets.front() == 0 &&
               found->offsets.back() == value_count;
  for (std::size_t i = 0; sound && i < element_->size; ++i) {
    sound = found->offsets[i] <= found->offsets[i + 1];
  }
  if (!sound) {
    throw InputError("element '" + name_ + "', property '" + property + "': lists and rows do not match");
  }
  return *found;
}

std::vector<int> ElementReader::list_values(const Property& column, int lowest, int highest) const {
  std::vector<int> result;
  auto read = [&](const auto& values) {
    using Value = typename std::decay_t<decltype(values)>::value_type;
    if constexpr (std::is_floating_point_v<Value>) {
      throw InputError("element '" + name_ + "', property '" + column.name + "': indices must be integers");
    } else {
      result.reserve(values.size());
      for (std::size_t i = 0; i < values.size(); ++i) {
        const auto value = static_cast<std::int64_t>(values[i]);
        if (value < lowest || value > highest) {
          const auto next_row = std::upper_bound(column.offsets.begin(), column.offsets.end(), i);
          fail(next_row - column.offsets.begin() - 1, column.name,
               not_in_range(std::to_string(value), std::to_string(lowest), std::to_string(highest)));
        }
        result.push_back(static_cast<int>(value));
      }
    }
  };
  std::visit(read, column.values);
  return result;
}

std::vector<std::vector<int>> ElementReader::lists(const std::string& property, int lowest,
                                                   int highest) const {
  const Property& column = list_property(property);
  const std::vector<int> values = list_values(column, lowest, highest);
  std::vector<std::vector<int>> rows;
  for (int row = 0; row < size_; ++row) {
    rows.emplace_back(values.begin() + column.offsets[row], values.begin() + column.offsets[row + 1]);
  }
  return rows;
}

Facets ElementReader::facets(int vertex_count) const {
  const std::string property =
      element_->find("vertex_indices") != nullptr ? "vertex_indices" : "vertex_index";
  const Property& column = list_property(property);
  for (int row = 0; row < size_; ++row) {
    const std::size_t corners = column.offsets[row + 1] - column.offsets[row];
    if (corners != 3) {
      fail(row, property,
           "the facet has " + std::to_string(corners) + " vertices, not 3; convert-mesh triangulates");
    }
  }
  const std::vector<int> values = list_values(column, 0, vertex_count - 1);
  Facets facets(element_->size);
  for (std::size_t f = 0; f < facets.size(); ++f) {
    facets[f] = {values[3 * f], values[3 * f + 1], values[3 * f + 2]};
  }
  return facets;
}

void ElementReader::require_equal(const std::string& property, const std::vector<int>& expected) const {
  const std::vector<int> values =
      integers(property, std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
  if (values.size() != expected.size()) {
    throw InputError("element '" + name_ + "' has " + std::to_string(values.size()) + " rows, " +
                     std::to_string(expected.size()) + " are expected");
  }
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (values[row] == expected[row]) continue;
    fail(row, property,
         std::to_string(values[row]) + " contradicts the rest of the document, which says " +
             std::to_string(expected[row]));
  }
}

std::vector<RowRange> rows_by_part(const ElementReader& table, int part_count) {
  const std::vector<int> part = table.integers("part", 0, part_count - 1);
  std::vector<RowRange> ranges(part_count);
  for (int row = 0; row < table.size(); ++row) {
    if (row > 0 && part[row] < part[row - 1]) table.fail(row, "part", "rows are not sorted by part");
    RowRange& range = ranges[part[row]];
    if (range.last == 0) range.first = row;
    range.last = row + 1;
  }
  for (int k = 0; k < part_count; ++k) {
    if (ranges[k].size() == 0) table.fail(0, "part", "no row belongs to part " + std::to_string(k));
  }
  return ranges;
}

}  // namespace partwise::io
