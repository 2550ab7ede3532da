#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>

#include "attributes/carry_attributes.h"
#include "cli/series.h"
#include "deform/deformation_transfer.h"
#include "error.h"
#include "io/stage_documents.h"
#include "measure/inverted_facets.h"

using namespace partwise;

namespace {

constexpr double kSuspiciousTurn = 30;  // degrees

struct Request {
  std::vector<std::string> poses;
  std::string attributes;
  std::vector<std::string> properties;
  bool reverse = false;
  std::vector<std::string> held;
  double threshold = 0.02;
  DeformationTransferOptions deformation;

  Direction direction() const { return reverse ? Direction::to_source : Direction::to_target; }

  /// Of the results: the input's file names without folders and endings.
  /// \throws UsageError when two are the same
  std::vector<std::string> names() const {
    std::vector<std::string> result;
    std::set<std::string> seen;
    for (const std::string& file : poses.empty() ? std::vector<std::string>{attributes} : poses) {
      result.push_back(std::filesystem::path(file).stem().string());
      if (seen.insert(result.back()).second) continue;
      throw UsageError("two poses are called " + result.back() + ": their results would replace each other");
    }
    return result;
  }
};

void declare(CLI::App& app, Request& request) {
  CLI::Option* poses = app.add_option("--poses", request.poses,
                                      "Poses of the source, meshes with its vertices and facets: the target "
                                      "takes them");
  CLI::Option* attributes =
      app.add_option(
             "--attributes", request.attributes,
             "The source as a PLY file with properties of vertices or facets (colours, labels, texture "
             "coordinates, skinning weights, any), or as an OBJ file with texture coordinates: the target "
             "gets them")
          ->excludes(poses);
  app.add_option("--property", request.properties, "Only these properties")
      ->allow_extra_args(false)
      ->needs(attributes);
  app.add_flag("--reverse", request.reverse, "From the target to the source instead");
  app.add_option("--threshold", request.threshold,
                 "With a cross map: facets whose centroids on the common hull are this near, over the hull's "
                 "diagonal, correspond")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  app.add_flag("--turn", request.deformation.turn,
               "Turn the movements as the models are turned against each other; without, directions in space "
               "are the same for both")
      ->needs(poses);
  app.add_option("--hold", request.held,
                 "A marker, or a vertex of the receiving model by its number, that moves exactly as on the "
                 "giving one, over the models' sizes: feet that stand there stand here; again for others")
      ->allow_extra_args(false)
      ->needs(poses);
}

/// A map between two models, one of which gives what the other receives.
struct Pair {
  TriMesh giver, receiver;
  std::optional<Origins> origins;      // of a compatible mesh
  FacetCorrespondence correspondence;  // for poses
  std::vector<HeldPair> held;          // for poses
};

Pair ordered(const TriMesh& source, const TriMesh& target, bool reverse) {
  return reverse ? Pair{target, source, {}, {}, {}} : Pair{source, target, {}, {}, {}};
}

/// The marker of that name, or the vertex of the receiver with that number.
HeldPair held_pair(const CompatibleMesh& mesh, const Pair& pair, const std::string& name, bool reverse) {
  for (const MarkerPair& marker : mesh.markers) {
    if (marker.name == name) {
      return reverse ? HeldPair{marker.target, marker.source} : HeldPair{marker.source, marker.target};
    }
  }
  int vertex = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), vertex);
  if (error != std::errc() || end != name.data() + name.size()) {
    std::string known;
    for (const MarkerPair& marker : mesh.markers) known += (known.empty() ? "" : ", ") + marker.name;
    throw InputError("there is no marker '" + name +
                     "' to hold, nor is that the number of a vertex; there are: " + known);
  }
  if (vertex < 0 || vertex >= pair.receiver.vertex_count()) {
    throw InputError("there is no vertex " + name + " to hold: the receiving model has " +
                     std::to_string(pair.receiver.vertex_count()));
  }
  return {pair.origins->vertices[vertex], vertex_point(pair.receiver, vertex)};
}

Pair compatible_pair(const cli::Command& command, const CompatibleMesh& mesh, const Request& request) {
  const TwoWayMap map(mesh);
  if (!map.one_to_one()) {
    command.warn("the map is not certified one-to-one: closest points take the place of its inverse");
  }
  Pair pair = ordered(mesh.source, mesh.target, request.reverse);
  pair.origins = Origins{{}, sample_origins(mesh, map, request.direction())};
  for (int v = 0; v < pair.receiver.vertex_count(); ++v) {
    pair.origins->vertices.push_back(request.reverse ? map.vertex_to_target(v) : map.vertex_to_source(v));
  }
  if (!request.poses.empty()) pair.correspondence = exact_correspondence(pair.origins->facets);
  for (const std::string& name : request.held)
    pair.held.push_back(held_pair(mesh, pair, name, request.reverse));
  return pair;
}

Pair pair_of(const cli::Command& command, const io::Document& document, const Request& request) {
  if (document.kind() == "compatible") {
    return compatible_pair(command, io::read_compatible_mesh(document), request);
  }
  if (request.poses.empty()) {
    throw InputError("a cross map has no places on the target yet: properties need a compatible mesh");
  }
  if (!request.held.empty()) {
    throw InputError("a cross map has no places on the target yet: --hold needs a compatible mesh");
  }
  const CrossMap map = io::read_cross_map(document);
  Pair pair = ordered(map.source.mesh, map.target.hulled.model.mesh, request.reverse);
  pair.correspondence = hull_correspondence(map, request.threshold, request.direction());
  return pair;
}

