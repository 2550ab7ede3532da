#include "mapping/map_to_hull.h"

#include <utility>

#include "error.h"
#include "mapping/map_progressively.h"
#include "mapping/parallel_parts.h"
#include "measure/hull_folds.h"

namespace partwise {
namespace {

int genus(const TriMesh& closed) {
  return (2 - closed.euler_characteristic()) / 2;
}

Points by_energy(const Part& part, const ConvexHull& hull, const EnergyMapOptions& options,
                 PartMapReport& report) {
  EnergyMap mapped = map_by_energy(part, hull, options);
  report.method = HullMapMethod::energy;
  report.folds_before = mapped.folds_before;
  report.off_hull = mapped.off_hull / part.mesh.diagonal();
  return std::move(mapped.images);
}

Points one_to_one(ProgressiveMap mapped, HullMapMethod method, PartMapReport& report) {
  report.method = method;
  report.distortion = mapped.distortion;
  return std::move(mapped.images);
}

/// By the method asked for, or by the next one where that method has no result.
Points map_part(const Part& part, const ConvexHull& hull, const MapToHullOptions& options,
                PartMapReport& report) {
  if (options.method == HullMapMethod::energy) return by_energy(part, hull, options.energy, report);
  if (const int handles = genus(part.mesh); handles > 0) {
    report.remark = "has " + std::to_string(handles) + (handles == 1 ? " handle" : " handles") +
                    ", which no convex hull has: decompose it further for a one-to-one map";
    return by_energy(part, hull, options.energy, report);
  }
  if (options.method == HullMapMethod::progressive) {
    try {
      return one_to_one(map_progressively(part, hull), HullMapMethod::progressive, report);
    } catch (const ComputationError& error) {
      report.remark = std::string("could not be mapped progressively: ") + error.what();
    }
  }
  try {
    return one_to_one(map_by_lifting(part, hull), HullMapMethod::lifted, report);
  } catch (const ComputationError& error) {
    report.remark +=
        (report.remark.empty() ? "" : "; ") + std::string("could not be lifted: ") + error.what();
  }
  return by_energy(part, hull, options.energy, report);
}

void certify(const Part& part, const ConvexHull& hull, const Points& images, PartMapReport& report) {
  const HullFolds found = hull_folds(images, part.mesh.facets(), hull_centre(hull));
  report.facets = part.mesh.facet_count();
  report.folds = found.count();
  report.degree = found.degree;
  report.euler_characteristic = part.mesh.euler_characteristic();
  report.one_to_one = found.one_to_one() && report.euler_characteristic == 2;
}

}  // namespace

MappedToHull map_to_hull(const HulledModel& hulled, const MapToHullOptions& options) {
  const int count = static_cast<int>(hulled.parts.size());
  MappedToHull result{{hulled, std::vector<Points>(count)}, std::vector<PartMapReport>(count)};
  for_each_part(count, [&](int k) {
    try {
      result.map.images[k] = map_part(hulled.parts[k], hulled.hulls[k], options, result.reports[k]);
      certify(hulled.parts[k], hulled.hulls[k], result.map.images[k], result.reports[k]);
    } catch (const ComputationError& error) {
      throw ComputationError("part \"" + hulled.model.segmentation.names[k] + "\": " + error.what());
    }
  });
  return result;
}

}  // namespace partwise
