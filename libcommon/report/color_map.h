#pragma once

#include <array>
#include <cstdint>

namespace partwise::report {

/// Red, green, blue, each 0 ... 255.
using Rgb = std::array<std::uint8_t, 3>;

/// Viridis, the perceptually uniform colour map of N. Smith and S. van der Walt (2015, CC0), readable also in
/// grey and by people who do not see all colours: dark violet at 0, yellow at 1. Interpolated between nine
/// colours. Numbers outside 0 ... 1 look like the end.
Rgb viridis(double share);

}  // namespace partwise::report
