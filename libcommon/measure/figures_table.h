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

/// One figure of a measure document for people.
struct FigureRow {
  std::string pointer;  ///< JSON pointer to it, such as "/rms_distance"
  std::string heading;  ///< short, for a column; empty when it is not among the main figures
  std::string meaning;  ///< what it is, with its unit
  std::string value;    ///< "-" when the document has none
};

/// The figures of one document in the order of the tables; those of a ground truth only where there is one.
std::vector<FigureRow> figure_rows(const io::Json& document);

/// All figures of one measure document for people: a line per figure with its value and what it means.
std::string figures_table(const NamedMeasure& measure);

/// The main figures of many measure documents: a heading, then a line for each, in the order given.
std::string summary_table(const std::vector<NamedMeasure>& measures);

}  // namespace partwise
