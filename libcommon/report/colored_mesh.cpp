#include "report/colored_mesh.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

#include "io/table_builder.h"
#include "io/table_reader.h"
#include "report/color_map.h"

namespace partwise::report {

io::PlyTables colored_mesh(const SurfaceField& field) {
  std::array<std::vector<std::uint8_t>, 3> channels;
  for (const double value : field.values) {
    const Rgb color = viridis(field.share(value));
    for (std::size_t i = 0; i < channels.size(); ++i) channels[i].push_back(color[i]);
  }
  io::Element vertices = io::ElementBuilder("vertex", field.points.size())
                             .points(field.points)
                             .numbers("quality", field.values)
                             .build();
  const char* const names[] = {"red", "green", "blue"};
  for (std::size_t i = 0; i < channels.size(); ++i) {
    vertices.properties.push_back(io::scalar_column(names[i], std::move(channels[i])));
  }
  std::ostringstream range, extent;
  range << "colours: viridis, dark violet at " << field.low << " and below, yellow at " << field.high
        << " and above, " << (field.logarithmic ? "logarithmic" : "linear");
  const auto [least, most] = std::minmax_element(field.values.begin(), field.values.end());
  if (least != field.values.end()) extent << "quality: from " << *least << " to " << *most << " on this mesh";
  return {
      {"quality: " + field.meaning, range.str(), extent.str()},
      {std::move(vertices), io::ElementBuilder("face", field.facets.size()).facets(field.facets).build()}};
}

bool has_vertex_colors(const io::PlyTables& tables) {
  const io::Element* const vertices = tables.find("vertex");
  return vertices != nullptr && vertices->find("red") != nullptr && vertices->find("green") != nullptr &&
         vertices->find("blue") != nullptr;
}

Panel colored_panel(const io::PlyTables& tables) {
  Panel panel;
  panel.points = io::ElementReader(tables, "vertex").points();
  panel.facets = io::ElementReader(tables, "face").facets(static_cast<int>(panel.points.size()));
  panel.view = automatic_view(panel.points);
  std::vector<Color> of_vertex(panel.points.size());
  const char* const names[] = {"red", "green", "blue"};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::vector<double> channel = io::ElementReader(tables, "vertex").numbers(names[i], 0, 255);
    for (std::size_t v = 0; v < channel.size(); ++v) of_vertex[v][i] = static_cast<float>(channel[v] / 255);
  }
  for (const auto& [a, b, c] : panel.facets) {
    Color color{};
    for (std::size_t i = 0; i < 3; ++i) color[i] = (of_vertex[a][i] + of_vertex[b][i] + of_vertex[c][i]) / 3;
    panel.colors.push_back(color);
  }
  panel.caption = std::to_string(panel.facets.size()) + " facets";
  return panel;
}

}  // namespace partwise::report
