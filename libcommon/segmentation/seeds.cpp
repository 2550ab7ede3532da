#include "segmentation/seeds.h"

#include <algorithm>

#include "error.h"
#include "mesh/facet_regions.h"

namespace partwise {
namespace {

constexpr int kContested = -2;

/// Notes that `part` claims a vertex or facet; a second claimant makes it contested.
void claim(int& owner, int part) {
  if (owner == kUnseeded) owner = part;
  if (owner != part) owner = kContested;
}

void release_contested(std::vector<int>& owners) {
  std::replace(owners.begin(), owners.end(), kContested, kUnseeded);
}

std::string quoted(const std::string& name) {
  return "part '" + name + "'";
}

void require_strokes(const std::vector<std::string>& names, const std::vector<SeedStroke>& strokes) {
  std::vector<bool> drawn(names.size(), false);
  for (const SeedStroke& stroke : strokes) drawn[stroke.part] = true;
  for (std::size_t part = 0; part < names.size(); ++part) {
    if (!drawn[part]) throw InputError(quoted(names[part]) + " has no stroke; draw at least one");
  }
}

/// Every stroke must keep a facet: one that other parts' strokes cover entirely says nothing.
void require_effect(const TriMesh& mesh, const std::vector<std::string>& names,
                    const std::vector<SeedStroke>& strokes, const Seeds& seeds) {
  for (const SeedStroke& stroke : strokes) {
    const bool has_facet = std::any_of(stroke.vertices.begin(), stroke.vertices.end(), [&](int v) {
      const auto facets = mesh.half_edges().vf_range(OpenMesh::VertexHandle(v));
      return std::any_of(facets.begin(), facets.end(),
                         [&](OpenMesh::FaceHandle f) { return seeds.facet_part[f.idx()] == stroke.part; });
    });
    if (!has_facet) {
      throw InputError(quoted(names[stroke.part]) + ", stroke " + std::to_string(stroke.index) +
                       ": strokes of other parts touch every facet it touches (near vertex " +
                       std::to_string(stroke.vertices.front()) + "); move it away from them");
    }
  }
}

void require_components(const TriMesh& mesh, const std::vector<int>& component,
                        const std::vector<std::string>& names, const std::vector<SeedStroke>& strokes) {
  const int count = 1 + *std::max_element(component.begin(), component.end());
  std::vector<int> first_vertex(names.size(), -1), part_component(names.size(), -1);
  std::vector<bool> reached(count, false);
  for (const SeedStroke& stroke : strokes) {
    for (const int v : stroke.vertices) {
      const int here = component[mesh.half_edges().cvf_begin(OpenMesh::VertexHandle(v))->idx()];
      reached[here] = true;
      if (first_vertex[stroke.part] < 0) {
        first_vertex[stroke.part] = v;
        part_component[stroke.part] = here;
      }
      if (part_component[stroke.part] != here) {
        throw InputError(quoted(names[stroke.part]) +
                         " has strokes on two unconnected components of the mesh (vertices " +
                         std::to_string(first_vertex[stroke.part]) + " and " + std::to_string(v) +
                         "); every part must be connected");
      }
    }
  }
  for (std::size_t f = 0; f < component.size(); ++f) {
    if (reached[component[f]]) continue;
    throw InputError(
        "the mesh has " + std::to_string(count) + " components, and the one of vertex " +
        std::to_string(mesh.facet(static_cast<int>(f))[0]) +
        " has no stroke; draw one of a part of its own there, or keep the largest component alone "
        "(convert-mesh --keep-largest-component)");
  }
}

}  // namespace

std::vector<int> facet_components(const TriMesh& mesh) {
  std::vector<int> component = facet_regions(mesh, {});
  int count = 0;
  for (std::size_t f = 0; f < component.size(); ++f) {
    component[f] = component[f] == static_cast<int>(f) ? count++ : component[component[f]];
  }
  return component;
}

Seeds collect_seeds(const TriMesh& mesh, const std::vector<std::string>& names,
                    const std::vector<SeedStroke>& strokes) {
  return collect_seeds(mesh, facet_components(mesh), names, strokes);
}

Seeds collect_seeds(const TriMesh& mesh, const std::vector<int>& components,
                    const std::vector<std::string>& names, const std::vector<SeedStroke>& strokes) {
  require_strokes(names, strokes);
  require_components(mesh, components, names, strokes);
  Seeds seeds{std::vector<int>(mesh.vertex_count(), kUnseeded),
              std::vector<int>(mesh.facet_count(), kUnseeded)};
  for (const SeedStroke& stroke : strokes) {
    for (const int v : stroke.vertices) {
      claim(seeds.vertex_part[v], stroke.part);
      for (const OpenMesh::FaceHandle f : mesh.half_edges().vf_range(OpenMesh::VertexHandle(v))) {
        claim(seeds.facet_part[f.idx()], stroke.part);
      }
    }
  }
  release_contested(seeds.vertex_part);
  release_contested(seeds.facet_part);
  require_effect(mesh, names, strokes, seeds);
  return seeds;
}

}  // namespace partwise
