#include "cli/arguments.h"

#include <charconv>
#include <cmath>

namespace partwise::cli {
namespace {

using io::Json;

template <class T>
bool parses(const std::string& text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

Json value_of(const std::string& text) {
  std::int64_t whole = 0;
  if (parses(text, whole)) return whole;
  double number = 0;
  if (parses(text, number) && std::isfinite(number)) return number;
  return text;
}

bool is_file(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return type.find("FILE") != std::string::npos || type.find("PATH") != std::string::npos ||
         type.find("DIR") != std::string::npos;
}

}  // namespace

Json given_arguments(const CLI::App& app) {
  Json arguments = Json::object();
  for (const CLI::Option* option : app.get_options()) {
    if (option->count() == 0 || option->get_positional() || option->get_group() == "Common") continue;
    if (is_file(*option)) continue;
    Json value = Json::array();
    for (const std::string& result : option->results()) value.push_back(value_of(result));
    if (value.size() == 1) value = Json(value[0]);
    if (option->get_items_expected_max() == 0) value = true;
    if (value == value_of(option->get_default_str())) continue;
    const std::string name = option->get_name();
    arguments[name.substr(name.find_first_not_of('-'))] = value;
  }
  return arguments;
}

}  // namespace partwise::cli
