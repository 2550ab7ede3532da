#pragma once

#include "mesh/tri_mesh.h"
#include "report/panel.h"

namespace partwise::report {

inline constexpr Color kPlain = {0.78F, 0.77F, 0.74F};
inline constexpr Color kFolded = {0.86F, 0.05F, 0.05F};

/// A colour per part, never red, by the alphabetical place of its name: two models with equal part names get
/// equal colours. The colours repeat after twelve parts.
std::vector<Color> part_colors(const std::vector<std::string>& names);

/// `color` nearer to white by `amount` in 0 ... 1.
Color lighten(const Color& color, float amount);

/// Per facet: 0 or 1, alternating along the longest extent of the mesh.
std::vector<int> bands(const TriMesh& mesh);

}  // namespace partwise::report
