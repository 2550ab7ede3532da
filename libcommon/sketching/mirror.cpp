#include "sketching/mirror.h"

#include <cstdio>

#include "error.h"

namespace partwise::sketching {
namespace {

constexpr double kLargestError = 0.02;  // of the diagonal: animals in a pose have 0.01, hands 0.025
constexpr double kApart = 0.02;         // of the diagonal

std::string percent(double share) {
  char text[40];
  std::snprintf(text, sizeof text, "%.2g %%", 100 * share);
  return text;
}

}  // namespace

Mirror::Mirror(const TriMesh& mesh)
    : mesh_(mesh), surface_(mesh), plane_(find_mirror_plane(mesh, surface_)) {}

std::optional<std::string> Mirror::problem() const {
  if (plane_.error <= kLargestError) return {};
  return "the model is not symmetric enough: it and its mirror image are " + percent(plane_.error) +
         " of the diagonal apart (RMS), and no more than " + percent(kLargestError) + " will do";
}

io::Json Mirror::facts() const {
  io::Json facts = {{"error", plane_.error}};
  if (const auto sentence = problem()) facts["problem"] = *sentence;
  return facts;
}

std::optional<SurfacePoint> Mirror::image(const SurfacePoint& point) const {
  if (const auto sentence = problem()) throw InputError(*sentence);
  const Vec3 from = position(mesh_, point);
  const SurfaceHit hit = surface_.closest(plane_.mirrored(from));
  if ((hit.position - from).norm() < kApart * mesh_.diagonal()) return {};
  return hit.point;
}

}  // namespace partwise::sketching
