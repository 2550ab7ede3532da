#pragma once

#include <string>

#include "io/document.h"
#include "segmentation/sketch.h"

namespace partwise::io {

/// The sketch (partwise/sketch-1) in `json`.
///
/// Checked: forms and types, unique names, anchors between known parts, barycentric coordinates that are not
/// negative and sum to 1 (within 1e-6; they are then scaled to sum exactly), invertible cameras, then the
/// sketch's schema. Whether vertices and facets exist is checked where the sketch meets its mesh
/// (segment_mesh). \throws InputError naming part, stroke and entry (0-based), marker or anchor.
Sketch parse_sketch(const Json& json);

/// The same from JSON text. \throws InputError also naming the line of a JSON error.
Sketch parse_sketch(const std::string& text);

/// The sketch as JSON that parse_sketch() reads back; `comment` says what it is, unless empty.
Json to_json(const Sketch& sketch, const std::string& comment);

/// Reads a sketch from a file. \throws IoError; InputError as parse_sketch, with the path in front.
Sketch read_sketch(const std::string& path);

}  // namespace partwise::io
