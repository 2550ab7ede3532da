#pragma once

#include <string>
#include <vector>

#include "io/document.h"

namespace partwise::io {

/// A value inside a JSON document together with the path to it. Every fault is an InputError that names the
/// path.
class JsonReader {
 public:
  /// `value` must outlive the reader. The path is a JSON pointer such as "/parts/3/name".
  explicit JsonReader(const Json& value, std::string path = "") : value_(value), path_(std::move(path)) {}

  bool has(const std::string& key) const { return value_.is_object() && value_.contains(key); }
  /// Member of an object. \throws InputError when it is missing.
  JsonReader operator[](const std::string& key) const;
  /// Elements of an array.
  std::vector<JsonReader> items() const;

  bool is_null() const { return value_.is_null(); }
  bool boolean() const;
  /// Whole number in lowest .. highest.
  int integer(int lowest, int highest) const;
  /// Finite number.
  double number() const;
  std::string text() const;

  const Json& value() const { return value_; }
  [[noreturn]] void fail(const std::string& problem) const;

  /// Checks facts that follow from the rest of the document: every member and element of `expected` must be
  /// there and equal, numbers to a relative 1e-9 (other machines sum in another order).
  void require_consistent(const Json& expected) const;

 private:
  const Json& value_;
  std::string path_;
};

}  // namespace partwise::io
