#include "io/refinement_tables.h"

#include <algorithm>
#include <string>
#include <utility>

#include "error.h"
#include "io/chart_tables.h"
#include "io/json_reader.h"
#include "remeshing/split_source.h"

namespace partwise::io {
namespace {

constexpr double kRounding = 1e-9;  // over the source's diagonal

Element& element(PlyTables& tables, const std::string& name) {
  return *std::find_if(tables.elements.begin(), tables.elements.end(),
                       [&](const Element& e) { return e.name == name; });
}

/// Whether a vertex of the refined source lies in a facet of the original.
bool lies_in(const SourceRefinement& refinement, int originals, int vertex, const Facet& facet) {
  auto is_corner = [&](int v) { return std::find(facet.begin(), facet.end(), v) != facet.end(); };
  if (vertex < originals) return is_corner(vertex);
  const SurfacePoint& place = refinement.vertices[vertex - originals];
  const Facet& of_place = refinement.original_facets[place.facet];
  for (int i = 0; i < 3; ++i) {
    if (place.barycentric[i] > 0 && !is_corner(of_place[i])) return false;
  }
  return true;
}

void require_same_surface(const ElementReader& vertices, const ElementReader& facets,
                          const CompatibleMesh& mesh, const TriMesh& original) {
  const double near = kRounding * mesh.source.diagonal();
  const int originals = original.vertex_count();
  for (std::size_t i = 0; i < mesh.refinement.vertices.size(); ++i) {
    const Vec3& there = mesh.source.point(originals + static_cast<int>(i));
    if ((position(original, mesh.refinement.vertices[i]) - there).norm() <= near) continue;
    vertices.fail(i, "original_u", "the point is not where the source's vertex is");
  }
  for (int f = 0; f < mesh.source.facet_count(); ++f) {
    const Facet& parent = original.facet(mesh.refinement.parent_facet[f]);
    for (const int v : mesh.source.facet(f)) {
      if (lies_in(mesh.refinement, originals, v, parent)) continue;
      facets.fail(f, "original_face", "vertex " + std::to_string(v) + " does not lie in that facet");
    }
  }
}

}  // namespace

void add_refinement(Document& document, const CompatibleMesh& mesh) {
  const SourceRefinement& refinement = mesh.refinement;
  document.metadata["refined_vertices"] = refinement.vertices.size();
  if (refinement.is_empty()) return;
  Element parents = ElementBuilder("face", refinement.parent_facet.size())
                        .integers("original_face", refinement.parent_facet)
                        .build();
  element(document.tables, "face").properties.push_back(std::move(parents.properties.front()));
  ElementBuilder vertices("refined_vertex", refinement.vertices.size());
  document.tables.elements.push_back(add_surface_points(vertices, "original", refinement.vertices).build());
  document.tables.elements.push_back(ElementBuilder("original_face", refinement.original_facets.size())
                                         .facets(refinement.original_facets)
                                         .build());
}

void read_refinement(const Document& document, CompatibleMesh& mesh) {
  const auto count = document.metadata.find("refined_vertices");
  if (count == document.metadata.end()) return;
  const int added =
      JsonReader(document.metadata)["refined_vertices"].integer(0, mesh.source.vertex_count() - 1);
  if (added == 0) return;
  const ElementReader vertices(document.tables, "refined_vertex"), facets(document.tables, "face");
  if (vertices.size() != added) {
    JsonReader(document.metadata)["refined_vertices"].fail(
        "differs from the rows of element 'refined_vertex'");
  }
  const int originals = mesh.source.vertex_count() - added;
  mesh.refinement.original_facets = ElementReader(document.tables, "original_face").facets(originals);
  mesh.refinement.vertices.resize(added);
  const TriMesh original = original_source(mesh);
  mesh.refinement.vertices = read_surface_points(vertices, "original", original);
  mesh.refinement.parent_facet = facets.integers("original_face", 0, original.facet_count() - 1);
  require_same_surface(vertices, facets, mesh, original);
}

}  // namespace partwise::io
