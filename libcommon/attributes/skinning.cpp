#include "attributes/skinning.h"

#include <algorithm>
#include <map>
#include <utility>

#include "attributes/column_values.h"
#include "error.h"

namespace partwise {
namespace {

using Binding = std::vector<std::pair<double, double>>;  // joint, weight

std::vector<Binding> read_bindings(const SkinColumns& skin, int vertex_count) {
  std::vector<Binding> bindings(vertex_count);
  for (std::size_t k = 0; k < skin.joints.size(); ++k) {
    const io::Property &joint = *skin.joints[k], &weight = *skin.weights[k];
    const std::vector<double> joints = io::numbers_of(joint.values), weights = io::numbers_of(weight.values);
    for (int v = 0; v < vertex_count; ++v) {
      const std::size_t first = joint.is_list ? joint.offsets[v] : v;
      const std::size_t last = joint.is_list ? joint.offsets[v + 1] : v + 1;
      const std::size_t other = weight.is_list ? weight.offsets[v] : v;
      if (weight.is_list && weight.offsets[v + 1] - other != last - first) {
        throw InputError("element 'vertex', row " + std::to_string(v) + ": '" + joint.name + "' and '" +
                         weight.name + "' have different lengths");
      }
      for (std::size_t i = first; i < last; ++i) {
        bindings[v].emplace_back(joints[i], weights[other + i - first]);
      }
    }
  }
  return bindings;
}

/// The `most` largest weights, scaled to the sum of all; of equals the lower joints.
Binding largest(const std::map<double, double>& mixed, std::size_t most) {
  Binding all;
  double sum = 0, kept = 0;
  for (const auto& [joint, weight] : mixed) {
    if (weight == 0) continue;
    all.emplace_back(joint, weight);
    sum += weight;
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  if (all.size() > most) all.resize(most);
  for (const auto& entry : all) kept += entry.second;
  if (kept > 0) {
    for (auto& entry : all) entry.second *= sum / kept;
  }
  return all;
}

std::vector<io::Property> as_scalars(const SkinColumns& skin, const std::vector<Binding>& bindings) {
  std::vector<io::Property> columns;
  for (std::size_t k = 0; k < skin.joints.size(); ++k) {
    std::vector<double> joints, weights;
    for (const Binding& binding : bindings) {
      joints.push_back(k < binding.size() ? binding[k].first : 0);
      weights.push_back(k < binding.size() ? binding[k].second : 0);
    }
    columns.push_back(io::scalar_column(skin.joints[k]->name, values_like(skin.joints[k]->values, joints)));
    columns.push_back(
        io::scalar_column(skin.weights[k]->name, values_like(skin.weights[k]->values, weights)));
  }
  return columns;
}

std::vector<io::Property> as_lists(const SkinColumns& skin, const std::vector<Binding>& bindings) {
  std::vector<double> joints, weights;
  std::vector<std::size_t> offsets{0};
  for (const Binding& binding : bindings) {
    for (const auto& [joint, weight] : binding) {
      joints.push_back(joint);
      weights.push_back(weight);
    }
    offsets.push_back(joints.size());
  }
  const io::Property &joint = *skin.joints[0], &weight = *skin.weights[0];
  return {{joint.name, values_like(joint.values, joints), true, joint.count_type, offsets},
          {weight.name, values_like(weight.values, weights), true, weight.count_type, offsets}};
}

}  // namespace

bool SkinColumns::contains(const io::Property& property) const {
  return std::find(joints.begin(), joints.end(), &property) != joints.end() ||
         std::find(weights.begin(), weights.end(), &property) != weights.end();
}

SkinColumns find_skin(const io::Element& vertices) {
  for (const std::string word : {"joint", "bone"}) {
    const io::Property* joints = vertices.find(word + "s");
    const io::Property* weights = vertices.find("weights");
    if (joints && weights && joints->is_list && weights->is_list) return {{joints}, {weights}};
    SkinColumns skin;
    for (int k = 0;; ++k) {
      const io::Property* joint = vertices.find(word + "_" + std::to_string(k));
      const io::Property* weight = vertices.find("weight_" + std::to_string(k));
      if (!joint || !weight || joint->is_list || weight->is_list) break;
      skin.joints.push_back(joint);
      skin.weights.push_back(weight);
    }
    if (!skin.empty()) return skin;
  }
  return {};
}

std::vector<io::Property> carry_skin(const SkinColumns& skin, const TriMesh& giver,
                                     const std::vector<SurfacePoint>& origins) {
  const std::vector<Binding> given = read_bindings(skin, giver.vertex_count());
  const bool lists = skin.joints[0]->is_list;
  std::size_t most = skin.joints.size();
  if (lists) {
    for (const Binding& binding : given) most = std::max(most, binding.size());
  }
  std::vector<Binding> carried;
  carried.reserve(origins.size());
  for (const SurfacePoint& origin : origins) {
    std::map<double, double> mixed;
    for (int i = 0; i < 3; ++i) {
      for (const auto& [joint, weight] : given[giver.facet(origin.facet)[i]]) {
        mixed[joint] += origin.barycentric[i] * weight;
      }
    }
    carried.push_back(largest(mixed, most));
  }
  return lists ? as_lists(skin, carried) : as_scalars(skin, carried);
}

}  // namespace partwise
