#pragma once

#include <array>

#include "mesh/tri_mesh.h"
#include "report/panel.h"

namespace partwise::report {

inline constexpr Color kPlain = {0.78F, 0.77F, 0.74F};
inline constexpr Color kFolded = {0.86F, 0.05F, 0.05F};

/// Of parts; never red.
inline constexpr std::array<Color, 12> kPartColors = {{{0.31F, 0.47F, 0.66F},
                                                       {0.95F, 0.56F, 0.17F},
                                                       {0.35F, 0.63F, 0.31F},
                                                       {0.93F, 0.79F, 0.28F},
                                                       {0.69F, 0.48F, 0.63F},
                                                       {0.46F, 0.72F, 0.70F},
                                                       {0.61F, 0.46F, 0.37F},
                                                       {0.55F, 0.78F, 0.90F},
                                                       {0.75F, 0.73F, 0.42F},
                                                       {0.24F, 0.37F, 0.36F},
                                                       {0.96F, 0.72F, 0.62F},
                                                       {0.49F, 0.49F, 0.76F}}};

/// A colour per part, of kPartColors, by the alphabetical place of its name: two models with equal part names
/// get equal colours. The colours repeat after twelve parts.
std::vector<Color> part_colors(const std::vector<std::string>& names);

/// `color` nearer to white by `amount` in 0 ... 1.
Color lighten(const Color& color, float amount);

/// Per facet: 0 or 1, alternating along the longest extent of the mesh.
std::vector<int> bands(const TriMesh& mesh);

}  // namespace partwise::report
