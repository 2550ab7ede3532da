#include <filesystem>
#include <optional>
#include <set>

#include "cli/series.h"
#include "deform/deformation_transfer.h"
#include "io/stage_documents.h"
#include "measure/inverted_facets.h"

using namespace partwise;

namespace {

constexpr double kSuspiciousTurn = 30;  // degrees

struct Request {
  std::vector<std::string> poses;
  bool reverse = false;
  double threshold = 0.02;
  DeformationTransferOptions deformation;

  Direction direction() const { return reverse ? Direction::to_source : Direction::to_target; }
};

void declare(CLI::App& app, Request& request) {
  app.add_option("--poses", request.poses,
                 "Poses of the source, meshes with its vertices and facets: the target takes them")
      ->required();
  app.add_flag("--reverse", request.reverse, "From the target to the source instead");
  app.add_option("--threshold", request.threshold,
                 "With a cross map: facets whose centroids on the common hull are this near, over the hull's "
                 "diagonal, correspond")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  app.add_flag("--turn", request.deformation.turn,
               "Turn the movements as the models are turned against each other; without, directions in space "
               "are the same for both");
}

/// Who gives and who receives, and which facets correspond.
struct Pair {
  TriMesh giver, receiver;
  FacetCorrespondence correspondence;
};

Pair ordered(const TriMesh& source, const TriMesh& target, FacetCorrespondence correspondence, bool reverse) {
  return reverse ? Pair{target, source, std::move(correspondence)}
                 : Pair{source, target, std::move(correspondence)};
}

void warn_unless_one_to_one(const cli::Command& command, const TwoWayMap& map) {
  if (map.one_to_one()) return;
  command.warn("the map is not certified one-to-one: closest points take the place of its inverse");
}

Pair pair_of(const cli::Command& command, const io::Document& document, const Request& request) {
  if (document.kind() == "crossmap") {
    const CrossMap map = io::read_cross_map(document);
    return ordered(map.source.mesh, map.target.hulled.model.mesh,
                   hull_correspondence(map, request.threshold, request.direction()), request.reverse);
  }
  const CompatibleMesh mesh = io::read_compatible_mesh(document);
  const TwoWayMap map(mesh);
  warn_unless_one_to_one(command, map);
  return ordered(mesh.source, mesh.target,
                 exact_correspondence(sample_origins(mesh, map, request.direction())), request.reverse);
}

/// File names without folders and endings; \throws UsageError when two are the same
std::vector<std::string> pose_names(const std::vector<std::string>& files) {
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (const std::string& file : files) {
    names.push_back(std::filesystem::path(file).stem().string());
    if (seen.insert(names.back()).second) continue;
    throw UsageError("two poses are called " + names.back() + ": their results would replace each other");
  }
  return names;
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

}  // namespace

int main(int argc, char** argv) {
  cli::Command command("transfer", "Give the target of a map the source's poses.",
                       "transfer cat-lion/compatible.ply --poses cat-01.ply cat-02.ply -o lion-poses/");
  const std::string& input = command.input(
      "map", "Compatible mesh (exact correspondence), or a cross map (facets near on the hulls)", false);
  Request request;
  declare(command.options(), request);
  const cli::SeriesOutput output(command);
  return command.run(argc, argv, [&] {
    const std::vector<std::string> names = pose_names(request.poses);
    output.require_writable(names);
    const io::Document document = command.read(input, {"compatible", "crossmap"});
    const Pair pair = command.about(input, [&] { return pair_of(command, document, request); });
    std::vector<cli::ModelInput> poses;
    std::vector<Points> positions;
    for (const std::string& file : request.poses) {
      poses.push_back(cli::read_model(command, file));
      cli::require_same_connectivity(
          poses.back().mesh, file, pair.giver,
          std::string(request.reverse ? "the target" : "the source") + " of " + input);
      positions.push_back(poses.back().mesh.points());
    }
    const DeformationTransfer transfer(pair.giver, pair.receiver, pair.correspondence, request.deformation);
    if (transfer.turned_by() > kSuspiciousTurn && !request.deformation.turn) {
      command.warn("source and target are turned against each other by " +
                   std::to_string(std::lround(transfer.turned_by())) +
                   " degrees, so the poses will be, too; --turn corrects it");
    }
    cli::Series series{"poses", pair.receiver, transfer.follow(positions), names, {}};
    for (std::size_t i = 0; i < positions.size(); ++i) {
      series.metrics.push_back(inverted_faces(pair, positions[i], series.shapes[i]));
    }
    std::vector<const io::Document*> inputs{&document};
    for (const cli::ModelInput& pose : poses) {
      if (pose.document) inputs.push_back(&*pose.document);
    }
    output.write(series, inputs);
  });
}
