#pragma once

#include <string>
#include <vector>

#include "io/document.h"

namespace partwise {

/// A measure document with the name it has in a table.
struct NamedMeasure {
  std::string name;
  io::Json document;
};

/// All figures of one measure document for people: a line per figure with its value and what it means.
std::string figures_table(const NamedMeasure& measure);

/// The main figures of many measure documents: a heading, then a line for each, in the order given.
std::string summary_table(const std::vector<NamedMeasure>& measures);

}  // namespace partwise
