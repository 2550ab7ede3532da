#include "attributes/carry_attributes.h"

#include <algorithm>
#include <map>
#include <optional>

#include "attributes/carry_texture.h"
#include "attributes/column_values.h"
#include "attributes/skinning.h"
#include "error.h"
#include "io/carried_columns.h"
#include "io/texture_columns.h"

namespace partwise {
namespace {

using io::Property;

bool may_be_mixed(const Property& property) {
  return is_real(property.values) || is_colour(property.name);
}

/// The rows of a list column that `rows` name.
Property chosen_lists(const Property& property, const std::vector<int>& rows) {
  Property result{property.name, {}, true, property.count_type, {0}};
  std::visit(
      [&](const auto& values) {
        std::decay_t<decltype(values)> chosen;
        for (const int row : rows) {
          chosen.insert(chosen.end(), values.begin() + static_cast<std::ptrdiff_t>(property.offsets[row]),
                        values.begin() + static_cast<std::ptrdiff_t>(property.offsets[row + 1]));
          result.offsets.push_back(chosen.size());
        }
        result.values = std::move(chosen);
      },
      property.values);
  return result;
}

/// The most frequent of some values, the smallest of equals.
template <class Value>
Value most_frequent(const std::vector<Value>& values) {
  std::map<Value, int> counts;
  for (const Value& value : values) ++counts[value];
  return std::max_element(counts.begin(), counts.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

Property vertex_column(const Property& property, const TriMesh& giver,
                       const std::vector<SurfacePoint>& origins) {
  std::vector<int> nearest;
  for (const SurfacePoint& origin : origins) {
    int corner = 0;
    origin.barycentric.maxCoeff(&corner);
    nearest.push_back(giver.facet(origin.facet)[corner]);
  }
  if (property.is_list) return chosen_lists(property, nearest);
  const std::vector<double> given = io::numbers_of(property.values);
  std::vector<double> carried;
  for (std::size_t v = 0; v < origins.size(); ++v) {
    const Facet& f = giver.facet(origins[v].facet);
    const Vec3 corners(given[f[0]], given[f[1]], given[f[2]]);
    carried.push_back(may_be_mixed(property) ? origins[v].barycentric.dot(corners) : given[nearest[v]]);
  }
  return io::scalar_column(property.name, values_like(property.values, carried));
}

Property face_column(const Property& property, const std::vector<std::vector<SurfacePoint>>& samples) {
  if (property.is_list) {
    std::vector<int> rows;
    for (const std::vector<SurfacePoint>& of_facet : samples) {
      std::vector<int> facets;
      facets.reserve(of_facet.size());
      for (const SurfacePoint& sample : of_facet) facets.push_back(sample.facet);
      rows.push_back(most_frequent(facets));
    }
    return chosen_lists(property, rows);
  }
  const std::vector<double> given = io::numbers_of(property.values);
  std::vector<double> carried;
  for (const std::vector<SurfacePoint>& of_facet : samples) {
    std::vector<double> values;
    double sum = 0;
    for (const SurfacePoint& sample : of_facet) {
      values.push_back(given[sample.facet]);
      sum += values.back();
    }
    carried.push_back(may_be_mixed(property) ? sum / static_cast<double>(values.size())
                                             : most_frequent(values));
  }
  return io::scalar_column(property.name, values_like(property.values, carried));
}

std::string known_properties(const io::PlyTables& from) {
  std::string text;
  for (const char* element : {"vertex", "face"}) {
    for (const Property& property : from.find(element)->properties) {
      if (!io::is_geometry(property.name)) text += (text.empty() ? "" : ", ") + property.name;
    }
  }
  return text.empty() ? "it has none but its geometry" : "there are: " + text;
}

}  // namespace

CarriedAttributes carry_attributes(const io::PlyTables& from, const TriMesh& giver, const TriMesh& receiver,
                                   const Origins& origins, const std::vector<std::string>& properties) {
  const io::Element &vertices = *from.find("vertex"), &faces = *from.find("face");
  for (const std::string& name : properties) {
    if (!io::is_geometry(name) && (vertices.find(name) || faces.find(name))) continue;
    throw InputError("neither vertices nor facets have a property '" + name + "' to transfer; " +
                     known_properties(from));
  }
  const auto wanted = [&](const std::string& name) {
    if (io::is_geometry(name)) return false;
    return properties.empty() || std::find(properties.begin(), properties.end(), name) != properties.end();
  };
  CarriedAttributes carried;
  SkinColumns skin = find_skin(vertices);
  if (!skin.empty() && !wanted(skin.joints[0]->name)) skin = {};
  if (!skin.empty()) carried.vertex = carry_skin(skin, giver, origins.vertices);
  for (const Property& property : vertices.properties) {
    if (!wanted(property.name) || skin.contains(property)) continue;
    carried.vertex.push_back(vertex_column(property, giver, origins.vertices));
  }
  const auto texture = wanted("texcoord") ? io::read_texture(from) : std::nullopt;
  if (texture) carried.face = io::texture_columns(carry_texture(*texture, giver, receiver, origins));
  for (const Property& property : faces.properties) {
    const bool done = texture && (property.name == "texcoord" || property.name == "texnumber");
    if (wanted(property.name) && !done) carried.face.push_back(face_column(property, origins.facets));
  }
  return carried;
}

}  // namespace partwise
