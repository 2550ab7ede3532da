#include "report/color_map.h"

#include <algorithm>
#include <cmath>

namespace partwise::report {
namespace {

constexpr std::array<Rgb, 9> kViridis = {{{68, 1, 84},
                                          {71, 45, 123},
                                          {59, 82, 139},
                                          {44, 114, 142},
                                          {33, 145, 140},
                                          {40, 174, 128},
                                          {94, 201, 98},
                                          {173, 220, 48},
                                          {253, 231, 37}}};

}  // namespace

Rgb viridis(double share) {
  const double place = (share > 0 ? std::min(share, 1.0) : 0) * static_cast<double>(kViridis.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kViridis.size() - 2);
  const double fraction = place - static_cast<double>(below);
  Rgb color{};
  for (std::size_t i = 0; i < color.size(); ++i) {
    color[i] = static_cast<std::uint8_t>(
        std::lround((1 - fraction) * kViridis[below][i] + fraction * kViridis[below + 1][i]));
  }
  return color;
}

}  // namespace partwise::report
