#pragma once

#include "segmentation/band_cut.h"
#include "segmentation/facet_hierarchy.h"

namespace partwise {

/// Labels of the facets of a large mesh: random walk and band cut on the coarsest level, then on each finer
/// one both again within a few rings of the boundaries found so far.
///
/// Time and memory are those of the coarsest level, plus what is proportional to the length of the
/// boundaries, plus a few passes over the facets. Facets away from boundaries keep the part of their group.
/// \param graphs of all levels, finest first, see graphs_of_levels()
/// \param seeds of the facets \pre every component of the mesh has a seeded facet
std::vector<int> label_on_levels(const FacetHierarchy& hierarchy, const std::vector<FacetGraph>& graphs,
                                 const std::vector<int>& facet_seeds, int part_count,
                                 const BandCutOptions& options);

}  // namespace partwise
