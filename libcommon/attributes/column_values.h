#pragma once

#include <string>
#include <vector>

#include "io/ply.h"

/// PLY columns of any type as numbers, and back.
namespace partwise {

/// Numbers in the type that `like` has; rounded and held within its range where it is of integers.
io::Values values_like(const io::Values& like, const std::vector<double>& numbers);

bool is_real(const io::Values& values);

/// Whether a column is a channel of a colour, which may be mixed although it is of integers.
bool is_colour(const std::string& property);

}  // namespace partwise
