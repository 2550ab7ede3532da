#include "remeshing/chart_source.h"

#include <cmath>
#include <string>
#include <utility>

#include "error.h"

namespace partwise {
namespace {

std::string called(int vertex, int source_vertices) {
  return vertex < source_vertices ? "source vertex " + std::to_string(vertex)
                                  : "added vertex " + std::to_string(vertex - source_vertices);
}

ChartTarget::LoopPlace loop_place(const Part& piece, int local, const std::vector<SurfacePoint>& images,
                                  const ChartTarget& target) {
  const int v = piece.model_vertex[local];
  const auto place = target.on_loop(images[v]);
  if (place) return *place;
  throw InputError("vertex " + std::to_string(v) +
                   " lies on a boundary of the source, but not on that of the target");
}

}  // namespace

RefinedSource refine_source(const CompatibleMesh& mesh) {
  std::vector<EdgePoint> places;
  std::vector<SurfacePoint> images = mesh.map.images();
  for (const AddedVertex& added : mesh.added_vertices) {
    places.push_back(added.place);
    images.push_back(added.image);
  }
  EdgeSplitMesh split = split_edges(mesh.source, places);
  std::vector<int> labels;
  labels.reserve(split.parent_facet.size());
  for (const int parent : split.parent_facet) labels.push_back(mesh.source_labels[parent]);
  return {std::move(split), std::move(labels), std::move(images)};
}

ChartSource lay_out(const RefinedSource& source, const std::vector<bool>& inside, const ChartTarget& target) {
  ChartSource result{extract_piece(source.split.mesh, inside), {}};
  const Part& piece = result.piece;
  if (piece.loops.size() != target.piece().loops.size()) {
    throw InputError("the piece has " + std::to_string(piece.loops.size()) +
                     " boundary loops on the source and " + std::to_string(target.piece().loops.size()) +
                     " on the target");
  }
  const int originals = source.split.mesh.vertex_count() - static_cast<int>(source.split.points.size());
  for (int local = 0; local < piece.mesh.vertex_count(); ++local) {
    Vec3 direction = Vec3::Zero();
    if (!piece.is_cap_vertex(local)) {
      const SurfacePoint& image = source.images[piece.model_vertex[local]];
      if (image.facet >= 0) {
        const auto found = target.direction(image);
        if (!found) {
          throw InputError(called(piece.model_vertex[local], originals) + " lies outside its part's image");
        }
        direction = *found;
      }
    }
    result.directions.push_back(direction);
  }
  for (std::size_t i = 0; i < piece.loops.size(); ++i) {
    const int there = loop_place(piece, piece.loops[i].front(), source.images, target).loop;
    result.directions[piece.cap_vertices[i]] = target.directions()[target.piece().cap_vertices[there]];
  }
  return result;
}

std::vector<double> loop_steps(const ChartSource& source, const std::vector<SurfacePoint>& images,
                               std::size_t loop, const ChartTarget& target) {
  const std::vector<int>& vertices = source.piece.loops[loop];
  std::vector<double> steps;
  double sum = 0, n = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto from = loop_place(source.piece, vertices[i], images, target);
    const auto to = loop_place(source.piece, vertices[(i + 1) % vertices.size()], images, target);
    n = static_cast<double>(target.piece().loops[from.loop].size());
    double step = to.position - from.position;
    if (step < 0) step += n;
    if (from.loop != to.loop || !(step > 0)) {
      throw InputError("the boundary does not go on along the target's from vertex " +
                       std::to_string(source.piece.model_vertex[vertices[i]]));
    }
    steps.push_back(step);
    sum += step;
  }
  if (std::abs(sum - n) > 0.5) {
    throw InputError("the boundary at vertex " + std::to_string(source.piece.model_vertex[vertices[0]]) +
                     " turns back and forth along the target's");
  }
  return steps;
}

}  // namespace partwise
