#include <charconv>
#include <cmath>
#include <cstdlib>
#include <type_traits>
#include <utility>

#include "error.h"
#include "io/ply_codec.h"

namespace partwise::io {
namespace {

constexpr std::size_t kLongestRow = std::size_t{1} << 30;

enum class Parse { done, no_number, no_fit };

template <class T>
Parse parse(std::string_view word, T& value) {
  if (word.size() > 1 && word.front() == '+' && word[1] != '-') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || error == std::errc::invalid_argument) return Parse::no_number;
  if (error == std::errc()) return Parse::done;
  if constexpr (std::is_floating_point_v<T>) {
    // Too small for the type is as good as zero; too large is not as good as infinity.
    value = static_cast<T>(std::strtod(std::string(word).c_str(), nullptr));
    if (std::isfinite(value)) return Parse::done;
  }
  return Parse::no_fit;
}

/// One row's text, word by word; rows are lines, as PLY says.
class AsciiRows {
 public:
  AsciiRows(ByteSource& source, PlyTables tables) : source_(source), tables_(std::move(tables)) {}

  PlyTables read() {
    for (Element& element : tables_.elements) {
      for (std::size_t row = 0; row < element.size; ++row) read_row(element, row);
    }
    if (next_row()) {
      throw InputError("line " + std::to_string(source_.line_number()) +
                       " follows after the last row that the header names: correct the counts in the header");
    }
    return std::move(tables_);
  }

 private:
  /// The next line that is not blank.
  bool next_row() {
    while (source_.next_line(line_, kLongestRow)) {
      if (line_.find_first_not_of(" \t") != std::string_view::npos) return true;
    }
    return false;
  }

  [[noreturn]] void fault(const Element& element, std::size_t row, const Property& property,
                          const std::string& what) const {
    throw InputError("line " + std::to_string(source_.line_number()) + " (" + place(element, row, property) +
                     ") " + what);
  }

  std::string_view next_word() {
    std::size_t begin = 0;
    while (begin < line_.size() && (line_[begin] == ' ' || line_[begin] == '\t')) ++begin;
    std::size_t end = begin;
    while (end < line_.size() && line_[end] != ' ' && line_[end] != '\t') ++end;
    const std::string_view word = line_.substr(begin, end - begin);
    line_.remove_prefix(end);
    return word;
  }

  template <class T>
  T number(const Element& element, std::size_t row, const Property& property, ScalarType type) {
    const std::string_view word = next_word();
    T value{};
    const Parse outcome = word.empty() ? Parse::no_number : parse(word, value);
    if (outcome == Parse::done) return value;
    if (word.empty()) fault(element, row, property, "ends too early");
    const std::string quoted = "\"" + std::string(word.substr(0, 40)) + "\"";
    if (outcome == Parse::no_fit) {
      fault(element, row, property,
            "has " + quoted + ", which does not fit into " + std::string(type_name(type)));
    }
    fault(element, row, property,
          "has " + quoted + " where a value of type " + std::string(type_name(type)) + " belongs");
  }

  std::size_t list_length(const Element& element, std::size_t row, const Property& property) {
    const auto length = number<std::int64_t>(element, row, property, property.count_type);
    if (length < 0) fault(element, row, property, "has a list of negative length");
    return static_cast<std::size_t>(length);
  }

  void read_row(Element& element, std::size_t row) {
    if (!next_row()) {
      throw InputError("the file ends before element " + element.name + ", row " + std::to_string(row) +
                       " of " + std::to_string(element.size) + ": it is truncated");
    }
    for (Property& property : element.properties) {
      const std::size_t count = property.is_list ? list_length(element, row, property) : 1;
      std::visit(
          [&](auto& values) {
            using T = typename std::decay_t<decltype(values)>::value_type;
            const ScalarType type = property.type();
            for (std::size_t i = 0; i < count; ++i) {
              values.push_back(number<T>(element, row, property, type));
            }
          },
          property.values);
      if (property.is_list) property.offsets.push_back(value_count(property.values));
    }
    if (!next_word().empty()) {
      throw InputError("line " + std::to_string(source_.line_number()) + " (element " + element.name +
                       ", row " + std::to_string(row) + ") has more values than the header names");
    }
  }

  ByteSource& source_;
  PlyTables tables_;
  std::string_view line_;
};

}  // namespace

PlyTables read_ascii_rows(ByteSource& source, PlyHeader header) {
  return AsciiRows(source, std::move(header.tables)).read();
}

}  // namespace partwise::io
