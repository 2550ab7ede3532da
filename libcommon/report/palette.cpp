#include "report/palette.h"

#include <algorithm>
#include <cmath>

namespace partwise::report {

namespace {

constexpr int kBandCount = 30;

constexpr std::array<Color, 12> kPartColors = {{{0.31F, 0.47F, 0.66F},
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

}  // namespace

std::vector<Color> part_colors(const std::vector<std::string>& names) {
  std::vector<std::string> sorted = names;
  std::sort(sorted.begin(), sorted.end());
  std::vector<Color> colors;
  for (const std::string& name : names) {
    const auto place = std::lower_bound(sorted.begin(), sorted.end(), name) - sorted.begin();
    colors.push_back(kPartColors[static_cast<std::size_t>(place) % kPartColors.size()]);
  }
  return colors;
}

Color lighten(const Color& color, float amount) {
  Color result = color;
  for (float& channel : result) {
    channel += (1 - channel) * amount;
  }
  return result;
}

std::vector<int> bands(const TriMesh& mesh) {
  Vec3 low = mesh.point(0);
  Vec3 high = low;
  for (const Vec3& p : mesh.points()) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  int axis = 0;
  const double length = (high - low).maxCoeff(&axis);
  std::vector<int> result(mesh.facet_count(), 0);
  for (int f = 0; f < mesh.facet_count(); ++f) {
    const Facet& facet = mesh.facet(f);
    const double middle = (mesh.point(facet[0]) + mesh.point(facet[1]) + mesh.point(facet[2]))[axis] / 3;
    result[f] = static_cast<int>(kBandCount * (middle - low[axis]) / std::max(length, 1e-300)) % 2;
  }
  return result;
}

}  // namespace partwise::report
