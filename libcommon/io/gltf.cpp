#include "io/gltf.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <ostream>

#include "error.h"
#include "geometry/normals.h"
#include "io/document.h"

namespace partwise::io {
namespace {

// Constants of the glTF 2.0 specification.
constexpr int kUnsignedInt = 5125, kFloat = 5126;
constexpr int kVertexData = 34962, kIndexData = 34963;
constexpr std::uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

/// The file's one buffer, and the accessors into it, each with a view of its own.
class Buffer {
 public:
  explicit Buffer(Json& document) : document_(document) {}

  /// \return index of the accessor
  template <class T>
  int add(const std::vector<T>& values, int component_type, const std::string& type, int width, int target) {
    const std::size_t size = values.size() * sizeof(T);
    Json view{{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", size}};
    if (target != 0) view["target"] = target;
    document_["bufferViews"].push_back(view);
    bytes_.append(reinterpret_cast<const char*>(values.data()), size);
    bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
    document_["accessors"].push_back({{"bufferView", document_["bufferViews"].size() - 1},
                                      {"componentType", component_type},
                                      {"count", values.size() / width},
                                      {"type", type}});
    return static_cast<int>(document_["accessors"].size()) - 1;
  }

  /// Floats with the smallest and largest value of each component.
  int add_bounded(const std::vector<float>& values, const std::string& type, int width, int target) {
    const int index = add(values, kFloat, type, width, target);
    std::vector<float> least(width, std::numeric_limits<float>::max()), most(width, -least[0]);
    for (std::size_t i = 0; i < values.size(); ++i) {
      least[i % width] = std::min(least[i % width], values[i]);
      most[i % width] = std::max(most[i % width], values[i]);
    }
    document_["accessors"][index]["min"] = least;
    document_["accessors"][index]["max"] = most;
    return index;
  }

  const std::string& bytes() const { return bytes_; }

 private:
  Json& document_;
  std::string bytes_;
};

using Floats = std::vector<float>;

/// The entries of the vertices' origins.
template <class T>
std::vector<T> spread(const std::vector<T>& of_mesh, const SeamVertices& vertices) {
  std::vector<T> result;
  result.reserve(vertices.origins.size());
  for (const int origin : vertices.origins) result.push_back(of_mesh[origin]);
  return result;
}

Floats floats_of(const Points& vectors) {
  Floats floats;
  floats.reserve(3 * vectors.size());
  for (const Vec3& vector : vectors) {
    for (const double value : vector) floats.push_back(static_cast<float>(value));
  }
  return floats;
}

/// Differences of what a reader sees, so that no rounding adds up.
Floats difference(const Floats& to, const Floats& from) {
  Floats result(to.size());
  for (std::size_t i = 0; i < to.size(); ++i) result[i] = to[i] - from[i];
  return result;
}

/// Normals of unit length, as glTF wants them: where facets cancel, any. Smooth over seams.
Floats normals_of(const Points& points, const Facets& facets, const SeamVertices& vertices) {
  Points normals = spread(vertex_normals(points, facets), vertices);
  for (Vec3& normal : normals) {
    if (normal.isZero()) normal = Vec3::UnitZ();
  }
  return floats_of(normals);
}

/// sRGB to linear light, which is what glTF's vertex colours are.
Floats linear_colours(const std::vector<std::array<std::uint8_t, 3>>& colours) {
  Floats floats;
  for (const auto& colour : colours) {
    for (const std::uint8_t channel : colour) {
      const double c = channel / 255.0;
      floats.push_back(static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4)));
    }
  }
  return floats;
}

Json attributes_of(const ShapeAnimation& animation, Buffer& buffer, const SeamVertices& vertices,
                   const Floats& positions, const Floats& normals) {
  Json attributes{{"POSITION", buffer.add_bounded(positions, "VEC3", 3, kVertexData)},
                  {"NORMAL", buffer.add(normals, kFloat, "VEC3", 3, kVertexData)}};
  if (!animation.colours.empty()) {
    attributes["COLOR_0"] =
        buffer.add(linear_colours(spread(animation.colours, vertices)), kFloat, "VEC3", 3, kVertexData);
  }
  if (animation.texture) {
    Floats places;
    for (const Eigen::Vector2d& place : vertices.places) {
      places.push_back(static_cast<float>(place.x()));
      places.push_back(static_cast<float>(1 - place.y()));  // glTF's images begin above
    }
    attributes["TEXCOORD_0"] = buffer.add(places, kFloat, "VEC2", 2, kVertexData);
  }
  return attributes;
}

/// One per vertex of the mesh where there is no texture.
SeamVertices vertices_of(const ShapeAnimation& animation) {
  const auto count = static_cast<int>(animation.frames[0].size());
  if (animation.texture) return split_at_seams(count, animation.facets, *animation.texture);
  SeamVertices vertices{std::vector<int>(count), {}, animation.facets};
  std::iota(vertices.origins.begin(), vertices.origins.end(), 0);
  return vertices;
}

void add_mesh(const ShapeAnimation& animation, Json& document, Buffer& buffer) {
  const SeamVertices vertices = vertices_of(animation);
  const Floats positions = floats_of(spread(animation.frames[0], vertices));
  const Floats normals = normals_of(animation.frames[0], animation.facets, vertices);
  Json primitive{{"mode", 4}, {"material", 0}};
  primitive["attributes"] = attributes_of(animation, buffer, vertices, positions, normals);
  std::vector<std::uint32_t> corners;
  for (const Facet& facet : vertices.facets) corners.insert(corners.end(), facet.begin(), facet.end());
  primitive["indices"] = buffer.add(corners, kUnsignedInt, "SCALAR", 1, kIndexData);
  Json names = Json::array();
  for (std::size_t i = 1; i < animation.frames.size(); ++i) {
    const Points& points = animation.frames[i];
    const Floats moves = difference(floats_of(spread(points, vertices)), positions);
    const Floats turns = difference(normals_of(points, animation.facets, vertices), normals);
    primitive["targets"].push_back({{"POSITION", buffer.add_bounded(moves, "VEC3", 3, kVertexData)},
                                    {"NORMAL", buffer.add(turns, kFloat, "VEC3", 3, kVertexData)}});
    names.push_back(animation.frame_names[i]);
  }
  Json mesh{{"name", animation.name}, {"primitives", {primitive}}};
  if (!names.empty()) {
    mesh["weights"] = std::vector<double>(names.size(), 0.0);
    mesh["extras"]["targetNames"] = names;  // where Blender and three.js look for names
  }
  document["meshes"] = Json::array({mesh});
}

/// At the time of frame i, target i alone has the weight 1.
void add_animation(const ShapeAnimation& animation, Json& document, Buffer& buffer) {
  const std::size_t count = animation.frames.size();
  Floats times, weights(count * (count - 1), 0.0F);
  for (std::size_t i = 0; i < count; ++i) {
    times.push_back(static_cast<float>(animation.seconds * static_cast<double>(i) / (count - 1.0)));
    if (i > 0) weights[i * (count - 1) + i - 1] = 1;
  }
  const int input = buffer.add_bounded(times, "SCALAR", 1, 0);
  const int output = buffer.add(weights, kFloat, "SCALAR", 1, 0);
  const Json sampler{{"input", input}, {"interpolation", "LINEAR"}, {"output", output}};
  const Json channel{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}};
  document["animations"] = Json::array({{{"name", animation.name},
                                         {"samplers", Json::array({sampler})},
                                         {"channels", Json::array({channel})}}});
}

void write_word(std::ostream& out, std::uint32_t word) {
  char raw[sizeof word];
  std::memcpy(raw, &word, sizeof word);
  out.write(raw, sizeof raw);
}

}  // namespace

