#include "measure/figures_table.h"

#include <algorithm>
#include <cstdio>

namespace partwise {
namespace {

using io::Json;

enum class Format { count, percent, number, text };

/// One figure: where it is in the document, how it is shown.
struct Figure {
  const char* pointer;
  Format format;
  const char* heading;
  const char* meaning;
};

constexpr Figure kFigures[] = {
    {"/source_faces", Format::count, "source", "facets of the source"},
    {"/target_faces", Format::count, "target", "facets of the target"},
    {"/parts", Format::count, "", "parts"},
    {"/markers", Format::count, "markers", "markers"},
    {"/rms_distance", Format::percent, "rms %", "two-sided RMS distance, % of the target's diagonal"},
    {"/max_distance", Format::percent, "max %", "two-sided largest distance, % of the diagonal"},
    {"/on_surface_max", Format::number, "off",
     "largest distance of a vertex to the target, over the diagonal"},
    {"/marker_error_max", Format::percent, "marker %", "largest error at a marker, % of the diagonal"},
    {"/marker_worst", Format::text, "", "the marker where it is"},
    {"/boundary_gap_max", Format::number, "", "largest gap between parts, over the diagonal"},
    {"/flipped_faces", Format::count, "flipped", "facets that face against the target"},
    {"/degenerate_faces", Format::count, "degen", "facets without area"},
    {"/self_intersections/compatible", Format::count, "selfint", "self-intersecting pairs of facets"},
    {"/self_intersections/source", Format::count, "", "the source's own"},
    {"/self_intersections/target", Format::count, "", "the target's own"},
    {"/hull_folds/total", Format::count, "folds", "folded facets in the maps onto hulls"},
    {"/one_to_one", Format::text, "1:1", "whether the map is certified one-to-one"},
    {"/l2_stretch_efficiency", Format::number, "l2eff", "L2 stretch efficiency, 1 is best"},
    {"/symmetric_dirichlet", Format::number, "symdir", "symmetric Dirichlet energy, 4 is an isometry"},
    {"/symmetric_dirichlet_median", Format::number, "", "its median"},
    {"/angle_error_deg", Format::number, "angle", "mean change of angles, degrees"},
    {"/truth/mean", Format::percent, "truth %", "mean geodesic error, % of sqrt(area)"},
    {"/truth/median", Format::percent, "", "its median"},
    {"/truth/quantile_90", Format::percent, "", "its 90 % quantile"},
    {"/truth/quantile_99", Format::percent, "", "its 99 % quantile"},
    {"/truth/max", Format::percent, "", "the largest"},
    {"/truth/share_below_05", Format::percent, "", "% of the vertices with an error below 0.05"},
    {"/truth/share_below_10", Format::percent, "", "below 0.1"},
    {"/truth/share_below_25", Format::percent, "", "below 0.25"},
};

std::string printed(const char* format, double value) {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// "-" where the document has no value.
std::string shown(const Json& document, const Figure& figure) {
  const Json::json_pointer pointer(figure.pointer);
  if (!document.contains(pointer)) return "-";
  const Json& value = document.at(pointer);
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (!value.is_number()) return "-";
  switch (figure.format) {
    case Format::count:
      return printed("%.0f", value.get<double>());
    case Format::percent:
      return printed("%.3f", 100 * value.get<double>());
    default:
      return printed("%.4g", value.get<double>());
  }
}

using Row = std::vector<std::string>;

/// Columns side by side, the first on the left, the others on the right of their place.
std::string aligned(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string padding(widths[i] - row[i].size(), ' ');
      text += i == 0 ? row[i] + padding : "  " + padding + row[i];
    }
    text += '\n';
  }
  return text;
}

}  // namespace

std::vector<FigureRow> figure_rows(const Json& document) {
  std::vector<FigureRow> rows;
  for (const Figure& figure : kFigures) {
    const std::string value = shown(document, figure);
    const bool optional = std::string(figure.pointer).rfind("/truth", 0) == 0;
    if (value != "-" || !optional) rows.push_back({figure.pointer, figure.heading, figure.meaning, value});
  }
  return rows;
}

std::string figures_table(const NamedMeasure& measure) {
  std::vector<Row> rows{{measure.name, ""}};
  for (const FigureRow& row : figure_rows(measure.document)) rows.push_back({row.meaning, row.value});
  return aligned(rows);
}

std::string summary_table(const std::vector<NamedMeasure>& measures) {
  std::vector<const Figure*> columns;
  Row heading{"name"};
  for (const Figure& figure : kFigures) {
    if (!*figure.heading) continue;
    const bool used = std::any_of(measures.begin(), measures.end(), [&](const NamedMeasure& measure) {
      return shown(measure.document, figure) != "-";
    });
    if (!used) continue;
    columns.push_back(&figure);
    heading.push_back(figure.heading);
  }
  std::vector<Row> rows{heading};
  for (const NamedMeasure& measure : measures) {
    Row row{measure.name};
    for (const Figure* figure : columns) row.push_back(shown(measure.document, *figure));
    rows.push_back(row);
  }
  return aligned(rows);
}

}  // namespace partwise
