#include "report/pov_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "error.h"

namespace partwise::report {

namespace {

// A cell in units of its own width; the origin of the scene is the picture's upper left corner.
constexpr double kCellHeight = 0.86;
constexpr double kMargin = 0.04;
constexpr double kCaptionHeight = 0.1;
constexpr double kTextSize = 0.052;

std::string number(double value) {
  std::ostringstream out;
  out.precision(6);
  out << value;
  return out.str();
}

std::string vector(const Vec3& v) {
  std::ostringstream out;
  out.precision(6);
  out << '<' << v[0] << ',' << v[1] << ',' << v[2] << '>';
  return out.str();
}

// POV-Ray's z points away from the eye.
Vec3 to_scene(const Vec3& seen) {
  return {seen[0], seen[1], -seen[2]};
}

// The panel's points in its view, scaled and shifted into the cell whose upper left corner is (x, y).
Points fitted(const Panel& panel, double x, double y) {
  Points seen;
  for (const Vec3& p : panel.points) {
    seen.push_back(panel.view.apply(p));
  }
  Vec3 low = Vec3::Constant(HUGE_VAL);
  Vec3 high = -low;
  for (const Facet& facet : panel.facets) {
    for (const int v : facet) {
      low = low.cwiseMin(seen[v]);
      high = high.cwiseMax(seen[v]);
    }
  }
  const double width = 1 - 2 * kMargin;
  const double height = kCellHeight - kCaptionHeight - 2 * kMargin;
  const Vec3 extent = (high - low).cwiseMax(1e-12 * (high - low).norm() + 1e-300);
  const double scale = std::min(width / extent[0], height / extent[1]);
  const Vec3 centre = (low + high) / 2;
  const Vec3 place(x + 0.5, y - kMargin - height / 2, 0);
  for (Vec3& p : seen) {
    p = to_scene(place + scale * (p - centre));
  }
  return seen;
}

void write_mesh(std::ostream& out, const Panel& panel, const Points& points) {
  std::map<Color, int> textures;
  for (const Color& color : panel.colors) {
    textures.emplace(color, 0);
  }
  int next = 0;
  out << "mesh2 {\nvertex_vectors { " << points.size();
  for (const Vec3& p : points) {
    out << ",\n" << vector(p);
  }
  out << " }\ntexture_list { " << textures.size();
  for (auto& [color, index] : textures) {
    index = next++;
    out << ",\ntexture { Surface(" << vector({color[0], color[1], color[2]}) << ") }";
  }
  out << " }\nface_indices { " << panel.facets.size();
  for (std::size_t f = 0; f < panel.facets.size(); ++f) {
    const Facet& v = panel.facets[f];
    out << ",\n<" << v[0] << "," << v[1] << "," << v[2] << ">," << textures[panel.colors[f]];
  }
  out << " }\n}\n";
}

// The font is one that POV-Ray carries inside.
void write_caption(std::ostream& out, const std::string& caption, double x, double y) {
  std::string text;
  for (const char c : caption) {
    const bool printable = c >= ' ' && c <= '~';
    text += std::string(c == '"' || c == '\\' ? "\\" : "") + (printable ? c : '?');
  }
  if (text.empty()) return;
  out << "Caption(\"" << text << "\", " << number(x + 0.5) << ", "
      << number(y - kCellHeight + kCaptionHeight / 2) << ")\n";
}

void write_preamble(std::ostream& out, const SceneOptions& options, int rows) {
  const double height = rows * kCellHeight;
  const long pixels = std::lround(options.width * height / options.columns);
  out << "// +W" << options.width << " +H" << pixels << "\n"
      << "#version 3.7;\n"
      << "global_settings { assumed_gamma 1.0 }\n"
      << "background { color srgb 1 }\n"
      << "camera { orthographic location <" << number(options.columns / 2.0) << "," << number(-height / 2)
      << ",-100> direction z right x*" << options.columns << " up y*" << number(height) << " }\n"
      << "light_source { <-200,300,-400> color rgb 0.75 parallel point_at 0 shadowless }\n"
      << "light_source { <300,50,-300> color rgb 0.3 parallel point_at 0 shadowless }\n"
      << "#macro Surface(Shade) pigment { srgb Shade } finish { ambient 0.22 diffuse 0.75 } #end\n"
      << "#macro Caption(Words, X, Y)\n"
      << "  #local Letters = text { internal 1 Words 0.01, 0 scale " << number(kTextSize) << " }\n"
      << "  object { Letters translate <X - max_extent(Letters).x / 2, Y, -50>\n"
      << "    pigment { srgb 0.15 } finish { ambient 1 diffuse 0 } }\n"
      << "#end\n";
}

}  // namespace

std::string pov_scene(const std::vector<Panel>& panels, const SceneOptions& options) {
  if (panels.empty() || options.columns < 1 || options.width < 1) {
    throw UsageError("a picture needs at least one panel, one column and one pixel");
  }
  const int rows = (static_cast<int>(panels.size()) + options.columns - 1) / options.columns;
  std::ostringstream out;
  write_preamble(out, options, rows);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    if (panels[i].facets.empty()) {
      throw InputError("panel \"" + panels[i].caption + "\" has no facets to show");
    }
    const std::size_t row = i / options.columns;
    const double x = static_cast<double>(i % options.columns);
    const double y = -static_cast<double>(row) * kCellHeight;
    write_mesh(out, panels[i], fitted(panels[i], x, y));
    write_caption(out, panels[i].caption, x, y);
  }
  return out.str();
}

}  // namespace partwise::report
