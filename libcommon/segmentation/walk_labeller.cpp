#include "segmentation/walk_labeller.h"

#include <utility>

#include "segmentation/crease_field.h"
#include "segmentation/multilevel_labels.h"

namespace partwise {
namespace {

constexpr int kCoarsest = 20'000;  // nodes of the level whose linear system is solved

}  // namespace

WalkLabeller::WalkLabeller(const TriMesh& mesh, int largest_exact) {
  if (mesh.facet_count() > largest_exact) hierarchy_.emplace(mesh, kCoarsest);
  const std::vector<double> concavity = hierarchy_ ? edge_concavity(mesh, *hierarchy_) : edge_concavity(mesh);
  boundary_costs_ = partwise::boundary_costs(mesh, concavity);
  FacetGraph facets = facet_graph(mesh, concavity, boundary_costs_);
  if (hierarchy_) {
    graphs_ = graphs_of_levels(*hierarchy_, std::move(facets));
  } else {
    graphs_.push_back(std::move(facets));
  }
}

std::vector<int> WalkLabeller::labels(const Seeds& seeds, int part_count,
                                      const BandCutOptions& options) const {
  if (hierarchy_) return label_on_levels(*hierarchy_, graphs_, seeds.facet_part, part_count, options);
  std::vector<bool> is_seeded(seeds.facet_part.size());
  PartProbabilities probabilities =
      PartProbabilities::Zero(static_cast<Eigen::Index>(is_seeded.size()), part_count);
  for (std::size_t f = 0; f < is_seeded.size(); ++f) {
    is_seeded[f] = seeds.facet_part[f] != kUnseeded;
    if (is_seeded[f]) probabilities(static_cast<Eigen::Index>(f), seeds.facet_part[f]) = 1;
  }
  probabilities = walk_randomly(graphs_.front(), is_seeded, std::move(probabilities));
  return cut_band(graphs_.front(), nodes_in_doubt(is_seeded, probabilities, options.band),
                  most_probable_parts(probabilities), probabilities, options);
}

}  // namespace partwise
