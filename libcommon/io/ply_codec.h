#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

#include "io/byte_source.h"
#include "io/ply.h"

/// The pieces of the PLY codec; `ply.h` is the way in.
namespace partwise::io {

enum class PlyFormat { ascii, binary_little_endian, binary_big_endian };

/// What a PLY header says: elements have names, sizes and empty columns.
struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  PlyTables tables;
};

/// Reads up to and with the line `end_header`. \throws InputError naming the line.
PlyHeader read_ply_header(ByteSource& source);

/// Reads the rows of every element into the header's empty columns. \throws InputError, see read_ply.
PlyTables read_ascii_rows(ByteSource& source, PlyHeader header);
PlyTables read_binary_rows(ByteSource& source, PlyHeader header);

/// "int" for int32 and so on: the names of PLY 1.0, which every reader knows.
std::string_view type_name(ScalarType type);

/// The type of this name, in either spelling ("int", "int32"), or nothing.
std::optional<ScalarType> type_called(std::string_view name);

/// Bytes of one value.
std::size_t type_size(ScalarType type);

/// An empty vector of the type.
Values values_of(ScalarType type);

/// Number of values.
std::size_t value_count(const Values& values);

/// "element vertex, row 3, property x", for messages.
std::string place(const Element& element, std::size_t row, const Property& property);

}  // namespace partwise::io
