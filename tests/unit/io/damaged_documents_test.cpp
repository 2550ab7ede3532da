#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <set>
#include <sstream>
#include <type_traits>

#include "error.h"
#include "io/stage_documents.h"
#include "stage_samples.h"

namespace partwise::io {
namespace {

/// A valid document and how it is read.
struct Sample {
  std::string name;
  Document document;
  std::function<void(const Document&)> read;
};

std::vector<Sample> samples() {
  return {{"segment", to_document(tests::sample_segmented_model()), read_segmented_model},
          {"hull", to_document(tests::sample_hulled_model()), read_hulled_model},
          {"hullmap", to_document(tests::sample_hull_map()), read_hull_map},
          {"crossmap", to_document(tests::sample_cross_map()), read_cross_map},
          {"compatible", to_document(tests::sample_compatible_mesh()), read_compatible_mesh},
          {"refined", to_document(tests::sample_refined_mesh()), read_compatible_mesh}};
}

bool is_colour(const std::string& property) {
  return property == "red" || property == "green" || property == "blue";
}

/// What reading says, or "" when it succeeds. Anything but an InputError escapes and fails the test.
std::string complaint(const Sample& sample, const Document& document) {
  try {
    sample.read(document);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// Sets the value at a fraction of the column's length.
void set_value(Property& property, double place, double value) {
  std::visit(
      [&](auto& values) {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        values.at(static_cast<std::size_t>(place * (values.size() - 1))) = static_cast<Value>(value);
      },
      property.values);
}

bool holds_doubles(const Property& property) {
  return std::holds_alternative<std::vector<double>>(property.values);
}

TEST(DamagedDocuments, EveryCellIsChecked) {
  for (const Sample& sample : samples()) {
    for (std::size_t e = 0; e < sample.document.tables.elements.size(); ++e) {
      const Element& element = sample.document.tables.elements[e];
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const Property& property = element.properties[p];
        if (is_colour(property.name)) continue;
        const std::vector<double> wrong =
            holds_doubles(property) ? std::vector<double>{std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}
                                    : std::vector<double>{-2, 1 << 30};
        for (const double value : wrong) {
          for (const double place : {0.0, 0.5, 1.0}) {
            Document damaged = sample.document;
            set_value(damaged.tables.elements[e].properties[p], place, value);
            const std::string message = complaint(sample, damaged);
            const std::string where = sample.name + " " + element.name + " " + property.name + ": " + message;
            EXPECT_NE(message.find("'" + element.name + "'"), std::string::npos) << where;
            EXPECT_NE(message.find("'" + property.name + "'"), std::string::npos) << where;
            EXPECT_NE(message.find("row "), std::string::npos) << where;
          }
        }
      }
    }
  }
}

TEST(DamagedDocuments, EveryColumnAndElementIsNeeded) {
  for (const Sample& sample : samples()) {
    for (std::size_t e = 0; e < sample.document.tables.elements.size(); ++e) {
      const Element& element = sample.document.tables.elements[e];
      Document damaged = sample.document;
      damaged.tables.elements.erase(damaged.tables.elements.begin() + e);
      EXPECT_NE(complaint(sample, damaged).find("'" + element.name + "'"), std::string::npos);
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        if (is_colour(element.properties[p].name)) continue;
        damaged = sample.document;
        auto& properties = damaged.tables.elements[e].properties;
        properties.erase(properties.begin() + p);
        EXPECT_NE(complaint(sample, damaged), "")
            << sample.name << element.name << element.properties[p].name;
      }
    }
  }
}

/// Removes the last row of a table.
void shorten(Element& element) {
  --element.size;
  for (Property& property : element.properties) {
    std::visit(
        [&](auto& values) { values.resize(property.is_list ? *(property.offsets.end() - 2) : element.size); },
        property.values);
    if (property.is_list) property.offsets.pop_back();
  }
}

TEST(DamagedDocuments, EveryRowIsNeeded) {
  for (const Sample& sample : samples()) {
    for (std::size_t e = 0; e < sample.document.tables.elements.size(); ++e) {
      Document damaged = sample.document;
      Element& element = damaged.tables.elements[e];
      shorten(element);
      // Rows of these stand for themselves: one less is another valid document.
      if (element.name == "critical_point" || element.name == "boundary_vertex") continue;
      EXPECT_NE(complaint(sample, damaged), "") << sample.name << " " << element.name;
    }
  }
}

/// Pointers to every value inside a JSON document.
std::vector<Json::json_pointer> pointers(const Json& json) {
  std::vector<Json::json_pointer> result;
  const Json leaves = json.flatten();
  for (const auto& [path, value] : leaves.items()) {
    for (Json::json_pointer at(path); !at.empty(); at = at.parent_pointer()) result.push_back(at);
  }
  return result;
}

TEST(DamagedDocuments, EveryFactIsChecked) {
  const std::set<std::string> unread{"schema", "history", "metrics"};
  for (const Sample& sample : samples()) {
    for (const Json::json_pointer& at : pointers(sample.document.metadata)) {
      Json::json_pointer top = at;
      while (!top.parent_pointer().empty()) top = top.parent_pointer();
      if (unread.contains(top.back())) continue;
      Document damaged = sample.document;
      damaged.metadata[at] = Json::object();
      EXPECT_NE(complaint(sample, damaged), "") << sample.name << " " << at;
      const std::string key = at.back();
      // Names, and what a user or a stage decided, may be anything valid.
      if (sample.document.metadata[at].is_number()) {
        damaged.metadata[at] = 1e100;
        if (key != "largest" && key != "mean" && key != "snap_distance") {
          EXPECT_NE(complaint(sample, damaged), "") << sample.name << " " << at;
        }
        damaged.metadata[at] = std::numeric_limits<std::uint64_t>::max();
        complaint(sample, damaged);
      }
    }
  }
}

TEST(DamagedDocuments, RandomCellsNeverCrash) {
  std::mt19937 random(7);
  for (const Sample& sample : samples()) {
    int noticed = 0;
    for (int trial = 0; trial < 300; ++trial) {
      Document damaged = sample.document;
      Element& element = damaged.tables.elements[random() % damaged.tables.elements.size()];
      Property& property = element.properties[random() % element.properties.size()];
      const double place = static_cast<double>(random() % 1000) / 999;
      set_value(property, place, static_cast<double>(static_cast<int>(random() % 60) - 2));
      noticed += complaint(sample, damaged).empty() ? 0 : 1;
    }
    EXPECT_GT(noticed, 100) << sample.name;
  }
}

TEST(DamagedDocuments, RandomFactsNeverCrash) {
  std::mt19937 random(8);
  const std::vector<Json> values{nullptr, true, -1, 3, 1e300, "top", "", "\xff", Json::array(), {1, 2}};
  for (const Sample& sample : samples()) {
    const std::vector<Json::json_pointer> places = pointers(sample.document.metadata);
    for (int trial = 0; trial < 300; ++trial) {
      Document damaged = sample.document;
      damaged.metadata[places[random() % places.size()]] = values[random() % values.size()];
      complaint(sample, damaged);
    }
  }
}

TEST(DamagedDocuments, FlippedBitsNeverCrash) {
  std::mt19937 random(9);
  for (const Sample& sample : samples()) {
    std::ostringstream out;
    write_ply(out, sample.document.tables);
    const std::string bytes = out.str();
    for (int trial = 0; trial < 300; ++trial) {
      std::string flipped = bytes;
      // Half of the trials hit the header, which is a small share of the bytes.
      const std::size_t range = trial % 2 == 0 ? bytes.size() : bytes.find("end_header");
      flipped[random() % range] ^= static_cast<char>(1 << (random() % 8));
      std::istringstream in(flipped);
      try {
        sample.read({read_ply(in), sample.document.metadata});
      } catch (const InputError&) {
      }
    }
  }
}

}  // namespace
}  // namespace partwise::io
