#include "io/texture_columns.h"

#include <algorithm>

namespace partwise::io {

std::optional<TextureCorners> read_texture(const PlyTables& tables) {
  const Element* faces = tables.find("face");
  const Property* places = faces ? faces->find("texcoord") : nullptr;
  if (!places || !places->is_list) return {};
  const std::vector<double> numbers = lists<double>(tables, "face", "texcoord", 6);
  TextureCorners texture;
  texture.places.resize(faces->size);
  for (std::size_t f = 0; f < faces->size; ++f) {
    std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(6 * f), 6, texture.places[f].begin());
  }
  const Property* images = faces->find("texnumber");
  if (images && !images->is_list) texture.images = column<int>(tables, "face", "texnumber");
  return texture;
}

std::vector<Property> texture_columns(const TextureCorners& texture) {
  std::vector<float> numbers;
  numbers.reserve(6 * texture.places.size());
  for (const auto& places : texture.places) numbers.insert(numbers.end(), places.begin(), places.end());
  std::vector<Property> columns{list_column("texcoord", std::move(numbers), 6)};
  if (!texture.images.empty()) columns.push_back(scalar_column("texnumber", texture.images));
  return columns;
}

std::vector<std::string> texture_comments(const PlyTables& tables) {
  std::vector<std::string> comments;
  for (const std::string& comment : tables.comments) {
    if (comment.starts_with("TextureFile")) comments.push_back(comment);
  }
  return comments;
}

}  // namespace partwise::io