/// Facets against their surroundings, of both models: what folds in the pose given may fold in the one made.
io::Json inverted_faces(const Pair& pair, const Points& given, const Points& made) {
  const auto count = [](const TriMesh& mesh, const Points& points) {
    return inverted_facets(points, mesh.facets()).size();
  };
  return {{"inverted_faces", count(pair.receiver, made)},
          {"inverted_faces_at_rest", count(pair.receiver, pair.receiver.points())},
          {"inverted_faces_of_pose", count(pair.giver, given)},
          {"inverted_faces_of_giver_at_rest", count(pair.giver, pair.giver.points())}};
}

/// Reads a mesh that must have the giver's connectivity.
cli::ModelInput read_giver(cli::Command& command, const std::string& file, const Pair& pair,
                           const std::string& map, bool reverse) {
  cli::ModelInput input = cli::read_model(command, file);
  cli::require_same_connectivity(input.mesh, file, pair.giver,
                                 std::string(reverse ? "the target" : "the source") + " of " + map);
  return input;
}

void transfer_poses(cli::Command& command, const cli::SeriesOutput& output, const std::string& input,
                    const io::Document& document, const Pair& pair, const Request& request) {
  std::vector<cli::ModelInput> poses;
  std::vector<Points> positions;
  for (const std::string& file : request.poses) {
    poses.push_back(read_giver(command, file, pair, input, request.reverse));
    positions.push_back(poses.back().mesh.points());
  }
  DeformationTransferOptions options = request.deformation;
  options.held = pair.held;
  const DeformationTransfer transfer(pair.giver, pair.receiver, pair.correspondence, options);
  if (transfer.turned_by() > kSuspiciousTurn && !request.deformation.turn) {
    command.warn("source and target are turned against each other by " +
                 std::to_string(std::lround(transfer.turned_by())) +
                 " degrees, so the poses will be, too; --turn corrects it");
  }
  cli::Series series{"poses", pair.receiver, transfer.follow(positions), request.names(), {}};
  for (std::size_t i = 0; i < positions.size(); ++i) {
    series.metrics.push_back(inverted_faces(pair, positions[i], series.shapes[i]));
  }
  std::vector<const io::Document*> inputs{&document};
  for (const cli::ModelInput& pose : poses) {
    if (pose.document) inputs.push_back(&*pose.document);
  }
  output.write(series, inputs);
}

void transfer_attributes(cli::Command& command, const cli::SeriesOutput& output, const std::string& input,
                         const io::Document& document, const Pair& pair, const Request& request) {
  const cli::ModelInput given = read_giver(command, request.attributes, pair, input, request.reverse);
  const io::PlyTables tables = given.tables();
  CarriedAttributes carried = command.about(request.attributes, [&] {
    return carry_attributes(tables, pair.giver, pair.receiver, *pair.origins, request.properties);
  });
  if (carried.vertex.empty() && carried.face.empty()) {
    throw InputError(request.attributes +
                     ": has no property to transfer but its geometry; PLY files have them, and OBJ files "
                     "with texture coordinates");
  }
  io::Json names = io::Json::array();
  for (const auto* columns : {&carried.vertex, &carried.face}) {
    for (const io::Property& property : *columns) names.push_back(property.name);
  }
  io::Document looks;
  looks.tables.comments = tables.comments;
  looks.tables.elements = {{"vertex", pair.receiver.points().size(), std::move(carried.vertex)},
                           {"face", pair.receiver.facets().size(), std::move(carried.face)}};
  cli::Series series{"attributes", pair.receiver, {pair.receiver.points()}, request.names(), {}};
  series.metrics.push_back({{"properties", names}});
  series.looks = &looks;
  std::vector<const io::Document*> inputs{&document};
  if (given.document) inputs.push_back(&*given.document);
  output.write(series, inputs);
}

}  // namespace

int main(int argc, char** argv) {
  cli::Command command(
      "transfer", "Carry poses or properties from one model of a map to the other.",
      "transfer cat-lion/compatible.ply --poses cat-01.ply cat-02.ply -o lion-poses/\n"
      "  transfer cat-lion/compatible.ply --attributes cat-textured.ply -o lion-textured.ply");
  const std::string& input = command.input(
      "map", "Compatible mesh (exact correspondence), or a cross map (facets near on the hulls)", false);
  Request request;
  declare(command.options(), request);
  const cli::SeriesOutput output(command);
  return command.run(argc, argv, [&] {
    if (request.poses.empty() && request.attributes.empty()) {
      throw UsageError("nothing to transfer: give --poses FILE... or --attributes FILE");
    }
    output.require_writable(request.names());
    const io::Document document = command.read(input, {"compatible", "crossmap"});
    const Pair pair = command.about(input, [&] { return pair_of(command, document, request); });
    const auto transfer = request.poses.empty() ? transfer_attributes : transfer_poses;
    transfer(command, output, input, document, pair, request);
  });
}
