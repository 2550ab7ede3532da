#include "io/json_reader.h"

#include <algorithm>
#include <cmath>

#include "error.h"

namespace partwise::io {
namespace {

/// For messages; never throws, also when a text is no valid UTF-8.
std::string shown(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

void JsonReader::fail(const std::string& problem) const {
  throw InputError("metadata " + (path_.empty() ? "/" : path_) + ": " + problem);
}

JsonReader JsonReader::operator[](const std::string& key) const {
  if (!value_.is_object()) fail("an object is expected here");
  const auto member = value_.find(key);
  if (member == value_.end()) fail("'" + key + "' is missing");
  return JsonReader(*member, path_ + "/" + key);
}

std::vector<JsonReader> JsonReader::items() const {
  if (!value_.is_array()) fail("an array is expected here");
  std::vector<JsonReader> result;
  for (std::size_t i = 0; i < value_.size(); ++i) {
    result.emplace_back(value_[i], path_ + "/" + std::to_string(i));
  }
  return result;
}

bool JsonReader::boolean() const {
  if (!value_.is_boolean()) fail("true or false is expected here");
  return value_.get<bool>();
}

int JsonReader::integer(int lowest, int highest) const {
  if (!value_.is_number_integer()) fail("an integer is expected here");
  // An unsigned number beyond the signed range would wrap around.
  const bool huge = value_.is_number_unsigned() && value_.get<std::uint64_t>() > std::uint64_t{1} << 62;
  const auto number = huge ? std::int64_t{1} << 62 : value_.get<std::int64_t>();
  if (number < lowest || number > highest) {
    fail(shown(value_) + " is not in " + std::to_string(lowest) + " .. " + std::to_string(highest));
  }
  return static_cast<int>(number);
}

double JsonReader::number() const {
  if (!value_.is_number()) fail("a number is expected here");
  const auto number = value_.get<double>();
  if (!std::isfinite(number)) fail("the number is not finite");
  return number;
}

std::string JsonReader::text() const {
  if (!value_.is_string()) fail("a text is expected here");
  return value_.get<std::string>();
}

void JsonReader::require_consistent(const Json& expected) const {
  if (expected.is_object()) {
    for (const auto& [key, value] : expected.items()) (*this)[key].require_consistent(value);
  } else if (expected.is_array()) {
    const std::vector<JsonReader> elements = items();
    if (elements.size() != expected.size()) {
      fail(std::to_string(elements.size()) + " elements where the tables give " +
           std::to_string(expected.size()));
    }
    for (std::size_t i = 0; i < elements.size(); ++i) elements[i].require_consistent(expected[i]);
  } else if (expected.is_number() && value_.is_number()) {
    const auto wanted = expected.get<double>();
    if (!(std::abs(number() - wanted) <= 1e-9 * std::abs(wanted))) {
      fail(shown(value_) + " contradicts the tables, which give " + shown(expected));
    }
  } else if (value_ != expected) {
    fail(shown(value_) + " contradicts the tables, which give " + shown(expected));
  }
}

}  // namespace partwise::io
