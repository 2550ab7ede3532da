#include "io/ply.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <sstream>

#include "error.h"
#include "io/ply_codec.h"

namespace partwise::io {
namespace {

/// Tables with every scalar type, as scalars and lists, at the ends of their ranges.
PlyTables every_type() {
  PlyTables tables;
  tables.comments = {"one", "", "  spaces kept  ", "ends with a dot."};
  Element scalars{"scalars", 4, {}};
  Element lists{"lists", 4, {}};
  for (int t = 0; t < 8; ++t) {
    const auto type = static_cast<ScalarType>(t);
    Values values = values_of(type);
    std::visit(
        [](auto& column) {
          using T = typename std::decay_t<decltype(column)>::value_type;
          column = {std::numeric_limits<T>::lowest(), std::numeric_limits<T>::max(), T(1), T(0.3)};
        },
        values);
    scalars.properties.push_back(scalar_column("s" + std::to_string(t), values));
    Property list = scalar_column("l" + std::to_string(t), values);
    list.is_list = true;
    list.count_type = static_cast<ScalarType>(t % 6);
    list.offsets = {0, 1, 1, 4, 4};
    lists.properties.push_back(list);
  }
  tables.elements = {scalars, lists, Element{"nothing", 0, {}}};
  return tables;
}

void expect_equal(const PlyTables& a, const PlyTables& b) {
  EXPECT_EQ(a.comments, b.comments);
  ASSERT_EQ(a.elements.size(), b.elements.size());
  for (std::size_t e = 0; e < a.elements.size(); ++e) {
    EXPECT_EQ(a.elements[e].name, b.elements[e].name);
    EXPECT_EQ(a.elements[e].size, b.elements[e].size);
    ASSERT_EQ(a.elements[e].properties.size(), b.elements[e].properties.size());
    for (std::size_t p = 0; p < a.elements[e].properties.size(); ++p) {
      const Property& left = a.elements[e].properties[p];
      const Property& right = b.elements[e].properties[p];
      EXPECT_EQ(left.name, right.name);
      EXPECT_EQ(left.values, right.values) << left.name;
      EXPECT_EQ(left.is_list, right.is_list);
      EXPECT_EQ(left.offsets, right.offsets);
      EXPECT_TRUE(!left.is_list || left.count_type == right.count_type);
    }
  }
}

std::string written(const PlyTables& tables) {
  std::ostringstream out;
  write_ply(out, tables);
  return out.str();
}

PlyTables read(const std::string& text) {
  std::istringstream in(text);
  return read_ply(in);
}

/// The message of the InputError that reading ends with, or "" when it does not.
std::string fault(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

template <class T>
void put(std::string& bytes, T value, bool big) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (big == (std::endian::native == std::endian::little)) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

/// The same tables in another format: an independent writer, straight from the description of PLY.
std::string in_format(const PlyTables& tables, PlyFormat format, const std::string& line_end, bool sized) {
  const char* kSized[] = {"int8", "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"};
  const char* kFormats[] = {"ascii", "binary_little_endian", "binary_big_endian"};
  auto name = [&](ScalarType type) {
    return sized ? std::string(kSized[static_cast<int>(type)]) : std::string(type_name(type));
  };
  std::string text = "ply" + line_end + "format " + kFormats[static_cast<int>(format)] + " 1.0" + line_end;
  text += "obj_info ignored" + line_end;
  for (const auto& comment : tables.comments) text += "comment " + comment + line_end;
  for (const Element& e : tables.elements) {
    text += "element " + e.name + " " + std::to_string(e.size) + line_end;
    for (const Property& p : e.properties) {
      text += "property " + (p.is_list ? "list " + name(p.count_type) + " " : "") + name(p.type()) + " " +
              p.name + line_end;
    }
  }
  text += "end_header" + line_end;
  auto value = [&](auto v) {
    if (format == PlyFormat::ascii) {
      std::ostringstream word;
      word.precision(std::numeric_limits<double>::max_digits10);
      word << +v << ' ';
      text += word.str();
    } else {
      put(text, v, format == PlyFormat::binary_big_endian);
    }
  };
  for (const Element& e : tables.elements) {
    for (std::size_t row = 0; row < e.size; ++row) {
      for (const Property& p : e.properties) {
        const std::size_t begin = p.is_list ? p.offsets[row] : row;
        const std::size_t end = p.is_list ? p.offsets[row + 1] : row + 1;
        if (p.is_list) {
          Values count = values_of(p.count_type);
          std::visit([&](auto& c) { value(typename std::decay_t<decltype(c)>::value_type(end - begin)); },
                     count);
        }
        std::visit(
            [&](const auto& values) {
              for (std::size_t i = begin; i < end; ++i) value(values[i]);
            },
            p.values);
      }
      if (format == PlyFormat::ascii) text += line_end;
    }
  }
  return text;
}

/// Two facets of different sizes after two vertices; small enough to damage at every place.
PlyTables small() {
  PlyTables tables;
  Element vertices{"vertex", 4, {}};
  for (const char* axis : {"x", "y", "z"}) {
    vertices.properties.push_back(scalar_column(axis, std::vector<double>{0, 1, 2.5, -3}));
  }
  Element faces{"face", 3, {list_column("vertex_indices", std::vector<int>{0, 1, 2, 1, 2, 3, 0, 2, 3}, 3)}};
  tables.elements = {vertices, faces};
  return tables;
}

TEST(Ply, WritesAndReadsEveryType) {
  expect_equal(every_type(), read(written(every_type())));
}

TEST(Ply, WritesWhatItReadsByteForByte) {
  EXPECT_EQ(written(every_type()), written(read(written(every_type()))));
}

TEST(Ply, ReadsEveryFormatLineEndAndSpelling) {
  for (const PlyFormat format :
       {PlyFormat::ascii, PlyFormat::binary_little_endian, PlyFormat::binary_big_endian}) {
    for (const char* line_end : {"\n", "\r\n"}) {
      for (const bool sized : {false, true}) {
        expect_equal(every_type(), read(in_format(every_type(), format, line_end, sized)));
      }
    }
  }
}

TEST(Ply, ReadsListsLongerThanABlockAndOfMixedLength) {
  PlyTables tables;
  std::mt19937 random(1);
  Property list = list_column("l", std::vector<int>{}, 3);
  list.count_type = ScalarType::int32;
  auto& values = std::get<std::vector<int>>(list.values);
  for (int row = 0; row < 3000; ++row) {
    const std::size_t length = row == 1000 ? 700000 : (row % 7 == 0 ? random() % 5 : 3);
    for (std::size_t i = 0; i < length; ++i) values.push_back(static_cast<int>(random()));
    list.offsets.push_back(values.size());
  }
  tables.elements = {Element{"e", 3000, {list}},
                     Element{"f", 3000, {list, scalar_column("s", std::vector<double>(3000, 0.1))}}};
  expect_equal(tables, read(written(tables)));
}

TEST(Ply, EveryTruncationIsAnError) {
  for (const PlyFormat format :
       {PlyFormat::ascii, PlyFormat::binary_little_endian, PlyFormat::binary_big_endian}) {
    std::string text = in_format(small(), format, "\n", false);
    if (format == PlyFormat::ascii) text.resize(text.find_last_of("0123456789") + 1);
    for (std::size_t length = 0; length < text.size(); ++length) {
      EXPECT_NE(fault(text.substr(0, length)), "") << "format " << static_cast<int>(format) << ", " << length;
    }
    EXPECT_EQ(fault(text), "");
  }
}

TEST(Ply, FlippedBitsNeverCrash) {
  std::mt19937 random(20111);
  for (const PlyFormat format :
       {PlyFormat::ascii, PlyFormat::binary_little_endian, PlyFormat::binary_big_endian}) {
    for (const PlyTables& tables : {small(), every_type()}) {
      const std::string text = in_format(tables, format, "\n", false);
      for (int round = 0; round < 4000; ++round) {
        std::string damaged = text;
        for (unsigned flips = 1 + random() % 4; flips > 0; --flips) {
          damaged[random() % damaged.size()] ^= static_cast<char>(1U << (random() % 8));
        }
        try {
          const PlyTables back = read(damaged);
          for (const Element& e : back.elements) {
            for (const Property& p : e.properties) {
              ASSERT_EQ(p.is_list ? p.offsets.size() - 1 : value_count(p.values), e.size);
            }
          }
        } catch (const InputError&) {
        }
      }
    }
  }
}

TEST(Ply, ClaimedCountsAllocateNothing) {
  const std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 18446744073709551615\nproperty double x\n"
      "end_header\nabc";
  EXPECT_NE(fault(header).find("element vertex, row 0, property x"), std::string::npos) << fault(header);
  std::string list =
      "ply\nformat binary_big_endian 1.0\nelement face 1\nproperty list uint uint v\nend_header\n";
  list += "\xff\xff\xff\xff";
  EXPECT_NE(fault(list).find("element face, row 0, property v"), std::string::npos);
  EXPECT_NE(fault("ply\nformat ascii 1.0\nelement e 99999999999\nproperty int x\nend_header\n1\n")
                .find("row 1 of 99999999999"),
            std::string::npos);
}

TEST(Ply, NamesTheFaultyHeaderLine) {
  const std::string head = "ply\nformat ascii 1.0\n";
  EXPECT_NE(fault("").find("no data"), std::string::npos);
  EXPECT_NE(fault("solid cube\n").find("line 1"), std::string::npos);
  EXPECT_NE(fault("ply\nformat ascii 2.0\nend_header\n").find("line 2"), std::string::npos);
  EXPECT_NE(fault("ply\nend_header\n").find("line 2"), std::string::npos);
  EXPECT_NE(fault(head + "element vertex\nend_header\n").find("line 3"), std::string::npos);
  EXPECT_NE(fault(head + "element vertex -1\nend_header\n").find("line 3"), std::string::npos);
  EXPECT_NE(fault(head + "property int x\nend_header\n").find("before any element"), std::string::npos);
  EXPECT_NE(fault(head + "element v 1\nproperty quad x\nend_header\n").find("unknown type \"quad\""),
            std::string::npos);
  EXPECT_NE(fault(head + "element v 1\nproperty list float int x\nend_header\n").find("line 4"),
            std::string::npos);
  EXPECT_NE(fault(head + "element v 1\nend_header\n\n").find("no properties"), std::string::npos);
  EXPECT_NE(fault(head + "element v 0\nelement v 0\nend_header\n").find("line 4"), std::string::npos);
  EXPECT_NE(fault(head + "elephant v 0\nend_header\n").find("elephant"), std::string::npos);
}

TEST(Ply, NamesTheFaultyAsciiRow) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement v 2\nproperty char a\nproperty list uchar int b\n"
      "end_header\n";
  EXPECT_EQ(fault(head + "1 2 3 4\n-128 0\n"), "");
  EXPECT_EQ(fault(head + "\n1 2 3 4\n\n+7 0\n\n"), "");
  EXPECT_NE(fault(head + "1 2 3 4\n128 0\n").find("line 8 (element v, row 1, property a)"),
            std::string::npos);
  EXPECT_NE(fault(head + "1 2 3\n1 0\n").find("property b) ends too early"), std::string::npos);
  EXPECT_NE(fault(head + "1 1 3 4\n1 0\n").find("more values"), std::string::npos);
  EXPECT_NE(fault(head + "1 1 x\n1 0\n").find("\"x\""), std::string::npos);
  EXPECT_NE(fault(head + "1 1 2.5\n1 0\n").find("\"2.5\""), std::string::npos);
  EXPECT_NE(fault(head + "1 0\n1 0\n1 0\n").find("line 9"), std::string::npos);
}

TEST(Ply, AsciiNumbersAtTheEdges) {
  const std::string head = "ply\nformat ascii 1.0\nelement v 1\nproperty double a\nend_header\n";
  const auto value = [&](const std::string& word) {
    return column<double>(read(head + word + "\n"), "v", "a")[0];
  };
  EXPECT_EQ(value("1e-400"), 0);
  EXPECT_EQ(value("+.5e1"), 5);
  EXPECT_EQ(value("-inf"), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(value("nan")));
  EXPECT_NE(fault(head + "1e400\n").find("does not fit"), std::string::npos);
}

TEST(Ply, SurplusBinaryDataIsAnError) {
  EXPECT_NE(fault(written(small()) + "x").find("data follows"), std::string::npos);
}

TEST(Ply, ColumnsConvertOnlyWithoutLoss) {
  PlyTables tables;
  tables.elements = {Element{
      "e",
      2,
      {scalar_column("whole", std::vector<double>{-4, 7}), scalar_column("part", std::vector<float>{1, 0.5F}),
       scalar_column("large", std::vector<std::uint32_t>{1, 4000000000U}),
       scalar_column("nan", std::vector<double>{0, std::nan("")}),
       list_column("list", std::vector<std::uint8_t>{1, 2, 3, 4}, 2)}}};
  EXPECT_EQ(column<int>(tables, "e", "whole"), (std::vector<int>{-4, 7}));
  EXPECT_EQ(column<double>(tables, "e", "part"), (std::vector<double>{1, 0.5}));
  EXPECT_EQ(column<double>(tables, "e", "large")[1], 4e9);
  EXPECT_EQ(lists<int>(tables, "e", "list", 2), (std::vector<int>{1, 2, 3, 4}));
  EXPECT_THROW(column<int>(tables, "e", "part"), InputError);
  EXPECT_THROW(column<int>(tables, "e", "large"), InputError);
  EXPECT_THROW(column<int>(tables, "e", "nan"), InputError);
  EXPECT_THROW(column<int>(tables, "e", "list"), InputError);
  EXPECT_THROW(column<int>(tables, "e", "missing"), InputError);
  EXPECT_THROW(column<int>(tables, "missing", "whole"), InputError);
  EXPECT_THROW(lists<int>(tables, "e", "list", 3), InputError);
  EXPECT_THROW(lists<int>(tables, "e", "whole", 1), InputError);
}

TEST(Ply, RefusesToWriteInconsistentTables) {
  PlyTables tables = small();
  tables.elements[0].size = 5;
  EXPECT_THROW(written(tables), std::invalid_argument);
  tables = small();
  tables.elements[1].properties[0].offsets[1] = 7;
  EXPECT_THROW(written(tables), std::invalid_argument);
  tables = small();
  tables.comments = {"two\nlines"};
  EXPECT_THROW(written(tables), std::invalid_argument);
  tables = small();
  tables.elements[0].name = "a b";
  EXPECT_THROW(written(tables), std::invalid_argument);
}

TEST(Ply, FailingStreamIsAnIoError) {
  std::ostringstream out;
  out.setstate(std::ios::badbit);
  EXPECT_THROW(write_ply(out, small()), IoError);
}

}  // namespace
}  // namespace partwise::io
