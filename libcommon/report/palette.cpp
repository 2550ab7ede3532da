#include "report/palette.h"

#include <algorithm>
#include <cmath>

namespace partwise::report {

namespace {

constexpr int kBandCount = 30;

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
