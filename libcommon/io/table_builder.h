#pragma once

#include <string>
#include <utility>
#include <vector>

#include "io/ply.h"
#include "mesh/types.h"

namespace partwise::io {

/// Builds one element column by column; every column has as many rows as the element.
class ElementBuilder {
 public:
  ElementBuilder(std::string name, std::size_t size);

  /// Columns x, y, z.
  ElementBuilder& points(const Points& points);
  /// Column vertex_indices.
  ElementBuilder& facets(const Facets& facets);
  ElementBuilder& integers(const std::string& property, std::vector<int> values);
  ElementBuilder& numbers(const std::string& property, std::vector<double> values);
  ElementBuilder& lists(const std::string& property, const std::vector<std::vector<int>>& rows);
  /// Columns red, green, blue by which viewers tell the parts apart; readers ignore them.
  ElementBuilder& part_colours(const std::vector<int>& parts);

  /// The finished element; the builder is empty afterwards.
  Element build() { return std::move(element_); }

 private:
  ElementBuilder& add(const std::string& property, Values values);

  Element element_;
};

}  // namespace partwise::io