void write_glb(std::ostream& out, const ShapeAnimation& animation) {
  Json document{{"asset", {{"version", "2.0"}, {"generator", "partwise"}}},
                {"scene", 0},
                {"scenes", Json::array({{{"nodes", {0}}}})}};
  Json node{{"name", animation.name}, {"mesh", 0}};
  if (animation.z_is_up) node["rotation"] = {-std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)};
  document["nodes"] = Json::array({node});
  document["materials"] = Json::array(
      {{{"doubleSided", true},
        {"pbrMetallicRoughness",
         {{"baseColorFactor", {0.8, 0.8, 0.8, 1.0}}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.7}}}}});
  Buffer buffer(document);
  add_mesh(animation, document, buffer);
  if (animation.frames.size() > 1 && animation.seconds > 0) add_animation(animation, document, buffer);
  document["buffers"] = Json::array({{{"byteLength", buffer.bytes().size()}}});
  std::string text = document.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::size_t total = 12 + 8 + text.size() + 8 + buffer.bytes().size();
  if (total > std::numeric_limits<std::uint32_t>::max()) {
    throw InputError("a .glb may have 4 GB at the most: ask for fewer frames, or for PLY files");
  }
  write_word(out, kMagic);
  write_word(out, 2);
  write_word(out, static_cast<std::uint32_t>(total));
  write_word(out, static_cast<std::uint32_t>(text.size()));
  write_word(out, kJsonChunk);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  write_word(out, static_cast<std::uint32_t>(buffer.bytes().size()));
  write_word(out, kBinaryChunk);
  out.write(buffer.bytes().data(), static_cast<std::streamsize>(buffer.bytes().size()));
}

}  // namespace partwise::io
