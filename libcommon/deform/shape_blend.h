#pragma once

#include <memory>
#include <vector>

#include "deform/surface_integration.h"

namespace partwise {

enum class BlendMethod {
  rotations,  ///< facets turn and stretch (as rigid as possible)
  linear      ///< vertices move along straight lines
};

/// Affine blends of models with one connectivity: between two (a morph) or many, and beyond them.
///
/// Rotations: every facet's deformation gradient from the first model to each other one is split into a
/// rotation R_k and a stretch S_k. The blend of weights w has the stretch sum w_k S_k, and the positions are
/// those whose edges come nearest (SurfaceIntegration). R_k is the product of what the model turns as a
/// whole, what the facet's surroundings turn besides (smoothed_rotations) and what is left to the facet, and
/// each factor is blended on its own, exp(sum w_k log): so all of a limb turns alike, and a fold at its joint
/// does not lead it astray. Logarithms go on from facet to facet beyond half a turn (rotation_logarithms).
/// After Alexa et al. 2000 and Sumner et al. 2005. Weights of a model alone give back that model. Centres of
/// components follow straight lines.
/// Not guaranteed: that blends are free of self-intersections.
class ShapeBlend {
 public:
  /// \param first the first model and the connectivity of all \param others positions of the other models
  /// \throws InputError when a model has another number of vertices
  ShapeBlend(const TriMesh& first, const std::vector<Points>& others,
             BlendMethod method = BlendMethod::rotations);

  int model_count() const { return static_cast<int>(models_.size()); }

  /// The blend for each row of `weights`, one weight per model; negative ones go beyond. Where they do not
  /// add up to 1, the blend of their shares is scaled about the origin by their sum.
  /// \throws InputError when a row has another number of weights
  std::vector<Points> frames(const std::vector<std::vector<double>>& weights) const;

 private:
  struct FacetBlend {
    bool known = true;                     // false: a line in some model; its edges are blended linearly
    Points smooth, rest;                   // per model but the first: rotation vectors
    std::vector<Eigen::Matrix3d> stretch;  // per model but the first
  };
  void split(const TriMesh& first);
  FacetEdges blended_edges(int facet, const std::vector<double>& weights, const std::vector<double>& shares,
                           const Eigen::Matrix3d& whole) const;
  Points linear_frame(const std::vector<double>& weights) const;

  BlendMethod method_;
  Facets facets_;
  std::vector<Points> models_;
  Points whole_;  // per model: rotation vector of the model as a whole
  std::vector<FacetBlend> facet_blends_;
  std::unique_ptr<SurfaceIntegration> integration_;
};

/// `count` rows of weights on the way from the first of `models` models to the last, through all of them.
/// \pre models > 1; count == 1 is the first model
std::vector<std::vector<double>> weights_along(int models, int count);

/// The weights at `place` on that way: 0 is the first model, 1 the second; beyond the ends it goes straight
/// on.
std::vector<double> weights_at(int models, double place);

}  // namespace partwise
