#pragma once

#include <string>
#include <vector>

#include "mapping/domains.h"
#include "report/shown_model.h"

namespace partwise::report {

/// The convex hulls of a model's parts as a surface of the page. \param names of the parts
io::Json hulls_surface(const std::vector<ConvexHull>& hulls, const std::vector<std::string>& names,
                       const Frame& frame, const PartNumbers& numbers, PageArrays& arrays);

/// Parts mapped onto hulls: their images, and the hulls that they lie on, both per entry of `parts`.
struct PartImages {
  const std::vector<Part>& parts;
  const std::vector<Points>& images;
  const std::vector<ConvexHull>& hulls;
};

/// The same as a surface of the page: the model's shown facets in their order, then the caps ("caps_from"),
/// and, when there are any, all "folded" facets once more, lifted a little.
/// \param frame of the hulls
io::Json images_surface(const ShownModel& shown, const PartImages& on_hulls, const Frame& frame,
                        const PartNumbers& numbers, PageArrays& arrays);

}  // namespace partwise::report
