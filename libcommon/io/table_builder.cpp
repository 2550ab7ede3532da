#include "io/table_builder.h"

#include <cmath>

namespace partwise::io {
namespace {

/// Well separated, light colours: the hue turns by the golden ratio from part to part.
std::array<std::uint8_t, 3> part_colour(int part) {
  const double turn = part * 0.6180339887498949;
  const double hue = 6 * (turn - std::floor(turn));
  std::array<std::uint8_t, 3> colour{};
  for (int channel = 0; channel < 3; ++channel) {
    const double distance = std::abs(std::remainder(hue - 2 * channel, 6));
    const double strength = std::min(1.0, std::max(0.0, 2 - distance));
    colour[channel] = static_cast<std::uint8_t>(std::lround(75 + 165 * strength));
  }
  return colour;
}

}  // namespace

ElementBuilder::ElementBuilder(std::string name, std::size_t size) {
  element_.name = std::move(name);
  element_.size = size;
}

ElementBuilder& ElementBuilder::add(const std::string& property, Values values) {
  element_.properties.push_back(scalar_column(property, std::move(values)));
  return *this;
}

ElementBuilder& ElementBuilder::points(const Points& points) {
  const char* const names[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    values.reserve(points.size());
    for (const Vec3& point : points) values.push_back(point[axis]);
    add(names[axis], std::move(values));
  }
  return *this;
}

ElementBuilder& ElementBuilder::facets(const Facets& facets) {
  std::vector<int> values;
  values.reserve(3 * facets.size());
  for (const Facet& facet : facets) values.insert(values.end(), facet.begin(), facet.end());
  element_.properties.push_back(list_column("vertex_indices", std::move(values), 3));
  return *this;
}

ElementBuilder& ElementBuilder::integers(const std::string& property, std::vector<int> values) {
  return add(property, std::move(values));
}

ElementBuilder& ElementBuilder::numbers(const std::string& property, std::vector<double> values) {
  return add(property, std::move(values));
}

ElementBuilder& ElementBuilder::lists(const std::string& property,
                                      const std::vector<std::vector<int>>& rows) {
  std::vector<int> values;
  Property column;
  for (const std::vector<int>& row : rows) {
    column.offsets.push_back(values.size());
    values.insert(values.end(), row.begin(), row.end());
  }
  column.offsets.push_back(values.size());
  column.name = property;
  column.is_list = true;
  column.count_type = ScalarType::int32;
  column.values = std::move(values);
  element_.properties.push_back(std::move(column));
  return *this;
}

ElementBuilder& ElementBuilder::part_colours(const std::vector<int>& parts) {
  const char* const names[] = {"red", "green", "blue"};
  for (int channel = 0; channel < 3; ++channel) {
    std::vector<std::uint8_t> values;
    values.reserve(parts.size());
    for (const int part : parts) values.push_back(part_colour(part)[channel]);
    add(names[channel], std::move(values));
  }
  return *this;
}

}  // namespace partwise::io
