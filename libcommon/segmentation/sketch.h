#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "mesh/surface_point.h"

/// All that a user says of one mesh (partwise/sketch-1), independent of how it was stored.
namespace partwise {

/// How a mesh was seen on the screen: clip = projection * view * p; pixels with x to the right and y down.
struct Camera {
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
  Eigen::Matrix4d projection = Eigen::Matrix4d::Identity();
  double width = 0;   ///< of the viewport, in pixels
  double height = 0;  ///< of the viewport, in pixels
};

struct VertexStroke {
  std::vector<int> vertices;
};

/// Points near the surface, in the units of the model.
struct PointStroke {
  Points points;
};

/// A polyline drawn freehand over a picture of the mesh, in pixels.
struct ScreenStroke {
  std::vector<Eigen::Vector2d> polyline;
  Camera camera;
};

using Stroke = std::variant<VertexStroke, PointStroke, ScreenStroke>;

struct SketchedPart {
  std::string name;
  std::vector<Stroke> strokes;
};

/// A vertex, a point near the surface, or a point of a facet.
using Place = std::variant<int, Vec3, SurfacePoint>;

struct SketchedMarker {
  std::string name;
  Place place;
};

struct SketchedAnchor {
  std::string name;
  std::array<std::string, 2> between;  ///< names of the two parts on whose common boundary it lies
  Place place;
};

/// Size of the mesh that a sketch was drawn for; guards against using it with another.
struct SketchedMesh {
  int vertices = 0;
  int facets = 0;
};

/// No parts, or one: the whole mesh is one part.
struct Sketch {
  std::vector<SketchedPart> parts;
  std::vector<SketchedMarker> markers;
  std::vector<SketchedAnchor> anchors;
  std::optional<SketchedMesh> mesh;
};

/// Names of the parts in their order; a sketch without parts has one, "whole".
std::vector<std::string> part_names(const Sketch& sketch);

/// \throws InputError when the sketch says that it was drawn for a mesh of other size.
void require_drawn_for(const TriMesh& mesh, const Sketch& sketch);

}  // namespace partwise
